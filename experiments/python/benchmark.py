"""What Python costs: kb.fit against Scheme::fit, evaluation against the same batches in C++ alone.

    python3 experiments/python/benchmark.py

Bars: a fit within 20 us of C++, a million points within twice its time.
"""

import statistics
import time

import numpy as np

import kappabench as kb
from kappabench import _core
from kappabench._catalogue import chosen_scheme


def median_seconds(work, repetitions):
    """The median time of a call."""
    seconds = []
    for _ in range(repetitions):
        start = time.perf_counter()
        work()
        seconds.append(time.perf_counter() - start)
    return statistics.median(seconds)


def fits():
    print(f"{'fit':<24} {'points':>6} {'kb.fit':>10} {'C++':>10} {'over C++':>10}   {'solver alone':>12}")
    rng = np.random.default_rng(1)
    for scheme in ["kappa", "ekappa:a=0.8", "fpc", "catmull-rom", "yuksel"]:
        for count in [5, 20, 200]:
            angle = 2.0 * np.pi * np.arange(count) / count
            points = np.stack([np.cos(angle), np.sin(angle)], axis=1) * (1.0 + 0.2 * rng.random((count, 1)))
            given = kb.Points(points, closed=True)
            name, _, text = scheme.partition(":")
            parameters = {"a": 0.8} if text else {}
            repetitions = 500 if count < 200 else 50
            # By turns, so that a busy machine slows both.
            python, cpp = [], []
            for _ in range(5):
                python.append(median_seconds(lambda: kb.fit(points, name, closed=True, **parameters), repetitions))
                cpp.append(_core.fit_seconds(chosen_scheme(name, **parameters), given._input, repetitions))
            python, cpp = min(python), min(cpp)
            alone = kb.fit(points, name, closed=True, **parameters).report.seconds
            print(
                f"{scheme:<24} {count:>6} {python * 1e6:>7.1f} us {cpp * 1e6:>7.1f} us {(python - cpp) * 1e6:>7.1f} us"
                f"   {alone * 1e6:>9.1f} us"
            )


def points():
    count = 1_000_000
    rng = np.random.default_rng(1)
    print(f"\n{count} points           {'kb':>9} {'C++':>9} {'ratio':>6}")
    for scheme in ["kappa", "ekappa", "ekappa-trig", "yuksel", "euler-spiral", "intrinsic"]:
        if scheme not in [info["id"] for info in kb.schemes()]:
            continue
        c = kb.fit(kb.read("toy")[0], scheme)
        ascending = np.linspace(0.0, len(c), count, endpoint=False)
        anyhow = rng.permutation(ascending)
        works = {
            "c(t)": (0, lambda: c(ascending)),
            "c(t), t shuffled": (0, lambda: c(anyhow)),
            "c(t, nu=1)": (1, lambda: c(ascending, nu=1)),
            "c.curvature(t)": (2, lambda: c.curvature(ascending)),
        }
        for what, (order, work) in works.items():
            ours, cpp = [], []
            for _ in range(5):
                ours.append(median_seconds(work, 1))
                cpp.append(median_seconds(lambda: _core.checksum(c._fitted, count, order), 1))
            ours, cpp = min(ours), min(cpp)
            print(f"{scheme + ', ' + what:<32} {ours * 1e3:>6.1f} ms {cpp * 1e3:>6.1f} ms {ours / cpp:>6.2f}")


if __name__ == "__main__":
    fits()
    points()
