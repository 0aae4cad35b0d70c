#!/usr/bin/env bash
# Fetches and joins the model that reads, for the tests that run it, unless FILE is newer than the
# adapter that it is made of (what is fetched is checked by its SHA-256).
# Usage: fetch_reader_once.sh SOURCES FILE
set -euo pipefail
[ "$2" -nt "$1/models/reader.gguf" ] || "$1/scripts/fetch_reader.sh" "$2"
