"""Reads a results file of kappabench with nothing but h5py: python3 read_results.py RESULTS.h5"""

import sys

import h5py


def in_order(group):
    """Children of a group by their attribute "index"; HDF5 itself lists them by name."""
    return sorted(group.values(), key=lambda child: child.attrs["index"])


def table(group):
    """A table as a dict from column name to values; words become str."""
    columns = {}
    for column in in_order(group):
        words = h5py.check_string_dtype(column.dtype) is not None
        columns[column.attrs["name"]] = list(column.asstr()[:]) if words else column[:]
    return columns


def describe_cell(cell):
    print(f"  {cell.attrs['dataset']}, {cell.attrs['label']}: {cell.attrs['outcome']} {cell.attrs['message']}".rstrip())
    for curve in in_order(cell["curves"]):
        report = curve["report"].attrs
        print(f"    {report['iterations']} iterations, residual {report['residual']:.3g}, {report['seconds']:.3g} s")
        if "samples" in curve:  # absent when there is no curve
            samples = curve["samples"]
            kappa = samples["kappa"][:]
            print(f"    {len(kappa)} samples, length {samples['s'][-1]:.6g}, curvature {kappa.min():.4g} to {kappa.max():.4g}")
        if "metrics" in curve:
            metrics = curve["metrics"]
            for name, value, method in zip(metrics["column"].asstr()[:], metrics["value"][:], metrics["method"].asstr()[:]):
                print(f"    {name} = {value:.6g} ({method})")


def main(path):
    with h5py.File(path, "r") as results:
        if results.attrs["format"] != "kappabench-results":
            sys.exit(f"{path}: not a results file of kappabench")
        for key, value in sorted(results.attrs.items()):
            print(f"{key}: {str(value)[:100]}")
        for experiment in in_order(results["experiments"]):
            print(f"\n{experiment.attrs['id']}: {experiment.attrs['title']}")
            for cell in in_order(experiment["cells"]):
                describe_cell(cell)
            for group in in_order(experiment["tables"]):
                columns = table(group)
                print(f"  table {group.attrs['id']}: {', '.join(columns)}")
            for claim in in_order(experiment["claims"]):
                print(f"  {claim.attrs['paper']}, {claim.attrs['claim']}: {claim.attrs['verdict']}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
