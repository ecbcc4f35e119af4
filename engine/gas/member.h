// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/thread_team.h"

#include <array>
#include <cstddef>
#include <vector>

namespace bedmix {

/// One of the threads that take a gas step together, or the only one. All of them call the same functions in
/// the same order; each does its share of the rows and waits for the others before it reads theirs.
class Member {
 public:
  Member() = default;  // works alone
  Member(ThreadTeam& team, int index) : team_(&team), index_(index) {}

  std::size_t index() const { return static_cast<std::size_t>(index_); }
  bool first() const { return index_ == 0; }
  bool shares() const { return team_ != nullptr; }
  Range share(int n) const {
    const auto all = static_cast<std::size_t>(n);
    return team_ ? team_->share(all, index_) : Range{0, all};
  }
  void wait() const {
    if (team_) team_->barrier();
  }
  /// Alternates; so what is shared out in one turn may still be read in the next.
  std::size_t nextTurn() { return turn_ ^= 1; }

 private:
  ThreadTeam* team_ = nullptr;
  int index_ = 0;
  std::size_t turn_ = 0;
};

/// Brings together what members find in their rows, so that the result does not depend on how many they are.
template <class Value>
class RowReduction {
 public:
  explicit RowReduction(int rows) {
    for (auto& p : parts_) p.resize(static_cast<std::size_t>(rows));
  }

  /// All members get the same: join(...join(join(Value{}, of(0)), of(1))...). Waits for all once.
  template <class OfRow, class Join>
  Value overRows(Member& member, OfRow&& of, Join&& join) {
    std::vector<Value>& parts = parts_[member.nextTurn()];
    const Range mine = member.share(static_cast<int>(parts.size()));
    for (std::size_t row = mine.begin; row < mine.end; ++row) parts[row] = of(static_cast<int>(row));
    return joined(member, parts, join);
  }
  /// For what comes out the same in any order, such as a maximum: what the member found in all of its rows.
  template <class Join>
  Value overShares(Member& member, const Value& found, Join&& join) {
    std::vector<Value>& parts = parts_[member.nextTurn()];
    const Range mine = member.share(static_cast<int>(parts.size()));
    for (std::size_t row = mine.begin; row < mine.end; ++row)
      parts[row] = row == mine.begin ? found : Value{};
    return joined(member, parts, join);
  }

 private:
  template <class Join>
  static Value joined(const Member& member, const std::vector<Value>& parts, Join&& join) {
    member.wait();
    Value all{};
    for (const Value& v : parts) all = join(all, v);
    return all;
  }

  std::array<std::vector<Value>, 2> parts_;
};

}  // namespace bedmix
