"""What authors do to the helper: print, raise, return what is no list of segments, as the parameter `kind` says."""
import os

import kappabench_scheme as ks

print("loaded")


def fit(points, closed, parameters, options):
    kind = parameters["kind"]
    print("fitting", len(points), "points")
    os.system("echo from a child")
    if kind == "raises":
        return 1 // 0
    if kind == "refuses":
        raise ks.Unsupported("more than %d points" % (len(points) - 1))
    if kind == "nan":
        return [ks.bezier(points[0], (float("nan"), 0.0))]
    if kind == "nothing":
        return None
    segments = [ks.bezier(p, q) for p, q in zip(points, points[1:])]
    if kind == "more":
        return ks.Answer(segments, iterations=3, counters={"steps": 2}, message="fine")
    return segments


ks.serve(fit)
