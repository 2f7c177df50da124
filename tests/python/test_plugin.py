"""Schemes from outside: loaded, they are schemes like any other."""

from pathlib import Path

import numpy as np
import pytest

import kappabench as kb

folder = Path(__file__).parents[1] / "external_example"


@pytest.fixture(scope="module")
def outside():
    return kb.load_plugin(folder / "catmull_rom.toml")


def test_an_external_scheme_gives_the_curve_of_the_built_in_one(outside, five):
    assert outside == ["catmull-rom-python"]
    theirs, ours = kb.fit(five, "catmull-rom-python", alpha=1, closed=True), kb.fit(five, "catmull-rom:alpha=1", closed=True)
    assert theirs.report.outcome == "converged" and theirs.parameters == {"alpha": 1.0}
    t = np.linspace(0.0, 5.0, 101)
    assert np.allclose(theirs(t), ours(t), rtol=0, atol=1e-13)
    table = kb.compare(five, ["catmull-rom-python", "catmull-rom"])
    assert table["length_over_chords"][0] == pytest.approx(table["length_over_chords"][1], rel=1e-12)


def test_what_cannot_be_loaded_says_why(outside, tmp_path):
    with pytest.raises(ValueError, match="registered already"):
        kb.load_plugin(folder / "catmull_rom.toml")
    file = tmp_path / "mine.toml"
    file.write_text("id = 3\n")
    with pytest.raises(ValueError, match="mine.toml") as refused:
        kb.load_plugin(file)
    assert "\n" not in str(refused.value)
    assert "mine" not in str(kb.schemes())
