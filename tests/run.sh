#!/usr/bin/env bash
# Installs what is missing, builds, and passes every test. Usage: tests/run.sh [release|debug|asan|ci]
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:-${CI:+ci}}
preset=${preset:-release}
.ci/install_packages.sh .ci/packages.txt
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --preset "$preset" --parallel "$(nproc)"
