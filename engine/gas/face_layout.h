// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"

#include <array>
#include <cstddef>
#include <vector>

namespace bedmix {

/// One side of a momentum control volume.
struct MomentumSide {
  int neighbour = 0;  // face whose velocity is the neighbour's; the zero face at a no-slip wall; itself at
                      // the outlet (zero gradient)
  int fluxA = 0, fluxB = 0;  // faces whose mean mass flux crosses this side
  double outward = 1.0;      // +1 where that flux counts outward as it stands, else -1
  double conductance = 0.0;  // area over distance to the neighbour, m
};

/// The control volume around one face whose velocity is solved for.
struct MomentumVolume {
  int face = 0;
  int cellMinus = 0;  // the cell to the left or below
  int cellPlus = 0;   // the cell to the right or above; -1 at the outlet, where pressure is zero
  bool vertical = false;
  double area = 0.0;    // m2
  double volume = 0.0;  // m3
  std::array<MomentumSide, 4> sides;
};

/// A floor face and what enters there.
struct FloorFace {
  int face = 0;
  double area = 0.0;  // m2
  double flux = 0.0;  // m3/s, upward
};

/// The staggered arrangement: one numbering for all faces, first the upright ones (x-velocity, row by row),
/// then the level ones (y-velocity), and last one face whose velocity and flux are always zero. Everything
/// the gas solver walks along is listed here once, so that its loops need no case distinctions for walls,
/// risers, inlets or the outlet. Riser and wall faces keep zero velocity; the top faces belong to half-height
/// volumes with zero gradient above.
struct FaceLayout {
  int columns = 0, rows = 0;
  int zeroFace = 0;  // also the number of real faces
  std::vector<MomentumVolume> volumes;
  std::vector<FloorFace> floor;               // one a column
  std::vector<int> openCells;                 // in cell order
  std::vector<std::array<int, 4>> cellFaces;  // per cell: left, right, bottom, top
  std::vector<double> cellVolume;             // m3
  std::vector<double> faceArea;               // m2, 0 at the zero face
  /// Voidage of a face = weight * voidage[cellA] + (1 - weight) * voidage[cellB]: by volume of the two half
  /// cells.
  struct FaceCells {
    int a = 0, b = 0;
    double weightA = 1.0;
  };
  std::vector<FaceCells> faceCells;
  /// Per face, the face a particle takes its gas velocity from: itself, or the lowest open one of its column
  /// where the particle dips into blocked cells.
  std::vector<int> openFace;

  int uFace(int i, int j) const { return j * (columns + 1) + i; }
  int vFace(int i, int j) const { return (columns + 1) * rows + j * columns + i; }
};

FaceLayout makeFaceLayout(const GasGrid& grid);

}  // namespace bedmix
