// SPDX-License-Identifier: MIT
#include "engine/gas/gas_solver.h"

#include "engine/gas/frame_kernel.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

// SIMPLE's under-relaxation, Patankar (1980) with the pressure share that suits a transient: 1 - velocity
// share.
constexpr double relaxVelocity = 0.7;
constexpr double relaxPressure = 0.3;

constexpr int worthSharing = 4096;  // cells; below it waiting for each other costs more than is gained

// What a pressure correction may leave of the imbalance; and of the inflow, however small the imbalance is.
// The second of PISO's closes what the first one leaves.
constexpr double ofImbalance = 1e-12, ofFirstImbalance = 1e-3, ofInflow = 1e-12;

}  // namespace

GasSolver::GasSolver(const Scene& scene, ThreadTeam& team)
    : grid_(makeGasGrid(scene)),
      layout_(makeFaceLayout(grid_)),
      momentum_(scene, layout_),
      pressureSolver_(layout_, team.size()),
      team_(grid_.columns * grid_.rows < worthSharing || team.size() == 1 ? nullptr : &team),
      scheme_(scene.gas->scheme),
      step_(scene.gas->step.valueOr(longestGasStep(scene))),
      sinceLast_(step_),
      tolerance_(scene.gas->tolerance),
      maxIterations_(scene.gas->maxIterations),
      reduction_(grid_.rows) {
  const auto faces = static_cast<std::size_t>(layout_.faces()),
             places = static_cast<std::size_t>(layout_.size);
  const std::size_t cells = grid_.cells();
  fields_ = {std::vector<double>(faces), std::vector<double>(cells), std::vector<double>(cells, 1.0)};
  exchange_ = {std::vector<double>(faces), std::vector<double>(faces)};
  for (auto* field : {&conductance_, &change_}) field->assign(faces, 0.0);
  for (auto* field : {&growth_, &pressure_, &imbalance_, &correction_}) field->assign(places, 0.0);
  faceVoidage_.assign(faces, 1.0);
  voidage_.assign(places, 1.0);
  setInletFlux(grid_.inletFlux);
}

void GasSolver::setInletFlux(const std::vector<double>& superficial) {
  grid_.inletFlux = superficial;
  inflow_ = 0.0;
  for (std::size_t column = 0; column < layout_.floor.size(); ++column) {
    FloorFace& f = layout_.floor[column];
    f.flux = superficial[column] * f.area;
    inflow_ += std::abs(f.flux);
  }
}

void GasSolver::setStep(double seconds) {
  step_ = seconds;
  momentum_.setStep(seconds);
}

void GasSolver::startWith(const std::vector<double>& voidage) {
  sinceLast_ = step_;
  Member alone;
  takeVoidage(alone, voidage);
  publish(alone);
}

void GasSolver::replaceSolids(const std::vector<double>& before, const std::vector<double>& after) {
  const int places = layout_.stride * (layout_.rows + 1);  // as in takeVoidage()
  for (int c = 0; c < places; ++c) {
    const int cell = layout_.voidageCell[c];
    voidage_[c] += after[cell] - before[cell];
  }
  Member alone;
  updateFaceVoidage(alone);
}

void GasSolver::save(StateWriter& out) const {
  out.put(sinceLast_);
  out.putAll(grid_.inletFlux);
  out.putAll(fields_.velocity);
  out.putAll(pressure_);
  out.putAll(voidage_);
  out.putAll(faceVoidage_);
}

bool GasSolver::load(StateReader& in) {
  std::vector<double> inletFlux(grid_.inletFlux.size());
  if (!(in.get(sinceLast_) && sinceLast_ > 0.0 && in.getAll(inletFlux) && in.getAll(fields_.velocity) &&
        in.getAll(pressure_) && in.getAll(voidage_) && in.getAll(faceVoidage_)))
    return false;
  setStep(sinceLast_);
  setInletFlux(inletFlux);
  Member alone;
  publish(alone);
  return true;
}

GasStepReport GasSolver::advance(const std::vector<double>& voidage) {
  GasStepReport report;
  if (!team_) {
    Member alone;
    report = step(alone, voidage);
  } else {
    team_->run([&](int index) {
      Member member(*team_, index);
      const GasStepReport mine = step(member, voidage);
      if (member.first()) report = mine;  // all have the same
    });
  }
  sinceLast_ = step_;
  return report;
}

GasStepReport GasSolver::step(Member& member, const std::vector<double>& voidage) {
  momentum_.beginStep(member, fields_.velocity, faceVoidage_);
  member.wait();
  if (member.first()) {
    for (const FloorFace& f : layout_.floor) fields_.velocity[f.face] = f.flux / (f.area * voidage[f.cell]);
    layout_.copyAround(&fields_.velocity[layout_.families[1].first], {0, 1});  // level, so that it is all
  }
  takeVoidage(member, voidage);
  GasStepReport report = scheme_ == GasScheme::projection ? project(member) : simple(member);
  report.massResidual = massResidual(member);
  report.solved = report.solved && std::isfinite(report.massResidual);
  report.courant = courant(member);
  publish(member);
  return report;
}

