#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Drawing beside VTK: the same frames, size and OpenGL (Mesa's llvmpipe), turn by turn, medians.
#   bash tests/bench/vtk.sh BENCH_DRAW [ROUNDS]
# BENCH_DRAW is build/bench/tests/bench/bench_draw. THREADS (default "1 2") lists llvmpipe's threads, SECONDS_A_TURN (default 2)
# says how long a turn takes. Debian's python3-vtk9, python3-numpy, xvfb and xauth must be there: its VTK needs an X
# server.
set -euo pipefail

give_up() {
  echo "vtk: $*" >&2
  exit 1
}

(($# >= 1)) || give_up "give BENCH_DRAW [ROUNDS]; the first lines of this file explain"
ours=$1 rounds=${2:-5} threads=${THREADS:-1 2} seconds=${SECONDS_A_TURN:-2}
[[ -x $ours ]] || give_up "$ours is not there; build with -DBEDMIX_BENCH=ON"
command -v xvfb-run >/dev/null && /usr/bin/python3 -c 'import vtk, numpy' || give_up "apt install python3-vtk9 python3-numpy xvfb xauth"
here=$(dirname "$0")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$ours" --write "$scratch"

run_ours() { # PARTICLES
  "$ours" --benchmark_filter="^drawing/$1/" --benchmark_min_time="$seconds" --benchmark_format=csv 2>/dev/null |
    awk -F, '/^"drawing/ { print $3, $4 }'
}

run_vtk() { # PARTICLES WIDTH HEIGHT MODE
  xvfb-run -a -s "-screen 0 1920x1080x24" /usr/bin/python3 "$here/vtk_frames.py" "$scratch" "$1" "$2" "$3" "$4" "$seconds" 2>/dev/null
}

for n in $threads; do
  export LP_NUM_THREADS=$n
  for ((r = 0; r < rounds; r++)); do
    while read -r particles width height mode; do
      echo "$n $particles ${width}x$height $mode $(run_ours "$particles") $(run_vtk "$particles" "$width" "$height" "$mode")"
    done <<<"1000 1280 720 gaussian
1000 1280 720 sphere
100000 1920 1080 gaussian"
  done
done >"$scratch/rows"

# Medians; the ratio is that of a turn, as both ran under the same load there.
awk 'function median(values, count,   i, j, swap) {
    for (i = 2; i <= count; i++)
      for (j = i; j > 1 && values[j - 1] > values[j]; j--) { swap = values[j]; values[j] = values[j - 1]; values[j - 1] = swap }
    return (values[int((count + 1) / 2)] + values[int(count / 2) + 1]) / 2
  }
  {
    key = $1 " | " $2 " | " $3 " | " $4
    if (!(key in rows)) order[++kinds] = key
    k = ++rows[key]
    wall[key, k] = 1e3 / $5
    cpu[key, k] = 1e3 / $6
    peerWall[key, k] = 1e3 / $7
    peerCpu[key, k] = 1e3 / $8
  }
  END {
    print "| threads | discs | px | VTK draws | bedmix, pictures/s | VTK | ratio | bedmix, pictures per CPU s | VTK | ratio | lowest to highest |"
    print "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
    for (i = 1; i <= kinds; i++) {
      key = order[i]; n = rows[key]
      for (k = 1; k <= n; k++) { a[k] = wall[key, k]; b[k] = peerWall[key, k]; ratio[k] = a[k] / b[k] }
      printf "| %s | %.0f | %.3g | %.1f |", key, median(a, n), median(b, n), median(ratio, n)
      for (k = 1; k <= n; k++) { a[k] = cpu[key, k]; b[k] = peerCpu[key, k]; ratio[k] = a[k] / b[k] }
      middle = median(ratio, n)
      printf " %.0f | %.3g | %.1f | %.1f to %.1f |\n", median(a, n), median(b, n), middle, ratio[1], ratio[n]
    }
  }' "$scratch/rows"
