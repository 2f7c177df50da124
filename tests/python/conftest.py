import json
import os
import subprocess

import matplotlib
import numpy as np
import pytest

matplotlib.use("Agg")


@pytest.fixture(scope="session")
def program(tmp_path_factory):
    """Runs the program; skips where a test run has none (variable KAPPABENCH)."""
    path = os.environ.get("KAPPABENCH")
    if not path:
        pytest.skip("the variable KAPPABENCH does not name the program")

    def run(*arguments, status=0):
        ran = subprocess.run([path, *map(str, arguments)], capture_output=True, text=True, check=False)
        assert ran.returncode == status, ran.stderr
        return ran.stdout

    return run


@pytest.fixture
def five():
    return np.array([[0.0, 0.0], [4.0, -1.0], [5.0, 3.0], [2.0, 5.0], [-1.0, 3.0]])


def decoded(text):
    """The objects of curve JSON, an array or one object."""
    found = json.loads(text)
    return found if isinstance(found, list) else [found]
