#!/usr/bin/env bash
# A plugin made by `new-scheme --plugin`, and plugins with every kind of trouble, built against an installed kappabench.
# Usage: run.sh SOURCE BUILD
set -euo pipefail
source=$1
build=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$build" --prefix "$scratch/prefix" >/dev/null
kappabench=$scratch/prefix/bin/kappabench
cd "$scratch"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# expect STATUS TEXT COMMAND...: the command ends with that status and says TEXT.
expect() {
  local status=0 wanted=$1 text=$2
  shift 2
  "$@" >out 2>&1 || status=$?
  [ "$status" -eq "$wanted" ] || fail "status $status, not $wanted, of: $*: $(tail -3 out)"
  grep -qF -- "$text" out || fail "no '$text' from: $*: $(tail -3 out)"
}

# As the README says.
"$kappabench" new-scheme my-spline my-spline --plugin >next
grep -q 'cmake -S my-spline' next
cmake -S my-spline -B my-spline/build -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_CXX_FLAGS="${PLUGIN_FLAGS:-}" >/dev/null
cmake --build my-spline/build >/dev/null
plugin=my-spline/build/my_spline.so
expect 0 "continuity     held" "$kappabench" check my-spline --plugin "$plugin"
expect 0 '"outcome":"converged"' "$kappabench" fit bird --plugin "$plugin" --scheme my-spline:tension=0.4
expect 0 "my-spline" "$kappabench" compare toy --plugin "$plugin" --format csv
expect 0 "my_spline.so)" "$kappabench" list schemes --plugin "$plugin"
KAPPABENCH_PLUGINS=$plugin expect 0 "my-spline" "$kappabench" compare toy --schemes my-spline,kappa
expect 2 "is there already" "$kappabench" new-scheme my-spline my-spline --plugin
expect 2 "is no id of a scheme" "$kappabench" new-scheme My_Spline other --plugin
expect 2 "a scheme 'kappa' already" "$kappabench" new-scheme kappa other --plugin

# Trouble.
cmake -S "$source/tests/plugin_example" -B bad -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_CXX_FLAGS="${PLUGIN_FLAGS:-}" >/dev/null
cmake --build bad -j 2 >/dev/null
refused() { # LIBRARY TEXT: one line, by name and by list
  expect 2 "$2" "$kappabench" fit bird --plugin "bad/$1.so" --scheme kappa
  [ "$(wc -l <out)" -eq 1 ] || fail "more than a line of $1: $(cat out)"
}
refused no_entry "no function kappabench_plugin"
refused other_stamp "interface=0, and this program has interface=1"
refused undefined "cannot be loaded: undefined symbol"
refused crash_at_load "crashed when it was tried (Segmentation fault)"
refused exit_at_load "ended the process when it was tried (status 7)"
refused nothing "registers no scheme"
refused hang_at_load "took longer than 10 s"
refused nowhere "no such file"
cp next bad/text.so
refused text "cannot be loaded"
mkdir bad/folder.so
refused folder "a folder; name the shared library in it"
refused crash_when_made_in_fit "crashed when it was tried (Segmentation fault)"
refused bad_id_in_fit "registers a scheme 'My Spline:a=1'; an id has"
refused taken_id_in_fit "bad/taken_id_in_fit.so: there is a scheme 'kappa' already"
expect 0 "not loaded: bad/no_entry.so" "$kappabench" list schemes --plugin bad/no_entry.so
KAPPABENCH_PLUGINS=bad/no_entry.so:$plugin expect 0 "not loaded: bad/no_entry.so" "$kappabench" list schemes
grep -q '^my-spline' out || fail "a good plugin beside a bad one is not there"
KAPPABENCH_PLUGINS=bad/no_entry.so expect 0 "not loaded" "$kappabench" fit bird --scheme kappa -o bird.json
expect 0 '"not_loaded": "bad/no_entry.so' "$kappabench" list schemes --json --plugin bad/no_entry.so
KAPPABENCH_PLUGINS=$plugin:$plugin expect 0 '"outcome":"converged"' "$kappabench" fit bird --plugin "$plugin" --scheme my-spline
expect 3 "failed: the plugin throws: no such" "$kappabench" fit bird --plugin bad/throw_in_fit.so --scheme trouble
expect 3 "converged, and returns no curve" "$kappabench" fit bird --plugin bad/no_curve_in_fit.so --scheme trouble
expect 3 "crashed: Segmentation fault" "$kappabench" fit bird --plugin bad/crash_in_fit.so --scheme trouble
printf 'seed = 1\n[[experiment]]\nid = "compare"\nschemes = ["kappa", "trouble"]\ndatasets = ["toy"]\n' >plan.toml
for trouble in crash hang; do
  expect 3 "1 cells crashed, timed out or failed" \
    "$kappabench" run plan.toml --plugin "bad/${trouble}_in_fit.so" -o "$trouble.h5" --timeout 3
done
echo "plugins: all as they should be"
