// SPDX-License-Identifier: MIT
#include "app/series.h"

#include "replay/series_log.h"

#include <utility>

namespace bedmix {

namespace {

template <class Sink>
void keep(Result<Sink> sink, Series& series, std::vector<Diagnostic>& problems) {
  if (sink)
    series.push_back(std::make_unique<Sink>(std::move(*sink)));
  else
    problems.insert(problems.end(), sink.problems.begin(), sink.problems.end());
}

}  // namespace

Result<Series> openSeries(const RunFolder& folder, const Scene& scene) {
  Series series;
  std::vector<Diagnostic> problems;
  keep(MixingLog::create(folder.mixing(), samplingGrid(scene)), series, problems);
  if (scene.flux) keep(FluxLog::create(folder.flux(), scene), series, problems);
  if (scene.gas) keep(PressureLog::create(folder.pressure(), scene), series, problems);
  if (!problems.empty()) return problems;
  return series;
}

}  // namespace bedmix
