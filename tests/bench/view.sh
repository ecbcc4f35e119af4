#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Measures `bedmix view`: rate, bandwidth, latency, and what it costs the solver. Needs what the tests in a browser need.
#   bash tests/bench/view.sh BEDMIX [FOLDER]
# ROUNDS (default 3) and SECONDS_A_TURN (default 8) say how long: 5 minutes. On a machine that does nothing else.
set -euo pipefail

BEDMIX=$(realpath "${1:?give the program, build/release/bedmix}")
OUT=${2:-$(mktemp -d)}
mkdir -p "$OUT"
OUT=$(realpath "$OUT")
cd "$(dirname "${BASH_SOURCE[0]}")"
if [[ ! -d $OUT/node_modules/playwright-core ]]; then
  cp ../view/browser/package.json ../view/browser/package-lock.json "$OUT"
  (cd "$OUT" && npm ci --no-audit --no-fund >npm.log 2>&1) || { echo "view: npm cannot install, see $OUT/npm.log" >&2; exit 1; }
fi
export BEDMIX OUT PLAYWRIGHT=$OUT
node view.mjs
