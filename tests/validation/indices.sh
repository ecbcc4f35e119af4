#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Where the indices of one run disagree, over time and with the size of the sampling cells, as a figure of
# 180 mm at 300 dpi.
#   bash tests/validation/indices.sh RUN FILE.png
# Needs a build and gnuplot. Curves are means over 0.1 s, as `bedmix replay --analysis indices` takes them to
# tell when a bed is mixed.
set -euo pipefail
run=$1 figure=$(realpath -m "$2")
cd "$(dirname "$0")/../.."
tables=$(mktemp -d)
trap 'rm -rf "$tables"' EXIT
build/release/bedmix replay "$run" -o "$tables" --analysis indices,sampling --quiet

# Columns `time` and those asked for, each the mean of 11 samples around every fifth.
smooth() {
  awk -F, -v names="$1" '
    NR == 1 { for (c = 1; c <= NF; c++) at[$c] = c; n = split(names, want, " "); next }
    { t[NR] = $1; for (k = 1; k <= n; k++) v[NR, k] = $at[want[k]] }
    END { for (r = 7; r + 5 <= NR; r += 5) {
        printf "%s", t[r]
        for (k = 1; k <= n; k++) {
          sum = count = 0
          for (j = r - 5; j <= r + 5; j++) if (v[j, k] != "") { sum += v[j, k]; count++ }
          printf ",%s", count ? sum / count : "nan"
        }
        print "" } }' "$tables/indices.csv"
}
smooth "lacey ashton kramers entropy nearest_neighbour principal_component" > "$tables/smooth.csv"

gnuplot <<EOF
set encoding utf8
set terminal pngcairo size 2126,1000 font 'DejaVu Sans,24' linewidth 2.5 noenhanced
set output '$figure'
set datafile separator comma
set grid linecolor rgb '#D0D0D0' linetype 1 linewidth 0.5
set tics nomirror out
set border 3
set multiplot layout 1,2 margins 0.083,0.985,0.155,0.92 spacing 0.095
set key bottom right samplen 2 spacing 1.1
set title 'Sampling as in the scene, means over 0.1 s'
set xlabel 'time (s)'
set ylabel 'index'
set yrange [-0.05:1.1]
set ytics 0.2
plot 1 notitle with lines linecolor rgb '#808080' dashtype 2 linewidth 0.8, \
  '$tables/smooth.csv' using 1:2 title 'Lacey' with lines linecolor rgb '#0072B2', \
  '' using 1:3 title 'Ashton' with lines linecolor rgb '#D55E00', \
  '' using 1:4 title 'Kramers' with lines linecolor rgb '#CC79A7', \
  '' using 1:5 title 'entropy' with lines linecolor rgb '#E69F00', \
  '' using 1:6 title 'nearest neighbour' with lines linecolor rgb '#009E73', \
  '' using 1:(1 - \$7) title '1 - principal component' with lines linecolor rgb '#000000' dashtype 3 linewidth 1.5
set title 'Means over the second half, cells of other sizes'
set xlabel 'particles in a used cell'
set logscale x
set autoscale xfix
set xrange [] reverse
set key bottom left Left reverse
set xtics (1, 2, 5, 10, 20, 50, 100, 200, 500)
set yrange [0.65:1.05]
set ytics 0.1
set xtics nomirror out
plot 1 notitle with lines linecolor rgb '#808080' dashtype 2 linewidth 0.8, \
  '$tables/sampling.csv' using 4:6 title 'Lacey' with linespoints pointtype 7 linecolor rgb '#0072B2', \
  '' using 4:8 title 'Lacey, weighted' with linespoints pointtype 6 linecolor rgb '#56B4E9', \
  '' using 4:7 title 'Ashton' with linespoints pointtype 7 linecolor rgb '#D55E00', \
  '' using 4:9 title 'nearest neighbour' with lines linecolor rgb '#009E73'
EOF
