#!/usr/bin/env bash
# .ci/lint.sh format               every C++ file is as clang-format writes it
# .ci/lint.sh tidy BUILD [FILE...]  clang-tidy is clean, for these files or all; BUILD: a folder built by
#                                   -DKAPPABENCH_PCH=OFF, for clang cannot read GCC's precompiled headers
# .ci/lint.sh changed BUILD         clang-tidy, for what changed since main, or since the last commit of main
# Sources that BUILD leaves out (of optional libraries) are left out here, too.
set -euo pipefail
cd "$(dirname "$0")/.."

tidy() {
  local build=$1
  shift
  local built=()
  for file in "$@"; do
    ! grep -qF "/$file\"" "$build/compile_commands.json" || built+=("$file")
  done
  [ ${#built[@]} -gt 0 ] || return 0
  printf '%s\0' "${built[@]}" | xargs -0 -P "$(nproc)" -n 2 clang-tidy-14 --quiet -p "$build" --warnings-as-errors='*'
}

# The sources that differ from where this branch left main, in commits and in the working tree. A header is checked
# with the source of its name.
changed_sources() {
  local base
  base=$(git merge-base HEAD origin/main 2>/dev/null || git merge-base HEAD main 2>/dev/null || git rev-parse HEAD)
  [ "$base" != "$(git rev-parse HEAD)" ] || base=$(git rev-parse -q --verify HEAD~1 || echo HEAD)
  git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.hpp' ':!tests' ':!*/templates/*' | sed 's/\.hpp$/.cpp/' | sort -u |
    while read -r file; do [ ! -f "$file" ] || echo "$file"; done
}

case ${1:-} in
  format)
    mapfile -t files < <(git ls-files '*.cpp' '*.hpp' ':!*/templates/*')
    clang-format-14 --dry-run --Werror "${files[@]}" ;;
  tidy)
    build=${2:?the build folder}
    files=("${@:3}")
    [ ${#files[@]} -gt 0 ] || mapfile -t files < <(git ls-files '*.cpp' ':!tests' ':!*/templates/*')
    tidy "$build" "${files[@]}" ;;
  changed)
    mapfile -t files < <(changed_sources)
    tidy "${2:?the build folder}" "${files[@]}" ;;
  *) echo "usage: .ci/lint.sh format | tidy BUILD [FILE...] | changed BUILD" >&2; exit 2 ;;
esac
