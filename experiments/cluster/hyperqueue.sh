#!/usr/bin/env bash
# Submits the shards as tasks of one job to the server of HyperQueue and waits for them.
set -euo pipefail
count=${SHARDS:-16}
export PROFILE=${PROFILE:-full} OUT=${OUT:-out/shards} ZONOBENCH=${ZONOBENCH:-zonobench} COUNT=$count
hq submit --name zonotopes --array "0-$((count - 1))" --cpus 1 --crash-limit 100 --wait \
  --env PROFILE="$PROFILE" --env OUT="$OUT" --env ZONOBENCH="$ZONOBENCH" --env COUNT="$COUNT" -- \
  bash -c '"$ZONOBENCH" reproduce --profile "$PROFILE" --threads 1 --shard "$HQ_TASK_ID/$COUNT" --out "$OUT"'
