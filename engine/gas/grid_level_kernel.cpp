// SPDX-License-Identifier: MIT
#include "engine/gas/grid_level.h"
#include "engine/gas/independent.h"

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
};

/// Columns [from, to) of a row.
struct Span {
  int from, to;

  /// And so many more on both sides, of the n there are.
  HWY_INLINE Span with(int more, int n) const { return {std::max(from - more, 0), std::min(to + more, n)}; }
};

HWY_INLINE Row rowOf(const GridLevel& l, int row) {
  const int c = l.at(0, row);
  return {&l.west[c], &l.south[c], &l.south[c + l.stride], &l.perDiagonal[c], &l.b[c]};
}

/// The last four rows of a field that is made row by row, each with a zero before it and two behind.
class Ring {
 public:
  Ring(float* memory, int columns) {
    for (int i = 0; i < 4; ++i) {
      rows_[i] = memory + i * (columns + 4) + 1;
      rows_[i][-1] = rows_[i][columns] = rows_[i][columns + 1] = 0.0f;
    }
  }
  HWY_INLINE float* operator[](int row) const { return rows_[row & 3]; }

 private:
  float* rows_[4];
};

/// Two sweeps from zero.
HWY_INLINE void relaxTwice(const Row& r, int stride, Span columns, float* to) {
  const float *d = r.perDiagonal, *b = r.b;
  BEDMIX_INDEPENDENT
  for (int i = columns.from; i < columns.to; ++i) {
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
                             Span columns, float* to) {
  BEDMIX_INDEPENDENT
  for (int i = columns.from; i < columns.to; ++i) to[i] = residual(r, below, own, above, i);
}

HWY_INLINE void relax(const Row& r, const float* below, const float* own, const float* above, float damping,
                      Span columns, float* to) {
  BEDMIX_INDEPENDENT
  for (int i = columns.from; i < columns.to; ++i)
    to[i] = own[i] + damping * r.perDiagonal[i] * residual(r, below, own, above, i);
}

/// The interpolation transposed: from the residuals of a coarse row's two fine ones and of those beside them.
HWY_INLINE void restrict(const GridLevel& coarse, int row, const float* below, const float* lower,
                         const float* upper, const float* above, Span columns, float* to) {
  const int c = coarse.at(0, row), n = coarse.stride;
  const float *w = &coarse.toWest[c], *e = &coarse.toEast[c], *s = &coarse.toSouth[c],
              *t = &coarse.toNorth[c];
  if (!coarse.across.joined) {
    BEDMIX_INDEPENDENT
    for (int i = columns.from; i < columns.to; ++i)
      to[i] = lower[i] + upper[i] + (t[i - n] * below[i] - s[i] * lower[i]) +
              (s[i + n] * above[i] - t[i] * upper[i]);
    return;
  }
  BEDMIX_INDEPENDENT
  for (int i = columns.from; i < columns.to; ++i) {
    const int f = 2 * i;
    const float left = lower[f] + upper[f], right = lower[f + 1] + upper[f + 1];
    to[i] = left + right + (e[i - 1] * (lower[f - 1] + upper[f - 1]) - w[i] * left) +
            (w[i + 1] * (lower[f + 2] + upper[f + 2]) - e[i] * right) +
            (t[i - n] * (below[f] + below[f + 1]) - s[i] * (lower[f] + lower[f + 1])) +
            (s[i + n] * (above[f] + above[f + 1]) - t[i] * (upper[f] + upper[f + 1]));
  }
}

/// x plus the coarse correction interpolated to one of the fine rows of a coarse one, for its `columns`.
HWY_INLINE void prolong(const GridLevel& coarse, int row, bool upper, const float* x, int fineColumns,
                        Span columns, float* to) {
  const int c = coarse.at(0, row);
  const float* own = &coarse.x[c];
  const float* beside = upper ? own + coarse.stride : own - coarse.stride;
  const float* share = upper ? &coarse.toNorth[c] : &coarse.toSouth[c];
  if (!coarse.across.joined) {
    BEDMIX_INDEPENDENT
    for (int i = columns.from; i < columns.to; ++i) to[i] = x[i] + (own[i] + share[i] * (beside[i] - own[i]));
    return;
  }
  const float *w = &coarse.toWest[c], *e = &coarse.toEast[c];
  const auto correction = [=](int i, float side, float other) HWY_ATTR {
    return own[i] + share[i] * (beside[i] - own[i]) + side * (other - own[i]);
  };
  const int pairs = std::min(columns.to, fineColumns / 2);
  BEDMIX_INDEPENDENT
  for (int i = columns.from; i < pairs; ++i) {
    to[2 * i] = x[2 * i] + correction(i, w[i], own[i - 1]);
    to[2 * i + 1] = x[2 * i + 1] + correction(i, e[i], own[i + 1]);
  }
  // The last cell may be alone.
  for (int i = pairs; i < columns.to; ++i) to[2 * i] = x[2 * i] + correction(i, w[i], own[i - 1]);
}

/// What a patch of the coarse grid is on the fine one, and the loops over it.
struct Work {
  Span rows, coarseRows, columns, coarseColumns;
  int perRow;

  Work(const GridLevel& fine, const GridLevel& coarse, const Patch& patch)
      : coarseRows{static_cast<int>(patch.rows.begin), static_cast<int>(patch.rows.end)},
        coarseColumns{static_cast<int>(patch.columns.begin), static_cast<int>(patch.columns.end)},
        perRow(coarse.up.joined ? 2 : 1) {
    const int perColumn = coarse.across.joined ? 2 : 1;
    rows = {perRow * coarseRows.from, std::min(perRow * coarseRows.to, fine.rows)};
    columns = {perColumn * coarseColumns.from, std::min(perColumn * coarseColumns.to, fine.columns)};
  }
};

/// Makes a row by `make`, or one of zeros outside the grid.
template <class Make>
HWY_INLINE void makeRow(const GridLevel& level, int row, float* to, const Make& make) {
  if (row >= 0 && row < level.rows)
    make();
  else
    std::fill(to, to + level.columns, 0.0f);
}

void descend(GridLevel& fine, GridLevel& coarse, const Patch& patch, float* scratch) {
  const Work work(fine, coarse, patch);
  const int n = fine.columns, perRow = work.perRow;
  // The residual needs one more of x on all sides, the coarse grid one more of the residual.
  const Span wide = work.columns.with(2, n), narrow = work.columns.with(1, n), own = work.columns;
  const float* const zero = &fine.b[fine.at(0, fine.rows)];  // the row above the outlet
  const Ring x(scratch, n), r(scratch + 4 * (n + 4), n);
  int next = work.coarseRows.from;
  for (int row = work.rows.from - 2; next < work.coarseRows.to; ++row) {
    float* const smooth = x[row];
    makeRow(fine, row, smooth, [&]() HWY_ATTR { relaxTwice(rowOf(fine, row), fine.stride, wide, smooth); });
    if (row >= work.rows.from && row < work.rows.to)
      std::copy(smooth + own.from, smooth + own.to, &fine.smoothed[fine.at(own.from, row)]);
    const int done = row - 1;
    if (done < work.rows.from - 1) continue;
    float* const left = r[done];
    makeRow(fine, done, left, [&]() HWY_ATTR {
      findResidual(rowOf(fine, done), x[done - 1], x[done], x[done + 1], narrow, left);
    });
    if (done < perRow * (next + 1)) continue;
    float* const b = &coarse.b[coarse.at(0, next)];
    if (perRow == 2)
      restrict(coarse, next, r[done - 3], r[done - 2], r[done - 1], r[done], work.coarseColumns, b);
    else
      restrict(coarse, next, zero, r[done - 1], zero, zero, work.coarseColumns, b);
    ++next;
  }
}

void ascend(GridLevel& fine, const GridLevel& coarse, const Patch& patch, float* scratch) {
  const Work work(fine, coarse, patch);
  const int n = fine.columns, perRow = work.perRow;
  // Each sweep needs one more of what it starts from on all sides.
  const Span wide = work.coarseColumns.with(coarse.across.joined ? 1 : 2, coarse.columns);
  const Span narrow = work.columns.with(1, n), own = work.columns;
  const Ring corrected(scratch, n), once(scratch + 4 * (n + 4), n);
  for (int row = work.rows.from - 2; row < work.rows.to + 2; ++row) {
    float* const sum = corrected[row];
    makeRow(fine, row, sum, [&]() HWY_ATTR {
      prolong(coarse, row / perRow, row % perRow == 1, &fine.smoothed[fine.at(0, row)], n, wide, sum);
    });
    const int done = row - 1;
    if (done < work.rows.from - 1) continue;
    float* const first = once[done];
    makeRow(fine, done, first, [&]() HWY_ATTR {
      relax(rowOf(fine, done), corrected[done - 1], corrected[done], corrected[done + 1], secondDamping,
            narrow, first);
    });
    const int last = row - 2;
    if (last >= work.rows.from)
      relax(rowOf(fine, last), once[last - 1], once[last], once[last + 1], firstDamping, own,
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

void GridLevel::descend(GridLevel& coarse, const Patch& patch, float* scratch) {
  HWY_DYNAMIC_DISPATCH(descend)(*this, coarse, patch, scratch);
}
void GridLevel::ascend(const GridLevel& coarse, const Patch& patch, float* scratch) {
  HWY_DYNAMIC_DISPATCH(ascend)(*this, coarse, patch, scratch);
}

}  // namespace bedmix
#endif  // HWY_ONCE
