// SPDX-License-Identifier: MIT
#include "engine/gas/face_layout.h"

namespace bedmix {

namespace {

/// Builds the lists of a FaceLayout; `open` answers false outside the grid.
class Builder {
 public:
  explicit Builder(const GasGrid& grid) : g_(grid) {
    out_.columns = g_.columns;
    out_.rows = g_.rows;
    out_.zeroFace = (g_.columns + 1) * g_.rows + g_.columns * (g_.rows + 1);
  }

  FaceLayout build() {
    addCells();
    addFaces();
    for (int j = 0; j < g_.rows; ++j)
      for (int i = 1; i < g_.columns; ++i)
        if (open(i - 1, j) && open(i, j)) out_.volumes.push_back(uprightVolume(i, j));
    for (int j = 1; j <= g_.rows; ++j)
      for (int i = 0; i < g_.columns; ++i)
        if (open(i, j - 1)) out_.volumes.push_back(levelVolume(i, j));
    return std::move(out_);
  }

 private:
  bool open(int i, int j) const { return i >= 0 && i < g_.columns && j >= 0 && j < g_.rows && g_.open(i, j); }
  int cell(int i, int j) const { return static_cast<int>(g_.cell(i, j)); }

  void addCells() {
    for (int j = 0; j < g_.rows; ++j)
      for (int i = 0; i < g_.columns; ++i) {
        out_.cellFaces.push_back(
            {out_.uFace(i, j), out_.uFace(i + 1, j), out_.vFace(i, j), out_.vFace(i, j + 1)});
        out_.cellVolume.push_back(g_.volume(i, j));
        if (open(i, j)) out_.openCells.push_back(cell(i, j));
      }
    for (int i = 0; i < g_.columns; ++i) {
      const int j = g_.lowestRow[i];
      const double area = g_.dx(i) * g_.thickness;
      out_.floor.push_back({out_.vFace(i, j), area, g_.inletFlux[i] * area});
    }
  }

  /// The cells whose halves make up the volume around a face; the open one alone at a boundary.
  FaceLayout::FaceCells halves(int i0, int j0, int i1, int j1) const {
    if (!open(i0, j0))
      return open(i1, j1) ? FaceLayout::FaceCells{cell(i1, j1), cell(i1, j1), 1.0} : FaceLayout::FaceCells{};
    if (!open(i1, j1)) return {cell(i0, j0), cell(i0, j0), 1.0};
    const double v0 = g_.volume(i0, j0), v1 = g_.volume(i1, j1);
    return {cell(i0, j0), cell(i1, j1), v0 / (v0 + v1)};
  }

  void addFaces() {
    for (int j = 0; j < g_.rows; ++j)
      for (int i = 0; i <= g_.columns; ++i) {
        out_.faceArea.push_back(g_.dy(j) * g_.thickness);
        out_.faceCells.push_back(halves(i - 1, j, i, j));
        int lowest = j;
        while (!open(i - 1, lowest) && !open(i, lowest)) ++lowest;
        out_.openFace.push_back(out_.uFace(i, lowest));
      }
    for (int j = 0; j <= g_.rows; ++j)
      for (int i = 0; i < g_.columns; ++i) {
        out_.faceArea.push_back(g_.dx(i) * g_.thickness);
        out_.faceCells.push_back(halves(i, j - 1, i, j));
        out_.openFace.push_back(out_.vFace(i, std::max(j, g_.lowestRow[i])));
      }
    out_.faceArea.push_back(0.0);
    out_.faceCells.push_back({});
    out_.openFace.push_back(out_.zeroFace);
  }

  MomentumVolume uprightVolume(int i, int j) const {
    const FaceLayout& o = out_;
    const double width = 0.5 * (g_.dx(i - 1) + g_.dx(i)), height = g_.dy(j);
    const double endArea = height * g_.thickness, sideArea = width * g_.thickness;
    MomentumVolume v{o.uFace(i, j), cell(i - 1, j), cell(i, j), false, endArea, width * endArea, {}};
    v.sides[0] = {o.uFace(i - 1, j), o.uFace(i - 1, j), v.face, -1.0, endArea / g_.dx(i - 1)};
    v.sides[1] = {o.uFace(i + 1, j), v.face, o.uFace(i + 1, j), 1.0, endArea / g_.dx(i)};
    const bool onFloor = !open(i - 1, j - 1) && !open(i, j - 1);
    v.sides[2] = {onFloor ? o.zeroFace : o.uFace(i, j - 1), o.vFace(i - 1, j), o.vFace(i, j), -1.0,
                  sideArea / (onFloor ? 0.5 * height : 0.5 * (height + g_.dy(j - 1)))};
    if (j + 1 < g_.rows)
      v.sides[3] = {o.uFace(i, j + 1), o.vFace(i - 1, j + 1), o.vFace(i, j + 1), 1.0,
                    sideArea / (0.5 * (height + g_.dy(j + 1)))};
    else
      v.sides[3] = {v.face, o.vFace(i - 1, j + 1), o.vFace(i, j + 1), 1.0, 0.0};
    return v;
  }

  MomentumVolume levelVolume(int i, int j) const {
    const FaceLayout& o = out_;
    const bool outlet = j == g_.rows;
    const double below = 0.5 * g_.dy(j - 1), above = outlet ? 0.0 : 0.5 * g_.dy(j);
    const double area = g_.dx(i) * g_.thickness;
    MomentumVolume v{
        o.vFace(i, j), cell(i, j - 1), outlet ? -1 : cell(i, j), true, area, area * (below + above), {}};
    v.sides[0] = levelSide(i, j, i - 1, i, -1.0, (below + above) * g_.thickness);
    v.sides[1] = levelSide(i, j, i + 1, i + 1, 1.0, (below + above) * g_.thickness);
    v.sides[2] = {o.vFace(i, j - 1), o.vFace(i, j - 1), v.face, -1.0, area / g_.dy(j - 1)};
    v.sides[3] = outlet ? MomentumSide{v.face, v.face, v.face, 1.0, 0.0}
                        : MomentumSide{o.vFace(i, j + 1), v.face, o.vFace(i, j + 1), 1.0, area / g_.dy(j)};
    return v;
  }

  /// Left or right side of the volume around level face (i, j): towards column `next`, through upright face
  /// `through`.
  MomentumSide levelSide(int i, int j, int next, int through, double outward, double area) const {
    const FaceLayout& o = out_;
    const bool outlet = j == g_.rows;
    MomentumSide side;
    side.outward = outward;
    side.fluxA = o.uFace(through, j - 1);
    side.fluxB = outlet ? o.zeroFace : o.uFace(through, j);
    const bool wall = !open(next, outlet ? j - 1 : j);
    side.neighbour = wall ? o.zeroFace : o.vFace(next, j);
    side.conductance = area / (wall ? 0.5 * g_.dx(i) : 0.5 * (g_.dx(i) + g_.dx(next)));
    return side;
  }

  const GasGrid& g_;
  FaceLayout out_;
};

}  // namespace

FaceLayout makeFaceLayout(const GasGrid& grid) { return Builder(grid).build(); }

}  // namespace bedmix
