#!/usr/bin/env bash
# Builds the Python package kappabench and installs it where `import kappabench` finds it: in the virtual environment
# that is active, else among the user's own packages of /usr/bin/python3. Debian's rule for its Python (PEP 668) is about
# pip; nothing of the system is touched.
# Usage: experiments/python/install.sh [--to FOLDER]
#   --to FOLDER   there instead; the line that makes Python look there is printed
#   PYTHON=...    the interpreter, if it is to be another one
set -euo pipefail
cd "$(dirname "$0")/../.."

to=
case ${1:-} in
  "") ;;
  --to)
    mkdir -p "${2:?the folder}"
    to=$(cd "$2" && pwd) ;;
  *) echo "usage: experiments/python/install.sh [--to FOLDER]" >&2; exit 2 ;;
esac

python=${PYTHON:-${VIRTUAL_ENV:+$VIRTUAL_ENV/bin/python3}}
python=${python:-/usr/bin/python3}
.ci/install_packages.sh .ci/packages.txt .ci/python_packages.txt
if ! "$python" -c "import numpy" 2>/dev/null; then
  echo "kappabench: $python has no numpy; install it there, or take another interpreter: PYTHON=/usr/bin/python3" >&2
  exit 2
fi

site=$to
if [ -z "$site" ] && "$python" -c "import sys; sys.exit(sys.prefix == sys.base_prefix)"; then
  site=$("$python" -c "import sysconfig; print(sysconfig.get_path('platlib'))")
elif [ -z "$site" ]; then
  site=$("$python" -c "import site; print(site.getusersitepackages() if site.ENABLE_USER_SITE else '')")
  if [ -z "$site" ]; then
    echo "kappabench: $python does not look among the user's packages; say where to: --to FOLDER" >&2
    exit 2
  fi
fi

build=${KAPPABENCH_BUILD:-build/python-module}
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DKAPPABENCH_PYTHON=ON -DKAPPABENCH_TESTS=OFF \
  -DPython_EXECUTABLE="$python" -DKAPPABENCH_PYTHON_SITE="$site" >/dev/null
cmake --build "$build" --target kappabench_python_package
cmake --install "$build" --component python >/dev/null

cd /
PYTHONPATH=$to${PYTHONPATH:+:$PYTHONPATH} "$python" -c "
import kappabench as kb
print('kappabench is in', kb.__path__[0] + ':', len(kb.schemes()), 'schemes')"
[ -z "$to" ] || echo "export PYTHONPATH=$to\${PYTHONPATH:+:\$PYTHONPATH}"
