"""Planar curves through points, fitted, measured and compared by kappabench.

>>> import kappabench as kb
>>> c = kb.fit([[0, 0], [4, -1], [5, 3], [2, 5], [-1, 3]], "ekappa", a=0.8, closed=True)
>>> c.report.outcome
'converged'
>>> c([0, 0.5, 1]).shape
(3, 2)

Bad input raises ValueError with one line that says what is wrong and what would be right. A fit that does not converge
raises nothing: its `report` says so.
"""

from ._curve import Curve, Joint, Node
from ._catalogue import datasets, load_plugin, metrics, schemes
from ._fit import fit
from ._json import curves_from_json
from ._measure import Measurement, compare, measure
from ._plot import plot
from ._points import Drawing, Points, read
from ._results import Experiment, Results, open_results
from ._tables import Table

__all__ = [
    "Curve",
    "Drawing",
    "Experiment",
    "Joint",
    "Measurement",
    "Node",
    "Points",
    "Results",
    "Table",
    "compare",
    "curves_from_json",
    "datasets",
    "fit",
    "load_plugin",
    "measure",
    "metrics",
    "open_results",
    "plot",
    "read",
    "schemes",
]
