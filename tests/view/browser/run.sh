#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests of `bedmix view` in a real browser.
#   bash tests/view/browser/run.sh BEDMIX FOLDER
# FOLDER is where playwright-core is installed, if it is not there, and where the screenshots stay. Leaves with 77
# where there is no browser, no Node.js or no playwright-core to be had.
set -euo pipefail

BEDMIX=$(realpath "${1:?give the program, build/release/bedmix}")
mkdir -p "${2:?give a folder for screenshots}"
OUT=$(realpath "$2")
cd "$(dirname "${BASH_SOURCE[0]}")"

skip() {
  echo "no test in a browser: $*" >&2
  exit 77
}

command -v node >/dev/null || skip "there is no Node.js"
command -v npm >/dev/null || skip "there is no npm"
[[ -x /usr/bin/chromium ]] || skip "there is no chromium"
if [[ ! -d $OUT/node_modules/playwright-core ]]; then
  cp package.json package-lock.json "$OUT"
  (cd "$OUT" && timeout 120 npm ci --no-audit --no-fund --fetch-retries=1 >npm.log 2>&1) || skip "npm cannot install playwright-core, see $OUT/npm.log"
fi
export BEDMIX OUT PLAYWRIGHT=$OUT
# A browser on a busy machine may stumble; what is wrong with the view is so twice.
node --test scenarios.mjs || node --test scenarios.mjs
