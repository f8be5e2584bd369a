#!/usr/bin/env bash
# The pages of a finished `reproduce`, as a browser lays them out: how long the report is, how small its texts are,
# whether they stay in their column, whether its tables are wider than it, and whether its links lead somewhere. The
# limits are those of the table below.
#
#     bash tests/browser/check.sh out/reproduce
#
# It needs Chromium or Chrome: the variable CHROMIUM, or one of the usual names. Without one it says SKIPPED, loudly,
# and succeeds.
set -euo pipefail
folder=$(cd "${1:?the folder of a finished run}" && pwd)
here=$(cd "$(dirname "$0")" && pwd)

browser=${CHROMIUM:-}
for name in chromium chromium-browser google-chrome chrome; do
  [ -n "$browser" ] || browser=$(command -v "$name" || true)
done
if [ -z "$browser" ]; then
  printf '\n*** SKIPPED: there is no browser, so nobody has looked at the pages ***\n\n'
  exit 0
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# What the browser finds: lines of a word and its value.
measured() {
  timeout 120 "$browser" --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --user-data-dir="$work/profile" \
    --allow-file-access-from-files --virtual-time-budget=20000 --dump-dom \
    "file://$here/measure.html?width=$2#file://$folder/$1" 2>"$work/complaints" |
    sed -n '/<pre id="found">/,/<\/pre>/p' | sed 's/.*<pre id="found">//; s/<\/pre>.*//'
}

faults=0
fault() {
  printf 'WRONG %s\n' "$1"
  faults=$((faults + 1))
}

# page, width of the window, greatest height with everything folded, least size of text: in CSS pixels
while read -r page width height size; do
  measured "$page" "$width" >"$work/found"
  if ! grep -q '^done$' "$work/found"; then
    cat "$work/complaints"
    fault "$page at $width: the browser did not finish"
    continue
  fi
  value() { sed -n "s/^$1 //p" "$work/found"; }
  printf '%s at %s: %s high, least text %s (%s)\n' "$page" "$width" "$(value height)" "$(value size)" "$(value smallest)"
  [ "$height" = any ] || [ "$(value height)" -le "$height" ] || fault "$page at $width: higher than $height"
  awk -v found="$(value size)" -v least="$size" 'BEGIN { exit !(found + 0.01 >= least) }' ||
    fault "$page at $width: text below $size: $(value smallest)"
  [ "$(value sideways)" -le "$width" ] || fault "$page at $width: scrolls sideways, to $(value sideways)"
  value beyond | sort -u >"$work/beyond"
  while read -r words; do fault "$page at $width: beyond its column: $words"; done <"$work/beyond"
  value wide | sort -u >"$work/wide"
  while read -r columns; do fault "$page at $width: a table is wider than the page: $columns"; done <"$work/wide"
  value broken >"$work/broken"
  while read -r link; do fault "$page: no anchor $link"; done <"$work/broken"
  value file >"$work/files"
  while read -r file; do [ -f "$folder/$file" ] || fault "$page: no file $file"; done <"$work/files"
done <<'LIMITS'
report.html 1280 20000 9
report.html 390 any 8
times.html 1280 any 9
times.html 390 any 8
LIMITS
[ "$faults" -eq 0 ]
