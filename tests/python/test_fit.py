"""kb.fit: the program's numbers, the program's refusals."""

import os
import threading
import time

import numpy as np
import pytest
from conftest import decoded

import kappabench as kb


@pytest.mark.parametrize("scheme", ["kappa", "ekappa:a=0.9", "fpc", "catmull-rom", "yuksel", "hobby"])
@pytest.mark.parametrize("drawing", ["bird", "toy", "loops-typed"])
def test_a_fit_is_the_programs_fit(program, scheme, drawing):
    ours = [kb.fit(points, scheme) for points in kb.read(drawing)]
    theirs = decoded(program("fit", drawing, "--scheme", scheme))
    assert len(ours) == len(theirs)
    for c, json in zip(ours, theirs):
        assert c.segments == json["segments"]
        assert (c.report.outcome, c.report.iterations) == (json["outcome"], json["iterations"])
        assert c.report.counters == json["counters"]
        assert c.closed == json["closed"]
        assert c.parameters == json["parameters"]
        assert [(n.point, n.segment, n.t - n.segment, n.marks) for n in c.nodes] == [
            (n["point"], n["segment"], pytest.approx(n["t"], abs=1e-13), n["marks"]) for n in json["nodes"]
        ]
        assert [(j.segment, j.claimed) for j in c.joints] == [(j["segment"], j["claimed"]) for j in json["joints"]]


def test_points_may_be_lists_arrays_names_and_files(five, tmp_path):
    file = tmp_path / "five.txt"
    file.write_text("closed\n" + "\n".join(f"{x} {y}" for x, y in five))
    at = kb.fit(five, "kappa", closed=True)(0.3)
    for points in [five.tolist(), kb.Points(five, closed=True), np.asfortranarray(five), five.astype(np.float32)]:
        assert np.array_equal(kb.fit(points, "kappa", closed=True)(0.3), at)
    for points in [file, str(file), kb.read(file)]:
        assert np.array_equal(kb.fit(points, "kappa")(0.3), at)
    assert not kb.fit(five, "kappa").closed
    assert not kb.fit(file, "kappa", closed=False).closed


def test_parameters_are_given_by_name_or_in_the_text(five):
    by_name = kb.fit(five, "ekappa", a=0.9, closed=True)
    assert by_name.parameters["a"] == 0.9
    assert by_name.label == "ekappa a=0.9"
    assert np.array_equal(by_name(0.3), kb.fit(five, "ekappa:a=0.9", closed=True)(0.3))
    assert np.array_equal(by_name(0.3), kb.fit(five, "ekappa", a=np.float64(0.9), closed=True)(0.3))
    assert not np.array_equal(by_name(0.3), kb.fit(five, "ekappa", closed=True)(0.3))
    assert kb.fit(five, "fpc", h=1, closed=True).parameters["h"] == 1.0  # a whole number for a number
    published = kb.fit(five, "kappa", iteration="published", max_iterations=np.int64(100), closed=True)
    assert published.parameters["max_iterations"] == 100


def test_options_of_points(five):
    cusp = kb.fit(five, "fpc", options={1: {"type": "cusp"}})
    at = [node.t for node in cusp.nodes if node.point == 1]
    assert np.linalg.norm(cusp(at[0], nu=1)) < 1e-6
    same = kb.fit(five, "fpc", options=[None, {"type": "cusp"}, {}, None, None])
    assert np.array_equal(cusp(0.5), same(0.5))
    points = kb.Points(five, options={2: {"a": 0.9, "tangent": 30.0}})
    assert points.options[2] == {"a": 0.9, "tangent": pytest.approx(30.0)}
    assert points.options[0] == {}
    assert np.array_equal(np.asarray(points), five)


