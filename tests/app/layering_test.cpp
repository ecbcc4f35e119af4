// SPDX-License-Identifier: MIT
#include "tests/app/program.h"

#include <map>
#include <regex>
#include <set>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

/// Every source file of a folder of the repository with the targets of its includes.
std::map<std::string, std::set<std::string>> includesUnder(const std::string& part) {
  std::map<std::string, std::set<std::string>> found;
  const std::regex include(R"(#include\s*["<]([^">]+)[">])");
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(BEDMIX_SOURCE_DIR) / part)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".h" && ending != ".cpp") continue;
    const std::string text = readFile(entry.path());
    auto& targets = found[fs::relative(entry.path(), BEDMIX_SOURCE_DIR).string()];
    for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it)
      targets.insert((*it)[1]);
  }
  return found;
}

bool startsWithAny(const std::string& text, const std::vector<std::string>& beginnings) {
  for (const std::string& b : beginnings)
    if (text.starts_with(b)) return true;
  return false;
}

const std::vector<std::string> houseParts{"engine/", "render/", "replay/", "app/"};

/// Which parts of the house a folder may include.
struct Layer {
  const char* folder;
  std::vector<std::string> allowed;
};

TEST(Layering, FoldersIncludeOnlyWhatLiesBelowThem) {
  const Layer layers[]{
      // Beside them, what a scene says of effects, and what is known of each.
      {"engine/core", {"engine/core/", "engine/effects/settings.h", "engine/effects/effects.h"}},
      {"engine/dem", {"engine/core/", "engine/dem/", "engine/effects/cohesion", "engine/effects/rolling"}},
      {"engine/gas", {"engine/core/", "engine/gas/"}},
      {"engine/coupling",
       {"engine/core/", "engine/coupling/", "engine/dem/", "engine/gas/"}},  // joins the two
      {"engine", {"engine/"}},
      {"render", {"engine/core/", "render/"}},
      {"replay", {"engine/core/", "replay/"}},
  };
  for (const Layer& layer : layers) {
    const auto files = includesUnder(layer.folder);
    EXPECT_FALSE(files.empty()) << layer.folder;
    for (const auto& [file, targets] : files)
      for (const std::string& target : targets)
        EXPECT_TRUE(!startsWithAny(target, houseParts) || startsWithAny(target, layer.allowed))
            << file << " includes " << target;
  }
}

/// A library and the files that may know it, by the beginning of their path.
struct Foreign {
  std::vector<std::string> headers;
  std::vector<std::string> users;
};

TEST(Layering, LibrariesAreKnownInFewPlaces) {
  const Foreign libraries[]{
      {{"toml++/"}, {"engine/core/scene_reader.cpp", "engine/core/scene_tree."}},
      {{"Eigen/"}, {"engine/gas/"}},
      {{"unsupported/Eigen/"}, {"replay/analysis/spectrum.cpp"}},
      {{"hdf5"}, {"replay/"}},
      {{"muParser"}, {"replay/tracer_choice.cpp"}},
      {{"GL/", "EGL/", "imgui", "libav", "libsw", "png.h", "turbojpeg"}, {"render/"}},
      {{"CLI/"}, {"app/"}},
      {{"nlohmann/"}, {"app/", "replay/summary"}},
  };
  for (const std::string part : {"engine", "render", "replay", "app"})
    for (const auto& [file, targets] : includesUnder(part))
      for (const std::string& target : targets)
        for (const Foreign& library : libraries)
          EXPECT_TRUE(!startsWithAny(target, library.headers) || startsWithAny(file, library.users))
              << file << " includes " << target;
}

/// Schedules and measurements go by a clock that never jumps; the calendar is for the log alone.
TEST(Layering, TheWallClockIsReadInOnePlace) {
  const std::regex forbidden(
      R"(system_clock|high_resolution_clock|CLOCK_REALTIME|gettimeofday|std::time\(|ITIMER_REAL|\balarm\()");
  for (const std::string part : {"engine", "render", "replay", "app"})
    for (const auto& [file, targets] : includesUnder(part)) {
      if (file == "app/attempts.cpp") continue;  // the date of a resume
      const std::string text = readFile(fs::path(BEDMIX_SOURCE_DIR) / file);
      std::smatch found;
      EXPECT_FALSE(std::regex_search(text, found, forbidden)) << file << ": " << found.str();
    }
}

/// Two types of one name in the namespace are one type to the linker, which then takes the destructor of
/// either.
TEST(Layering, TypesOfHeadersHaveNamesOfTheirOwn) {
  const std::regex type(
      R"(\n(?:struct|class|enum class) (?:alignas\(\w+\) )?(\w+)\b(?!<)[^;{\n]*\{)");  // but specializations
  std::map<std::string, std::string> fileOf;
  for (const std::string part : {"engine", "render", "replay", "app"})
    for (const auto& [file, targets] : includesUnder(part)) {
      if (!file.ends_with(".h")) continue;
      const std::string text = readFile(fs::path(BEDMIX_SOURCE_DIR) / file);
      for (std::sregex_iterator it(text.begin(), text.end(), type), end; it != end; ++it) {
        const auto [known, isNew] = fileOf.emplace((*it)[1], file);
        EXPECT_TRUE(isNew) << (*it)[1] << " in " << file << " and " << known->second;
      }
    }
  EXPECT_GT(fileOf.size(), 100u);
}

TEST(Layering, NothingBelowTheProgramPrintsOrExits) {
  const std::regex forbidden(
      R"(\b(std::cout|std::cerr|printf|fmt::print|std::exit|std::abort|_exit|exit)\s*(\(|<<))");
  for (const std::string part : {"engine", "render", "replay"})
    for (const auto& [file, targets] : includesUnder(part)) {
      if (file == "replay/child_process.cpp") continue;  // the child ends, the program does not
      const std::string text = readFile(fs::path(BEDMIX_SOURCE_DIR) / file);
      std::smatch found;
      EXPECT_FALSE(std::regex_search(text, found, forbidden)) << file << ": " << found.str();
    }
}

}  // namespace
}  // namespace bedmix
