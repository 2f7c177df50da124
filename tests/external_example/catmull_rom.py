"""The cubic Catmull-Rom spline (Catmull and Rom 1974; Barry and Goldman 1988)."""
import math

import kappabench_scheme as ks


def slope(p, q, h):
    return [(b - a) / h for a, b in zip(p, q)]


def velocity(before, at, after, h0, h1):
    """That of the parabola through three points, h0 and h1 apart in the parameter."""
    return [(h1 * a + h0 * b) / (h0 + h1) for a, b in zip(slope(before, at, h0), slope(at, after, h1))]


def fit(points, closed, parameters, options):
    p = [(float(x), float(y)) for x, y in points]
    n = len(p)
    spans = [(i, (i + 1) % n) for i in range(n if closed else n - 1)]
    h = [math.dist(p[i], p[j]) ** parameters["alpha"] for i, j in spans]

    def v(i):
        if not closed and i == 0:
            return slope(p[0], p[1], h[0])
        if not closed and i == n - 1:
            return slope(p[i - 1], p[i], h[i - 1])
        return velocity(p[i - 1], p[i], p[(i + 1) % n], h[i - 1], h[i])

    def moved(q, direction, step):
        return [a + step * b for a, b in zip(q, direction)]

    return [ks.bezier(p[i], moved(p[i], v(i), h[i] / 3), moved(p[j], v(j), -h[i] / 3), p[j]) for i, j in spans]


ks.serve(fit)
