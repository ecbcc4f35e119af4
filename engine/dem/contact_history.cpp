// SPDX-License-Identifier: MIT
#include "engine/dem/contact_history.h"

#include <utility>

namespace bedmix {

namespace {

/// Copies contacts of `from`, candidates of `oldList`, to their places in `newList`; both lists ascend. The
/// numbers of their first candidates are the offsets.
void copyContacts(const ContactHistory& from, std::span<const std::int32_t> contacts,
                  const std::vector<Candidate>& oldList, std::size_t oldOffset,
                  const std::vector<Candidate>& newList, std::size_t newOffset, ContactHistory& to) {
  std::size_t k = 0;
  for (const std::int32_t old : contacts) {
    const Candidate& key = oldList[old - oldOffset];
    while (k < newList.size() && newList[k] < key) ++k;
    if (k == newList.size() || newList[k] != key) continue;  // left the skin within one step
    to.touching[to.count++] = static_cast<std::int32_t>(newOffset + k);
    if (!from.hasSprings) continue;
    to.spring[newOffset + k] = from.spring[old];
    to.slip[newOffset + k] = from.slip[old];
  }
}

}  // namespace

void ContactHistory::reset(std::size_t candidates, bool withSprings) {
  hasSprings = withSprings;
  spring.assign(hasSprings ? candidates : 0, 0.0);
  slip.assign(hasSprings ? candidates : 0, 0.0);
  touching.resize(candidates);
  pairCount = count = 0;
}

void ContactHistory::clear() {
  if (hasSprings)
    for (std::size_t c = 0; c < count; ++c) spring[touching[c]] = slip[touching[c]] = 0.0;
  pairCount = count = 0;
}

void ContactHistory::carryOver(const NeighbourList& list, ContactHistory& spare) {
  spare.reset(list.size(), hasSprings);
  copyContacts(*this, pairContacts(), list.oldPairs(), 0, list.pairs(), 0, spare);
  spare.pairCount = spare.count;
  copyContacts(*this, wallContacts(), list.oldWallPairs(), list.oldPairs().size(), list.wallPairs(),
               list.pairs().size(), spare);
  std::swap(*this, spare);
  spare.reset(list.size(), hasSprings);
}

}  // namespace bedmix
