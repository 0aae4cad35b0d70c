#!/usr/bin/env bash
# Installs from Debian's packages what is missing of the groups in scripts/packages/, and says
# before it begins what that is and how much. Does nothing, and needs no rights, when all is there.
# Usage: scripts/install_dependencies.sh [--say] [GROUP ...]
#   GROUP  world (what scripts/run.sh needs, and what is meant where none is given), page, tests,
#          benchmarks, training, cluster, python, package, lint
#   --say  only says what is missing and, by the package lists that are there, how much it is
set -euo pipefail
export PATH="/usr/sbin:/usr/bin:/sbin:/bin:${PATH}"

folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/packages
say=
[ "${1:-}" != --say ] || { say=yes; shift; }
groups=("${@:-world}")

# The packages of a group: words of its file, without comments.
packages_of() {
  [ -f "$folder/$1.txt" ] || {
    echo "there is no group '$1': it is one of $(cd "$folder" && echo *.txt | sed 's/\.txt//g')" >&2
    exit 2
  }
  sed 's/#.*//' "$folder/$1.txt"
}

is_there() {
  case $1 in
    # Node.js may well come from elsewhere than Debian, whose own packages would then conflict.
    nodejs) command -v node ;;
    npm) command -v npm ;;
    *) [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ] ;;
  esac >/dev/null
}

# "509 packages, 294 MB to fetch, 1,139 MB when unpacked", as apt-get counts it.
how_much() {
  LC_ALL=C apt-get install --assume-no --no-install-recommends "$@" 2>/dev/null |
    sed -n -e 's/.* \([0-9]*\) newly installed.*/\1 packages/p' \
      -e 's/^Need to get \(.*\) of archives.*/\1 to fetch/p' \
      -e 's/^After this operation, \(.*\) of additional disk space.*/\1 when unpacked/p' |
    paste --serial --delimiters=, | sed 's/,/, /g' || true  # of lists that are not there yet
}

# Reads what apt-get says and tells a person how far it is, now and then.
tell_how_far() {
  local line fetched=0 unpacked=0 set_up=0
  while IFS= read -r line; do
    case $line in
      Get:*) ((++fetched % 100)) || echo "  fetched $fetched" ;;
      Unpacking*) ((++unpacked % 100)) || echo "  unpacked $unpacked" ;;
      "Setting up"*) ((++set_up % 100)) || echo "  set up $set_up" ;;
    esac
  done
}

missing=()
for group in "${groups[@]}"; do
  packages=$(packages_of "$group")
  for package in $packages; do
    is_there "$package" || missing+=("$package")
  done
done
[ ${#missing[@]} -gt 0 ] || exit 0
if [ -n "$say" ]; then
  echo "missing of ${groups[*]}: ${missing[*]}"
  amount=$(how_much "${missing[@]}")
  echo "${amount:-how much that is shows after apt-get update}"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "these packages are missing, and installing them needs root or sudo: ${missing[*]}" >&2
    exit 1
  }
  as_root=(sudo)
fi
echo "missing of ${groups[*]}: ${missing[*]}"
echo "reading Debian's lists of packages (some 10 MB)"
"${as_root[@]}" apt-get update --quiet=2
echo "installing $(how_much "${missing[@]}")"
log=$(mktemp "${TMPDIR:-/tmp}/latticeworld_install.XXXXXX.log")
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C \
  apt-get install --yes --quiet --no-install-recommends -o Dpkg::Use-Pty=0 "${missing[@]}" 2>&1 |
  tee "$log" | tell_how_far || {
  tail -n 20 "$log"
  echo "apt-get could not install them; all that it said is in $log"
  exit 1
} >&2
rm "$log"
