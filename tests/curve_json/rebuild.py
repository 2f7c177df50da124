#!/usr/bin/env python3
"""Rebuilds curves from schemes/api/CURVE_JSON.md alone and holds them against the program.

Usage: rebuild.py KAPPABENCH
For schemes that between them use every type of segment, the JSON of a fit is evaluated by the formulas of that page and
compared with the positions that the program itself writes (--format csv). The types that no scheme makes are compared in
a round trip, through `kappabench measure` (tests/integration/measure_verb.cpp), and here with a curve known otherwise.
"""

import csv
import io
import json
import math
import subprocess
import sys

TOLERANCE = 1e-12  # of the drawing: the integrals below are good to that

# Gauss and Legendre's rule with five points, on [-1, 1].
GAUSS = [
    (0.0, 128.0 / 225.0),
    *[
        (sign * math.sqrt(5.0 - 2.0 * math.sqrt(10.0 / 7.0)) / 3.0, (322.0 + 13.0 * math.sqrt(70.0)) / 900.0)
        for sign in (-1.0, 1.0)
    ],
    *[
        (sign * math.sqrt(5.0 + 2.0 * math.sqrt(10.0 / 7.0)) / 3.0, (322.0 - 13.0 * math.sqrt(70.0)) / 900.0)
        for sign in (-1.0, 1.0)
    ],
]


def integral(f, a, b, parts=64):
    total = 0.0
    for i in range(parts):
        middle, half = a + (b - a) * (i + 0.5) / parts, 0.5 * (b - a) / parts
        total += half * sum(w * f(middle + half * x) for x, w in GAUSS)
    return total


def weighted(weights, points):
    return [sum(w * p[k] for w, p in zip(weights, points)) for k in (0, 1)]


def bernstein(n, t):
    return [math.comb(n, i) * t**i * (1.0 - t) ** (n - i) for i in range(n + 1)]


def polynomial(s, t):
    return weighted(bernstein(len(s["control_points"]) - 1, t), s["control_points"])


def rational(s, t):
    w = [b * w for b, w in zip(bernstein(len(s["weights"]) - 1, t), s["weights"])]
    return [c / sum(w) for c in weighted(w, s["control_points"])]


def trigonometric(s, t):
    x = math.pi * t / 2.0
    u, v, w = 1.0 - math.sin(x), math.sin(x) + math.cos(x) - 1.0, 1.0 - math.cos(x)
    return weighted([u * u, 2 * u * v, 4 * u * w, 2 * v * w, w * w], s["control_points"])


def along(start, length, heading, t):
    return [start[0] + length * integral(lambda v: math.cos(heading(v)), 0.0, t),
            start[1] + length * integral(lambda v: math.sin(heading(v)), 0.0, t)]


def clothoid(s, t):
    length = s["length"]

    def heading(v):
        return s["angle"] + s["curvature"] * length * v + 0.5 * s["curvature_rate"] * (length * v) ** 2

    return along(s["start"], length, heading, t)


def basis_function(knots, i, n, t):
    if n == 0:
        return 1.0 if knots[i] <= t < knots[i + 1] or (t == knots[i + 1] == knots[-1] and knots[i] < t) else 0.0
    left, right = knots[i + n] - knots[i], knots[i + n + 1] - knots[i + 1]
    value = 0.0
    if left > 0.0:
        value += (t - knots[i]) / left * basis_function(knots, i, n - 1, t)
    if right > 0.0:
        value += (knots[i + n + 1] - t) / right * basis_function(knots, i + 1, n - 1, t)
    return value


def intrinsic(s, t):
    n, k, knots = s["degree"], s["control_curvatures"], [0.0, *s["knots"], 1.0]
    breaks = sorted({q for q in knots if q < t} | {t})

    def curvature(v):
        return sum(c * basis_function(knots, i, n, v) for i, c in enumerate(k))

    x, y, turned, before = s["start"][0], s["start"][1], s["angle"], 0.0
    for end in breaks:
        if end == before:
            continue
        parts = 24
        for i in range(parts):  # the heading is integrated along with the position
            a, b = before + (end - before) * i / parts, before + (end - before) * (i + 1) / parts

            def heading(v, a=a, turned=turned):
                return turned + s["length"] * integral(curvature, a, v, 1)

            x += s["length"] * integral(lambda v: math.cos(heading(v)), a, b, 1)
            y += s["length"] * integral(lambda v: math.sin(heading(v)), a, b, 1)
            turned = heading(b)
        before = end
    return [x, y]


def elliptic_arc(s, t):
    w = s["from"] + (s["to"] - s["from"]) * t
    return [s["centre"][k] + s["axis_a"][k] * math.cos(w) + s["axis_b"][k] * math.sin(w) for k in (0, 1)]


def reparametrized(s, t):
    m = s["start_speed"]
    return evaluate(s["of"], m * t / (1.0 + (m - 1.0) * t))


