#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Kills runs at random moments, and fills the disk under others, and goes on with them each time; at the end
# everything must be as if nothing had happened. Prints a table.
#   bash tests/validation/kills.sh
# BEDMIX (program), KILLS (200), DISKS (20) and SEED (1) may be set. Every second full disk is a real one, a
# tmpfs, where root may mount one. Takes some minutes. Exits 1 where anything was lost.
set -euo pipefail
cd "$(dirname "$0")/../.."
bedmix=$(realpath "${BEDMIX:-build/release/bedmix}")
kills=${KILLS:-200} disks=${DISKS:-20} until=16 perRun=10
RANDOM=${SEED:-1}
work=$(mktemp -d)
disk=$work/disk
trap 'mountpoint -q "$disk" && umount "$disk"; rm -rf "$work"' EXIT

# Name and settings of each kind of run.
names=(tiny simple rk4 smooth dry)
settings_tiny=() settings_simple=(--set 'gas.scheme="simple"') settings_rk4=(--set 'time.integrator="rk4"')
settings_smooth=(--set contacts.friction=) settings_dry=(--set gas=)

run() { # KIND FOLDER [OPTION...]; with by=exec in the place of its shell, so that a kill meets the program
  local -n settings=settings_$1
  local folder=$2
  shift 2
  ${by:-} "$bedmix" run tiny --quiet --until "$until" -o "$folder" "${settings[@]}" "$@"
}
hash_of() { grep state_hash "$1/summary.json"; }
# Whether a run came to the results of the undisturbed one of its kind.
same() { # KIND FOLDER
  [ "$(hash_of "$2")" = "$(hash_of "$work/whole-$1")" ] || return 1
  for csv in "$work/whole-$1"/*.csv; do cmp -s "$csv" "$2/${csv##*/}" || return 1; done
  "$bedmix" replay "$2" -o "$2/again" --quiet && cmp -s "$2/mixing.csv" "$2/again/mixing.csv"
}
# Reads a trajectory as it was left: counts those that cannot be read, and those with fewer frames than there
# were when it was looked at last, or than the series have whole lines, which are written after their frames.
look() { # FOLDER
  local rows=0 frames
  [ ! -e "$1/mixing.csv" ] || rows=$(($(wc -l <"$1/mixing.csv") - 1))
  [ "$rows" -gt 0 ] || return 0 # not a frame was reported
  if ! frames=$("$bedmix" replay "$1" -o "$work/look" --quiet --json | sed -n 's/.*"frames": \([0-9]*\).*/\1/p'); then
    unreadable=$((unreadable + 1))
  elif [ "$frames" -lt "$rows" ] || [ "$frames" -lt "$seen" ]; then
    lost=$((lost + 1))
  else
    seen=$frames
  fi
}
mib() { awk -v r="$RANDOM" -v from="$1" -v to="$2" 'BEGIN { printf "%d", from + (to - from) * r / 32768 }'; }

for kind in "${names[@]}"; do run "$kind" "$work/whole-$kind" & done
wait

unreadable=0 lost=0 other=0 anew=0 done=0 runs=0
while [ "$done" -lt "$kills" ]; do
  kind=${names[runs % ${#names[@]}]} folder=$work/killed
  seconds=$(sed -n 's/.*"wall_seconds": \([0-9.e+-]*\).*/\1/p' "$work/whole-$kind/summary.json")
  rm -rf "$folder"
  resume=() killed=0 seen=0
  while [ "$killed" -lt "$perRun" ] && [ "$done" -lt "$kills" ]; do
    by=exec run "$kind" "$folder" --checkpoint 0.05 --threads $((1 + RANDOM % 2)) "${resume[@]}" 2>/dev/null &
    pid=$!
    sleep "$(awk -v r="$RANDOM" -v s="$seconds" -v n="$perRun" 'BEGIN { print 0.02 + 1.5 * s / n * r / 32768 }')"
    kill -9 "$pid" 2>/dev/null || true
    code=0
    { wait "$pid"; } 2>/dev/null || code=$?
    [ "$code" -eq 137 ] || break # it had come to its end
    killed=$((killed + 1)) done=$((done + 1)) resume=(--resume)
    look "$folder"
    # Killed before its first checkpoint there is nothing to go on with, and it says so.
    if ! grep -qs '!bedmckp' "$folder/trajectory.h5"; then
      resume=(--force) seen=0 anew=$((anew + 1))
    fi
  done
  run "$kind" "$folder" "${resume[@]}" 2>/dev/null || true
  same "$kind" "$folder" || { other=$((other + 1)); echo "another result: $kind, run $runs" >&2; }
  runs=$((runs + 1))
done
echo "| trial | runs | stops | before the first checkpoint | unreadable files | reported frames lost | other results |"
echo "| --- | --- | --- | --- | --- | --- | --- |"
echo "| kill -9 | $runs | $done | $anew | $unreadable | $lost | $other |"
failures=$((unreadable + lost + other))

unreadable=0 lost=0 other=0 anew=0 full=0
mkdir -p "$disk"
for ((trial = 0; trial < disks; ++trial)); do
  kind=${names[trial % ${#names[@]}]} folder=$work/full
  whole=$(($(stat -c %s "$work/whole-$kind/trajectory.h5") / 1024))
  kib=$(mib 8 $((whole * 9 / 10))) code=0
  if ((trial % 2 == 0)) && mount -t tmpfs -o size="${kib}k" tmpfs "$disk" 2>/dev/null; then folder=$disk/full; fi
  rm -rf "$folder"
  seen=0
  (ulimit -f "$kib" && run "$kind" "$folder" --checkpoint 0.05 2>/dev/null) || code=$?
  [ "$code" -eq 4 ] && full=$((full + 1)) || echo "exit $code on a full disk: $kind" >&2
  look "$folder"
  ! mountpoint -q "$disk" || mount -o remount,size=64m "$disk"
  if grep -qs '!bedmckp' "$folder/trajectory.h5"; then resume=(--resume); else resume=(--force) anew=$((anew + 1)); fi
  run "$kind" "$folder" "${resume[@]}" 2>/dev/null || true
  same "$kind" "$folder" || { other=$((other + 1)); echo "another result: $kind, $kib KiB" >&2; }
  ! mountpoint -q "$disk" || umount "$disk"
done
echo "| full disk | $disks | $full | $anew | $unreadable | $lost | $other |"
[ "$((failures + unreadable + lost + other))" -eq 0 ] && [ "$full" -eq "$disks" ]
