// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

#include <vector>

namespace bedmix {

/// What a scene's integrator makes of the parting speed of two spheres that meet head-on, against the exact
/// exp(-pi zeta/sqrt(1 - zeta^2)) times their closing speed; with walls, whose springs swing slower, it errs
/// less. The law is linear, so the error is a share of the closing speed that depends on the step alone. Its
/// order has reasons of its own for each integrator (assets/docs/model.md); here it is measured, once, with
/// the very solver: pairs that meet at all phases of a step, for steps from T/14 to T/448 that are close
/// enough together to part at all phases too.
class ContactError {
 public:
  /// Some hundredths of a second of work.
  explicit ContactError(const Scene& scene);

  /// Largest error at a step (s), of the closing speed. The same for all steps between two measured ones,
  /// proportional to the step below them, infinite above T/14.
  double at(double step) const;
  /// The largest step, s, of those measured or a shorter one, at which two spheres that close at `closing`
  /// part with an error of `allowed` at most, both m/s. Positive for any `allowed` above 0.
  double largestStep(double closing, double allowed) const;

 private:
  struct Measured {
    double step, error;
  };
  std::vector<Measured> measured_;  // ascending in both
};

}  // namespace bedmix
