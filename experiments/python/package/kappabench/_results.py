"""Results files of experiments."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from typing import Union

from . import _core
from ._curve import Curve
from ._json import curves_from_json
from ._tables import Table


class Experiment:
    """What an experiment of a results file found."""

    def __init__(self, results: _core.Results, name: str) -> None:
        self._results = results
        self.id, self.title, self.about, tables = results.describe(name)
        self.tables: dict[str, Table] = {key: Table(*table) for key, table in tables.items()}

    @property
    def cells(self) -> Table:
        """One row a drawing and scheme: dataset, scheme, parameters, label, outcome, message, curves, key."""
        return Table(*self._results.cells(self.id))

    @property
    def claims(self) -> Table:
        """One row a verdict: paper, claim, verdict, ours, evidence, method, kind, sample, interval, rule."""
        return Table(*self._results.claims(self.id))

    def curve(self, cell: int, curve: int = 0) -> Curve:
        """A curve of a cell, both by their places from 0. ValueError for a fit without a curve."""
        text = self._results.curve_json(self.id, cell, curve)
        if not text:
            raise ValueError(f"cell {cell}: no curve {curve}; {self.cells['outcome'][cell]}")
        return curves_from_json(text)[0]

    def __repr__(self) -> str:
        return f"<kappabench.Experiment {self.id}: {self.title}, {self.cells.rows} cells>"


class Results(Mapping[str, Experiment]):
    """A results file: its experiments by their ids, in their order.

    Attributes
    ----------
    provenance : dict from str to str
        Commit, compiler, flags, versions, seed, plan, ...
    """

    def __init__(self, results: _core.Results) -> None:
        self._results = results
        self.provenance: dict[str, str] = results.provenance

    def __getitem__(self, name: str) -> Experiment:
        if name not in self._results.experiments:
            raise KeyError(f"{name}; there are {', '.join(self._results.experiments)}")
        return Experiment(self._results, name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._results.experiments)

    def __len__(self) -> int:
        return len(self._results.experiments)

    def __repr__(self) -> str:
        return f"<kappabench.Results: {', '.join(self)}>"


def open_results(file: Union[str, "os.PathLike[str]"]) -> Results:
    """A results file of `kappabench run`, `reproduce` or `compare -o`, as tables.

    Raises
    ------
    ValueError
        For a file that is missing, damaged, foreign or of another version, one line.

    Examples
    --------
    >>> results = open_results("results.h5")  # doctest: +SKIP
    >>> pandas.DataFrame(results["compare"].tables["compare"])  # doctest: +SKIP
    """
    return Results(_core.read_results(os.fspath(file)))
