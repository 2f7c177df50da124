"""Points to interpolate: from arrays, from files, from the drawings that are built in."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any, Iterator, Optional, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

PointOptions = Mapping[str, Union[float, str]]
Options = Union[Sequence[Optional[PointOptions]], Mapping[int, PointOptions]]


class Points:
    """A sequence of points to interpolate, closed or open, with what is said of single points.

    Parameters
    ----------
    points : array_like, shape (n, 2)
        A row each, finite.
    closed : bool
        Does the last point lead back to the first? It must not repeat it.
    options : sequence of dict or None, one a point; or dict from index to dict
        Per-point options under their names in files of points: ``type`` ("regular", "cusp", "loop", "inflection"),
        ``a``, ``h``, ``alpha``, ``beta``, ``tangent`` (degrees against the x axis, anticlockwise), ``curvature``
        (1/length, positive to the left). A scheme reads what it knows.

    Raises
    ------
    ValueError
        For another shape, what is no number, an unknown option.
    """

    __slots__ = ("_input",)

    def __init__(self, points: ArrayLike, closed: bool = False, options: Optional[Options] = None) -> None:
        self._input = _core.Input(_rows(points), bool(closed), _said(options, points))

    @classmethod
    def _of(cls, given: _core.Input) -> Points:
        points = cls.__new__(cls)
        points._input = given
        return points

    @property
    def points(self) -> NDArray[np.float64]:
        """A new array of shape (n, 2)."""
        return self._input.points

    @property
    def closed(self) -> bool:
        return self._input.closed

    @property
    def options(self) -> list[dict[str, Any]]:
        """One dict a point, or an empty list if nothing is said of any."""
        return self._input.options

    def __len__(self) -> int:
        return len(self._input)

    def __array__(self, dtype: Any = None) -> NDArray[Any]:
        return self.points if dtype is None else self.points.astype(dtype)

    def __repr__(self) -> str:
        return f"<kappabench.Points: {len(self)}, {'closed' if self.closed else 'open'}>"


class Drawing(Sequence[Points]):
    """A named sequence of curves to interpolate, with where it comes from."""

    __slots__ = ("_drawing",)

    def __init__(self, drawing: _core.Drawing) -> None:
        self._drawing = drawing

    @property
    def id(self) -> str:
        return self._drawing.id

    @property
    def title(self) -> str:
        return self._drawing.title

    @property
    def source(self) -> str:
        return self._drawing.source

    @property
    def licence(self) -> str:
        return self._drawing.licence

    @property
    def units(self) -> str:
        return self._drawing.units

    @property
    def curves(self) -> list[Points]:
        return [Points._of(curve) for curve in self._drawing.curves]

    def __len__(self) -> int:
        return len(self._drawing.curves)

    @overload
    def __getitem__(self, index: int) -> Points: ...
    @overload
    def __getitem__(self, index: slice) -> list[Points]: ...
    def __getitem__(self, index: Union[int, slice]) -> Union[Points, list[Points]]:
        return self.curves[index]

    def __iter__(self) -> Iterator[Points]:
        return iter(self.curves)

    def __repr__(self) -> str:
        return f"<kappabench.Drawing {self.id}: {self.title or 'no title'}, {len(self)} curves>"


PointsLike = Union[str, "os.PathLike[str]", Points, Drawing, ArrayLike]


def read(name: Union[str, "os.PathLike[str]"]) -> Drawing:
    """A drawing by its id, or from a file.

    Parameters
    ----------
    name : str or path
        The id of a built-in drawing ("bird", see `datasets`), a file (.txt, .pts, .csv, .toml),
        "glyph:FONT:CHAR", "random:KIND:n=..,seed=.." or "analytic:KIND:n=..,sampling=..".

    Returns
    -------
    Drawing
        A sequence of `Points`, one a curve.

    Raises
    ------
    ValueError
        If there is no such thing, or the file is wrong: file, line, what would be right.
    """
    drawings = _core.open_drawings(os.fspath(name))
    if len(drawings) != 1:
        raise ValueError(f"{name}: {len(drawings)} drawings; read one of them")
    return Drawing(drawings[0])


def one_curve(points: PointsLike, closed: Optional[bool], options: Optional[Options]) -> _core.Input:
    """What is to be fitted, as one input; `closed` and `options` go before what the points themselves say."""
    if isinstance(points, (str, os.PathLike)):
        points = read(points)
    if isinstance(points, Drawing):
        if len(points) != 1:
            raise ValueError(f"{points.id}: {len(points)} curves; fit one of them: fit({points.id}[0], ...)")
        points = points[0]
    if isinstance(points, Points):
        if closed is None and options is None:
            return points._input
        closed = points.closed if closed is None else closed
        options = points.options if options is None else options
        points = points.points
    return _core.Input(_rows(points), bool(closed), _said(options, points))


def _rows(points: ArrayLike) -> NDArray[np.float64]:
    try:
        rows = np.asarray(points, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError("points are not numbers in rows of two; give an array of shape (n, 2)") from None
    if rows.size == 0:
        return rows.reshape(0, 2)
    if rows.ndim == 2 and rows.shape[0] == 2 and rows.shape[1] != 2:
        raise ValueError(f"points are of shape {rows.shape}; a row is a point: give them transposed, {rows.T.shape}")
    if rows.ndim != 2 or rows.shape[1] != 2:
        raise ValueError(f"points are of shape {rows.shape}; a row is a point: give shape (n, 2)")
    return rows


def _said(options: Optional[Options], points: ArrayLike) -> list[dict[str, str]]:
    """One dict a point, values as words: they are read as a file's are."""
    if not options:
        return []
    if isinstance(options, Mapping):
        count = len(np.asarray(points))
        for index in options:
            if not (isinstance(index, (int, np.integer)) and 0 <= index < count):
                raise ValueError(f"options: {index!r} is no index of a point; give 0 to {count - 1}")
        options = [options.get(index) for index in range(count)]
    return [{key: _word(value) for key, value in (said or {}).items()} for said in options]


def _word(value: Union[float, str]) -> str:
    return value if isinstance(value, str) else repr(float(value))
