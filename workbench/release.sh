#!/usr/bin/env bash
# What must hold before a release: both crates can be published as they are, and the version says what has changed for
# those who call the library.
#
#     bash workbench/release.sh [REVISION]
#
# REVISION is the release that this one is compared with: the last tag, when nothing is said. Without one there is
# nothing to compare, which is said loudly. `cargo semver-checks` is installed where it is missing.
set -euo pipefail
cd "$(dirname "$0")/.."
skipped() { printf '\n*** SKIPPED: %s ***\n\n' "$1"; }

echo '== the packages of both crates, built from what would be published'
cargo publish --dry-run --package zonotope-verifier --package zonotope

echo '== what has changed for callers'
last=${1:-$(git describe --tags --abbrev=0 2>/dev/null || true)}
if [ -z "$last" ]; then
  skipped 'there is no tag yet, so there is no release to compare with'
  exit 0
fi
cargo semver-checks --version >/dev/null 2>&1 || cargo install --locked cargo-semver-checks
cargo semver-checks --baseline-rev "$last" --package zonotope-verifier --package zonotope
