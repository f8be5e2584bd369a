#!/usr/bin/env bash
# Builds the wheel, installs it into a fresh environment and runs the tests of the package there, away from its sources.
#
#     bash workbench/python/check.sh [FOLDER]
#
# It needs Rust and Python 3.10 or newer with its module `venv`; on Debian it installs these two where they are missing.
# Without them it says SKIPPED, loudly, and succeeds; so it does of every test that did not run.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=${1:-$(mktemp -d)}
mkdir -p "$work"
work=$(cd "$work" && pwd)
skipped() { printf '\n*** SKIPPED: %s ***\n\n' "$1"; }

usable() { python3 -c 'import ensurepip, sys, venv; sys.exit(sys.version_info < (3, 10))' 2>/dev/null; }
usable ||
  { apt-get update && apt-get install -y --no-install-recommends python3 python3-venv; } >"$work/apt.log" 2>&1 || true
if ! usable; then
  skipped 'there is no Python 3.10 with venv, so nobody has tried the package'
  exit 0
fi

python3 -m venv "$work/environment"
python=$work/environment/bin/python
pip=("$python" -m pip --disable-pip-version-check --quiet)
if ! "${pip[@]}" install ipykernel matplotlib maturin mypy nbclient nbformat numpy pytest scipy; then
  skipped 'the packages that the tests need cannot be had, so nobody has tried this one'
  exit 0
fi
rm -rf "$work/wheel"
began=$SECONDS
"${pip[@]}" wheel --no-deps --wheel-dir "$work/wheel" "$here"
wheel=$(echo "$work"/wheel/zonotope-*.whl)
size=$(stat -c %s "$wheel")
printf 'the wheel: %s bytes, built in %s s\n' "$size" "$((SECONDS - began))"
[ "$size" -le 6000000 ] || { echo 'the wheel is larger than 6 MB'; exit 1; }
"${pip[@]}" install --force-reinstall --no-deps "$wheel"
# What is imported is the installed package, not the sources beside which this was called.
cd "$work"
# The least of some is that of a machine with nothing else to do.
"$python" - <<'END'
import subprocess, sys
ask = "import time; began = time.process_time(); import zonotope; print(time.process_time() - began)"
least = min(float(subprocess.check_output([sys.executable, "-c", ask])) for _ in range(7))
print(f"import zonotope: {1000 * least:.0f} ms of the processor")
sys.exit(least > 0.05)
END
"${pip[@]}" install --only-binary :all: zonoopt || skipped 'there is no wheel of ZonoOpt for this Python'

# The tests run beside the installed package, not beside its sources.
cp -r "$here/tests" "$here/benchmarks" "$here/tour.ipynb" "$here/README.md" "$here/pyproject.toml" "$work"
export MPLBACKEND=Agg GOLDENS=$here/../../tests/goldens README=$here/../../README.md
"$python" -m pytest --quiet -rs tests | tee tests.log
"$python" -m pytest --quiet -rs --pyargs zonotope | tee doctests.log
"$python" -m mypy --strict tests benchmarks
for reason in $(grep -c '^SKIPPED' tests.log doctests.log); do
  [ "${reason##*:}" = 0 ] || skipped "${reason##*:} places in ${reason%%:*}, for the reasons above"
done
