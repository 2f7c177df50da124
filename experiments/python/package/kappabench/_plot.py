"""Pictures of curves: the curve with its comb, and its curvature over arc length."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import NDArray

from ._curve import Curve

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Okabe and Ito's palette and darker tones, as in the reports: colour-blind readers tell them apart.
_palette = [
    "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9",
    "#882255", "#332288", "#999933", "#661100", "#44AA99", "#777777",
]  # fmt: skip
_longest_tooth = 0.22  # over the size of the drawing
_between_teeth = 0.012  # the same
_dark = "#404040"


class _Samples(NamedTuple):
    """A curve seen closely, a row of `position` for each element of the others; NaN between segments."""

    position: NDArray[np.float64]
    normal: NDArray[np.float64]
    curvature: NDArray[np.float64]
    s: NDArray[np.float64]


def plot(
    curves: Union[Curve, Sequence[Curve]],
    comb: bool = True,
    curvature: bool = False,
    *,
    ax: Any = None,
    labels: Union[str, Sequence[str], None] = None,
    points: bool = True,
    joints: bool = True,
    nodes: bool = True,
    comb_scale: Optional[float] = None,
) -> Any:
    """Draws curves over one another, with matplotlib.

    Curves of one label (by default scheme and parameters) have one colour. One that did not converge is dashed, and its
    label says so. Input points are squares, joints circles, nodes dots; in the curvature plot nodes are dots and joints
    ticks below.

    Parameters
    ----------
    curves : Curve or sequence of Curve
    comb : bool
        With curvature combs, on the outer side of the bend, all of one scale. Curvature beyond both 3 times what 95 % of
        the length stays below and 20 over the size of the drawing is cut off.
    curvature : bool
        Also the curvature over arc length, in axes of its own.
    ax : Axes, or a pair of Axes if `curvature`, optional
        Default: of a new figure.
    labels : str or sequence of str, optional
        One for all, or one for each.
    points, joints, nodes : bool
        What to mark. Nodes are marked in the plane only where there is one label.
    comb_scale : float, optional
        Length of the comb's tooth for curvature 1. Default: the longest is 0.22 of the drawing's size.

    Returns
    -------
    Axes, or an array of two if `curvature`
    """
    curves = [curves] if isinstance(curves, Curve) else list(curves)
    if not curves:
        raise ValueError("no curves; give at least one")
    names = _names(curves, labels)
    axes = _axes(ax, curvature)
    samples = [_sampled(curve) for curve in curves]
    colours = {name: _palette[i % len(_palette)] for i, name in enumerate(dict.fromkeys(names))}
    if comb:
        _draw_combs(axes[0], curves, samples, [colours[name] for name in names], comb_scale)
    for curve, name, seen in zip(curves, names, samples):
        _draw_curve(axes[0], curve, name, seen, colours[name])
    _mark(axes[0], curves, points, joints, nodes and len(colours) == 1)
    axes[0].set_aspect("equal", adjustable="box" if _shared(axes[0]) else "datalim")
    axes[0].set_axis_off()
    if curvature:
        for curve, name, seen in zip(curves, names, samples):
            _draw_curvature(axes[1], curve, name, seen, colours[name], joints, nodes)
        _finish_curvature(axes[1], samples)
    for one in axes[:1] if ax is None else axes:
        _add_legend(one, len(colours) > 1 or any(curve.report.outcome != "converged" for curve in curves))
    return axes if curvature else axes[0]


def _shared(ax: Axes) -> bool:
    """Has it its limits together with others, both ways? Then they cannot give way to the aspect."""
    return all(len(group.get_siblings(ax)) > 1 for group in (ax.get_shared_x_axes(), ax.get_shared_y_axes()))


def _names(curves: list[Curve], labels: Union[str, Sequence[str], None]) -> list[str]:
    if labels is None:
        names = [curve.label for curve in curves]
    else:
        names = [labels] * len(curves) if isinstance(labels, str) else list(labels)
    if len(names) != len(curves):
        raise ValueError(f"{len(names)} labels for {len(curves)} curves; give one for each")
    return [
        name if curve.report.outcome == "converged" else f"{name} ({curve.report.outcome.replace('_', ' ')})"
        for name, curve in zip(names, curves)
    ]


def _axes(ax: Any, curvature: bool) -> NDArray[Any]:
    wanted = 2 if curvature else 1
    if ax is None:
        import matplotlib.pyplot as plt

        size = (9.6, 4.4) if curvature else (5.6, 4.8)
        return plt.subplots(1, wanted, figsize=size, layout="constrained", squeeze=False)[1][0]
    axes = np.atleast_1d(np.asarray(ax, dtype=object)).ravel()
    if len(axes) != wanted:
        raise ValueError(f"{len(axes)} axes; give {'a pair: of the curve and of the curvature' if curvature else 'one'}")
    return axes


def _sampled(curve: Curve) -> Optional[_Samples]:
    if not curve._fitted.has_curve:
        return None
    count = int(np.clip(40000 // len(curve), 9, 129))
    within = np.linspace(0.0, 1.0, count)
    t = np.arange(len(curve))[:, None] + within
    t[:, -1] = np.nextafter(t[:, -1], 0.0)  # the end of this segment, not the start of the next one
    tangent = curve.tangent(t)
    normal = np.stack([-tangent[..., 1], tangent[..., 0]], axis=-1)
    parts = curve(t), normal, curve.curvature(t), curve.arc_length(t)
    return _Samples(*(_with_gaps(part) for part in parts))


def _with_gaps(by_segment: NDArray[np.float64]) -> NDArray[np.float64]:
    """One after the other, a row of NaN between."""
    gap = np.full_like(by_segment[:, :1], np.nan)
    joined = np.concatenate([by_segment, gap], axis=1)
    return joined.reshape(-1, *by_segment.shape[2:])[:-1]


def _size(curves: list[Curve]) -> float:
    points = np.concatenate([curve.points.points for curve in curves])
    return float(np.ptp(points, axis=0).max()) or 1.0


def _limit(samples: list[Optional[_Samples]], least: float) -> float:
    """The curvature up to which pictures show it: peaks near cusps would make all else flat."""
    values, weights = [], []
    for seen in filter(None, samples):
        weight = np.diff(seen.s, append=np.nan)
        fine = np.isfinite(weight) & np.isfinite(seen.curvature)
        values.append(np.abs(seen.curvature[fine]))
        weights.append(weight[fine])
    value, weight = np.concatenate(values or [[0.0]]), np.concatenate(weights or [[1.0]])
    order = np.argsort(value)
    share = np.cumsum(weight[order])
    below = value[order][np.searchsorted(share, 0.95 * share[-1])]
    return float(min(value.max(), max(3.0 * below, least)))


def _draw_combs(
    ax: Axes,
    curves: list[Curve],
    samples: list[Optional[_Samples]],
    colours: list[str],
    scale: Optional[float],
) -> None:
    from matplotlib.collections import LineCollection

    size = _size(curves)
    limit = _limit(samples, 20.0 / size)
    if limit <= 0.0:
        return  # straight
    scale = _longest_tooth * size / limit if scale is None else scale
    for curve, seen, colour in zip(curves, samples, colours):
        if seen is None:
            continue
        tips = seen.position - scale * np.clip(seen.curvature, -limit, limit)[:, None] * seen.normal
        # Where the normal turns over, as in a cusp, the envelope would leap.
        leaps = np.linalg.norm(np.diff(tips, axis=0), axis=1) > 0.5 * scale * limit
        tips[1:-1][leaps[:-1] & leaps[1:]] = np.nan
        ax.plot(*np.insert(tips, 1 + np.flatnonzero(leaps), np.nan, axis=0).T, color=colour, lw=0.8, alpha=0.7)
        teeth = np.stack([seen.position, tips], axis=1)[_teeth(seen.s, tips, _between_teeth * size)]
        ax.add_collection(LineCollection(list(teeth), colors=colour, linewidths=0.5, alpha=0.45))


def _teeth(s: NDArray[np.float64], tips: NDArray[np.float64], distance: float) -> list[int]:
    """The samples that have a tooth: one each distance, and more where the tips run away from each other."""
    chosen: list[int] = []
    fine = np.flatnonzero(np.isfinite(s) & np.isfinite(tips).all(axis=1))
    last_s, last_x, last_y = -np.inf, np.inf, np.inf
    for i, length, (x, y) in zip(fine.tolist(), s[fine].tolist(), tips[fine].tolist()):
        if length - last_s >= distance or abs(x - last_x) + abs(y - last_y) >= 2.0 * distance:
            chosen.append(i)
            last_s, last_x, last_y = length, x, y
    return chosen


def _draw_curve(ax: Axes, curve: Curve, name: str, seen: Optional[_Samples], colour: str) -> None:
    x, y = ([], []) if seen is None else seen.position[np.isfinite(seen.position).all(axis=1)].T
    ax.plot(x, y, color=colour, lw=1.8, ls="-" if curve.report.outcome == "converged" else (0, (5, 2)), label=name)


def _mark(ax: Axes, curves: list[Curve], points: bool, joints: bool, nodes: bool) -> None:
    if points:
        given = np.concatenate([curve.points.points for curve in curves])
        ax.plot(*given.T, "s", color="black", ms=4.5, ls="none")
    for curve in curves:
        if not curve._fitted.has_curve:
            continue
        if joints and curve.joints:
            at = curve([joint.t for joint in curve.joints])
            ax.plot(*at.T, "o", mfc="white", mec=_dark, mew=0.9, ms=4.0, ls="none", zorder=2.4)
        if nodes and curve.nodes:
            at = curve([node.t for node in curve.nodes])
            ax.plot(*at.T, ".", color=_palette[4], ms=3.5, ls="none")


def _draw_curvature(
    ax: Axes, curve: Curve, name: str, seen: Optional[_Samples], colour: str, joints: bool, nodes: bool
) -> None:
    if seen is None:
        ax.plot([], [], color=colour, label=name)
        return
    line = "-" if curve.report.outcome == "converged" else (0, (5, 2))
    ax.plot(seen.s, seen.curvature, color=colour, lw=1.5, ls=line, label=name)
    if joints and curve.joints:
        s = curve.length * np.ones(len(curve.joints))
        inside = np.array([joint.t < len(curve) for joint in curve.joints])
        s[inside] = curve.arc_length([joint.t for joint in curve.joints if joint.t < len(curve)])
        ax.plot(s, np.full(len(s), 0.02), "|", color=colour, ms=6, transform=ax.get_xaxis_transform())
    if nodes and curve.nodes:
        t = [node.t for node in curve.nodes]
        ax.plot(curve.arc_length(t), curve.curvature(t), "o", color=colour, ms=3.5, ls="none")


def _finish_curvature(ax: Axes, samples: list[Optional[_Samples]]) -> None:
    longest = max((np.nanmax(seen.s) for seen in samples if seen is not None), default=1.0)
    limit = _limit(samples, 60.0 / longest)
    seen = [np.clip(one.curvature, -limit, limit) for one in samples if one is not None]
    if seen and limit > 0.0:
        least, most = min(np.nanmin(one) for one in seen), max(np.nanmax(one) for one in seen)
        least, most = min(least, 0.0), max(most, 0.0)
        ax.set_ylim(least - 0.1 * (most - least), most + 0.06 * (most - least))
    ax.axhline(0.0, color="#999999", lw=0.8, zorder=0)
    ax.margins(x=0.02)
    ax.spines[["top", "right"]].set_visible(False)
    ax.set_xlabel("arc length")
    ax.set_ylabel("curvature")


def _add_legend(ax: Axes, needed: bool) -> None:
    if not needed:
        return
    handles, names = ax.get_legend_handles_labels()
    once = dict(zip(names, handles))
    ax.legend(once.values(), once.keys(), loc="upper center", bbox_to_anchor=(0.5, 0.0), frameon=False, ncol=min(4, len(once)))
