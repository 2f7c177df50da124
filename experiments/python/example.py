"""A walk through kappabench in Python, cell by cell (as Spyder, VS Code and Jupytext run it), or all at once:

    python3 experiments/python/example.py [FOLDER FOR THE PICTURES]
"""

# %% Everything starts with points: an array, a row each.
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import kappabench as kb

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
folder.mkdir(parents=True, exist_ok=True)


def save(name):
    plt.gcf().savefig(folder / f"{name}.png", dpi=130, bbox_inches="tight", pad_inches=0.15)


P = [[0, 0], [4, -1], [5, 3], [2, 5], [-1, 3]]
c = kb.fit(P, "ekappa", a=0.8, closed=True)
print(c)
print(c.report.outcome, "after", c.report.iterations, "iterations, residual", c.report.residual)

# %% A curve is a function of t, a unit a segment, for arrays of any shape.
t = np.linspace(0, len(c), 7)
print("points\n", c(t))
print("curvature", c.curvature(t))
print("length", c.length, "- half of it at t =", c.at_length(c.length / 2))

# %% Picture 1. The curve with its comb, and its curvature: εκ-curves peak in curvature at the points.
axes = kb.plot(c, curvature=True)
axes[0].set_title("εκ-curve, a = 0.8")
axes[1].set_title("curvature peaks at the points (dots)")
save("1-one-curve")

# %% Picture 2. One parameter, many values: a is the sharpness of the peaks.
fig, axes = plt.subplots(1, 2, figsize=(9.6, 4.6), layout="constrained")
family = [kb.fit(P, "ekappa", a=a, closed=True) for a in (2 / 3, 0.75, 0.85, 0.95)]
kb.plot(family, comb=False, curvature=True, joints=False, ax=axes, labels=[f"a = {f.parameters['a']:.2f}" for f in family])
axes[0].set_title("εκ-curves")
axes[1].set_title("the larger a, the higher the peaks")
axes[1].get_legend().remove()
save("2-one-parameter")

# %% Picture 3. Schemes over one another on a drawing that comes with the program.
bird = kb.read("bird")
print(bird, "licence:", bird.licence)
schemes = [name for name in ("kappa", "ekappa", "hobby", "catmull-rom") if name in {s["id"] for s in kb.schemes()}]
ax = kb.plot([kb.fit(points, scheme) for scheme in schemes for points in bird], comb=False, joints=False)
ax.figure.set_size_inches(6.4, 6.6)
ax.set_title("A bird by four schemes")
save("3-schemes")

# %% Picture 4. Combs side by side and to one scale: where curvature jumps, the comb does.
guitar = kb.read("guitar-body")
fig, axes = plt.subplots(1, len(schemes), figsize=(2.7 * len(schemes), 4.4), layout="constrained", sharex=True, sharey=True)
for scheme, ax in zip(schemes, axes):
    kb.plot([kb.fit(points, scheme) for points in guitar], ax=ax, comb_scale=100.0, joints=False, nodes=False)
    ax.set_title(scheme)
save("4-combs")

# %% Cusps where one wants them: options of single points. FPC-curves know them, other schemes ignore them.
heart = kb.fit([[0, 2], [2.2, 3.4], [3, 1.5], [0, -2.4], [-3, 1.5], [-2.2, 3.4]], "fpc", closed=True,
               options={0: {"type": "cusp"}, 3: {"type": "cusp"}})  # fmt: skip

# %% Picture 5. Two cusps.
axes = kb.plot(heart, curvature=True)
axes[0].set_title("FPC-curve with two cusps")
axes[1].set_title("curvature is cut off near the cusps")
save("5-cusps")

# %% Numbers: each says how it was got.
for name, number in kb.measure(c).items():
    if name in ("curvature_extrema", "bending_energy", "continuity_curvature_jump_all"):
        print(f"{name}: {number.value:.6g} [{number.unit}], {number.method}")

# %% A table over drawings and schemes; pandas.DataFrame(table) takes it.
table = kb.compare(["bird", "toy", c.points], schemes, metrics="fairness")
print(table)

# %% Picture 6. Any column is an array: iterations and bending energy of each fit.
fig, ax = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
names = np.array([f"{d} {i}" if d == "bird" else d.replace("points 2", "P") for d, i in zip(table["dataset"], table["curve"])])
places = {name: i for i, name in enumerate(dict.fromkeys(names))}
for j, (scheme, marker) in enumerate(zip(schemes, "os^D")):
    rows = np.array(table["scheme"]) == scheme
    x = np.array([places[name] for name in names[rows]]) + 0.12 * (j - 1.5)
    ax.plot(x, table["bending_energy"][rows], marker, ls="none", color=["#0072B2", "#D55E00", "#009E73", "#CC79A7"][j],
            label=scheme)  # fmt: skip
ax.set_xticks(range(len(places)), places)
ax.set_yscale("log")
ax.set_ylabel("bending energy, scale-free")
ax.grid(axis="y", color="#DDDDDD", lw=0.6)
ax.spines[["top", "right"]].set_visible(False)
ax.legend(frameon=False)
save("6-table")
