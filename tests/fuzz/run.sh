#!/usr/bin/env bash
# The attack by a fuzzer that sees which branches an input takes: readers of files, lines of a batch, questions of every
# kind with the verifier behind them, changed answers, the dynamic hull beside its exact twin.
#
#     bash tests/fuzz/run.sh [SECONDS [TARGET...]]
#
# 300 seconds in all and every target, when nothing is said. It needs Rust and a C++ compiler. What was learned before is
# in corpus/, what this run learns in target/corpus/; with KEEP=1 the inputs that reach most are put into corpus/. An
# input that panics, takes more than 20 seconds or 4 GB is a file in target/finds/, and the script ends with 1: every find
# becomes a test. Most of the time goes to telling the fuzzer the operands of comparisons, from which it learns words and
# numbers of a format; COMPARES=0 leaves them out, for many executions from a corpus that knows the words already. OPTIONS
# are the fuzzer's own, as in OPTIONS="-max_len=96 -entropic=0 -reduce_inputs=0" for very many short inputs.
#
# A stable toolchain is enough: the counters of branches come from a pass of the compiler that needs no nightly flag, and
# there is no unsafe code of which the addresses would have to be watched. `cargo fuzz run TARGET` works as well.
set -euo pipefail
cd "$(dirname "$0")"
seconds=${1:-300}
[ $# -eq 0 ] || shift
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(points bodies lines questions motions answers hulls)

host=$(rustc -vV | sed -n 's/^host: //p')
counters=(-Cpasses=sancov-module)
options=(level=4 inline-8bit-counters pc-table)
[ "${COMPARES:-1}" = 0 ] || options+=(trace-compares)
for option in "${options[@]}"; do
  counters+=("-Cllvm-args=-sanitizer-coverage-$option")
done
# The host is named so that build scripts, which no fuzzer runs, are left without counters.
RUSTFLAGS="${counters[*]} --cfg fuzzing" cargo build --release --target "$host" --target-dir target
[ ! -d /dev/shm ] || export TMPDIR=/dev/shm

failed=()
share=$((seconds / ${#targets[@]}))
for target in "${targets[@]}"; do
  mkdir -p "target/corpus/$target" target/finds "corpus/$target"
  program=target/$host/release/$target
  log=target/$target.log
  printf '\n== %s, %s seconds\n' "$target" "$share"
  "$program" -max_total_time="$share" -timeout=20 -rss_limit_mb=4096 -print_final_stats=1 ${OPTIONS:-} \
    -artifact_prefix="target/finds/$target-" "target/corpus/$target" "corpus/$target" >"$log" 2>&1 ||
    failed+=("$target")
  grep -E '^stat::number_of_executed_units|^stat::slowest_unit_time_sec|SUMMARY|panicked|Test unit written' "$log" || true
  if [ "${KEEP:-}" = 1 ]; then
    mkdir -p "target/kept/$target"
    rm -f "target/kept/$target"/*
    "$program" -merge=1 "target/kept/$target" "corpus/$target" "target/corpus/$target" >>"$log" 2>&1
    rm -rf "corpus/$target"
    mkdir -p "corpus/$target"
    # the smallest ones, as many as a reader may look through
    find "target/kept/$target" -type f -printf '%s %p\n' | sort -n | head -n 200 | cut -d' ' -f2- |
      while read -r file; do cp "$file" "corpus/$target/"; done
  fi
done
[ ${#failed[@]} -eq 0 ] || { echo "FOUND: ${failed[*]}; the inputs are in tests/fuzz/target/finds"; exit 1; }
