#!/usr/bin/env bash
# Builds the wheel, installs it into a fresh environment and runs the tests of the package there, away from its sources.
#
#     bash workbench/python/check.sh [FOLDER]
#
# It needs Rust and Python 3.10 or newer with its module `venv`; on Debian it installs these two where they are missing.
# Without them it says SKIPPED, loudly, and succeeds.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=${1:-$(mktemp -d)}
mkdir -p "$work"

usable() { python3 -c 'import ensurepip, sys, venv; sys.exit(sys.version_info < (3, 10))' 2>/dev/null; }
usable ||
  { apt-get update && apt-get install -y --no-install-recommends python3 python3-venv; } >"$work/apt.log" 2>&1 || true
if ! usable; then
  printf '\n*** SKIPPED: there is no Python 3.10 with venv, so nobody has tried the package ***\n\n'
  exit 0
fi

python3 -m venv "$work/environment"
python=$work/environment/bin/python
pip=("$python" -m pip --disable-pip-version-check --quiet)
began=$SECONDS
"${pip[@]}" wheel --no-deps --wheel-dir "$work/wheel" "$here"
wheel=$(echo "$work"/wheel/zonotope-*.whl)
printf 'the wheel: %s bytes, built in %s s\n' "$(stat -c %s "$wheel")" "$((SECONDS - began))"
"${pip[@]}" install "$wheel" ipykernel matplotlib mypy nbclient nbformat pytest scipy

# The tests run beside the installed package, not beside its sources.
cp -r "$here/tests" "$here/tour.ipynb" "$here/pyproject.toml" "$work"
cd "$work"
export MPLBACKEND=Agg GOLDENS=$here/../../tests/goldens README=$here/../../README.md
"$python" -m pytest --quiet tests
"$python" -m pytest --quiet --pyargs zonotope
"$python" -m mypy --strict tests
