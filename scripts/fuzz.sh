#!/usr/bin/env bash
# Fuzzes what reads from outside (tests/fuzz) with libFuzzer, AddressSanitizer and
# UndefinedBehaviorSanitizer, and prints for each target how often it ran and how many edges of the
# program it reached. Installs clang where it is missing (Debian).
# Usage: scripts/fuzz.sh [TARGET|all] [SECONDS]     each target for so long (10)
#        scripts/fuzz.sh --minimise TARGET          puts what was found into the target's corpus, as
#                                                   few and small inputs as reach the same edges
#        scripts/fuzz.sh --coverage [TARGET|all]    how many functions and branches of each of our
#                                                   files the corpus and what was found reach, by
#                                                   clang's source-based coverage, in a build without
#                                                   sanitizers beside the other
# `cmake -DLATTICEWORLD_FUZZ_COMPARISONS=OFF build-fuzz` makes targets that compute much (worlds,
# texts) run several times as often.
# LATTICEWORLD_FUZZ_BUILD_DIR names another build folder than build-fuzz. Inputs that reached new
# edges are kept there below found/, those that ended a target below findings/: the exit status is
# 1 then. A finding is run again by giving its file to build-fuzz/tests/fuzz/fuzz_TARGET.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${LATTICEWORLD_FUZZ_BUILD_DIR:-$root/build-fuzz}
task=fuzz
case "${1:-}" in
  --minimise | --coverage) task=${1#--}; shift ;;
esac
target=${1:-all}
seconds=${2:-10}
export UBSAN_OPTIONS=print_stacktrace=1${UBSAN_OPTIONS:+:$UBSAN_OPTIONS}

as_root=$([ "$(id -u)" = 0 ] || echo sudo)
if ! command -v clang++ >/dev/null || ! ls "$(clang++ -print-resource-dir)"/lib/linux/libclang_rt.fuzzer-*.a >/dev/null 2>&1; then
  $as_root apt-get install -y --no-install-recommends clang
  # Debian has libFuzzer and the sanitizers apart, in a package of clang's version.
  version=$(clang++ -dumpversion)
  $as_root apt-get install -y --no-install-recommends "libclang-rt-${version%%.*}-dev"
fi

configure() {  # arguments: the folder, then options of cmake
  local folder=$1
  shift
  [ -f "$folder/build.ninja" ] ||
    cmake -G Ninja -S "$root" -B "$folder" -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
      -DCMAKE_BUILD_TYPE=Fuzz -DCMAKE_C_FLAGS_FUZZ=-O2 -DLATTICEWORLD_BUILD_PAGE=OFF "$@" >/dev/null
}

if [ "$target" = all ]; then
  mapfile -t targets < <(cd "$root/tests/fuzz" && ls ./*_fuzz.cc | sed 's|^\./||; s|_fuzz\.cc$||')
else
  targets=("$target")
fi

if [ "$task" = coverage ]; then
  command -v llvm-cov >/dev/null || $as_root apt-get install -y --no-install-recommends llvm
  folder=$build-coverage
  profile="-O1 -fprofile-instr-generate -fcoverage-mapping"
  configure "$folder" -DCMAKE_CXX_FLAGS_FUZZ="$profile" -DLATTICEWORLD_BUILD_TESTS=ON
  ninja -C "$folder" "${targets[@]/#/fuzz_}"
  for name in "${targets[@]}"; do
    program=$folder/tests/fuzz/fuzz_$name
    raw=$(mktemp -d)
    for inputs in "$root/tests/fuzz/corpus/$name" "$build/found/$name"; do
      [ -d "$inputs" ] || continue
      LLVM_PROFILE_FILE=$raw/%p.profraw "$program" "$inputs" 0 >/dev/null
    done
    llvm-profdata merge -o "$raw/profile" "$raw"/*.profraw
    llvm-cov export -summary-only -instr-profile="$raw/profile" "$program" |
      python3 -c '
import json, os, sys

name, root = sys.argv[1:]
for file in json.load(sys.stdin)["data"][0]["files"]:
    path = os.path.relpath(file["filename"], root)
    reached = file["summary"]
    if path.startswith("..") or reached["functions"]["covered"] == 0:
        continue
    print("%s %s: functions %d of %d, branches %d of %d" % (
        name, path, reached["functions"]["covered"], reached["functions"]["count"],
        reached["branches"]["covered"], reached["branches"]["count"]))
' "$name" "$root/src"
    rm -rf "$raw"
  done
  exit 0
fi

configure "$build" -DCMAKE_CXX_FLAGS_FUZZ=-O2 -DLATTICEWORLD_FUZZ=ON
if [ "$target" = all ]; then
  ninja -C "$build" fuzz_targets
else
  ninja -C "$build" "fuzz_$target"
fi

# Runs a target in its own folder of findings; arguments: its name, then those of libFuzzer.
run() {
  local name=$1
  shift
  mkdir -p "$build/findings/$name" "$build/found/$name"
  "$build/tests/fuzz/fuzz_$name" -timeout=20 -rss_limit_mb=4096 \
    -artifact_prefix="$build/findings/$name/" "$@" >"$build/findings/$name/log" 2>&1
}

if [ "$task" = minimise ]; then
  for name in "${targets[@]}"; do
    corpus=$root/tests/fuzz/corpus/$name
    smaller=$(mktemp -d)
    run "$name" -set_cover_merge=1 -use_counters=0 -max_len=8192 "$smaller" "$corpus" "$build/found/$name"
    # What has a name of its own stays: it is a seed, or was a finding. libFuzzer names an input by
    # its SHA-1, so that the same bytes are known by it.
    find "$corpus" -type f -regextype posix-extended -regex '.*/[0-9a-f]{40}' -delete
    named=$(find "$corpus" -type f -exec sha1sum {} + | cut -d' ' -f1)
    for input in "$smaller"/*; do
      [ -f "$input" ] || continue  # the folder is empty
      grep -qx "${input##*/}" <<<"$named" || mv "$input" "$corpus/"
    done
    rm -rf "$smaller"
    echo "$name: $(find "$corpus" -type f | wc -l) inputs, $(du -sb "$corpus" | cut -f1) bytes"
  done
  exit 0
fi

failed=0
printf '%-20s %12s %10s %10s\n' target executions edges of
for name in "${targets[@]}"; do
  [ -x "$build/tests/fuzz/fuzz_$name" ] || continue  # those of ROS, in a build without it
  ends="whole"
  run "$name" -max_total_time="$seconds" -print_final_stats=1 -max_len=65536 \
    "$build/found/$name" "$root/tests/fuzz/corpus/$name" || { ends="FINDING"; failed=1; }
  log=$build/findings/$name/log
  printf '%-20s %12s %10s %10s%s\n' "$name" \
    "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -1)" \
    "$(grep -o 'cov: [0-9]*' "$log" | tail -1 | cut -d' ' -f2)" \
    "$(sed -n 's/.*Loaded .* modules\{0,1\} .*(\([0-9]*\) inline 8-bit counters).*/\1/p' "$log" | head -1)" \
    "$([ "$ends" = whole ] || echo "  a finding: $log")"
done
exit $failed
