#!/usr/bin/env bash
# Fuzzes what reads from outside (tests/fuzz) with libFuzzer, AddressSanitizer and
# UndefinedBehaviorSanitizer, and prints for each target how often it ran and how many edges of the
# program it reached. Installs clang where it is missing (Debian).
# Usage: scripts/fuzz.sh [TARGET|all] [SECONDS]     each target for so long (10)
#        scripts/fuzz.sh --minimise TARGET          puts what was found into the target's corpus, as
#                                                   few and small inputs as reach the same edges
#        scripts/fuzz.sh --coverage TARGET          how much of each of our files the corpus and what
#                                                   was found reach: functions and edges, those into
#                                                   the sanitizers' own reports among them
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

if ! command -v clang++ >/dev/null || ! ls "$(clang++ -print-resource-dir)"/lib/linux/libclang_rt.fuzzer-*.a >/dev/null 2>&1; then
  as_root=$([ "$(id -u)" = 0 ] || echo sudo)
  $as_root apt-get install -y --no-install-recommends clang
  # Debian has libFuzzer and the sanitizers apart, in a package of clang's version.
  version=$(clang++ -dumpversion)
  $as_root apt-get install -y --no-install-recommends "libclang-rt-${version%%.*}-dev"
fi

[ -f "$build/build.ninja" ] ||
  cmake -G Ninja -S "$root" -B "$build" -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
    -DCMAKE_BUILD_TYPE=Fuzz -DCMAKE_C_FLAGS_FUZZ=-O2 -DCMAKE_CXX_FLAGS_FUZZ=-O2 \
    -DLATTICEWORLD_FUZZ=ON -DLATTICEWORLD_BUILD_PAGE=OFF >/dev/null
if [ "$target" = all ]; then
  ninja -C "$build" fuzz_targets
  mapfile -t targets < <(cd "$root/tests/fuzz" && ls ./*_fuzz.cc | sed 's|^\./||; s|_fuzz\.cc$||')
else
  ninja -C "$build" "fuzz_$target"
  targets=("$target")
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

if [ "$task" = coverage ]; then
  for name in "${targets[@]}"; do
    run "$name" -runs=0 -print_coverage=1 "$build/found/$name" "$root/tests/fuzz/corpus/$name"
    awk -v root="$root/src/" -v name="$name" '
      /COVERED_FUNC: / {
        file = $NF  # FOLDER/../src/FILE:LINE, where sources are named from the build folder
        while (sub(/\/[^\/]+\/\.\.\//, "/", file)) {
        }
        if (index(file, root) != 1) next
        file = substr(file, 1 + length(root))
        sub(/:.*/, "", file)
        match($0, /edges: [0-9]+\/[0-9]+/)
        split(substr($0, RSTART + 7, RLENGTH - 7), edges, "/")
        ++functions[file]
        reached_functions[file] += edges[1] > 0
        reached[file] += edges[1]
        of[file] += edges[2]
      }
      END {
        for (file in of)
          printf "%s %s: functions %d of %d, edges %d of %d\n", name, file,
                 reached_functions[file], functions[file], reached[file], of[file]
      }' "$build/findings/$name/log" | sort
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
