"""Metrics, tables of compare, results files."""

import csv
import io

import numpy as np
import pytest

import kappabench as kb


def columns_of(text):
    rows = list(csv.DictReader(io.StringIO(text, newline="")))
    return {name.split(" (")[0]: [row[name] for row in rows] for name in rows[0]}


def same(cells, words):
    """Cells of a table and the words of a CSV."""
    if isinstance(cells, list):
        return cells == words
    numbers = np.array([float(word) if word else np.nan for word in words])
    return np.array_equal(np.asarray(cells, dtype=float), numbers, equal_nan=True)


def test_compare_is_the_programs_table(program, tmp_path):
    schemes = ["kappa", "ekappa:a=0.9", "fpc", "hobby", "kappa:iteration=published,max_iterations=1"]
    table = kb.compare(["toy", "bird"], schemes)
    words = columns_of(program("compare", "toy", "bird", "--schemes", ",".join(schemes), "--format", "csv"))
    assert list(table) == list(words)
    assert table.rows == len(words["scheme"]) == 25
    for name, cells in table.items():
        assert same(cells, words[name]), name
    assert "not_converged" in table["outcome"]
    assert table.units["bending_energy"] == "1"
    assert isinstance(table["points"], np.ndarray) and table["points"].dtype.kind == "i"
    assert len(str(table).splitlines()) == 26 and str(table).startswith("dataset")


def test_compare_takes_arrays_and_many(five):
    one = kb.compare(five, "hobby")
    assert one["dataset"] == ["points"] and one["scheme"] == ["hobby"]
    assert kb.compare(five.tolist(), "hobby")["dataset"] == ["points"]
    many = kb.compare([five, kb.Points(five, closed=True), "toy", kb.read("bird")], ["hobby", "kappa"], threads=3)
    assert many["dataset"][:2] == ["points 0", "points 0"] and many.rows == 14
    again = kb.compare([five, kb.Points(five, closed=True), "toy", kb.read("bird")], ["hobby", "kappa"], threads=1)
    assert str(many) == str(again)


def test_what_a_scheme_refuses_is_a_row(five):
    table = kb.compare(five[:1], ["kappa", "hobby"], metrics="fairness")
    assert table["outcome"] == ["unsupported_input"] * 2 and table.rows == 2
    with pytest.raises(ValueError, match="unknown metric 'fairnes'"):
        kb.compare(five, "kappa", metrics=["fairnes"])
    with pytest.raises(ValueError, match="unknown scheme"):
        kb.compare(five, ["kapa"])


def test_measure_is_a_row_of_compare():
    table = kb.compare("toy", "ekappa:a=0.9")
    measured = kb.measure(kb.fit("toy", "ekappa", a=0.9))
    assert set(measured) <= set(table)
    for name, number in measured.items():
        assert np.array_equal(number.value, table[name][0], equal_nan=True), name
        assert number.unit == table.units[name] and number.method in ("exact", "enclosed", "sampled")
    assert measured["curvature_extrema"].method == "exact"
    assert list(kb.measure(kb.fit("toy", "kappa"), "fairness")) == [
        column["name"] for metric in kb.metrics() if metric["id"] == "fairness" for column in metric["columns"]
    ]


def test_results_are_the_reports_tables(program, tmp_path):
    program("compare", "toy", "--schemes", "kappa,hobby", "-o", tmp_path)
    results = kb.open_results(tmp_path / "results.h5")
    assert list(results) == ["compare"] and "commit" in results.provenance
    compare = results["compare"]
    files = {file.stem: file for file in tmp_path.glob("**/*.csv")}
    assert files
    for name, table in compare.tables.items():
        stem = name if name.startswith("compare") else f"compare-{name}"
        words = columns_of(files[stem].read_bytes().decode())
        assert list(table) == list(words)
        for column, cells in table.items():
            assert same(cells, words[column]), (name, column)
    assert compare.cells["label"] == ["kappa", "hobby"] and compare.cells["outcome"] == ["converged"] * 2
    assert compare.claims.rows == 0
    assert np.array_equal(compare.curve(0)(0.5), kb.fit("toy", "kappa")(0.5))
    with pytest.raises(KeyError, match="there are compare"):
        results["toy"]
    with pytest.raises(ValueError, match="no cell 7; there are 2"):
        compare.curve(7)


def test_files_that_are_no_results(tmp_path):
    file = tmp_path / "no.h5"
    with pytest.raises(ValueError, match="no.h5"):
        kb.open_results(file)
    file.write_text("nothing")
    with pytest.raises(ValueError, match="no.h5"):
        kb.open_results(file)


def test_pandas_takes_a_table(five):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(kb.compare(five, ["kappa", "hobby"]))
    assert list(frame["scheme"]) == ["kappa", "hobby"]
