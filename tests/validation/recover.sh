#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Kills runs at random moments and looks at what is left, as it is and cut off at a random length, with `bedmix
# recover` and `replay`: every frame that was reported as written must be there, what is saved of a cut copy must
# be a beginning of the run, and no file that is looked at may change. Prints a table.
#   bash tests/validation/recover.sh
# BEDMIX (program), RUNS (50) and SEED (1) may be set. Takes some minutes. Exits 1 where anything is not so.
set -euo pipefail
cd "$(dirname "$0")/../.."
bedmix=$(realpath "${BEDMIX:-build/release/bedmix}")
runs=${RUNS:-50}
RANDOM=${SEED:-1}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
folder=$work/killed

frames_of() { sed -n 's/.*"frames": *\([0-9]*\).*/\1/p'; }
between() { awk -v r="$RANDOM" -v from="$1" -v to="$2" 'BEGIN { print from + (to - from) * r / 32768 }'; }
# Recovers a file: `count` frames; counts it where it changed.
recovered() { # FILE OUT
  local before found
  before=$(sha256sum <"$1")
  found=$("$bedmix" recover "$1" -o "$2" --quiet --json 2>/dev/null | frames_of) || found=
  [ "$before" = "$(sha256sum <"$1")" ] || { echo "changed: $1" >&2; touched=$((touched + 1)); }
  count=${found:-0}
}

unreadable=0 lost=0 touched=0 foreign=0 cut=0 saved=0 reported=0 killed=0
while [ "$killed" -lt "$runs" ]; do
  rm -rf "$work"/*
  "$bedmix" run tiny --quiet --until 16 -o "$folder" --checkpoint 0.05 2>/dev/null &
  pid=$!
  sleep "$(between 0.05 2)"
  kill -9 "$pid" 2>/dev/null || true
  code=0
  { wait "$pid"; } 2>/dev/null || code=$?
  rows=0
  [ ! -e "$folder/mixing.csv" ] || rows=$(($(wc -l <"$folder/mixing.csv") - 1))
  [ "$code" -eq 137 ] && [ "$rows" -gt 0 ] || continue # at its end already, or before its first frame
  killed=$((killed + 1)) reported=$((reported + rows))

  recovered "$folder/trajectory.h5" "$work/sound.h5"
  read=$("$bedmix" replay "$folder" -o "$work/read" --quiet --json | frames_of) || read=0
  [ "$read" -gt 0 ] || unreadable=$((unreadable + 1))
  [ "$count" -ge "$rows" ] && [ "$read" -ge "$rows" ] || lost=$((lost + 1))

  size=$(stat -c %s "$folder/trajectory.h5")
  head -c "$(between "$((size / 5))" "$size" | cut -d. -f1)" "$folder/trajectory.h5" >"$work/cut.h5"
  recovered "$work/cut.h5" "$work/saved.h5"
  [ -e "$work/saved.h5" ] || continue
  cut=$((cut + 1)) saved=$((saved + count))
  "$bedmix" replay "$work/saved.h5" -o "$work/again" --quiet 2>/dev/null &&
    cmp -s "$work/again/mixing.csv" <(head -n "$((count + 1))" "$work/read/mixing.csv") || foreign=$((foreign + 1))
done
echo "| runs killed | frames reported | unreadable | runs with frames lost | cut copies saved | frames in them | not as recorded | files changed |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- |"
echo "| $killed | $reported | $unreadable | $lost | $cut | $saved | $foreign | $touched |"
[ "$((unreadable + lost + foreign + touched))" -eq 0 ]