void GasSolver::takeVoidage(Member& member, const std::vector<double>& voidage) {
  const Range rows = member.share(layout_.rows + 1);  // and the one below the floor
  const auto begin = rows.begin * static_cast<std::size_t>(layout_.stride);
  const auto end = rows.end * static_cast<std::size_t>(layout_.stride);
  for (std::size_t c = begin; c < end; ++c) {
    const double now = voidage[layout_.voidageCell[c]];
    growth_[c] = layout_.open[c] * (now - voidage_[c]) / sinceLast_;
    voidage_[c] = now;
  }
  member.wait();
  updateFaceVoidage(member);
}

void GasSolver::updateFaceVoidage(Member& member) {
  for (const FaceFamily& family : layout_.families) {
    const Range mine = member.share(family.rows + 1);
    const int from = layout_.rowStart(static_cast<int>(mine.begin) - 1),
              to = layout_.rowStart(static_cast<int>(mine.end) - 1);
    for (int c = std::max(from, family.along); c < to; ++c) {
      const double before = layout_.weightBefore[family.first + c];
      faceVoidage_[family.first + c] = before * voidage_[c - family.along] + (1.0 - before) * voidage_[c];
    }
    layout_.copyAround(&faceVoidage_[family.first], {std::max<std::size_t>(mine.begin, 1) - 1, mine.end - 1});
  }
  member.wait();
}

void GasSolver::updateImbalance(Member& member) {
  const auto flow = [this](const FaceFamily& family) {
    return FaceFlow{&fields_.velocity[family.first], &faceVoidage_[family.first],
                    &layout_.faceArea[family.first]};
  };
  const auto& [upright, level] = layout_.families;
  findImbalance(flow(upright), flow(level), layout_.stride, growth_.data(), layout_.open.data(),
                imbalance_.data(), layout_.places(member.share(layout_.rows)));
}

double GasSolver::massResidual(Member& member) {
  updateImbalance(member);
  const Range mine = layout_.places(member.share(layout_.rows));
  // A sum tells of what is no number, which a maximum may not.
  const Residual found{largestSize(imbalance_.data(), mine), total(imbalance_.data(), mine)};
  const Residual all = reduction_.overShares(member, found, [](Residual a, Residual b) {
    return Residual{std::max(a.largest, b.largest), a.sum + b.sum};
  });
  if (!std::isfinite(all.sum)) return all.sum;
  return inflow_ > 0.0 ? all.largest / inflow_ : all.largest;
}

double GasSolver::courant(Member& member) {
  double mine = 0.0;
  const Range rows = member.share(layout_.rows);
  for (int row = static_cast<int>(rows.begin); row < static_cast<int>(rows.end); ++row)
    for (int column = 0; column < layout_.columns; ++column) {
      mine = std::max(mine, std::abs(fields_.velocity[layout_.uFace(column, row)]) / layout_.width[column]);
      mine = std::max(mine, std::abs(fields_.velocity[layout_.vFace(column, row)]) / layout_.height[row]);
    }
  const auto larger = [](Residual a, Residual b) { return Residual{std::max(a.largest, b.largest), 0.0}; };
  return step_ * reduction_.overShares(member, {mine, 0.0}, larger).largest;
}

bool GasSolver::preparePressure(Member& member) {
  momentum_.conductances(member, conductance_);
  member.wait();
  return pressureSolver_.prepare(member, conductance_);
}

void GasSolver::correct(Member& member, double pressureShare, double left) {
  updateImbalance(member);
  member.wait();
  pressureSolver_.solve(member, imbalance_, correction_, {left, ofInflow * inflow_});
  layout_.copyAround(correction_.data(), member.share(layout_.rows));
  momentum_.correct(member, correction_, change_, fields_.velocity);
  const Range mine = layout_.places(member.share(layout_.rows));
  for (std::size_t c = mine.begin; c < mine.end; ++c) pressure_[c] += pressureShare * correction_[c];
  member.wait();
}

GasStepReport GasSolver::project(Member& member) {
  momentum_.assemble(member, fields_.velocity, faceVoidage_, pressure_, exchange_);
  momentum_.solve(member, fields_.velocity);
  if (!preparePressure(member)) return {.solved = false};
  correct(member, 1.0, ofFirstImbalance);
  momentum_.addNeighbourEffect(member, change_, fields_.velocity);
  member.wait();
  correct(member, 1.0, ofImbalance);
  return {};
}

GasStepReport GasSolver::simple(Member& member) {
  for (std::int64_t iteration = 0; iteration < maxIterations_; ++iteration) {
    momentum_.assemble(member, fields_.velocity, faceVoidage_, pressure_, exchange_);
    const double momentumResidual = momentum_.residual(member, fields_.velocity);
    momentum_.relax(member, fields_.velocity, relaxVelocity);
    momentum_.solve(member, fields_.velocity);
    if (!preparePressure(member)) return {.solved = false};
    const double mass = massResidual(member);
    correct(member, relaxPressure, ofImbalance);
    if (momentumResidual < tolerance_ && mass < tolerance_) return {};
  }
  return {.converged = false};
}

void GasSolver::publish(Member& member) {
  const Range rows = member.share(layout_.rows);
  for (int row = static_cast<int>(rows.begin); row < static_cast<int>(rows.end); ++row)
    for (int column = 0; column < layout_.columns; ++column) {
      const std::size_t cell = grid_.cell(column, row);
      const int c = layout_.at(column, row);
      const bool open = layout_.open[c] > 0.0;
      fields_.voidage[cell] = open ? voidage_[c] : 1.0;
      fields_.pressure[cell] = open ? pressure_[c] : 0.0;
    }
}

}  // namespace bedmix