@pytest.mark.parametrize(
    "given, said",
    [
        (lambda P: kb.fit(P.T, "kappa"), r"shape \(2, 5\); a row is a point: give them transposed, \(5, 2\)"),
        (lambda P: kb.fit(P[:, 0], "kappa"), r"shape \(5,\); a row is a point: give shape \(n, 2\)"),
        (lambda P: kb.fit([["a", "b"]], "kappa"), r"points are not numbers"),
        (lambda P: kb.fit([[0, 0], [1]], "kappa"), r"points are not numbers"),
        (lambda P: kb.fit([], "kappa"), r"0 points; an open curve needs at least"),
        (lambda P: kb.fit(P, "kapa"), r"unknown scheme 'kapa'; did you mean kappa"),
        (lambda P: kb.fit(P, "ekappa", a=2.0), r"scheme 'ekappa': a=2: allowed is a number in \[0.6667, 1\)"),
        (lambda P: kb.fit(P, "ekappa", b=2.0), r"unknown parameter 'b'; known are a"),
        (lambda P: kb.fit(P, "ekappa", a="x"), r"a=x: allowed is a number"),
        (lambda P: kb.fit(P, "ekappa", a=None), r"parameters are numbers, True or False, or words"),
        (lambda P: kb.fit(P, "ekappa", a=[0.8]), r"parameters are numbers, True or False, or words"),
        (lambda P: kb.fit(P, "ekappa:a=0.8", a=0.8), r"not both"),
        (lambda P: kb.fit(P[:2], "kappa", closed=True), r"kappa: 2 points; a closed curve needs at least 3"),
        (lambda P: kb.fit(P * [np.nan, 1], "kappa"), r"point 0 is not finite"),
        (lambda P: kb.fit(np.repeat(P, 2, axis=0), "kappa"), r"points 0 and 1 coincide; remove one of them"),
        (lambda P: kb.fit("bird", "kappa"), r"bird: 4 curves; fit one of them"),
        (lambda P: kb.fit("no-such-drawing", "kappa"), r"no-such-drawing"),
        (lambda P: kb.fit(P, "fpc", options={7: {"type": "cusp"}}), r"7 is no index of a point; give 0 to 4"),
        (lambda P: kb.fit(P, "fpc", options=[{}]), r"1 options for 5 points; give one for each"),
        (lambda P: kb.fit(P, "fpc", options={1: {"typ": "cusp"}}), r"point 1: unknown key \"typ\"; known are type"),
        (lambda P: kb.fit(P, "fpc", options={1: {"a": float("nan")}}), r"point 1: "),
        (lambda P: kb.load_plugin("no-such-plugin.so"), r"no-such-plugin"),
    ],
)
def test_what_is_wrong_is_one_line(five, given, said):
    with pytest.raises(ValueError, match=said) as refused:
        given(five)
    assert "\n" not in str(refused.value)


def test_a_fit_that_does_not_converge_says_so_and_raises_nothing():
    c = kb.fit(kb.read("bird")[0], "kappa", iteration="published", max_iterations=1)
    assert c.report.outcome == "not_converged"
    assert c.report.message
    assert np.isfinite(c(0.5)).all()
    assert "not_converged" in repr(c)


def test_reports(five):
    report = kb.fit(five, "kappa", closed=True).report
    assert report.outcome == "converged"
    assert 0.0 < report.seconds < 1.0
    assert len(report.trace) > 1 and report.residual < 1e-9
    assert isinstance(report.warnings, dict) and isinstance(report.iterations, int)


def test_catalogues_are_the_programs(program):
    assert kb.schemes() == decoded(program("list", "schemes", "--json"))
    assert kb.metrics() == decoded(program("list", "metrics", "--json"))
    assert kb.datasets() == decoded(program("list", "datasets", "--json"))


def test_the_lock_is_released():
    """A thread that fits and evaluates leaves the interpreter to others meanwhile."""
    points = kb.read("random:walk:n=3000,seed=1")[0]
    c = kb.fit(kb.read("toy")[0], "kappa")
    many = np.linspace(0.0, len(c), 3_000_000)
    for work in [lambda: kb.fit(points, "kappa"), lambda: c.curvature(many), lambda: kb.measure(kb.fit(points, "hobby"))]:
        worker = threading.Thread(target=work)
        start = time.perf_counter()
        worker.start()
        longest, last = 0.0, start
        while worker.is_alive():
            time.sleep(0.0005)
            now = time.perf_counter()
            longest, last = max(longest, now - last), now
        whole = last - start
        # With the lock held, this thread would have slept through all of it.
        assert longest < 0.7 * whole, f"no other thread ran for {longest:.3f} of {whole:.3f} s"


def test_fits_in_threads_are_fits(five):
    expected = kb.fit(five, "ekappa", closed=True)(np.linspace(0, 5, 50))
    wrong = []

    def work():
        for _ in range(50):
            if not np.array_equal(kb.fit(five, "ekappa", closed=True)(np.linspace(0, 5, 50)), expected):
                wrong.append(1)

    threads = [threading.Thread(target=work) for _ in range(max(4, os.cpu_count() or 1))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong
