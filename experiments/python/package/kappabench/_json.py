"""Curves from JSON."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Optional, Union

from . import _core
from ._catalogue import _registry
from ._curve import Curve
from ._points import PointsLike, one_curve


def curves_from_json(source: Union[str, "os.PathLike[str]"], points: Optional[PointsLike] = None) -> list[Curve]:
    """The curves of curve JSON ("kappabench-curve", version 1 or 2), whoever made them.

    Parameters
    ----------
    source : str or path
        A text that starts with "[" or "{", or the name of a file. `schemes/api/CURVE_JSON.md` is the format.
    points : what `fit` takes, optional
        The points that the curves are to be judged against. Default: the places of their nodes, or the ends of segments.

    Returns
    -------
    list of Curve
        One that misses these points or its own claims is "not_converged".

    Raises
    ------
    ValueError
        One line: which field of which curve is wrong, and what would be right.
    """
    text = str(source)
    name = "JSON"
    if isinstance(source, os.PathLike) or not text.lstrip().startswith(("[", "{")):
        name = os.fspath(source)
        try:
            text = Path(source).read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise ValueError(f"{name}: cannot be read ({getattr(error, 'strerror', None) or 'no UTF-8'})") from None
    given = None if points is None else one_curve(points, None, None)
    return [Curve(fitted) for fitted in _core.given_curves(text, name, _registry, given)]
