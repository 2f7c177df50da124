#!/usr/bin/env bash
# Installs what is missing, builds, and passes every test. Usage: tests/run.sh [release|debug|asan|ci|spiro]
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:-${CI:+ci}}
preset=${preset:-release}
lists=(.ci/packages.txt)
[ "$preset" != spiro ] || lists+=(.ci/spiro_packages.txt)
.ci/install_packages.sh "${lists[@]}"
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --preset "$preset" --parallel "$(nproc)"
