#!/usr/bin/env bash
# Makes the pictures of docs/gallery.md that its commands are shown for: runs each command of its
# bash blocks, and draws the world from above, from the south and as somebody in it sees it, side by
# side, as docs/images/NAME.png of the world's --out NAME. Build first: scripts/build.sh. Needs
# Pillow (Debian: python3-pil).
# Usage: scripts/gallery.sh [--out DIR] [NAME...]
# Without names all are made; DIR is docs/images unless another is given.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_BUILD_DIR:-$root/build}
program=${LATTICEWORLD_BUILD_DIR:-$root}/devel/lib/latticeworld/latticeworld
[ -x "$program" ] || program=$build/src/tools/latticeworld  # built without ROS
[ -x "$program" ] || { echo "no $program: run scripts/build.sh first" >&2; exit 1; }
python=$(command -v /usr/bin/python3 || command -v python3)
for candidate in "$python" python3; do
  if "$candidate" -c "import PIL" 2> /dev/null; then python=$candidate; fi
done
"$python" -c "import PIL" 2> /dev/null ||
  { echo "Pillow is missing: apt-get install python3-pil" >&2; exit 1; }

images=$root/docs/images
names=()
while [ $# -gt 0 ]; do
  case $1 in
    --out)
      [ $# -ge 2 ] || { echo "--out needs a directory" >&2; exit 2; }
      images=$2
      shift 2
      ;;
    -*)
      sed -n '2,8s/^# //p' "${BASH_SOURCE[0]}" >&2
      exit 2
      ;;
    *)
      names+=("$1")
      shift
      ;;
  esac
done
mkdir -p "$images"
images=$(cd "$images" && pwd)

work=$(mktemp -d "${TMPDIR:-/tmp}/latticeworld_gallery.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"
PATH=$(dirname "$program"):$PATH

# Side by side, and of no more colours than keep it small.
join() {
  "$python" - "$1" "$2.top.png" "$2.oblique.png" "$2.close.png" << 'PYTHON'
import os
import sys

from PIL import Image

LIMIT = 150_000  # bytes
out, *paths = sys.argv[1:]
views = [Image.open(path).convert("RGB") for path in paths]
height = min(view.height for view in views)
views = [view.resize((round(view.width * height / view.height), height), Image.LANCZOS)
         for view in views]
whole = Image.new("RGB", (sum(view.width for view in views) + 8 * (len(views) - 1), height),
                  "white")
left = 0
for view in views:
    whole.paste(view, (left, 0))
    left += view.width + 8
for share in (1.0, 0.9, 0.8, 0.7, 0.6, 0.5):
    size = (round(whole.width * share), round(whole.height * share))
    whole.resize(size, Image.LANCZOS).quantize(96).save(out, optimize=True)
    if os.path.getsize(out) < LIMIT:
        break
else:
    sys.exit(f"{out}: larger than {LIMIT} bytes however small")
PYTHON
}

made=0
while IFS= read -r command; do
  name=$(sed -n 's/.* --out \([a-z_]*\) .*/\1/p' <<< "$command")
  if [ ${#names[@]} -gt 0 ] && [[ " ${names[*]} " != *" $name "* ]]; then continue; fi
  echo "$name"
  bash -euo pipefail -c "$command" > "$name.log" 2>&1 || { cat "$name.log" >&2; exit 1; }
  latticeworld picture "$name" --view top --width 420 --out "$name.top.png" > /dev/null
  latticeworld picture "$name" --view oblique --width 640 --out "$name.oblique.png" > /dev/null
  latticeworld picture "$name" --view close --width 640 --out "$name.close.png" > /dev/null
  join "$images/$name.png" "$name"
  rm -rf "$name"
  made=$((made + 1))
done < <(grep '^latticeworld generate ' "$root/docs/gallery.md")
[ "$made" -gt 0 ] || { echo "docs/gallery.md has no command of that name: ${names[*]}" >&2; exit 2; }
