"""Fitting."""

from __future__ import annotations

from typing import Optional, Union

from . import _core
from ._catalogue import chosen_scheme
from ._curve import Curve
from ._points import Options, PointsLike, one_curve


def fit(
    points: PointsLike,
    scheme: str,
    /,
    *,
    closed: Optional[bool] = None,
    options: Optional[Options] = None,
    **parameters: Union[bool, int, float, str],
) -> Curve:
    """The curve through points by a scheme.

    The interpreter's lock is released meanwhile: fits in several threads run at once.

    Parameters
    ----------
    points : array_like of shape (n, 2), Points, Drawing of one curve, id or file
    scheme : str
        "ekappa", or with parameters "ekappa:a=0.8"; `schemes` lists them.
    closed : bool, optional
        Default: what the points say, and of an array False.
    options : optional
        Per-point options, as of `Points`. Default: what the points say.
    **parameters
        Of the scheme: ``a=0.8``.

    Returns
    -------
    Curve
        Look at its `report.outcome`: "converged", or "not_converged" (there may be a curve, which misses what the scheme
        claims of it), or "failed" (without a curve, so that evaluation raises ValueError).

    Raises
    ------
    ValueError
        If the scheme cannot take the input (too few points, coincident ones, numbers that are not finite, open or
        closed where it must not be), for unknown schemes and parameters, and values out of range.

    Examples
    --------
    >>> c = fit([[0, 0], [2, 1], [4, 0], [2, -3]], "ekappa", a=0.9, closed=True, options={1: {"a": 0.7}})
    >>> round(c.length, 3) > 0
    True
    """
    try:
        chosen = chosen_scheme(scheme, **parameters)
    except TypeError:  # not hashable
        raise ValueError(f"{scheme}: parameters are numbers, True or False, or words; given are {parameters}") from None
    fitted = _core.fit(chosen, one_curve(points, closed, options))
    curve = Curve(fitted)
    if not fitted.has_curve and fitted.report.outcome == "unsupported_input":
        raise ValueError(f"{scheme}: {fitted.report.message}")
    return curve
