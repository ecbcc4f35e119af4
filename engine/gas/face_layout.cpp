// SPDX-License-Identifier: MIT
#include "engine/gas/face_layout.h"

#include <algorithm>

namespace bedmix {

namespace {

/// Builds the lists of a FaceLayout; `open` answers false outside the grid.
class Builder {
 public:
  explicit Builder(const GasGrid& grid) : g_(grid) {
    out_.columns = g_.columns;
    out_.rows = g_.rows;
    out_.repeats = g_.repeats;
    out_.stride = g_.columns + (g_.repeats ? 2 : 1);
    out_.size = out_.stride * (g_.rows + 3);
    out_.families[0] = {0, 1, out_.stride, g_.rows};
    out_.families[1] = {out_.size, out_.stride, 1, g_.rows + 1};
    for (int i = 0; i < g_.columns; ++i) out_.width.push_back(g_.dx(i));
    for (int j = 0; j < g_.rows; ++j) out_.height.push_back(g_.dy(j));
    const auto faces = static_cast<std::size_t>(out_.faces()), places = static_cast<std::size_t>(out_.size);
    for (auto* field :
         {&out_.faceArea, &out_.solved, &out_.alongSide, &out_.acrossSide, &out_.wall, &out_.weightBefore})
      field->assign(faces, 0.0);
    out_.volume.assign(faces, 1.0);
    out_.voidageCell.assign(places, 0);
    out_.open.assign(places, 0.0);
  }

  FaceLayout build() {
    addCells();
    addUprightFaces();
    addLevelFaces();
    for (int j = 0; j < g_.rows; ++j)
      for (int i = g_.repeats ? 0 : 1; i < g_.columns; ++i)
        if (open(i - 1, j) && open(i, j)) addUprightVolume(i, j);
    for (int j = 1; j <= g_.rows; ++j)
      for (int i = 0; i < g_.columns; ++i)
        if (open(i, j - 1) && (j == g_.rows || open(i, j))) addLevelVolume(i, j);
    if (g_.repeats) fillGhosts();
    return std::move(out_);
  }

 private:
  int around(int i) const { return g_.repeats ? g_.columnAround(i) : i; }
  bool open(int i, int j) const {
    i = around(i);
    return i >= 0 && i < g_.columns && j >= 0 && j < g_.rows && g_.open(i, j);
  }
  int cell(int i, int j) const { return static_cast<int>(g_.cell(around(i), j)); }
  double dx(int i) const { return g_.dx(around(i)); }
  int lowestRow(int i) const {
    i = around(i);
    return i >= 0 && i < g_.columns ? g_.lowestRow[i] : g_.rows;
  }
  double volume(int i, int j) const { return g_.volume(around(i), j); }

  void addCells() {
    for (int j = 0; j < g_.rows; ++j)
      for (int i = 0; i < g_.columns; ++i) {
        out_.cellFaces.push_back(
            {out_.uFace(i, j), out_.uFace(i + 1, j), out_.vFace(i, j), out_.vFace(i, j + 1)});
        out_.cellVolume.push_back(g_.volume(i, j));
        if (!open(i, j)) continue;
        out_.openCells.push_back(cell(i, j));
        out_.open[out_.at(i, j)] = g_.volume(i, j);
      }
    for (int i = 0; i < g_.columns; ++i) {
      const int lowest = g_.lowestRow[i];
      for (int j = -1; j < g_.rows; ++j)
        out_.voidageCell[out_.at(i, j)] = static_cast<int>(g_.openCellFor(i, std::max(j, 0)));
      const double area = g_.dx(i) * g_.thickness;
      const int above = static_cast<int>(g_.openCellFor(i, lowest));
      out_.floor.push_back({out_.vFace(i, lowest), above, area, g_.inletFlux[i] * area});
    }
  }

  /// By volume of the cells before and behind a face; the open one alone at a boundary.
  double weightBefore(int i0, int j0, int i1, int j1) const {
    if (!open(i0, j0)) return 0.0;
    if (!open(i1, j1)) return 1.0;
    const double before = volume(i0, j0);
    return before / (before + volume(i1, j1));
  }