def blend(s, t):
    v, w = math.cos(math.pi * t / 2.0) ** 2, math.sin(math.pi * t / 2.0) ** 2
    first, second = evaluate(s["from"], t), evaluate(s["to"], t)
    g = [a - b for a, b in zip(evaluate(s["from"], 0.0), evaluate(s["to"], 0.0))]
    h = [b - a for a, b in zip(evaluate(s["from"], 1.0), evaluate(s["to"], 1.0))]
    return [v * first[k] + w * second[k] + v * w * (v * g[k] + w * h[k]) for k in (0, 1)]


def sampled(s, t):
    j = max(i for i in range(len(s["t"]) - 1) if s["t"][i] <= t)
    h = s["t"][j + 1] - s["t"][j]

    def of(x, y, i):
        return s[x][i], s[y][i]

    (p0, v0, a0), (p1, v1, a1) = (
        (of("x", "y", i), of("dx", "dy", i), of("ddx", "ddy", i)) for i in (j, j + 1))
    controls = [
        p0,
        [p0[k] + h * v0[k] / 5.0 for k in (0, 1)],
        [p0[k] + 2.0 * h * v0[k] / 5.0 + h * h * a0[k] / 20.0 for k in (0, 1)],
        [p1[k] - 2.0 * h * v1[k] / 5.0 + h * h * a1[k] / 20.0 for k in (0, 1)],
        [p1[k] - h * v1[k] / 5.0 for k in (0, 1)],
        p1,
    ]
    return weighted(bernstein(5, (t - s["t"][j]) / h), controls)


KINDS = {f.__name__: f for f in (polynomial, rational, trigonometric, clothoid, intrinsic, elliptic_arc,
                                 reparametrized, blend, sampled)}


def evaluate(segment, t):
    return KINDS[segment["type"]](segment, t)


def kinds_in(segment):
    inner = [segment[key] for key in ("of", "from", "to") if isinstance(segment.get(key), dict)]
    return {segment["type"]}.union(*[kinds_in(s) for s in inner])


def output(program, drawing, scheme, form):
    return subprocess.run([program, "fit", drawing, "--scheme", scheme, "--format", form], check=True,
                          capture_output=True, text=True).stdout


def worst_miss(program, drawing, scheme):
    curves = json.loads(output(program, drawing, scheme, "json"))
    rows = list(csv.DictReader(io.StringIO(output(program, drawing, scheme, "csv"))))
    size = max(abs(float(row[axis])) for row in rows for axis in "xy")
    kinds = set().union(*[kinds_in(s) for curve in curves for s in curve["segments"]])
    worst = 0.0
    for row in rows[::7]:
        place = evaluate(curves[int(row["curve"])]["segments"][int(row["segment"])], float(row["t"]))
        worst = max(worst, math.dist(place, (float(row["x"]), float(row["y"]))) / size)
    return worst, kinds


def main():
    program = sys.argv[1]
    seen = set()
    failures = 0
    for scheme in ("kappa", "ekappa-trig", "pkappa", "clothoid3", "euler-spiral", "intrinsic", "yuksel", "yuksel:arc=elliptical",
                   "yuksel:parametrization=c2", "hobby"):
        # Two of Yuksel's local curves are blended where a curve has more than three points.
        worst, kinds = worst_miss(program, "bird" if scheme.startswith("yuksel") else "toy", scheme)
        seen |= kinds
        failures += not worst <= TOLERANCE
        print(f"{scheme}: {', '.join(sorted(kinds))}: {worst:.1e} of the drawing")

    # A quarter of the unit circle, which the program never writes in these forms.
    circle = {"type": "rational", "control_points": [[1, 0], [1, 1], [0, 1]], "weights": [1, math.sqrt(0.5), 1]}
    turn = math.pi / 2.0
    angles = [turn * i / 16 for i in range(17)]
    samples = {"type": "sampled", "t": [i / 16 for i in range(17)],
               "x": [math.cos(w) for w in angles], "y": [math.sin(w) for w in angles],
               "dx": [-turn * math.sin(w) for w in angles], "dy": [turn * math.cos(w) for w in angles],
               "ddx": [-turn**2 * math.cos(w) for w in angles], "ddy": [-turn**2 * math.sin(w) for w in angles]}
    for segment in (circle, samples):
        seen |= kinds_in(segment)
        worst = max(abs(math.hypot(*evaluate(segment, i / 50)) - 1.0) for i in range(51))
        limit = 1e-15 if segment is circle else 1e-10  # the quintic between 16 samples
        failures += not worst <= limit
        print(f"{segment['type']}: the radius of a circle is off by {worst:.1e}")

    if seen != set(KINDS):
        failures += 1
        print(f"not tried: {', '.join(sorted(set(KINDS) - seen))}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
