#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What each effect costs: instructions per particle and step, counted by valgrind, beside the same bed without it, and
# bytes per particle. Beds and settings of the effects stand in effects.txt.
#   bash tests/bench/effects.sh BENCH_RUN [NAME...]                  a row an effect
#   bash tests/bench/effects.sh BENCH_RUN --against OTHER_BENCH_RUN  the plain beds, beside another build's
set -euo pipefail

ours=$(realpath "${1:?give bench_run, build/release/tests/bench/bench_run}")
shift
other=
if [[ ${1:-} == --against ]]; then
  other=$(realpath "${2:?give the bench_run of another build}")
  shift 2
fi
cd "$(dirname "${BASH_SOURCE[0]}")"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
short=500 long=1500 particles=1000 simd=avx2

# Options of a bed that is called packed or fluidized: case A's at 0 s without gas, or at 1 s with it.
bedOptions() { [[ $1 == packed ]] && echo packed.txt || echo fluidized.txt --gas 8; }

# Instructions per particle and step: NAME BENCH_RUN BED [OPTIONS]...
perStep() {
  local name=$1 program=$2 bed=$3 steps
  shift 3
  for steps in $short $long; do
    # shellcheck disable=SC2046
    env -i valgrind --command-line-only=yes --tool=callgrind --vgdb=no --callgrind-out-file=/dev/null \
      "$program" $(bedOptions "$bed") "$@" --simd $simd --relax 500 --steps $steps --repeats 1 \
      >"$scratch/$name.$steps" 2>&1 || { cat "$scratch/$name.$steps" >&2; return 1; }
  done
  awk -v n=$(((long - short) * particles)) '/Collected :/ { c[FILENAME] = $NF; names[++k] = FILENAME }
    END { printf "%.1f\n", (c[names[2]] - c[names[1]]) / n }' "$scratch/$name.$short" "$scratch/$name.$long"
}

# Bytes per particle of a larger bed, whose constant part does not count: BED [OPTIONS]...
bytes() {
  local bed=$1 tiles=100
  shift
  # shellcheck disable=SC2046
  "$ours" $(bedOptions "$bed") "$@" --tile $tiles --relax 0 --steps 20 --repeats 1 | awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "bytes_per_particle") at = i } NR == 2 { print $at }'
}

if [[ -n $other ]]; then
  for bed in packed fluidized; do
    now=$(perStep "now-$bed" "$ours" $bed) then=$(perStep "then-$bed" "$other" $bed)
    awk "BEGIN { printf \"%-10s %7.1f here, %7.1f there, %+.2f %%\n\", \"$bed\", $now, $then, 100 * ($now / $then - 1) }"
  done
  exit
fi

printf 'effect,bed,instructions_per_particle_step,without,bytes_per_particle,without\n'
declare -A plain plainBytes
while IFS='|' read -r name bed with without; do
  [[ -z $name || $name == '#'* ]] && continue
  [[ $# -gt 0 && " $* " != *" $name "* ]] && continue
  eval "setWith=($with) setWithout=($without)"
  key="$bed ${setWithout[*]}"
  if [[ -z ${plain[$key]:-} ]]; then
    plain[$key]=$(perStep plain "$ours" "$bed" "${setWithout[@]}")
    plainBytes[$key]=$(bytes "$bed" "${setWithout[@]}")
  fi
  printf '%s,%s,%s,%s,%s,%s\n' "$name" "$bed" "$(perStep "$name" "$ours" "$bed" "${setWith[@]}")" "${plain[$key]}" \
    "$(bytes "$bed" "${setWith[@]}")" "${plainBytes[$key]}"
done <effects.txt
