"""A fitted curve."""

from __future__ import annotations

import functools
import json
from typing import Any, NamedTuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._points import Points

Floats = Union[np.float64, NDArray[np.float64]]


class Node(NamedTuple):
    """Where a curve passes through an input point. A point may have several (a loop has two)."""

    point: int
    """Index of the input point."""
    t: float
    """Parameter of the curve: `curve(node.t)` is the point."""
    segment: int
    marks: list[str]
    """What the scheme says of the node: "pinned", ..."""


class Joint(NamedTuple):
    """Where two segments meet."""

    t: float
    """Parameter of the curve; of the last joint of a closed one its end."""
    segment: int
    """The segment that ends here."""
    claimed: str
    """The continuity that the scheme claims: "G0", "G1", "G1 |k|", "G2", "C1", "C2"."""


class Curve:
    """A curve through points, made by `fit` or read by `curves_from_json`. Immutable.

    Its parameter t runs over the whole curve, a unit a segment: segment k is [k, k + 1]. At a joint the segment after it
    is taken. Closed curves are periodic in t; outside of an open one is a ValueError. NaN gives NaN. Derivatives and
    curvature are analytic. t may be a number or an array of any shape, and every method works on all of it at once,
    without the interpreter's lock.
    """

    def __init__(self, fitted: _core.Fitted) -> None:
        self._fitted = fitted

    def __call__(self, t: ArrayLike, nu: int = 0) -> NDArray[np.float64]:
        """Points of the curve, or derivatives.

        Parameters
        ----------
        t : array_like
            Parameters, 0 to the number of segments.
        nu : int
            Order of the derivative with respect to t, 0 to 4.

        Returns
        -------
        ndarray, shape of t + (2,)

        Raises
        ------
        ValueError
            For t outside of an open curve, nu that is none of 0 to 4, and if there is no curve.
        """
        return self._fitted.derivative(t, _order(nu, 4))

    def curvature(self, t: ArrayLike, nu: int = 0) -> Floats:
        """Signed curvature, 1/length, positive where the curve turns left; or its derivative.

        Parameters
        ----------
        t : array_like
        nu : int
            Order of the derivative with respect to arc length, 0 to 2; unit 1/length^(nu + 1).

        Returns
        -------
        float or ndarray of the shape of t
            Not finite where the speed vanishes (a cusp).
        """
        return self._fitted.curvature(t, _order(nu, 2))[()]

    def tangent(self, t: ArrayLike) -> NDArray[np.float64]:
        """Unit tangents, shape of t + (2,); NaN where the speed vanishes."""
        velocity = self(t, nu=1)
        with np.errstate(invalid="ignore", divide="ignore"):
            return velocity / np.hypot(velocity[..., :1], velocity[..., 1:])

    @functools.cached_property
    def _arcs(self) -> _core.ArcMap:
        return _core.ArcMap(self._fitted)

    @property
    def length(self) -> float:
        """Arc length, to a relative 1e-10 or the rounding of the coordinates; worse only where it is not smooth."""
        return self._arcs.length

    def arc_length(self, t: ArrayLike) -> Floats:
        """Arc length from the start of the curve to t, of the shape of t. Round a closed curve it goes on growing."""
        return self._arcs.lengths(self._fitted, t)[()]

    def at_length(self, s: ArrayLike) -> Floats:
        """The parameters t with `arc_length(t)` = s, of the shape of s; s outside of an open curve gives its ends.

        Examples
        --------
        >>> import numpy as np
        >>> c = fit("toy", "kappa")  # doctest: +SKIP
        >>> evenly = c(c.at_length(np.linspace(0, c.length, 101)))  # doctest: +SKIP
        """
        return self._arcs.parameters(self._fitted, s)[()]

    @property
    def closed(self) -> bool:
        return self._fitted.closed

    def __len__(self) -> int:
        """The number of segments: t runs from 0 to there."""
        return self._fitted.size

    @functools.cached_property
    def segments(self) -> list[dict[str, Any]]:
        """The defining numbers of each segment, as curve JSON has them: `schemes/api/CURVE_JSON.md` has the formulas."""
        return self._json["segments"]

    @functools.cached_property
    def nodes(self) -> list[Node]:
        """Where the curve passes through its points."""
        return [Node(*node) for node in self._fitted.nodes]

    @functools.cached_property
    def joints(self) -> list[Joint]:
        """Where its segments meet."""
        return [Joint(*joint) for joint in self._fitted.joints]

    @property
    def report(self) -> _core.Report:
        """How the fit went: outcome, message, warnings, iterations, residual, trace, counters, seconds."""
        return self._fitted.report

    @property
    def points(self) -> Points:
        """The points that were fitted."""
        return Points._of(self._fitted.input)

    @property
    def scheme(self) -> str:
        """The scheme's id."""
        return self._fitted.scheme.id

    @property
    def parameters(self) -> dict[str, Any]:
        """All parameters of the scheme with their values."""
        return self._fitted.scheme.parameters

    @property
    def label(self) -> str:
        """For legends: "ekappa a=0.9", the parameters that differ from their defaults."""
        return self._fitted.scheme.label

    @functools.cached_property
    def _json(self) -> dict[str, Any]:
        found = json.loads(self.to_json())
        return found[0] if isinstance(found, list) else found

    def to_json(self) -> str:
        """The curve as JSON of format "kappabench-curve", which `curves_from_json` and any program read back."""
        return self._fitted.text("json")

    def to_svg(self) -> str:
        """A picture; polynomial segments up to cubics are exact in it."""
        return self._fitted.text("svg")

    def __repr__(self) -> str:
        closed = "closed" if self.closed else "open"
        segments = f"{len(self)} segments" if self._fitted.has_curve else "no curve"
        return f"<kappabench.Curve {self.label}: {closed}, {segments}, {self.report.outcome}>"


def _order(nu: int, most: int) -> int:
    if not 0 <= nu <= most:
        raise ValueError(f"nu = {nu}; give 0 to {most}")
    return nu
