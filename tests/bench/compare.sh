#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Particles alone beside LIGGGHTS: the same states, steps and core, turn by turn, medians.
#   bash tests/bench/compare.sh BENCH_RUN DECK STATES [ROUNDS]
# BENCH_RUN is build/bench/tests/bench/bench_run, DECK a folder with mkdata.py and liggghts/in.dem, STATES a folder with
# files packed_N.txt and agit_N.txt of rows `x y vx vy`. CORE (default 0) and OUT (default out/bench, all rows) may be set.
# Debian's liggghts, python3-numpy must be there.
set -euo pipefail

give_up() {
  echo "compare: $*" >&2
  exit 1
}

(($# >= 3)) || give_up "give BENCH_RUN DECK STATES [ROUNDS]; the first lines of this file explain"
ours=$1 deck=$2 states=$3 rounds=${4:-3}
core=${CORE:-0} out=${OUT:-out/bench}
[[ -x $ours ]] || give_up "$ours is not there; build with -DBEDMIX_BENCH=ON"
[[ -f $deck/liggghts/in.dem && -f $deck/mkdata.py ]] || give_up "$deck has no mkdata.py and liggghts/in.dem"
command -v liggghts >/dev/null || give_up "apt install liggghts python3-numpy"
mkdir -p "$out"
rm -f "$out/bedmix.csv" "$out/liggghts.csv"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# Six digits, the default, are too few to tell who touches in a wide bed.
sed 's/^write_dump.*/& modify format "%d %.15g %.15g %.15g %.15g"/' "$deck/liggghts/in.dem" >"$scratch/in.dem"

# State, particles, steps before the clock starts, steps measured.
cases="packed 1000 5000 20000
packed 10000 2000 5000
packed 100000 500 500
agit 1000 500 5000
agit 10000 500 5000
agit 100000 500 1000"

run_ours() { # NAME RELAX STEPS
  taskset -c "$core" "$ours" "$states/$1.txt" --relax "$2" --steps "$3" --repeats 1 >"$scratch/row"
  [[ -f $out/bedmix.csv ]] || head -1 "$scratch/row" >"$out/bedmix.csv"
  tail -1 "$scratch/row" >>"$out/bedmix.csv"
}

run_liggghts() { # NAME RELAX STEPS N
  local width
  width=$(awk "BEGIN { print 0.096 * $4 / 1000 }")
  [[ -f $scratch/$1.data ]] || /usr/bin/python3 "$deck/mkdata.py" lmp "$states/$1.txt" "$scratch/$1.data" "$width"
  taskset -c "$core" liggghts -log none -in "$scratch/in.dem" -var dim 3 -var bz f -var skin 0.001 \
    -var data "$scratch/$1.data" -var W "$width" -var nrelax "$2" -var n "$3" -var dump "$scratch/$1.dump" >"$scratch/log"
  [[ -f $out/liggghts.csv ]] || echo "case,particles,steps,ns_per_particle_step,contacts_per_particle" >"$out/liggghts.csv"
  # Contacts as bedmix counts them in the state LIGGGHTS ended in.
  awk 'NR > 9 { print $2, $3, $4, $5 }' "$scratch/$1.dump" >"$scratch/end.txt"
  local contacts
  contacts=$("$ours" "$scratch/end.txt" --relax 0 --steps 1 --repeats 1 |
    awk -F, 'NR == 1 { for (c = 1; c <= NF; c++) column[$c] = c } END { print $column["contacts_per_particle"] }')
  awk -v name="$1" -v n="$4" -v steps="$3" -v contacts="$contacts" '/^Loop time/ { seconds = $4 }
    END { printf "%s,%d,%d,%.2f,%s\n", name, n, steps, 1e9 * seconds / n / steps, contacts }' "$scratch/log" >>"$out/liggghts.csv"
}

while read -r state n relax steps; do
  for ((r = 0; r < rounds; r++)); do
    run_ours "${state}_$n" "$relax" "$steps"
    run_liggghts "${state}_$n" "$relax" "$steps" "$n"
  done
done <<<"$cases"

# Medians; the ratio is that of a round, as both ran under the same load there.
awk -F, 'function median(values, count,   i, j, swap) {
    for (i = 2; i <= count; i++)
      for (j = i; j > 1 && values[j - 1] > values[j]; j--) { swap = values[j]; values[j] = values[j - 1]; values[j - 1] = swap }
    return (values[int((count + 1) / 2)] + values[int(count / 2) + 1]) / 2
  }
  FNR == 1 { file++; for (c = 1; c <= NF; c++) column[file, $c] = c; next }
  {
    if (file == 1 && !($1 in rows)) order[++kinds] = $1
    k = file == 1 ? ++rows[$1] : ++peers[$1]
    cost[file, $1, k] = $column[file, "ns_per_particle_step"]
    contacts[file, $1] = $column[file, "contacts_per_particle"]
  }
  END {
    print "| state | bedmix, particle-steps/s | LIGGGHTS | ratio | lowest to highest ratio | contacts a particle, both |"
    print "| --- | --- | --- | --- | --- | --- |"
    for (i = 1; i <= kinds; i++) {
      s = order[i]; n = rows[s]
      for (k = 1; k <= n; k++) { a[k] = 1e9 / cost[1, s, k]; b[k] = 1e9 / cost[2, s, k]; ratio[k] = a[k] / b[k] }
      middle = median(ratio, n)
      printf "| %s | %.3g | %.3g | %.2f | %.2f to %.2f | %s, %s |\n", s, median(a, n), median(b, n), middle, ratio[1], ratio[n],
        contacts[1, s], contacts[2, s]
    }
  }' "$out/bedmix.csv" "$out/liggghts.csv"
