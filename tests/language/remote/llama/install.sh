#!/usr/bin/env bash
# Puts real llama.cpp for the tests (node-llama-cpp with its prebuilt library), and a Node new
# enough for it, into a directory. Quick when all is there. Usage: install.sh DIRECTORY
# DIRECTORY/node is the Node to use; packages lie in DIRECTORY/node_modules.
set -euo pipefail
export PATH="/usr/bin:${PATH}"

llama_version=3.22.1
node_version=22.23.3  # where the system's own is older than 20
directory=${1:?usage: install.sh DIRECTORY}

case $(uname -m) in
  x86_64) machine=x64 ;;
  aarch64) machine=arm64 ;;
  *) echo "install.sh: no prebuilt llama.cpp for $(uname -m)" >&2; exit 1 ;;
esac
wanted="node-llama-cpp@$llama_version @node-llama-cpp/linux-$machine@$llama_version"
node=$(command -v node || true)
if [ -z "$node" ] || [ "$("$node" -p 'Number(process.versions.node.split(".")[0])')" -lt 20 ]; then
  wanted+=" node-linux-$machine@$node_version"
  node=node_modules/node-linux-$machine/bin/node
fi

mkdir -p "$directory"
cd "$directory"
if [ "$(cat installed 2>/dev/null)" = "$wanted" ] && [ -x node ]; then
  echo "llama.cpp is there: $wanted"
  exit 0
fi
command -v npm >/dev/null || {
  echo "install.sh: npm is missing (Debian's package npm)" >&2
  exit 1
}
echo "installing $wanted with npm (about 100 MB, some seconds)"
rm -f installed
echo '{"private": true}' > package.json  # npm would else look for one in the directories above
# shellcheck disable=SC2086  # a list of packages
npm install --omit=optional --ignore-scripts --no-save --no-package-lock --no-audit --no-fund \
  --loglevel=error $wanted
ln -sfn "$node" node
echo "$wanted" > installed
echo "llama.cpp is installed, $(./node --version)"
