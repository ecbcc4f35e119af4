// SPDX-License-Identifier: MIT
#pragma once

#include "app/accuracy/sample.h"
#include "engine/core/scene.h"

#include <functional>

namespace bedmix {

/// What the scene's contacts, integrator and step make of single contacts, against closed forms: head-on
/// collisions of pairs and with a wall at sqrt(g d) (restitution, duration), wall impacts in full sliding
/// (tangential impulse; with friction only), and pairs followed within a contact, where forces are smooth.
/// Root mean squares over the phases of a step at which contacts begin. Without gas and gravity. Nothing
/// is measured where contacts do not rebound.
void measureContacts(const Scene& scene, Sample& into);

/// Energy of a closed box of elastic spheres without friction, gravity and gas, in contacts as the scene's:
/// its change after a hundred times sqrt(d/g), relative. False where `stop` said so, looked at a hundred
/// times.
bool measureDrift(const Scene& scene, const std::function<bool()>& stop, Sample& into);

}  // namespace bedmix
