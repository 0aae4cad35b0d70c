#!/usr/bin/env bash
# Gives a world to programs of others as a user would, measures what comes out, and writes it to
# docs/reports/peers.md: scripts/peers.sh [--program PATH] [--wheel PATH] [--worlds FOLDER] [NAME ...]
#
# NAME: of peers/NAME.py or peers/NAME.mjs; all without one. --program: latticeworld
# [devel/lib/latticeworld/latticeworld]. --wheel: the module for Python, of scripts/build_wheel.sh, or
# a folder that holds it [build/python_module]. --worlds: keeps the world and its exports for the next run.
# Every peer is installed in a temporary folder of its own, in the versions that its head names;
# Debian's packages have to be there. Ends with 1 where something is not as docs/exports.md says.
# Outside CI: it needs the network.
set -euo pipefail
exec /usr/bin/python3 "$(dirname "$(realpath "$0")")/../peers/run.py" "$@"
