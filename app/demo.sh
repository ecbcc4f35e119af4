#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# From a bare Debian 12 to the film, the picture and the curve of the paper's case A, in out/demo/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source app/setup.sh

cmake --preset release
cmake --build --preset release --target bedmix

bedmix=build/release/bedmix
"$bedmix" run tian-2007-even -o out/demo --video --force
"$bedmix" sheet out/demo -o out/demo/sheet.png
"$bedmix" plot out/demo -o out/demo/mixing.png --kind mixing

cat <<TEXT

The paper's case A, 10 s:
  film     $PWD/out/demo/video.mp4
  picture  $PWD/out/demo/sheet.png
  curve    $PWD/out/demo/mixing.png
  numbers  $PWD/out/demo/mixing.csv, flux.csv, pressure.csv, summary.json
TEXT
