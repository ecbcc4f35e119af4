#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Instructions per particle and step, counted by valgrind, beside those in instructions.csv: they hardly depend on the
# machine and not on its load, so that a loop that got slower is noticed at once.
#   bash tests/bench/instructions.sh BENCH_RUN [--renew]
# fails where a count has moved by more than 3 %; --renew writes the new ones. The beds are case A's at 0 s (packed, run
# without gas) and at 1 s (fluidized). Vector levels that valgrind does not know on this machine are left out.
set -euo pipefail

ours=$(realpath "${1:?give bench_run, build/release/tests/bench/bench_run}")
cd "$(dirname "${BASH_SOURCE[0]}")"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
short=500 long=3000 particles=1000

# Nothing of the user's own may change a count.
count() { # NAME SIMD STEPS BENCH_RUN-OPTIONS...
  env -i valgrind --command-line-only=yes --tool=callgrind --vgdb=no --callgrind-out-file=/dev/null \
    "$ours" "${@:4}" --simd "$2" --relax 500 --steps "$3" --repeats 1 >"$scratch/$1.$2.$3" 2>&1 ||
    grep -q 'not on this machine' "$scratch/$1.$2.$3" || cat "$scratch/$1.$2.$3" >&2
}

for simd in baseline avx2; do
  for steps in $short $long; do
    count packed "$simd" "$steps" packed.txt &
    count fluidized "$simd" "$steps" fluidized.txt --gas 8 &
  done
done
wait

counts=$(
  for bed in packed fluidized; do
    for simd in baseline avx2; do
      collected() { awk '/Collected :/ { print $NF }' "$scratch/$bed.$simd.$1"; }
      few=$(collected $short) many=$(collected $long)
      [[ -z $few ]] || awk "BEGIN { printf \"%s,%s,%.1f\n\", \"$bed\", \"$simd\", ($many - $few) / ($long - $short) / $particles }"
    done
  done
)
[[ $counts == packed,baseline,* ]] || exit 1
if [[ ${2:-} == --renew ]]; then
  printf 'bed,simd,instructions_per_particle_step\n%s\n' "$counts" | tee instructions.csv
  exit
fi
awk -F, 'FNR == NR { stored[$1, $2] = $3; next }
  {
    change = 100 * ($3 / stored[$1, $2] - 1)
    printf "%-10s %-9s %7.1f instructions, %7.1f stored, %+.1f %%\n", $1, $2, $3, stored[$1, $2], change
    if (change > 3 || change < -3) moved = 1
  }
  END { if (moved) print "more than 3 % off; where that is meant: bash tests/bench/instructions.sh BENCH_RUN --renew"; exit moved }' \
  instructions.csv - <<<"$counts"
