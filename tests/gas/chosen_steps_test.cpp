// SPDX-License-Identifier: MIT
#include "engine/core/scene_reader.h"
#include "engine/dem/packing.h"
#include "engine/simulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace bedmix {
namespace {

/// Case A with its settled bed, 40 ms into the lift: chaos then multiplies what steps miss by no more than a
/// few.
class CaseA : public testing::Test {
 protected:
  static Scene scene(const std::vector<Override>& numerics = {}) {
    const std::string path = BEDMIX_SOURCE_DIR "/assets/scenes/tian-2007-even.toml";
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    std::vector<Override> settings{{"time.integrator", "verlet-onset"}, {"sampling.interval", "0.002"}};
    settings.insert(settings.end(), numerics.begin(), numerics.end());
    Result<Scene> read = readScene(text.str(), path, settings);
    EXPECT_TRUE(read) << toString(read.problems.front());
    return *read;
  }

  struct Lift {
    FramePtr end;
    double work = 0.0;  // in particle steps; a gas step costs what four and a half do
  };
  Lift lift(const std::string& particles, const std::string& gas, double particleError = 0.003,
            double gasError = 0.015) const {
    Scene scene = CaseA::scene({{"time.step", particles}, {"gas.step", gas}});
    scene.time.error = particleError;
    scene.gas->error = gasError;
    Simulation simulation = Simulation::make(scene, start_);
    EXPECT_EQ(simulation.advance(20 * stepsPerFrame(scene)), std::nullopt);
    return {simulation.frame(), static_cast<double>(simulation.particleSteps()) +
                                    4.5 * static_cast<double>(simulation.gasSteps())};
  }

  static double distance(const Frame& a, const Frame& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(norm(a.position[i] - b.position[i]), 2.0);
    return std::sqrt(squares / static_cast<double>(a.size()));
  }

  Particles start_ = *packBed(scene());
};

TEST_F(CaseA, ChosenStepsBeatEveryFixedPair) {
  const FramePtr exact = lift("2e-6", "4e-6").end;
  struct Pair {
    const char *particles, *gas;
  };
  for (const auto& [particleError, gasError] : {std::pair{0.003, 0.015}, {0.1, 0.4}}) {
    const Lift chosen = lift("auto", "auto", particleError, gasError);
    const double missed = distance(*chosen.end, *exact);
    for (const Pair& pair :
         {Pair{"1e-5", "1e-5"}, Pair{"1e-5", "1e-4"}, Pair{"2e-5", "2e-5"}, Pair{"4e-5", "4e-5"},
          Pair{"5e-5", "5e-5"}, Pair{"5e-5", "1e-4"}, Pair{"6.25e-5", "1.25e-4"},
          Pair{"6.6666666666666667e-5", "2e-4"}, Pair{"6.25e-5", "2.5e-4"},
          Pair{"6.6666666666666667e-5", "4e-4"}, Pair{"6.25e-5", "5e-4"}}) {
      const Lift fixed = lift(pair.particles, pair.gas);
      EXPECT_TRUE(fixed.work > chosen.work || distance(*fixed.end, *exact) > missed)
          << pair.particles << ", " << pair.gas << ": " << fixed.work << " steps, "
          << distance(*fixed.end, *exact) << " m off; chosen " << chosen.work << ", " << missed;
    }
  }
}

}  // namespace
}  // namespace bedmix
