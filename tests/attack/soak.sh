#!/usr/bin/env bash
# A long run of `solve` on mixed questions: its memory stays flat, and its answers are those of fresh processes.
#
#     bash tests/attack/soak.sh [QUESTIONS [SEED]]
#
# 200,000 questions of the seed of today, when nothing is said. One process answers them all while its memory is read
# every second; then fresh processes answer them a thousand at a time. It ends with 1 where
# an answer differs, or where the memory of the second half exceeds that of the first by a tenth and 16 MB.
set -euo pipefail
cd "$(dirname "$0")/../.."
count=${1:-200000}
seed=${2:-$(date +%Y%m%d)}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cargo build --release -p zonobench
cargo build --release -p tests --example print_questions
program=target/release/zonobench
target/release/examples/print_questions "$count" "$seed" >"$work/questions.jsonl"

"$program" solve "$work/questions.jsonl" >"$work/answers.jsonl" 2>"$work/log" &
process=$!
while kill -0 "$process" 2>/dev/null; do
  sed -n 's/^VmRSS:[^0-9]*\([0-9]*\) kB/\1/p' "/proc/$process/status" 2>/dev/null || true
  sleep 1
done >"$work/memory"
wait "$process"
printf '%s questions of the seed %s: %s answers, %s seconds\n' \
  "$count" "$seed" "$(wc -l <"$work/answers.jsonl")" "$(wc -l <"$work/memory")"

split -l 1000 "$work/questions.jsonl" "$work/part-"
for part in "$work"/part-*; do
  "$program" solve "$part" 2>>"$work/log"
done >"$work/fresh.jsonl"
cmp "$work/answers.jsonl" "$work/fresh.jsonl"
echo 'the answers are those of fresh processes'

awk '{ kb[NR] = $1 }
  END {
    half = int(NR / 2)
    for (i = 1; i <= NR; i++) if (i <= half) { if (kb[i] > a) a = kb[i] } else if (kb[i] > b) b = kb[i]
    printf "memory: at most %d kB in the first half, %d kB in the second\n", a, b
    exit NR >= 4 && b > 1.1 * a + 16384
  }' "$work/memory"
