// SPDX-License-Identifier: MIT
#include "engine/gas/grid_level.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/gas/grid_level_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

// Jacobi's damping: 1 / (1.125 +- 0.875 cos(pi/4)). Two sweeps with these are the Chebyshev polynomial for
// eigenvalues of D^-1 A between 1/4 and 2, the part of the spectrum the coarser grid does not see.
constexpr float firstDamping = 0.57348f, secondDamping = 1.97512f;

/// What a row of a level needs from its frames.
struct Row {
  const float *west, *south, *north, *perDiagonal, *b;
  int n;
};

HWY_INLINE Row rowOf(const GridLevel& l, int row) {
  const int c = l.at(0, row);
  return {&l.west[c], &l.south[c], &l.south[c + l.stride], &l.perDiagonal[c], &l.b[c], l.columns};
}

/// The last four rows of a field that is made row by row, each with a zero before it and two behind.
class Ring {
 public:
  Ring(float* memory, int columns) : length_(columns + 4) {
    for (int i = 0; i < 4; ++i) {
      own_[i] = memory + i * length_ + 1;
      own_[i][-1] = own_[i][columns] = own_[i][columns + 1] = 0.0f;
    }
  }
  /// Where to write a row: here, or at `elsewhere`.
  HWY_INLINE float* start(int row) { return rows_[row & 3] = own_[row & 3]; }
  HWY_INLINE float* start(int row, float* elsewhere) { return rows_[row & 3] = elsewhere; }
  HWY_INLINE const float* operator[](int row) const { return rows_[row & 3]; }

 private:
  int length_;
  float* own_[4];
  float* rows_[4];
};

/// Two sweeps from zero.
HWY_INLINE void relaxTwice(const Row& r, int stride, float* to) {
  const float *d = r.perDiagonal, *b = r.b;
#pragma GCC ivdep
  for (int i = 0; i < r.n; ++i) {
    const float own = d[i] * b[i];
    const float flow =
        (r.west[i] * (own - d[i - 1] * b[i - 1]) + r.west[i + 1] * (own - d[i + 1] * b[i + 1])) +
        (r.south[i] * (own - d[i - stride] * b[i - stride]) +
         r.north[i] * (own - d[i + stride] * b[i + stride]));
    to[i] = firstDamping * own + secondDamping * d[i] * (b[i] - firstDamping * flow);
  }
}

HWY_INLINE float residual(const Row& r, const float* below, const float* own, const float* above, int i) {
  return r.b[i] - ((r.west[i] * (own[i] - own[i - 1]) + r.west[i + 1] * (own[i] - own[i + 1])) +
                   (r.south[i] * (own[i] - below[i]) + r.north[i] * (own[i] - above[i])));
}

HWY_INLINE void findResidual(const Row& r, const float* below, const float* own, const float* above,
                             float* to) {
#pragma GCC ivdep
  for (int i = 0; i < r.n; ++i) to[i] = residual(r, below, own, above, i);
}

HWY_INLINE void relax(const Row& r, const float* below, const float* own, const float* above, float damping,
                      float* to) {
#pragma GCC ivdep
  for (int i = 0; i < r.n; ++i)
    to[i] = own[i] + damping * r.perDiagonal[i] * residual(r, below, own, above, i);
}

/// The interpolation transposed: from the residuals of a coarse row's two fine ones and of those beside them.
HWY_INLINE void restrict(const GridLevel& coarse, int row, const float* below, const float* lower,
                         const float* upper, const float* above, float* to) {
  const int c = coarse.at(0, row), n = coarse.stride;
  const float *w = &coarse.toWest[c], *e = &coarse.toEast[c], *s = &coarse.toSouth[c],
              *t = &coarse.toNorth[c];
  if (!coarse.across.joined) {
#pragma GCC ivdep
    for (int i = 0; i < coarse.columns; ++i)
      to[i] = lower[i] + upper[i] + (t[i - n] * below[i] - s[i] * lower[i]) +
              (s[i + n] * above[i] - t[i] * upper[i]);
    return;
  }
#pragma GCC ivdep
  for (int i = 0; i < coarse.columns; ++i) {
    const int f = 2 * i;
    const float left = lower[f] + upper[f], right = lower[f + 1] + upper[f + 1];
    to[i] = left + right + (e[i - 1] * (lower[f - 1] + upper[f - 1]) - w[i] * left) +
            (w[i + 1] * (lower[f + 2] + upper[f + 2]) - e[i] * right) +
            (t[i - n] * (below[f] + below[f + 1]) - s[i] * (lower[f] + lower[f + 1])) +
            (s[i + n] * (above[f] + above[f + 1]) - t[i] * (upper[f] + upper[f + 1]));
  }
}

