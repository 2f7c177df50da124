"""Pictures: drawn without warnings, with all that they are to show."""

import warnings

import matplotlib.pyplot as plt
import numpy as np
import pytest

import kappabench as kb


@pytest.fixture(autouse=True)
def no_warnings():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield
    plt.close("all")


def drawn(ax):
    ax.figure.canvas.draw()
    return ax


@pytest.mark.parametrize("curvature", [False, True])
@pytest.mark.parametrize("scheme", ["kappa", "fpc", "hobby", "yuksel"])
def test_every_scheme_and_kind_of_drawing(scheme, curvature):
    for drawing in ["bird", "loops-typed", "minimal-open", "all-collinear", "very-uneven"]:
        axes = kb.plot([kb.fit(points, scheme) for points in kb.read(drawing)], curvature=curvature)
        drawn(np.atleast_1d(axes)[0])


def test_a_curve_its_points_and_its_curvature(five):
    c = kb.fit(five, "kappa", closed=True)
    plane, graph = kb.plot(c, comb=False, curvature=True)
    line = plane.lines[0]
    assert line.get_label() == "kappa" and line.get_linestyle() == "-"
    assert np.allclose(np.asarray(line.get_xydata())[0], c(0.0))
    marks = [mark for mark in plane.lines if mark.get_marker() == "s"]
    assert np.array_equal(marks[0].get_xydata(), five)
    assert plane.get_aspect() == 1.0
    assert graph.get_xlabel() == "arc length" and graph.get_ylabel() == "curvature"
    s, kappa = graph.lines[0].get_xydata().T
    assert np.nanmax(s) == pytest.approx(c.length)
    assert np.nanmax(kappa) == pytest.approx(c.curvature(np.linspace(0, 5, 1001)).max(), rel=1e-2)
    assert plane.get_legend() is None


def test_schemes_over_one_another(five):
    curves = [kb.fit(five, name, closed=True) for name in ["kappa", "ekappa", "hobby"]]
    ax = drawn(kb.plot(curves))
    words = [text.get_text() for text in ax.get_legend().get_texts()]
    assert words == ["kappa", "ekappa", "hobby"]
    ax = kb.plot(curves, labels=["a", "b", "c"], ax=plt.figure().add_subplot())
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["a", "b", "c"]
    with pytest.raises(ValueError, match="1 labels for 3 curves"):
        kb.plot(curves, labels=["a"])
    with pytest.raises(ValueError, match="give a pair"):
        kb.plot(curves, curvature=True, ax=ax)
    with pytest.raises(ValueError, match="no curves"):
        kb.plot([])


def test_what_did_not_converge_is_dashed_and_says_so():
    c = kb.fit(kb.read("bird")[0], "kappa", iteration="published", max_iterations=1)
    ax = drawn(kb.plot(c, comb=False))
    assert ax.get_legend().get_texts()[0].get_text().endswith("(not converged)")
    assert ax.lines[0].get_linestyle() == "--"
