#!/usr/bin/env bash
# Installs clang-tidy where it is missing, reads sources with it (.clang-tidy) and says what it
# finds. Needs a configured build.
# Usage: scripts/lint.sh [FILE.cc ...]   (those that differ from main where none is given)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_BUILD_DIR:-$root/build}

[ -f "$build/compile_commands.json" ] || {
  echo "no $build/compile_commands.json: run scripts/build.sh" >&2
  exit 1
}
cd "$root"
files=("$@")
[ ${#files[@]} -gt 0 ] || mapfile -t files < <(git diff --name-only --diff-filter=d main -- '*.cc')
[ ${#files[@]} -gt 0 ] || { echo "no source differs from main"; exit 0; }
"$root/scripts/install_dependencies.sh" lint
# clang reads no headers that GCC has precompiled: here each source reads its own.
commands=$(mktemp -d)
trap 'rm -rf "$commands"' EXIT
sed -E 's/ -Winvalid-pch -include [^ ]*cmake_pch\.hxx//' "$build/compile_commands.json" \
  >"$commands/compile_commands.json"
printf '%s\0' "${files[@]}" |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy -p "$commands" --quiet --warnings-as-errors='*'
