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
  if (scene.effects.find<HeatSettings>()) keep(HeatLog::create(folder.heat(), scene), series, problems);
  if (scene.effects.find<ReactionSettings>())
    keep(ReactionLog::create(folder.reaction(), scene), series, problems);
  if (scene.effects.find<FeedSettings>()) keep(FeedLog::create(folder.feed(), scene), series, problems);
  if (!problems.empty()) return problems;
  return series;
}

std::vector<std::string> seriesNames(const Scene& scene) {
  const RunFolder files;
  std::vector<std::string> names{files.mixing().stem()};
  if (scene.flux) names.push_back(files.flux().stem());
  if (scene.gas) names.push_back(files.pressure().stem());
  if (scene.effects.find<HeatSettings>()) names.push_back(files.heat().stem());
  if (scene.effects.find<ReactionSettings>()) names.push_back(files.reaction().stem());
  if (scene.effects.find<FeedSettings>()) names.push_back(files.feed().stem());
  return names;
}

}  // namespace bedmix
