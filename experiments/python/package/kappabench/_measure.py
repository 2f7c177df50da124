"""Metrics of a curve, and tables of many."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import NamedTuple, Optional, Union

import numpy as np

from . import _core
from ._catalogue import chosen_scheme, schemes as all_schemes
from ._curve import Curve
from ._points import Drawing, Points, PointsLike, one_curve, read
from ._tables import Table


class Measurement(NamedTuple):
    """A number with how it was got."""

    value: float
    """NaN where it does not exist, infinite where it diverges."""
    unit: str
    method: str
    """"exact" (closed form or certified root isolation), "enclosed" (an interval known to hold it) or "sampled"."""


def measure(curve: Curve, metrics: Union[str, Sequence[str], None] = None) -> dict[str, Measurement]:
    """What metrics say of a curve.

    Parameters
    ----------
    curve : Curve
    metrics : str or sequence of str, optional
        Ids, see `kappabench.metrics`. Default: all but those that fit again many times (locality, invariance).

    Returns
    -------
    dict from str to Measurement
        By the names of the columns; `metrics/README.md` defines them.

    Raises
    ------
    ValueError
        For unknown metrics, without a curve, and if a metric has to fit again what cannot be.
    """
    found = _core.measure(curve._fitted, _words(metrics))
    return {column: Measurement(value, unit, method) for column, value, unit, method in found}


def compare(
    points: Union[PointsLike, Sequence[PointsLike]],
    schemes: Union[str, Sequence[str], None] = None,
    *,
    metrics: Union[str, Sequence[str], None] = None,
    threads: Optional[int] = None,
) -> Table:
    """Schemes on the same points: the table that the program's `compare` prints.

    A fit that did not converge, failed, or was refused is a row like any other, its numbers NaN if it has no curve.

    Parameters
    ----------
    points : what `fit` takes, a Drawing of several curves, or a list of such
    schemes : str or sequence of str, optional
        "kappa", "ekappa:a=0.8", ... Default: all.
    metrics : str or sequence of str, optional
        As of `measure`.
    threads : int, optional
        Fits at once. Default: one a processor.

    Returns
    -------
    Table
        One row a curve and scheme: dataset, curve, scheme, points, outcome, warnings, iterations, residual, pinned,
        at_inflection, then a column for each number of the metrics.
    """
    names = _words(schemes) or [info["id"] for info in all_schemes()]
    chosen = [chosen_scheme(name) for name in names]
    threads = threads or len(os.sched_getaffinity(0))
    return Table(*_core.compare(_drawings(points), chosen, _words(metrics), threads))


def _words(given: Union[str, Sequence[str], None]) -> list[str]:
    return [given] if isinstance(given, str) else list(given or [])


def _drawings(points: Union[PointsLike, Sequence[PointsLike]]) -> list[_core.Drawing]:
    if not _is_many(points):
        return [_drawing(points, "points")]
    return [_drawing(one, f"points {i}") for i, one in enumerate(points)]


def _is_many(points: Union[PointsLike, Sequence[PointsLike]]) -> bool:
    """A list of drawings, and not a list of points, whose elements are pairs of numbers?"""
    if not isinstance(points, (list, tuple)) or not points:
        return False
    first = points[0]
    return isinstance(first, (str, os.PathLike, Points, Drawing)) or np.ndim(first) == 2


def _drawing(points: PointsLike, name: str) -> _core.Drawing:
    if isinstance(points, (str, os.PathLike)):
        points = read(points)
    if isinstance(points, Drawing):
        return points._drawing
    return _core.Drawing(name, [one_curve(points, None, None)])
