#!/usr/bin/env bash
# Installs what is missing, builds, runs every experiment, and writes results/index.html.
# Arguments go to `kappabench reproduce`: experiment ids, -o FOLDER, -j N.
set -euo pipefail
here=$PWD
cd "$(dirname "$0")/.."

preset=${CI:+ci}
preset=${preset:-release}
.ci/install_packages.sh .ci/packages.txt
cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" --target kappabench
program=$PWD/build/$preset/experiments/kappabench
cd "$here"
exec "$program" reproduce "$@"
