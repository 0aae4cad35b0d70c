#!/usr/bin/env bash
# Reads sources with clang-tidy (.clang-tidy) and says what it finds. Needs a configured build.
# Usage: scripts/lint.sh [FILE.cc ...]   (those that differ from main where none is given)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_BUILD_DIR:-$root/build}

command -v clang-tidy >/dev/null || { echo "there is no clang-tidy: apt-get install clang-tidy" >&2; exit 1; }
[ -f "$build/compile_commands.json" ] || { echo "no $build/compile_commands.json: run scripts/build.sh" >&2; exit 1; }

cd "$root"
files=("$@")
[ ${#files[@]} -gt 0 ] || mapfile -t files < <(git diff --name-only --diff-filter=d main -- '*.cc')
[ ${#files[@]} -gt 0 ] || { echo "no source differs from main"; exit 0; }
printf '%s\0' "${files[@]}" |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy -p "$build" --quiet --warnings-as-errors='*'
