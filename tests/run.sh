#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Everything CI runs: the unit tests under AddressSanitizer and UndefinedBehaviorSanitizer, then all tests as
# users build them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source app/setup.sh

cmake --preset debug
cmake --build --preset debug --target test_core test_dem test_gas test_replay test_render
ctest --preset debug --label-regex unit --parallel "$(nproc)"

cmake --preset release
cmake --build --preset release
ctest --preset release --parallel "$(nproc)"
