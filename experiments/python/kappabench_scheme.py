"""Your interpolation scheme in Python, as kappabench asks for it: copy this file beside your own and write

    import kappabench_scheme as ks

    def fit(points, closed, parameters, options):
        return [ks.bezier(p, q) for p, q in zip(points, points[1:])]

    ks.serve(fit)

points      n x 2 numpy array, or a list of [x, y] where numpy is not installed; row i is point i
closed      whether the curve returns to its first point
parameters  dict: a value for every [[parameter]] of the manifest
options     list of n dicts: what was said of each point (tangent in degrees, curvature, a, type, ...), mostly empty
returns     a list of segments, in order; or ks.Answer(segments, iterations=..., ...) to say more

Raise ks.Unsupported("why") for input that the scheme does not take, any other exception when it fails. Printing is safe
once this file is imported: standard output is the wire to kappabench, so what you print goes to standard error.
"""
import json
import os
import stat
import sys
import time
import traceback

try:
    import numpy
except ImportError:
    numpy = None


class Unsupported(Exception):
    """Input that the scheme does not take; the text says which."""


class Answer:
    """Segments, and any further fields of the curve JSON: outcome, message, iterations, residual, counters, nodes, joints."""

    def __init__(self, segments, **fields):
        self.fields = dict(fields, segments=list(segments))


def point(p):
    return [float(p[0]), float(p[1])]


def bezier(*control_points):
    """A Bezier piece of degree 1 to 5 from 2 to 6 control points."""
    return {"type": "polynomial", "control_points": [point(p) for p in control_points]}


def rational(control_points, weights):
    """A rational Bezier piece; weights above 0."""
    return {"type": "rational", "control_points": [point(p) for p in control_points], "weights": [float(w) for w in weights]}


def clothoid(start, angle, curvature, curvature_rate, length):
    """Curvature linear in arc length; the angle at the start in radians."""
    return {"type": "clothoid", "start": point(start), "angle": float(angle), "curvature": float(curvature),
            "curvature_rate": float(curvature_rate), "length": float(length)}


def elliptic_arc(centre, axis_a, axis_b, start, end):
    """centre + axis_a cos w + axis_b sin w, w from start to end in radians; the axes conjugate half diameters."""
    return {"type": "elliptic_arc", "centre": point(centre), "axis_a": point(axis_a), "axis_b": point(axis_b),
            "from": float(start), "to": float(end)}


def sampled(t, position, first, second):
    """What has no formula: positions and derivatives by t at ascending t from 0 to 1, each an m x 2 array or list."""
    columns = {"t": [float(x) for x in t]}
    for names, values in ((("x", "y"), position), (("dx", "dy"), first), (("ddx", "ddy"), second)):
        for axis in (0, 1):
            columns[names[axis]] = [float(value[axis]) for value in values]
    return dict(columns, type="sampled")


def _take_wire():
    """Standard output for us alone: what is printed, by libraries too, goes to standard error."""
    wire = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    sys.stdout = sys.stderr
    return wire


# At once if it is kappabench that asks, through a pipe; a notebook may import this and print as before.
_wire = _take_wire() if stat.S_ISFIFO(os.fstat(0).st_mode) else None


def _place(error):
    frame = traceback.extract_tb(error.__traceback__)[-1]
    return "%s:%d" % (os.path.basename(frame.filename), frame.lineno)


def _answer(fit, question):
    points = question["points"] if numpy is None else numpy.array(question["points"], float).reshape(-1, 2)
    start = time.perf_counter()
    try:
        answer = fit(points, question["closed"], question["parameters"], question["options"])
        fields = (answer if isinstance(answer, Answer) else Answer(answer)).fields
    except Unsupported as why:
        fields = {"outcome": "unsupported_input", "message": str(why), "segments": []}
    except Exception as error:
        traceback.print_exc()
        message = "%s: %s (%s)" % (type(error).__name__, error, _place(error))
        fields = {"outcome": "failed", "message": message, "segments": []}
    return dict(fields, format="kappabench-curve", version=2, seconds=time.perf_counter() - start)


def _plain(value):
    """numpy's numbers and arrays for json."""
    return value.tolist()


def serve(fit):
    """Answers kappabench until it has no more questions."""
    wire = _wire or _take_wire()
    for line in sys.stdin:
        answer = _answer(fit, json.loads(line))
        try:
            text = json.dumps(answer, default=_plain, allow_nan=False)
        except (AttributeError, TypeError, ValueError) as error:  # NaN is no JSON
            text = json.dumps({"outcome": "failed", "message": "answer: %s" % error, "segments": []})
        wire.write(text + "\n")
        wire.flush()
