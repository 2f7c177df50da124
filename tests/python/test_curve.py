"""Curves: points, derivatives, curvature and lengths, for arrays of any shape."""

import csv
import io

import numpy as np
import pytest
from conftest import decoded

import kappabench as kb


@pytest.mark.parametrize("scheme", ["kappa", "ekappa-trig", "fpc", "yuksel", "hobby"])
def test_numbers_are_those_of_the_programs_csv(program, scheme):
    rows = list(csv.DictReader(io.StringIO(program("fit", "toy", "--scheme", scheme, "--format", "csv"))))
    c = kb.fit("toy", scheme)
    inside = [row for row in rows if float(row["t"]) < 1.0]  # the end of a segment is the start of the next one
    assert len(inside) == 32 * len(c)
    t = np.array([float(row["segment"]) + float(row["t"]) for row in inside])
    column = {name: np.array([float(row[name]) for row in inside]) for name in ["x", "y", "s", "kappa"]}
    assert np.array_equal(c(t), np.stack([column["x"], column["y"]], axis=1))
    assert np.array_equal(c.curvature(t), column["kappa"])
    assert np.allclose(c.arc_length(t), column["s"], rtol=1e-8, atol=1e-8 * c.length)


def test_shapes(five):
    c = kb.fit(five, "kappa", closed=True)
    assert c(0.5).shape == (2,)
    assert c([0.5]).shape == (1, 2)
    assert c(np.zeros((3, 4))).shape == (3, 4, 2)
    assert c([]).shape == (0, 2)
    for method in [c.curvature, c.arc_length, c.at_length]:
        assert isinstance(method(0.5), float)
        assert method(np.zeros((3, 4))).shape == (3, 4)
    assert c.tangent(np.zeros((3, 4))).shape == (3, 4, 2)
    assert np.array_equal(c(np.array([[0, 1], [2, 3]]))[1, 0], c(2))


def test_derivatives_are_those_of_the_points(five):
    c = kb.fit(five, "ekappa", closed=True)
    t, h = np.linspace(0.1, 4.93, 40), 1e-5
    for nu in range(1, 5):
        step = (c(t + h, nu=nu - 1) - c(t - h, nu=nu - 1)) / (2.0 * h)
        inside = np.floor(t - h) == np.floor(t + h)
        assert np.allclose(step[inside], c(t, nu=nu)[inside], rtol=1e-6, atol=1e-4)
    first, second = c(t, nu=1), c(t, nu=2)
    cross = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    assert np.allclose(c.curvature(t), cross / np.linalg.norm(first, axis=1) ** 3)
    by_length = (c.curvature(t + h) - c.curvature(t - h)) / (c.arc_length(t + h) - c.arc_length(t - h))
    assert np.allclose(by_length, c.curvature(t, nu=1), rtol=1e-4, atol=1e-5)
    assert np.allclose(np.linalg.norm(c.tangent(t), axis=1), 1.0)


def test_parameters_of_closed_curves_are_periodic_and_those_of_open_ones_end(five):
    closed, opened = kb.fit(five, "kappa", closed=True), kb.fit(five, "kappa")
    t = np.linspace(0.01, 4.9, 20)
    assert np.allclose(closed(t + 5.0), closed(t), atol=1e-12)
    assert np.allclose(closed(t - 10.0), closed(t), atol=1e-12)
    assert np.array_equal(closed(5.0), closed(0.0))
    assert closed.arc_length(5.0) == pytest.approx(closed.length, rel=1e-12)
    assert closed.arc_length(7.5) == pytest.approx(closed.length + closed.arc_length(2.5), rel=1e-12)
    assert np.allclose(opened(len(opened)), five[-1])
    for wrong in [-1e-9, len(opened) + 1e-9, np.inf]:
        with pytest.raises(ValueError, match="outside of the curve; give 0 to"):
            opened([0.5, wrong])
    assert np.isnan(opened([0.5, np.nan])[1]).all()
    with pytest.raises(ValueError, match="nu = 5; give 0 to 4"):
        opened(0.5, nu=5)


def test_arc_length_both_ways(five):
    c = kb.fit(five, "ekappa", closed=True)
    s = np.linspace(0.0, c.length, 50)
    assert np.allclose(c.arc_length(c.at_length(s)), s, atol=1e-9)
    steps = np.linalg.norm(np.diff(c(np.linspace(0, 5, 200001)), axis=0), axis=1).sum()
    assert c.length == pytest.approx(steps, rel=1e-8)


def test_nodes_and_joints(five):
    c = kb.fit(five, "kappa", closed=True)
    assert [node.point for node in c.nodes] == [0, 1, 2, 3, 4]
    assert np.allclose(c([node.t for node in c.nodes]), five, atol=1e-12)
    assert [joint.t for joint in c.joints] == [1, 2, 3, 4, 5]
    assert {joint.claimed for joint in c.joints} <= {"G2", "G1 |k|", "G1"}
    assert np.array_equal(c.points.points, five) and c.points.closed


def test_json_is_the_programs_and_reads_back(program, five, tmp_path):
    for drawing, scheme in [("toy", "ekappa"), ("loops-typed", "fpc"), ("toy", "yuksel")]:
        c = kb.fit(drawing, scheme)
        (ours,), (theirs,) = decoded(c.to_json()), decoded(program("fit", drawing, "--scheme", scheme))
        assert ours.pop("seconds") > 0 and theirs.pop("seconds") > 0
        assert ours == theirs
        file = tmp_path / f"{scheme}.json"
        file.write_text(c.to_json())
        for source in [c.to_json(), file, str(file)]:
            (again,) = kb.curves_from_json(source, c.points)
            assert again.label == c.label and again.report.outcome == "converged"
            t = np.linspace(0, len(c), 101)
            assert np.array_equal(again(t), c(t))
            assert again.nodes == c.nodes and again.joints == c.joints
            assert str(kb.measure(again)) == str(kb.measure(c))  # NaN is NaN
    by_nodes = kb.curves_from_json(kb.fit(five, "kappa", closed=True).to_json())[0]
    assert np.allclose(by_nodes.points.points, five)


def test_json_of_others_is_judged(five):
    line = '{"format":"kappabench-curve","version":2,"closed":false,"segments":[{"type":"polynomial","control_points":%s}]}'
    (c,) = kb.curves_from_json(line % "[[0,0],[1,1],[2,0]]")
    assert c.report.outcome == "converged" and np.array_equal(c(0.5), [1.0, 0.5])
    assert np.array_equal(c.points.points, [[0, 0], [2, 0]])
    (off,) = kb.curves_from_json(line % "[[0,0],[1,1],[2,0]]", [[0, 0], [1, 0.7], [2, 0]])
    assert off.report.outcome == "not_converged" and "misses its claim" in off.report.message
    with pytest.raises(ValueError, match="cannot be"):
        kb.measure(c, "locality")
    with pytest.raises(ValueError, match="control_points"):
        kb.curves_from_json(line % "[[0,0],[1]]")
    with pytest.raises(ValueError, match="no-such.json: cannot be read"):
        kb.curves_from_json("no-such.json")


def test_svg_is_the_programs(program):
    assert kb.fit("toy", "kappa").to_svg() == program("fit", "toy", "--scheme", "kappa", "--format", "svg")
