// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/bed_state.h"
#include "engine/dem/contact_law.h"

namespace bedmix {

/// The hardest impact that is going on or may begin within `span` (s): the largest closing speed, m/s, of
/// pairs and particles at walls that are apart but meet within that time if they go on as they do, and of
/// those that touch the one with which they met, sqrt(v^2 + (w overlap)^2), w the frequency of their spring.
/// Looks at the pairs of the outer list; where that does not hold for so long, twice the largest speed,
/// `fastest` (m/s), is the bound. Puts the bodies where the particles are. Shared out to the bed's team; the
/// same to the bit for any number of threads. The list must have been made.
double closingSpeed(BedState& bed, const SpringDashpot& pair, const SpringDashpot& wall, double fastest,
                    double span);

}  // namespace bedmix
