// SPDX-License-Identifier: MIT
#include "engine/dem/population.h"

#include <algorithm>
#include <utility>

namespace bedmix {

Roster::Roster(std::vector<std::int32_t> unsorted) : ids_(std::move(unsorted)) {
  std::sort(ids_.begin(), ids_.end());
  isDense_ = ids_.empty() || (ids_.front() == 0 && static_cast<std::size_t>(ids_.back()) + 1 == ids_.size());
}

std::size_t Roster::find(std::int32_t id) const {
  return static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
}

}  // namespace bedmix
