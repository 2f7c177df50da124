"""What there is: schemes, metrics, built-in drawings, and plugins that bring more schemes."""

from __future__ import annotations

import functools
import os
import warnings
from typing import Any, Union

from . import _core

_registry = _core.Registry()


@functools.lru_cache(maxsize=256, typed=True)
def chosen_scheme(text: str, **parameters: Any) -> _core.Scheme:
    """The scheme of "ekappa" with a=0.8, or of "ekappa:a=0.8"."""
    if not parameters:
        return _registry.parse(text)
    if ":" in text:
        raise ValueError(f"{text}: parameters stand in the text or are given by name, not both")
    try:
        return _registry.create(text, {name: getattr(value, "item", lambda v=value: v)() for name, value in parameters.items()})
    except TypeError:
        raise ValueError(f"{text}: parameters are numbers, True or False, or words; given are {parameters}") from None


def schemes() -> list[dict[str, Any]]:
    """All schemes, those of plugins included.

    Returns
    -------
    list of dict
        id, title, citation, version; open, closed, fewest_open_points, fewest_closed_points, continuity,
        continuity_exceptions, locality, hermite; parameters (each name, default, range, help), marks, libraries, plugin (the file of one
        from outside, else empty).
    """
    return _registry.list()


def metrics() -> list[dict[str, Any]]:
    """All metrics.

    Returns
    -------
    list of dict
        id, title, version, columns (each name, unit, help). `metrics/README.md` defines them.
    """
    return _core.metrics()


def datasets() -> list[dict[str, Any]]:
    """The built-in drawings, which `read` opens.

    Returns
    -------
    list of dict
        id, title, stands_in_for, source, licence, units, curves, points.
    """
    return [
        {
            "id": drawing.id,
            "title": drawing.title,
            "stands_in_for": drawing.stands_in_for,
            "source": drawing.source,
            "licence": drawing.licence,
            "units": drawing.units,
            "curves": len(drawing.curves),
            "points": sum(len(curve) for curve in drawing.curves),
        }
        for drawing in _core.builtin_drawings()
    ]


def load_plugin(path: Union[str, "os.PathLike[str]"]) -> list[str]:
    """Adds schemes from outside: a shared library, or the manifest (.toml) of an external program.

    They run in, or are asked by, this process: a library that crashes ends it.

    Parameters
    ----------
    path : str or path

    Returns
    -------
    list of str
        The ids that it brought.

    Raises
    ------
    ValueError
        One line: why it cannot be used.
    """
    before = {info["id"] for info in schemes()}
    _registry.load_plugin(os.fspath(path))
    return [info["id"] for info in schemes() if info["id"] not in before]


def load_plugins_of_environment() -> None:
    """Those that the variable KAPPABENCH_PLUGINS names, a warning for each that cannot be used."""
    for path in filter(None, os.environ.get("KAPPABENCH_PLUGINS", "").split(os.pathsep)):
        try:
            load_plugin(path)
        except ValueError as refused:
            warnings.warn(f"KAPPABENCH_PLUGINS: {refused}", stacklevel=2)


load_plugins_of_environment()
