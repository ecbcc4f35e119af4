// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace bedmix {

/// The candidate that was probably meant by `word`: the nearest by insertions, deletions, replacements and
/// swaps of neighbours, where at most a third of the word (and always one letter) is wrong.
std::optional<std::string> nearMiss(std::string_view word, std::span<const std::string> candidates);

/// `; did you mean "x"?` or nothing, to be appended to a message about an unknown word.
std::string didYouMean(std::string_view word, std::span<const std::string> candidates);

}  // namespace bedmix
