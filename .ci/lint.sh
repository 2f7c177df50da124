#!/usr/bin/env bash
# .ci/lint.sh format: every C++ file as clang-format writes it. .ci/lint.sh tidy BUILD: clang-tidy clean.
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t sources < <(git ls-files '*.cpp' '*.hpp')
case ${1:-} in
  format) clang-format-14 --dry-run --Werror "${sources[@]}" ;;
  tidy)
    git ls-files '*.cpp' ':!tests' |
      xargs -P "$(nproc)" -n 4 clang-tidy-14 --quiet -p "${2:?the build folder}" --warnings-as-errors='*' ;;
  *) echo "usage: .ci/lint.sh format|tidy BUILD" >&2; exit 2 ;;
esac