/// x plus the coarse correction interpolated to one of the fine rows of a coarse one.
HWY_INLINE void prolong(const GridLevel& coarse, int row, bool upper, const float* x, int fineColumns,
                        float* to) {
  const int c = coarse.at(0, row);
  const float* own = &coarse.x[c];
  const float* beside = upper ? own + coarse.stride : own - coarse.stride;
  const float* share = upper ? &coarse.toNorth[c] : &coarse.toSouth[c];
  if (!coarse.across.joined) {
#pragma GCC ivdep
    for (int i = 0; i < fineColumns; ++i) to[i] = x[i] + (own[i] + share[i] * (beside[i] - own[i]));
    return;
  }
  const float *w = &coarse.toWest[c], *e = &coarse.toEast[c];
  const auto correction = [=](int i, float side, float other) HWY_ATTR {
    return own[i] + share[i] * (beside[i] - own[i]) + side * (other - own[i]);
  };
#pragma GCC ivdep
  for (int i = 0; i < fineColumns / 2; ++i) {
    to[2 * i] = x[2 * i] + correction(i, w[i], own[i - 1]);
    to[2 * i + 1] = x[2 * i + 1] + correction(i, e[i], own[i + 1]);
  }
  const int last = fineColumns - 1;
  if (last % 2 == 0) to[last] = x[last] + correction(last / 2, w[last / 2], own[last / 2 - 1]);
}

void descend(GridLevel& fine, GridLevel& coarse, Range coarseRows, float* scratch) {
  const Range own = fine.rowsOf(coarse, coarseRows);
  const int begin = static_cast<int>(own.begin), end = static_cast<int>(own.end);
  const int perRow = coarse.up.joined ? 2 : 1;
  const float* const zero = &fine.b[fine.at(0, fine.rows)];  // the row above the outlet
  Ring x(scratch, fine.columns), r(scratch + 4 * (fine.columns + 4), fine.columns);
  const auto inside = [&](int row) HWY_ATTR { return row >= 0 && row < fine.rows; };
  int next = static_cast<int>(coarseRows.begin);
  // A row of the residual needs one more of x on both sides, a coarse row one more of the residual.
  for (int row = begin - 2; next < static_cast<int>(coarseRows.end); ++row) {
    const bool mine = row >= begin && row < end;
    float* const to = mine ? x.start(row, &fine.smoothed[fine.at(0, row)]) : x.start(row);
    if (inside(row))
      relaxTwice(rowOf(fine, row), fine.stride, to);
    else
      std::fill(to, to + fine.columns, 0.0f);
    const int done = row - 1;
    if (done < begin - 1) continue;
    float* const left = r.start(done);
    if (inside(done))
      findResidual(rowOf(fine, done), x[done - 1], x[done], x[done + 1], left);
    else
      std::fill(left, left + fine.columns, 0.0f);
    if (done < perRow * (next + 1)) continue;
    float* const b = &coarse.b[coarse.at(0, next)];
    if (perRow == 2)
      restrict(coarse, next, r[done - 3], r[done - 2], r[done - 1], r[done], b);
    else
      restrict(coarse, next, zero, r[done - 1], zero, zero, b);
    ++next;
  }
}

void ascend(GridLevel& fine, const GridLevel& coarse, Range coarseRows, float* scratch) {
  const Range own = fine.rowsOf(coarse, coarseRows);
  const int begin = static_cast<int>(own.begin), end = static_cast<int>(own.end);
  const int perRow = coarse.up.joined ? 2 : 1;
  Ring corrected(scratch, fine.columns), once(scratch + 4 * (fine.columns + 4), fine.columns);
  const auto inside = [&](int row) HWY_ATTR { return row >= 0 && row < fine.rows; };
  for (int row = begin - 2; row < end + 2; ++row) {
    float* const to = corrected.start(row);
    if (inside(row))
      prolong(coarse, row / perRow, row % perRow == 1, &fine.smoothed[fine.at(0, row)], fine.columns, to);
    else
      std::fill(to, to + fine.columns, 0.0f);
    const int done = row - 1;
    if (done < begin - 1) continue;
    float* const first = once.start(done);
    if (inside(done))
      relax(rowOf(fine, done), corrected[done - 1], corrected[done], corrected[done + 1], secondDamping,
            first);
    else
      std::fill(first, first + fine.columns, 0.0f);
    const int last = row - 2;
    if (last >= begin)
      relax(rowOf(fine, last), once[last - 1], once[last], once[last + 1], firstDamping,
            &fine.x[fine.at(0, last)]);
  }
}

}  // namespace

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(descend);
HWY_EXPORT(ascend);

void GridLevel::descend(GridLevel& coarse, Range coarseRows, float* scratch) {
  HWY_DYNAMIC_DISPATCH(descend)(*this, coarse, coarseRows, scratch);
}
void GridLevel::ascend(const GridLevel& coarse, Range coarseRows, float* scratch) {
  HWY_DYNAMIC_DISPATCH(ascend)(*this, coarse, coarseRows, scratch);
}

}  // namespace bedmix
#endif  // HWY_ONCE
