#!/usr/bin/env bash
# `reproduce` killed at random moments: no file under its final name is half a file, and the next run ends as if nothing
# had been.
#
#     bash tests/attack/kills.sh [KILLS [SEED]]
#
# 100 kills, when nothing is said, over the whole time that a run of some experiments takes. After each of them what lies
# under a final name has the bytes of the undisturbed run, as far as these are fixed, and after the last kill of five the
# run is made to its end and compared with it.
set -euo pipefail
cd "$(dirname "$0")/../.."
kills=${1:-100}
RANDOM=${2:-1}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cargo build --release -p zonobench
run=(target/release/zonobench reproduce --force --only hull-scaling)
began=$(date +%s%N)
"${run[@]}" --out "$work/whole" >"$work/log" 2>&1
took=$(($(date +%s%N) - began))
printf 'a run takes %s ms\n' "$((took / 1000000))"

deterministic() { grep -B2 '"deterministic": true' "$1/manifest.json" | sed -n 's/.*"path": "\(.*\)",/\1/p'; }
deterministic "$work/whole" >"$work/fixed"
[ -s "$work/fixed" ] || { echo 'the manifest names no file with fixed bytes'; exit 1; }
same_bytes() {
  while read -r path; do
    [ ! -e "$work/out/$path" ] || cmp "$work/whole/$path" "$work/out/$path"
  done <"$work/fixed"
}

met=0
for kill in $(seq "$kills"); do
  "${run[@]}" --out "$work/out" >"$work/log" 2>&1 &
  process=$!
  part=$((took / 32768 * RANDOM))
  sleep "$(printf '%d.%09d' $((part / 1000000000)) $((part % 1000000000)))"
  kill -KILL "$process" 2>/dev/null && met=$((met + 1))
  wait "$process" 2>/dev/null || true
  same_bytes
  if [ $((kill % 5)) = 0 ]; then
    "${run[@]}" --out "$work/out" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
    same_bytes
    while read -r path; do [ -e "$work/out/$path" ] || { echo "$path is not there"; exit 1; }; done <"$work/fixed"
    rm -rf "$work/out"
  fi
done
printf '%s runs killed, %s of them before their end: no half file, and every run after them ended\n' "$kills" "$met"
