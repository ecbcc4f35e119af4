#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The paper's two cases over several seeds, as a table: mean and range of what Tian et al. (2007) report.
#   bash tests/validation/seeds.sh [run options, e.g. --set gas.scheme='"simple"']
# SCENES, SEEDS and OUT (folder) may be set. Runs as many at a time as there are processors, some 40 s each.
set -euo pipefail
cd "$(dirname "$0")/../.."
out=${OUT:-out/validation}
scenes=${SCENES:-tian-2007-even tian-2007-inclined}
seeds=${SEEDS:-1 2 3 4 5 6}

for scene in $scenes; do
  for seed in $seeds; do
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n; done
    build/release/bedmix run "$scene" --seed "$seed" --force --quiet -o "$out/$scene-$seed" "$@" &
  done
done
wait

# One line a run: t(A >= 0.9), mean and largest A over 5 to 10 s, mean flux, mean and largest counted fraction.
describe() {
  awk -F, 'FNR == 1 { file++; next }
    file == 1 && $3 != "" { if (t == "" && $3 >= 0.9) t = $1; if ($1 >= 5) { n++; sum += $3; if ($3 > max) max = $3 } }
    file == 1 { rows++; counted += $8; if ($8 > most) most = $8 }
    file == 2 { fluxes++; flux += $2 }
    END { print (t == "" ? "never" : t), sum / n, max, flux / fluxes, counted / rows, most }' "$1/mixing.csv" "$1/flux.csv"
}

echo "| scene | runs | t(A >= 0.9), s | mean A, 5-10 s | largest A | mean flux, kg/(m2 s) | counted | largest counted |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- |"
for scene in $scenes; do
  for seed in $seeds; do describe "$out/$scene-$seed"; done | awk -v scene="$scene" '
    { for (k = 1; k <= NF; k++) if ($k != "never") { v = $k + 0; sum[k] += v; n[k]++
        if (n[k] == 1 || v < low[k]) low[k] = v
        if (n[k] == 1 || v > high[k]) high[k] = v } }
    END { split("%.2f %.3f %.2f %.1f %.3f %.3f", form, " "); printf "| %s | %d |", scene, NR
      for (k = 1; k <= 6; k++) {
        if (n[k]) printf " " form[k] " (" form[k] " to " form[k] ")", sum[k] / n[k], low[k], high[k]
        if (n[k] < NR) printf " never in %d", NR - n[k]
        printf " |"
      }
      print "" }'
done
