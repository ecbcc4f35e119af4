// SPDX-License-Identifier: MIT
#include "replay/analysis/analysis.h"

#include "engine/core/near_miss.h"
#include "replay/analysis/band.h"
#include "replay/analysis/bubbles.h"
#include "replay/analysis/circulation.h"
#include "replay/analysis/crossings.h"
#include "replay/analysis/dispersion.h"
#include "replay/analysis/granular_temperature.h"
#include "replay/analysis/indices.h"
#include "replay/analysis/mechanisms.h"
#include "replay/analysis/residence.h"
#include "replay/analysis/sampling_size.h"
#include "replay/analysis/spectrum.h"
#include "replay/analysis/throughput.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace bedmix {

namespace {

std::string_view nothing(const Scene&) { return ""; }
std::string_view gas(const Scene& scene) { return scene.gas ? "" : "gas"; }
std::string_view feed(const Scene& scene) { return scene.effects.find<FeedSettings>() ? "" : "a feed"; }

template <class A>
std::unique_ptr<Analysis> make(const AnalysisInput& input) {
  return std::make_unique<A>(input);
}

constexpr std::array kinds{
    AnalysisKind{
        "temperature",
        "granular temperature: half the variance of the velocities' vector within the sampling cells, "
        "as motion is in a plane",
        "Gidaspow (1994), Multiphase Flow and Fluidization, ch. 9", nothing, make<GranularTemperature>},
    AnalysisKind{
        "mechanisms",
        "convective, shear and diffusive parts of the motion and of the displacement over a lag, by a "
        "linear fit in each sampling cell",
        "the three of Lacey (1954), J. Appl. Chem. 4:257", nothing, make<Mechanisms>},
    AnalysisKind{"dispersion",
                 "mean-square displacement over the lag and half its slope, the dispersion coefficients",
                 "Mostoufi & Chaouki (2001), Powder Technol. 114:23", nothing, make<Dispersion>},
    AnalysisKind{"flux", "solids flux, each way by itself, by height and through the upright centre line",
                 "crossings, counted", nothing, make<Crossings>},
    AnalysisKind{
        "circulation",
        "mean velocity and fraction of the solids in cells of two diameters, how much goes round and "
        "how long one round takes",
        "range of the mean flow's stream function", nothing, make<Circulation>},
    AnalysisKind{"residence",
                 "times that particles stay in either half and near the distributor, and until they are back",
                 "cycle times as of Stein et al. (2000), Chem. Eng. Sci. 55:5291", nothing, make<Residence>},
    AnalysisKind{"throughput",
                 "of a bed with a feed: who leaves, who is there, and how long those who come in stay",
                 "Danckwerts (1953), Chem. Eng. Sci. 2:1; Kaplan & Meier (1958), J. Am. Stat. Assoc. 53:457",
                 feed, make<Throughput>},
    AnalysisKind{
        "bubbles",
        "connected gas cells with more voidage than pictures.bubble_voidage, followed from frame to "
        "frame: diameter, rise, frequency, beside correlations",
        "Darton et al. (1977), Trans. IChemE 55:274; Davidson & Harrison (1963), Fluidised Particles", gas,
        make<Bubbles>},
    AnalysisKind{"spectrum", "power spectral density of pressure drop and bed height",
                 "Welch (1967), IEEE Trans. Audio Electroacoust. 15:70", nothing, make<Spectrum>},
    AnalysisKind{"indices", "all indices of mixing: assets/docs/indices.md",
                 "Poux et al. (1991), Powder Technol. 68:213, and each its own", nothing, make<Indices>},
    AnalysisKind{"band",
                 "95 % intervals of Lacey's and Ashton's index, by a studentized bootstrap over cells",
                 "Efron & Tibshirani (1993), An Introduction to the Bootstrap, ch. 12", nothing, make<Band>},
    AnalysisKind{"sampling", "indices against the size of the sampling cells",
                 "Danckwerts (1952), Appl. Sci. Res. A 3:279", nothing, make<SamplingSize>},
};

std::string listOf(std::span<const AnalysisKind> all) {
  std::string list;
  for (const AnalysisKind& kind : all)
    list += fmt::format("\n  {:<14}{} ({})", kind.name, kind.what, kind.citation);
  return list;
}

}  // namespace

std::span<const AnalysisKind> analysisKinds() { return kinds; }

Result<std::vector<const AnalysisKind*>> chooseAnalyses(std::string_view names, const Scene& scene) {
  std::vector<const AnalysisKind*> chosen;
  if (names == "all") {
    for (const AnalysisKind& kind : kinds)
      if (kind.lacks(scene).empty()) chosen.push_back(&kind);
    return chosen;
  }
  std::vector<Diagnostic> problems;
  for (std::size_t from = 0; from <= names.size();) {
    const std::size_t comma = std::min(names.find(',', from), names.size());
    const std::string_view name = names.substr(from, comma - from);
    from = comma + 1;
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.name == name; });
    if (kind == kinds.end()) {
      std::vector<std::string> known{"all"};
      for (const AnalysisKind& k : kinds) known.emplace_back(k.name);
      problems.push_back({{},
                          fmt::format("there is no analysis \"{}\"{}; there are{}", name,
                                      didYouMean(std::string(name), known), listOf(kinds))});
    } else if (const std::string_view lack = kind->lacks(scene); !lack.empty()) {
      problems.push_back({{}, fmt::format("\"{}\" needs {}", name, lack)});
    } else if (std::find(chosen.begin(), chosen.end(), &*kind) == chosen.end()) {
      chosen.push_back(&*kind);
    }
  }
  if (!problems.empty()) return problems;
  return chosen;
}

}  // namespace bedmix
