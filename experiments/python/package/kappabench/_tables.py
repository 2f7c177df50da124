"""A table of results."""

from __future__ import annotations

from typing import Any, Iterable


class Table(dict):
    """A dict from the name of a column to its cells: an array of numbers, or a list of str.

    `pandas.DataFrame(table)` takes it as it is. A number that does not exist is NaN.

    Attributes
    ----------
    title, caption : str
    units : dict from str to str
        Of the columns of numbers: "1", "1/length", "rad", ...
    """

    def __init__(self, title: str, caption: str, columns: dict[str, Any], units: dict[str, str]) -> None:
        super().__init__(columns)
        self.title = title
        self.caption = caption
        self.units = units

    @property
    def rows(self) -> int:
        """How many."""
        return len(next(iter(self.values()), ()))

    def __str__(self) -> str:
        columns = [[name, *map(_short, cells)] for name, cells in self.items()]
        widths = [max(map(len, column)) for column in columns]
        return "\n".join(_line(row, widths) for row in zip(*columns))

    def __repr__(self) -> str:
        return f"<kappabench.Table {self.title!r}: {self.rows} rows, {len(self)} columns>"


def _short(cell: Any) -> str:
    return f"{cell:.4g}" if isinstance(cell, float) else str(cell)


def _line(row: Iterable[str], widths: list[int]) -> str:
    return "  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip()
