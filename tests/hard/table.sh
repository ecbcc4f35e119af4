#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs all hard cases and writes their table into assets/docs/hard-cases.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
program="${1:-build/release/tests/hard/hard_cases}"
page=assets/docs/hard-cases.md
table="$(mktemp)"
trap 'rm -f "$table" "$table.page"' EXIT
outcome=0
"$program" >"$table" || outcome=$?
awk -v table="$table" '
  /^<!-- written by/ { print; while ((getline line <table) > 0) print line; inside = 1; next }
  inside && /^\|/ { next }
  { inside = 0; print }' "$page" >"$table.page"
cat "$table.page" >"$page"
exit "$outcome"
