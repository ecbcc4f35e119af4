// SPDX-License-Identifier: MIT
#include "tests/hard/hard_beds.h"
#include "tests/hard/hard_case.h"

#include <utility>

namespace bedmix::hard {

namespace {

/// What theory allows the restitution to err by, and why.
std::pair<double, const char*> allowance(const Scene& scene) {
  const double angle = pairAngle(scene), e = *scene.contacts.restitution;
  const double zeta =
      pairDamping(scene) / (2.0 * std::sqrt(0.5 * particleMass(scene) * normalStiffness(scene)));
  if (scene.time.integrator != Integrator::verletOnset)
    return {e * (angle * angle / 8.0 + 2.0 * zeta * angle),
            "e ((w dt)^2/8 + 2 zeta w dt): spring and dashpot that begin and end inside a step"};
  const double decays = pi * zeta / std::pow(1.0 - zeta * zeta, 1.5);  // -d ln e / d ln zeta
  return {e * (std::pow(angle, 4.0) / 16.0 + decays * (1.0 / 24.0 + zeta * zeta) * angle * angle),
          "e ((w dt)^4/16 + pi zeta/(1 - zeta^2)^1.5 (1/24 + zeta^2) (w dt)^2): ends of the spring; Verlet's "
          "frequency and damping"};
}

/// Largest departure of the rebound from the exact one over the phases of a step at which contact begins.
Check rebound(Scene scene, double restitution) {
  scene.contacts.restitution = restitution;
  constexpr double speed = 0.2;
  constexpr int phases = 100;
  double worst = 0.0;
  for (int phase = 0; phase < phases; ++phase) {
    const double gap = speed * scene.time.step * (1.0 + (phase + 0.5) / phases);
    const auto solver = solverAt(scene, {{0.0, 0.0}, {scene.particles.diameter + gap, 0.0}});
    solver->particles().velocity = {{0.5 * speed, 0.0}, {-0.5 * speed, 0.0}};
    go(*solver, std::llround(20.0 / pairAngle(scene)));
    const Particles& p = solver->particles();
    worst = std::max(worst, std::abs((p.velocity[1].x - p.velocity[0].x) / speed - restitution));
  }
  const auto [allowed, why] = allowance(scene);
  return {
      fmt::format("{}restitution {:g}, worst of {} phases of the step", named(scene), restitution, phases),
      allowed, why, worst};
}

std::vector<Check> restitutions() {
  std::vector<Check> checks;
  for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::verletOnset})
    for (const double restitution : {0.05, 0.9, 1.0}) {
      Scene scene = smoothSpheres();
      scene.time.integrator = integrator;
      checks.push_back(rebound(scene, restitution));
    }
  return checks;
}

Scene sceneWithStep(double ofScale) {
  Scene scene = smoothSpheres();
  scene.time.step = contactTimeScale(scene) / ofScale;
  return scene;
}

std::vector<Check> allowed() {
  std::vector<Check> checks;
  for (const double ofScale : {14.1, 14.0}) {
    Scene scene = sceneWithStep(ofScale);
    checks.push_back({fmt::format("T/{:g}: refused by check, 1 = yes", ofScale), 0.0, "",
                      refused(scene, "time.step") ? 1.0 : 0.0});
    for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::verletOnset}) {
      scene.time.integrator = integrator;
      checks.push_back(rebound(scene, 0.9));
      checks.back().invariant = fmt::format("T/{:g}: ", ofScale) + checks.back().invariant;
    }
  }
  return checks;
}

std::vector<Check> aboveLimit() {
  return {{"T/13.9: let pass by check, 1 = yes", 0.0, "the limit is T/14",
           refused(sceneWithStep(13.9), "time.step") ? 0.0 : 1.0}};
}

/// New contacts of two spheres in a box until the bed is stopped.
double contactsUntilStopped(double ofScale) {
  Scene scene = sceneWithStep(ofScale);
  const auto solver = solverAt(scene, {{0.006, 0.0051}, {0.013, 0.0052}}, closedBox(0.02, 0.01));
  solver->particles().velocity = {{0.5, 0.1}, {-0.4, 0.0}};
  std::int64_t touching = 0;
  double begun = 0.0;
  for (int k = 0; k < 1000000; ++k) {
    if (solver->advance(1)) return begun;
    begun += static_cast<double>(std::max<std::int64_t>(0, solver->contactCount() - touching));
    touching = solver->contactCount();
  }
  return infinity;
}

/// Durations of a contact, T/sqrt(8), until a hexagonal crystal under gravity is stopped.
double contactsOfCrystal(double ofScale) {
  Scene scene = sceneWithStep(ofScale);
  scene.gravity = 9.81;
  const double d = scene.particles.diameter;
  const auto solver = solverAt(scene, hexagonal(d, 12, 8), closedBox(12.0 * d, 0.1));
  const auto trouble = solver->advance(100000);
  return trouble ? static_cast<double>(trouble->steps) * std::sqrt(8.0) / ofScale : infinity;
}

std::vector<Check> forced() {
  std::vector<Check> checks;
  for (const double ofScale : {5.0, 4.0})
    checks.push_back({fmt::format("T/{:g}: durations of a contact until a crystal is stopped", ofScale), 10.0,
                      "its stiffest w^2 is 6 k/m: w dt > 2 above T/7.7", contactsOfCrystal(ofScale)});
  for (const double ofScale : {4.0, 3.0, 2.0, 1.0})
    checks.push_back({fmt::format("T/{:g}: contacts until a pair in a box is stopped", ofScale), 10.0,
                      "w^2 = 2 k/m: w dt > 2 above T/4.4", contactsUntilStopped(ofScale)});
  return checks;
}

}  // namespace

std::vector<HardCase> stepCases() {
  return {{"restitution 0.05 and 1", restitutions},
          {"particle step just below and at the limit", allowed},
          {"particle step above the limit", aboveLimit},
          {"particle step above the limit, forced", forced}};
}

}  // namespace bedmix::hard
