// SPDX-License-Identifier: MIT
#include "replay/analysis/throughput.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bedmix {

namespace {

constexpr double perSecond = 1e6;  // of the unit in which lengths are told apart
constexpr std::size_t rows = 100;  // of the table

}  // namespace

Throughput::Throughput(const AnalysisInput& input) : scene_(input.scene) {}

void Throughput::accept(const Frame& frame) {
  const double now = frame.time;
  if (!begun_) {
    begin_ = now_ = now;
    newest_ = static_cast<std::int32_t>(scene_.particles.count) - 1;
  }
  holdUp_ += static_cast<double>(present_.size()) * (now - now_);
  std::vector<Present> present;
  present.reserve(frame.size());
  std::size_t before = 0;
  const auto leaveUpTo = [&](std::int64_t id) {  // those below it
    for (; before < present_.size() && present_[before].id < id; ++before) {
      left_ += 1.0;
      if (present_[before].id >= scene_.particles.count && present_[before].since > begin_)
        stays_.push_back(now - present_[before].since);
    }
  };
  for (const std::int32_t id : frame.id) {
    leaveUpTo(id);
    const bool wasThere = before < present_.size() && present_[before].id == id;
    present.push_back(wasThere ? present_[before++] : Present{id, now});
  }
  leaveUpTo(std::int64_t{1} << 32);
  if (!frame.id.empty() && frame.id.back() > newest_) {
    if (begun_) {
      // Ids are consecutive: who came and left between two frames is counted, too.
      const double came = frame.id.back() - newest_;
      const auto seen =
          std::count_if(present.begin(), present.end(), [&](const Present& p) { return p.id > newest_; });
      entered_ += came;
      left_ += came - static_cast<double>(seen);
    }
    newest_ = frame.id.back();
  }
  present_ = std::move(present);
  now_ = now;
  begun_ = true;
}

std::map<std::int64_t, Throughput::Stays> Throughput::stays() const {
  std::map<std::int64_t, Stays> all;
  const auto key = [](double length) { return std::llround(length * perSecond); };
  for (const double length : stays_) all[key(length)].ended += 1.0;
  for (const Present& p : present_)
    if (p.id >= scene_.particles.count && p.since > begin_) all[key(now_ - p.since)].goOn += 1.0;
  return all;
}

Throughput::Shares Throughput::shares() const {
  Shares shares;
  const std::map<std::int64_t, Stays> all = stays();
  double atRisk = 0.0;
  for (const auto& [length, stay] : all) atRisk += stay.ended + stay.goOn;
  double remain = 1.0, last = 0.0, square = 0.0;
  for (const auto& [length, stay] : all) {
    const double time = static_cast<double>(length) / perSecond;
    shares.mean += remain * (time - last);
    square += remain * (time * time - last * last);
    last = time;
    if (stay.ended > 0.0) {
      remain *= 1.0 - stay.ended / atRisk;
      shares.time.push_back(time);
      shares.left.push_back(stay.ended);
      shares.share.push_back(1.0 - remain);
    }
    atRisk -= stay.ended + stay.goOn;
  }
  shares.variance = square - shares.mean * shares.mean;
  return shares;
}

std::optional<double> Throughput::holdUpOverOutflow() const {
  return left_ > 0.0 ? std::optional(holdUp_ / left_) : std::nullopt;
}

std::vector<NamedTable> Throughput::tables() const {
  Table table{{"time", "left", "density", "share", "stirred"}, std::vector<Table::Column>(5)};
  const Shares s = shares();
  if (!s.time.empty()) {
    const double width = s.time.back() / static_cast<double>(rows);
    double share = 0.0;
    for (std::size_t row = 1, k = 0; row <= rows; ++row) {
      const double time = row == rows ? s.time.back() : static_cast<double>(row) * width;
      double left = 0.0, before = share;
      for (; k < s.time.size() && s.time[k] <= time; ++k) {
        left += s.left[k];
        share = s.share[k];
      }
      table.append({time, left, (share - before) / width, share, 1.0 - std::exp(-time / s.mean)});
    }
  }
  return {{"residence_times", std::move(table)}};
}

std::vector<FoundNumber> Throughput::findings() const {
  const double span = now_ - begin_;
  const auto over = [](double value, double by) {
    return by > 0.0 ? std::optional(value / by) : std::nullopt;
  };
  const Shares s = shares();
  const bool has = !s.time.empty();
  return {{"particles_entered", over(entered_, span), "1/s"},
          {"particles_left", over(left_, span), "1/s"},
          {"hold_up", over(holdUp_, span), ""},
          {"hold_up_over_outflow", holdUpOverOutflow(), "s"},
          {"residence_mean", has ? std::optional(s.mean) : std::nullopt, "s"},
          {"residence_variance", has ? over(s.variance, s.mean * s.mean) : std::nullopt, ""},
          {"stirred_tanks", has ? over(s.mean * s.mean, s.variance) : std::nullopt, ""}};
}

}  // namespace bedmix
