// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"
#include "engine/core/thread_team.h"
#include "engine/gas/member.h"

#include <array>
#include <cstddef>
#include <vector>

namespace bedmix {

/// The control volume around one face whose velocity is solved for.
struct MomentumVolume {
  int face = 0;
  int cellMinus = 0;  // the cell to the left or below
  int cellPlus = 0;   // the cell to the right or above; -1 at the outlet, where pressure is zero
  bool vertical = false;
  double area = 0.0;    // m2
  double volume = 0.0;  // m3
};

/// A floor face and what enters there.
struct FloorFace {
  int face = 0;
  int cell = 0;       // the open one above
  double area = 0.0;  // m2
  double flux = 0.0;  // m3/s, upward
};

/// One kind of faces, upright or level ones, as the solver's loops see them. A volume has two neighbours
/// along its velocity and two across it; a side belongs to the face above or to the right of it.
struct FaceFamily {
  int first = 0;   // of its faces in the numbering of all
  int along = 0;   // from a frame place to the next along the velocity: also from cell to cell
  int across = 0;  // and across it
  int rows = 0;    // of faces
};

/// The staggered arrangement. Cells, upright faces and level faces each lie in a frame: row by row from
/// below, a row below the floor and two above the outlet, one place behind each row. A cell's left and lower
/// face have its own place. So neighbours are always the same number of places away, and whatever lies
/// outside the gas has its place too and stays zero. Faces are numbered upright ones first; riser and wall
/// faces keep zero velocity; the top faces belong to half-height volumes with zero gradient above.
///
/// Where sides are periodic each row has a place before it, too, and those before and behind are ghosts: they
/// have what stands at the other end of the row, see copyAround(). The first upright face is solved for, the
/// one behind the last column is its ghost.
struct FaceLayout {
  int columns = 0, rows = 0;
  bool repeats = false;  // sides are periodic
  int stride = 0;        // from row to row of a frame
  int size = 0;          // of a frame
  std::array<FaceFamily, 2> families;
  std::vector<MomentumVolume> volumes;
  std::vector<FloorFace> floor;               // one a column
  std::vector<int> openCells;                 // in cell order
  std::vector<std::array<int, 4>> cellFaces;  // per cell: left, right, bottom, top
  std::vector<double> cellVolume;             // m3
  std::vector<double> width, height;          // of columns and rows, m

  // Per face:
  std::vector<double> faceArea;      // m2, 0 outside the grid
  std::vector<double> solved;        // 1 where there is a momentum volume, else 0
  std::vector<double> volume;        // m3; 1 where nothing is solved
  std::vector<double> alongSide;     // lower side along: area over distance to that neighbour, m
  std::vector<double> acrossSide;    // lower side across; 0 at walls
  std::vector<double> wall;          // sides at walls without flow through them, m
  std::vector<double> weightBefore;  // of the cell before in the face's voidage: by volume of the half cells

  // Per place of a frame:
  std::vector<int> voidageCell;  // whose voidage stands here: blocked cells take that of the open one above
  std::vector<double> open;      // volume of open cells, m3, else 0

  int at(int i, int j) const { return rowStart(j) + (repeats ? 1 : 0) + i; }
  int rowStart(int j) const { return (j + 1) * stride; }
  /// Sets the ghosts in these rows of a frame.
  void copyAround(double* frame, Range mine) const;
  /// The same of both families' faces, in a member's rows.
  void copyAround(const Member& member, std::vector<double>& faces) const;
  /// Of a frame, what lies in these rows.
  Range places(Range mine) const {
    return {(mine.begin + 1) * static_cast<std::size_t>(stride),
            (mine.end + 1) * static_cast<std::size_t>(stride)};
  }
  int uFace(int i, int j) const { return at(i, j); }
  int vFace(int i, int j) const { return size + at(i, j); }
  int faces() const { return 2 * size; }
};

FaceLayout makeFaceLayout(const GasGrid& grid);

}  // namespace bedmix
