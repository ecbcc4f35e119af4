// SPDX-License-Identifier: MIT
#include "render/draw_list.h"

namespace bedmix {

void DrawList::clear() {
  triangles.clear();
  discs.clear();
  lines.clear();
  texts.clear();
}

}  // namespace bedmix
