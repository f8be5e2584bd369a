#!/usr/bin/env bash
# Puts the report, the explorer, the manual and the documentation of the libraries into one folder with a front page,
# to be opened as files or served by any web server.
#
#     bash workbench/site/build.sh FOLDER [RUN]
#
# RUN is a folder that `reproduce` wrote; without it the quick profile is run. Rust is all it needs: rustdoc lays out the
# pages. The Python package is documented where a Python has it installed (PYTHON=python3, if nothing else is said), else
# the script says SKIPPED, loudly. The folder appears under its name when it is whole.
set -euo pipefail
out=$(realpath -m "$1")
run=${2:+$(realpath "$2")}
python=${PYTHON:-python3}
cd "$(dirname "$0")/../.."
skipped() { printf '\n*** SKIPPED: %s ***\n\n' "$1"; }
[ ! -e "$out" ] || { echo "$out is there already"; exit 1; }
work=$out.partial
rm -rf "$work"
mkdir -p "$work"

cargo build --release
program=target/release/zonobench
if [ -n "$run" ]; then cp -r "$run" "$work/report"; else "$program" reproduce --out "$work/report"; fi
"$program" explore --out "$work/explorer.html"

page() { rustdoc "$1" -o "$work" --markdown-css style.css "${@:2}"; }
page workbench/zonobench/MANUAL.md
mv "$work/MANUAL.html" "$work/manual.html"
cp workbench/site/style.css "$work"

RUSTDOCFLAGS="-D warnings" cargo doc --no-deps -p zonotope -p zonotope-verifier --features zonotope/linear-programming
cp -r target/doc "$work/rust"

has_package=
if "$python" -c 'import zonotope' 2>/dev/null; then
  "$python" -m venv --system-site-packages "$work/environment"
  "$work/environment/bin/python" -m pip --quiet install pdoc
  "$work/environment/bin/python" -m pdoc zonotope --output-directory "$work/python"
  rm -rf "$work/environment"
  has_package=1
else
  skipped "no Python has the package installed (pip install ./workbench/python), so its documentation is left out"
fi

# The front page says what is there.
{
  cat workbench/site/front.md
  if [ -n "$has_package" ]; then echo '- [Python package](python/zonotope.html): its classes and functions'; fi
} >"$work/index.md"
page "$work/index.md" --markdown-no-toc
rm "$work/index.md"

# Every link of the front page leads somewhere.
grep -oE 'href="[^"#]+"' "$work/index.html" | cut -d'"' -f2 | while read -r link; do
  [ -e "$work/$link" ] || { echo "the front page links to $link, which is not there"; exit 1; }
done
mv "$work" "$out"
echo "$out/index.html"