  void addUprightFaces() {
    for (int i = 0; i <= g_.columns; ++i) {
      const int lowest = std::min(lowestRow(i - 1), lowestRow(i));
      for (int j = -1; j < g_.rows; ++j) {
        const int f = out_.uFace(i, j), nearest = std::max(j, lowest);
        out_.weightBefore[f] = weightBefore(i - 1, nearest, i, nearest);
        if (j >= 0) out_.faceArea[f] = g_.dy(j) * g_.thickness;
      }
    }
  }

  void addLevelFaces() {
    for (int i = 0; i < g_.columns; ++i)
      for (int j = 0; j <= g_.rows; ++j) {
        const int f = out_.vFace(i, j);
        out_.weightBefore[f] = weightBefore(i, j - 1, i, j);
        out_.faceArea[f] = g_.dx(i) * g_.thickness;
      }
  }

  void addVolume(const MomentumVolume& v) {
    out_.volumes.push_back(v);
    out_.solved[v.face] = 1.0;
    out_.volume[v.face] = v.volume;
  }

  void addUprightVolume(int i, int j) {
    const double width = 0.5 * (dx(i - 1) + dx(i)), height = g_.dy(j);
    const double endArea = height * g_.thickness;
    const int f = out_.uFace(i, j);
    addVolume({f, cell(i - 1, j), cell(i, j), false, endArea, width * endArea});
    out_.alongSide[f] = endArea / dx(i - 1);
    out_.alongSide[f + 1] = endArea / dx(i);
    // On the floor the neighbour is the face below it, which has no velocity.
    const bool onFloor = !open(i - 1, j - 1) && !open(i, j - 1);
    out_.acrossSide[f] = width * g_.thickness / (onFloor ? 0.5 * height : 0.5 * (height + g_.dy(j - 1)));
    // Below an obstacle likewise; elsewhere the side above is that of the volume there.
    if (j + 1 == g_.rows || (open(i - 1, j + 1) && open(i, j + 1))) return;
    const bool belowCeiling = !open(i - 1, j + 1) && !open(i, j + 1);
    out_.acrossSide[f + out_.stride] =
        width * g_.thickness / (belowCeiling ? 0.5 * height : 0.5 * (height + g_.dy(j + 1)));
  }

  void addLevelVolume(int i, int j) {
    const bool outlet = j == g_.rows;
    const double height = 0.5 * g_.dy(j - 1) + (outlet ? 0.0 : 0.5 * g_.dy(j));
    const double area = g_.dx(i) * g_.thickness, sideArea = height * g_.thickness;
    const int f = out_.vFace(i, j);
    addVolume({f, cell(i, j - 1), outlet ? -1 : cell(i, j), true, area, area * height});
    out_.alongSide[f] = area / g_.dy(j - 1);
    if (!outlet && j + 1 < g_.rows && !open(i, j + 1)) out_.alongSide[f + out_.stride] = area / g_.dy(j);
    for (int next : {i - 1, i + 1}) {
      if (open(next, outlet ? j - 1 : j))
        out_.acrossSide[std::max(f, out_.vFace(next, j))] = sideArea / (0.5 * (dx(i) + dx(next)));
      else
        out_.wall[f] += sideArea / (0.5 * g_.dx(i));
    }
  }

  /// What loops over whole rows ask of ghosts: whose voidage they have, and how large faces are.
  void fillGhosts() {
    for (int j = -1; j < g_.rows; ++j) {
      out_.voidageCell[out_.at(-1, j)] = out_.voidageCell[out_.at(g_.columns - 1, j)];
      out_.voidageCell[out_.at(g_.columns, j)] = out_.voidageCell[out_.at(0, j)];
    }
    out_.copyAround(Member(), out_.faceArea);
  }

  const GasGrid& g_;
  FaceLayout out_;
};

}  // namespace

void FaceLayout::copyAround(double* frame, Range mine) const {
  if (!repeats) return;
  for (int j = static_cast<int>(mine.begin); j < static_cast<int>(mine.end); ++j) {
    frame[at(-1, j)] = frame[at(columns - 1, j)];
    frame[at(columns, j)] = frame[at(0, j)];
  }
}

void FaceLayout::copyAround(const Member& member, std::vector<double>& faces) const {
  for (const FaceFamily& family : families) copyAround(&faces[family.first], member.share(family.rows));
}

FaceLayout makeFaceLayout(const GasGrid& grid) { return Builder(grid).build(); }

}  // namespace bedmix
