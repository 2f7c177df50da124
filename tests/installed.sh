#!/usr/bin/env bash
# The installed program needs nothing of its source folder. Usage: installed.sh SOURCE BUILD
# Where the system lets us, an empty folder is put over SOURCE; else the program must not name it.
set -euo pipefail
source=$1
build=$2

work() {
  cd "$1"
  if [ -n "${2:-}" ]; then
    mount -t tmpfs none "$2"
    [ -z "$(ls -A "$2")" ]
  fi
  kappabench=$1/prefix/bin/kappabench
  "$kappabench" list datasets | grep -q '^bird '
  "$kappabench" list experiments >list.txt
  "$kappabench" fit bird --scheme kappa -o bird.json
  "$kappabench" compare toy --schemes kappa,catmull-rom -o compared >/dev/null
  "$kappabench" run pkappa-toy -o results.h5 -j 2 2>log
  "$kappabench" report results.h5 -o report 2>>log
  "$kappabench" reproduce pkappa-toy -o reproduced -j 2 >>log 2>&1
  grep -q 'Bézier\|Wang' reproduced/index.html  # the paper's words
}

if [ "$source" = --inside ]; then
  work "${@:2}"
  exit
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$build" --prefix "$scratch/prefix" >/dev/null
hide=()
for way in "unshare -m" "unshare -rm"; do
  if $way mount -t tmpfs none "$source" 2>/dev/null; then
    hide=($way)
    break
  fi
done
cp "$0" "$scratch/installed.sh"
if [ ${#hide[@]} -gt 0 ]; then
  "${hide[@]}" bash "$scratch/installed.sh" --inside "$scratch" "$source"
else
  echo "the source folder cannot be hidden here: looking for its name in the program"
  ! grep -qF "$source/" "$scratch/prefix/bin/kappabench"
  bash "$scratch/installed.sh" --inside "$scratch"
fi
