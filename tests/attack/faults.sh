#!/usr/bin/env bash
# Faults of the file system: each write, each rename and each other call by which a command makes its files fails once.
#
#     bash tests/attack/faults.sh [PROGRAM]
#
# Commands that write files are run without a fault first, which counts their calls and keeps their files. Then they are
# run once for every call, which fails as on a full disk or a read-only folder. Afterwards no file under a final name may
# have other bytes than those of the undisturbed run, a run that lacks one or has printed something else must not end
# with 0, and no run may panic, whatever the call. The calls fail by `strace`, which is installed on Debian where it is
# missing; where it cannot be had, the script says SKIPPED and succeeds.
set -euo pipefail
cd "$(dirname "$0")/../.."
if ! command -v strace >/dev/null && ! { apt-get update && apt-get install -y --no-install-recommends strace; } \
  >/dev/null 2>&1; then
  printf '\n*** SKIPPED: strace cannot be had, so no call has failed ***\n\n'
  exit 0
fi
[ $# -gt 0 ] || cargo build --release -p zonobench
program=$(realpath "${1:-target/release/zonobench}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir "$work/inputs"
printf '0,0\n2,0\n0,2\n3,1\n' >"$work/inputs/plane.csv"
printf '0,0,0\n2,0,0\n0,2,0\n0,0,2\n1,1,1\n' >"$work/inputs/space.csv"
printf '[[1,0,0],[0,1,0],[0,0,1],[1,1,1]]' >"$work/inputs/body.json"
for id in a b c; do
  printf '{"id":"%s","kind":"min_area","input":{"points":[[0,0],[2,0],[0,2]]}}\n' "$id"
done >"$work/inputs/questions.jsonl"

commands=(
  'enclose plane.csv --json a.json --svg a.svg'
  'enclose space.csv --json a.json --obj a.obj'
  'inspect body.json --json a.json --question q.json --ply a.ply --stl a.stl --svg a.svg'
  'sweep body.json --translation 1,0,0 --json a.json --obj a.obj'
  'figure paper-figure-1 --svg a.svg'
  'solve questions.jsonl'
  'solve questions.jsonl --shard 0/2 --out shards'
  'reproduce --only hull-scaling --out run --threads 1'
  'reproduce --only hull-scaling --out run --threads 1 --shard 0/2'
)
# A call that makes or changes a file, and the error of it.
faults=(write:ENOSPC pwrite64:ENOSPC fsync:EIO fdatasync:EIO ftruncate:ENOSPC rename:EACCES renameat2:EACCES link:EACCES
  linkat:EACCES mkdir:EROFS unlink:EIO openat:EMFILE)
calls=$(printf '%s,' "${faults[@]%%:*}")

# Runs a command in the new folder `$1`, with further options of strace; what it prints is a file of the folder.
run() {
  local folder=$work/$1 command=$2
  shift 2
  rm -rf "$folder"
  cp -r "$work/inputs" "$folder"
  # shellcheck disable=SC2086
  (cd "$folder" && exec strace -f -qq -o "$work/trace" "$@" "$program" $command >printed 2>"$work/err")
}

failed=0
# Holds the last faulty run, of a command that ended with a status, against the undisturbed one.
look() {
  local command=$1 status=$2 lost=0 complaint=
  while read -r file; do
    if cmp -s "$work/whole/$file" "$work/faulty/$file"; then
      continue
    elif [ "$file" = ./printed ] || [ ! -e "$work/faulty/$file" ]; then
      lost=1
    else
      complaint="$file has other bytes"
    fi
  done <"$work/files"
  [ $lost = 0 ] || [ "$status" != 0 ] || complaint='a result is not there, and the status is 0'
  ! grep -q panicked "$work/err" || complaint=$(grep -A 1 panicked "$work/err" | tr '\n' ' ')
  [ "$status" -lt 100 ] || complaint=${complaint:-status $status}
  [ -z "$complaint" ] || { echo "FAILED: $command, $3: $complaint"; failed=1; }
}

for command in "${commands[@]}"; do
  for folder in twin whole; do
    run $folder "$command" -e trace="$calls" || { echo "$command fails without a fault"; cat "$work/err"; exit 1; }
  done
  # Times differ from run to run, and so do the files that state them. What the machine says of itself is not compared,
  # as a thread that reads it meets the faults of openat as well.
  (cd "$work/whole" && find . -type f ! -name environment.json -exec cmp -s {} ../twin/{} \; -print | sort) >"$work/files"
  mv "$work/trace" "$work/calls"
  count=0
  for fault in "${faults[@]}"; do
    call=${fault%%:*}
    # each thread counts its own calls; a file that is only read is opened without O_CREAT
    awk -v call="$call(" 'index($2, call) == 1 { n[$1]++; if (call != "openat(" || /O_CREAT/) print n[$1] }' \
      "$work/calls" | sort -nu >"$work/places"
    while read -r place <&3; do
      status=0
      run faulty "$command" -e trace="$call" -e inject="$call:error=${fault##*:}:when=$place" || status=$?
      count=$((count + $(grep -c INJECTED "$work/trace" || true)))
      look "$command" "$status" "$call $place"
    done 3<"$work/places"
  done
  printf '%s: %s faults, %s files\n' "$command" "$count" "$(wc -l <"$work/files")"
done
exit $failed
