// SPDX-License-Identifier: MIT
#include "app/accuracy/statistics.h"

#include "engine/core/bed_statistics.h"
#include "engine/core/mixing.h"
#include "engine/simulation.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace bedmix {

namespace {

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The series of one run, sampled at frames.
class Series {
 public:
  explicit Series(const Scene& scene) : scene_(scene), sampling_(samplingGrid(scene)) {
    if (scene.gas) grid_ = makeGasGrid(scene);
  }

  void accept(const Frame& frame, bool counts) {
    const MixingSample mixing = mixingSample(frame, sampling_);
    if (!mixingTime_ && mixing.ashton.value_or(0.0) >= mixedIndex) mixingTime_ = frame.time;
    if (!counts) return;
    if (mixing.ashton) ashton_.push_back(*mixing.ashton);
    if (mixing.lacey) lacey_.push_back(*mixing.lacey);
    if (frame.hasGas()) pressure_.push_back(pressureDrop(frame, grid_));
    if (scene_.flux) flux_.push_back(solidsFlux(frame, scene_));
    height_.push_back(bedHeight(frame, scene_));
    double sum = 0.0;
    for (const Vec2f v : frame.velocity)
      sum += static_cast<double>(v.x) * v.x + static_cast<double>(v.y) * v.y;
    speed2_.push_back(frame.size() == 0 ? 0.0 : sum / static_cast<double>(frame.size()));
  }

  void give(Sample& into) const {
    const auto set = [&](const Measure& m, std::span<const double> values) {
      if (!values.empty()) into.set(m, mean(values));
    };
    if (mixingTime_) into.set(measure::mixingTime, *mixingTime_);
    set(measure::ashton, ashton_);
    set(measure::lacey, lacey_);
    set(measure::pressureDrop, pressure_);
    set(measure::bedHeight, height_);
    set(measure::flux, flux_);
    if (!speed2_.empty()) into.set(measure::speed, std::sqrt(mean(speed2_)));
    if (pressure_.size() < 2) return;
    double sum = 0.0;
    for (const double p : pressure_) sum += (p - mean(pressure_)) * (p - mean(pressure_));
    into.set(measure::pressureSd, std::sqrt(sum / static_cast<double>(pressure_.size() - 1)));
    if (const auto centre = spectralCentre(pressure_, scene_.sampling.interval))
      into.set(measure::pressureFrequency, *centre);
  }

 private:
  const Scene& scene_;
  SamplingGrid sampling_;
  GasGrid grid_;
  std::optional<double> mixingTime_;
  std::vector<double> ashton_, lacey_, pressure_, height_, flux_, speed2_;
};

}  // namespace

std::optional<double> spectralCentre(std::span<const double> values, double interval) {
  const std::size_t n = values.size();
  const double middle = mean(values);
  double power = 0.0, moment = 0.0;
  for (std::size_t k = 1; k <= n / 2; ++k) {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    std::complex<double> amplitude;
    for (std::size_t i = 0; i < n; ++i)
      amplitude += (values[i] - middle) * std::polar(1.0, -turn * static_cast<double>(i));
    power += std::norm(amplitude);
    moment += std::norm(amplitude) * static_cast<double>(k) / (static_cast<double>(n) * interval);
  }
  if (!(power > 0.0)) return std::nullopt;
  return moment / power;
}

bool measureStatistics(const Scene& scene, const Particles& start, double duration,
                       const std::function<bool()>& stop, Sample& into) {
  Simulation simulation = Simulation::make(scene, start);
  Series series(scene);
  series.accept(*simulation.frame(), !scene.gas);
  const auto frames = std::llround(duration / scene.sampling.interval);
  for (std::int64_t k = 1; k <= frames; ++k) {
    if (stop()) return false;
    if (auto trouble = simulation.advance(stepsPerFrame(scene))) {
      into.failure = *trouble;
      break;
    }
    series.accept(*simulation.frame(), !scene.gas || 2 * k > frames);
  }
  const StepReport& report = simulation.report();
  into.set(measure::simulated, simulation.time());
  into.set(measure::overlap, report.largestOverlap);
  if (scene.gas) into.set(measure::massResidual, report.largestMassResidual);
  if (simulation.gasSteps() > 0)
    into.set(measure::notConverged,
             static_cast<double>(report.gasStepsNotConverged) / static_cast<double>(simulation.gasSteps()));
  if (into.failure.empty()) series.give(into);
  return true;
}

}  // namespace bedmix
