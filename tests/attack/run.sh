#!/usr/bin/env bash
# The attack by machine: fresh questions of every kind, each answer given to the verifier, for a number of seconds.
#
#     bash tests/attack/run.sh [SECONDS] [SEED]
#
# 300 seconds and the seed of today, when nothing is said: the seed is printed, and the same seed asks the same questions.
# It ends with 1 where an answer is not accepted or a question panics; the question is printed and becomes a test.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-300}
seed=${2:-$(date +%Y%m%d)}

cargo build --release -p tests --example attack_questions
printf 'seed %s, %s seconds\n' "$seed" "$seconds"
target/release/examples/attack_questions "$seconds" "$seed"
