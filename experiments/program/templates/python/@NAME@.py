"""@TITLE@.

Try it: kappabench fit bird --plugin @NAME@.toml --scheme @NAME@ -o bird.svg
        kappabench check @NAME@ --plugin @NAME@.toml
"""
import kappabench_scheme as ks  # first: from here on printing goes to standard error


def tangents(points, closed, tension):
    """TODO: your idea goes here. This one, of Catmull and Rom, takes the chord between the two neighbours."""
    n = len(points)
    found = []
    for i in range(n):
        if closed or 0 < i < n - 1:
            (x0, y0), (x1, y1) = points[i - 1], points[(i + 1) % n]
            found.append((tension * (x1 - x0), tension * (y1 - y0)))
        else:
            (x0, y0), (x1, y1) = (points[0], points[1]) if i == 0 else (points[n - 2], points[n - 1])
            found.append((x1 - x0, y1 - y0))
    return found


def fit(points, closed, parameters, options):
    """Points to segments: ks.bezier, ks.rational, ks.clothoid, ks.elliptic_arc, or ks.sampled for what has no formula."""
    n = len(points)
    v = tangents(points, closed, parameters["tension"])
    segments = []
    for i in range(n if closed else n - 1):
        j = (i + 1) % n
        (x0, y0), (x1, y1) = points[i], points[j]
        before, after = (x0 + v[i][0] / 3, y0 + v[i][1] / 3), (x1 - v[j][0] / 3, y1 - v[j][1] / 3)
        segments.append(ks.bezier(points[i], before, after, points[j]))
    return segments


ks.serve(fit)
