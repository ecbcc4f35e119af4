// SPDX-License-Identifier: MIT
#pragma once

#include "app/accuracy/findings.h"

#include <string>

namespace bedmix {

/// Findings as text for a terminal: cost and errors by setting, orders by knob, differences of the
/// statistics, what did not last, conservation.
std::string tablesOf(const Design& design, const Findings& findings);

/// The cheapest setting that does, what the paper's costs beside the standard's and for what: from the
/// findings alone. A line a sentence.
std::string verdictOf(const Design& design, const Findings& findings);

}  // namespace bedmix
