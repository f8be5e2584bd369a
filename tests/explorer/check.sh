#!/usr/bin/env bash
# The teaching page, in two steps, of which the first needs no other.
#
#     bash tests/explorer/check.sh build FOLDER             builds the page anew into FOLDER
#     bash tests/explorer/check.sh test FOLDER PROGRAM      holds it to the committed page and to the program, and
#                                                           goes through its chapters in a browser
#
# The page has the same bytes as the committed one where its compiler is the one that the committed page names; another
# compiler makes another module with the same answers. The module is the library on a machine of 32 bits, so the
# comparison of its answers with the program's is the check of such machines, too.
#
# The first step needs npm, and the target wasm32-unknown-unknown or Debian's rustc-web, which it unpacks into FOLDER.
# Where one of them cannot be had, both steps say SKIPPED, loudly, and succeed.
set -euo pipefail
step=${1:?build or test}
mkdir -p "${2:?the folder of the built page}"
folder=$(cd "$2" && pwd)
root=$(cd "$(dirname "$0")/../.." && pwd)
explorer=$root/workbench/explorer
page=$folder/page.html
module=$explorer/abi/target/wasm32-unknown-unknown/wasm/explorer_abi.wasm

skip() {
  printf '\n*** SKIPPED: %s, so nobody has built and looked at the explorer ***\n\n' "$1"
  touch "$folder/skipped"
  exit 0
}

compiler_of() { sed -n 's/.*<meta name="compiler" content="\([^"]*\)".*/\1/p' "$1" | head -n 1; }

build() {
  rm -f "$folder/skipped" "$page"
  command -v npm >/dev/null || skip "there is no npm"
  npm ping >/dev/null 2>&1 || skip "npm reaches no registry"
  local where=()
  if [ ! -d "$(rustc --print sysroot)/lib/rustlib/wasm32-unknown-unknown" ]; then
    # a list that came with the machine may name a compiler that is too old
    apt-get update >/dev/null 2>&1 || true
    apt-cache show rustc-web >/dev/null 2>&1 || skip "there is neither the target wasm32-unknown-unknown nor rustc-web"
    where=(--compiler "$folder/compiler")
  fi
  "$explorer/build" --out "$page" "${where[@]}"
}

run_tests() {
  local program=$1
  [ ! -e "$folder/skipped" ] || skip "the first step was skipped"
  local built committed
  built=$(compiler_of "$page")
  committed=$(compiler_of "$explorer/explorer.html")
  if [ "$built" = "$committed" ]; then
    cmp "$page" "$explorer/explorer.html" || {
      echo "explorer.html is not what its sources make; workbench/explorer/build makes it anew"
      exit 1
    }
    echo "the same bytes as explorer.html, by $built"
  else
    echo "by $built, explorer.html by $committed: answers are compared alone"
  fi
  node "$explorer/abi/check.mjs" "$module" "$program" "$root/tests/goldens/questions.jsonl"
  (cd "$explorer/page" && node tests/run.mjs "$page" "$module")
}

case $step in
  build) build ;;
  test) run_tests "${3:?the program}" ;;
  *) echo "$step: neither build nor test" >&2; exit 2 ;;
esac
