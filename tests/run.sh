#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Everything CI runs: under AddressSanitizer and UndefinedBehaviorSanitizer the unit tests of what reads files and
# of the particles' loops and a short run of the fuzz targets, under ThreadSanitizer a run in a thread of its own
# that is steered, then all other tests as users build them. All of it under sanitizers:
# cmake --preset debug && cmake --build --preset debug && ctest --preset debug, and likewise with tsan
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source app/setup.sh
[[ -n $(command -v node) && -n $(command -v npm) && -n $(command -v chromium) ]] ||
  (install_packages app/packages-browser.txt) || echo "bedmix: the tests in a browser are skipped" >&2

cmake --preset debug
cmake --build --preset debug --target test_core test_dem test_replay fuzz_scene fuzz_checkpoint fuzz_trajectory fuzz_foreign fuzz_dump fuzz_message
ctest --preset debug --label-regex 'unit|fuzz' --parallel "$(nproc)"

cmake --preset tsan
cmake --build --preset tsan --target test_live_run
ctest --preset tsan --tests-regex '^LiveRun\.' --no-tests=error

cmake --preset release
cmake --build --preset release
ctest --preset release --label-exclude fuzz --parallel "$(nproc)"
