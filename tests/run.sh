#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Everything CI runs: under AddressSanitizer and UndefinedBehaviorSanitizer the unit tests of what reads files and
# of the particles' loops and a short run of the fuzz targets, then all tests as users build them. All of it under
# sanitizers, in three times the time:
# cmake --preset debug && cmake --build --preset debug && ctest --preset debug
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source app/setup.sh

cmake --preset debug
cmake --build --preset debug --target test_core test_dem test_replay fuzz_scene fuzz_checkpoint fuzz_trajectory
ctest --preset debug --label-regex 'unit|fuzz' --parallel "$(nproc)"

cmake --preset release
cmake --build --preset release
ctest --preset release --parallel "$(nproc)"
