#!/usr/bin/env bash
# Installs what is missing, builds, and passes every test. Usage: tests/run.sh [release|debug|asan|ci|spiro]
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:-${CI:+ci}}
preset=${preset:-release}
lists=(.ci/packages.txt)
options=()
[ "$preset" != spiro ] || lists+=(.ci/spiro_packages.txt)
if [ "$preset" = ci ]; then  # what is optional is built and tested, too
  lists+=(.ci/python_packages.txt .ci/octave_packages.txt)
  options+=(-DKAPPABENCH_PYTHON=ON)
fi
.ci/install_packages.sh "${lists[@]}"
cmake --preset "$preset" "${options[@]}"
cmake --build --preset "$preset"
ctest --preset "$preset" --parallel "$(nproc)"
