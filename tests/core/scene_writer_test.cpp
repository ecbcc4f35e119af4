// SPDX-License-Identifier: MIT
#include "engine/core/near_miss.h"
#include "engine/core/scene_description.h"
#include "engine/core/scene_keys.h"
#include "engine/core/scene_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <type_traits>

namespace bedmix {
namespace {

/// Every value of a scene to the bit, one line a key.
class BitDump {
 public:
  template <class T>
  void operator()(const Key& key, T& value) {
    out_ << key.name << ' ';
    put(value);
  }
  std::string text() const { return out_.str(); }

 private:
  void put(double v) { out_ << std::hex << std::bit_cast<std::uint64_t>(v) << '\n'; }
  void put(const StepLength& v) {
    if (v.isAutomatic())
      out_ << automaticStep << '\n';
    else
      put(static_cast<double>(v));
  }
  void put(std::int64_t v) { out_ << v << '\n'; }
  void put(std::uint64_t v) { out_ << v << '\n'; }
  void put(const std::string& v) { out_ << v << '\n'; }
  template <class T>
  requires std::is_enum_v<T>
  void put(T v) { out_ << static_cast<int>(v) << '\n'; }
  void put(Layers v) { out_ << tomlNames(v) << '\n'; }
  void put(Rgba v) { out_ << colorText(v) << '\n'; }
  void put(GridSpan& s) {
    put(s.count);
    put(s.size);
  }
  template <class T>
  void put(std::optional<T>& v) {
    out_ << v.has_value() << '\n';
    if (v) put(*v);
  }
  template <class T>
  void put(std::vector<T>& v) {
    out_ << v.size() << '\n';
    for (T& element : v) put(element);
  }
  template <class T>
  requires requires(T& t, BitDump& d) { describe(t, d); }
  void put(T& table) { describe(table, *this); }

  std::ostringstream out_;
};

std::string bits(Scene scene) {
  BitDump dump;
  describe(scene, dump);
  return dump.text();
}

void expectRoundTrip(const Scene& scene) {
  const std::string text = writeScene(scene);
  const auto again = readScene(text, scene.name + ".toml");
  ASSERT_TRUE(again) << toString(again.problems.at(0)) << '\n' << text;
  EXPECT_EQ(bits(*again), bits(scene));
  EXPECT_EQ(writeScene(*again), text);
}

TEST(SceneWriter, BundledScenesRoundTrip) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(BEDMIX_SOURCE_DIR "/assets/scenes")) {
    std::stringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const auto scene = readScene(text.str(), entry.path().string());
    ASSERT_TRUE(scene) << toString(scene.problems.at(0));
    expectRoundTrip(*scene);
    ++scenes;
  }
  EXPECT_GE(scenes, 5);
}

TEST(SceneWriter, AwkwardValuesRoundTrip) {
  Scene scene;
  scene.title = "quote \" backslash \\ tab \t newline \n unit \u00b5";
  scene.seed = 9007199254740993u;  // 2^53 + 1, no double
  scene.particles.density = 1.0 / 3.0 * 4000.0;
  scene.contacts.damping = 0.1 + 0.2;
  scene.contacts.friction = FrictionSettings{};
  scene.gas.emplace().minimumFluidizationVelocity = 5e-324;
  scene.gas->grid = {{{8, 0.012}}, {{15, 0.012}, {12, 0.02}}};
  scene.time.integrator = Integrator::rk4;
  scene.time.step = scene.gas->step = StepLength::automatic();
  scene.accuracy = Accuracy::draft;
  scene.particles.count = 3;
  scene.pictures.emplace().layers = {Layer::curve, Layer::trails, Layer::voidage};
  scene.pictures->color = ParticleColor::spin;
  scene.pictures->ground = {1, 171, 255};
  scene.pictures->trails = {2, 0};
  scene.pictures->trailTime = 0.1 + 0.2;
  expectRoundTrip(scene);
  scene.pictures->layers = {};
  expectRoundTrip(scene);
}

TEST(SceneWriter, WritesEveryDefaultAndNoAbsentEffect) {
  Scene scene;
  scene.contacts.restitution = 0.9;
  const std::string text = writeScene(scene);
  const std::vector<SceneKey> keys = sceneKeys();
  for (const char* effect : {"gas", "gas.inlets.from", "flux", "contacts.friction", "pictures.layers"})
    EXPECT_TRUE(std::any_of(keys.begin(), keys.end(), [&](const SceneKey& key) {
      return key.path == effect && key.mayBeAbsent;
    })) << effect;
  for (const SceneKey& key : keys) {
    if (key.type == "table") {
      EXPECT_EQ(text.find('[' + key.path + "]\n") == std::string::npos, key.mayBeAbsent) << key.path;
    } else if (!key.mayBeAbsent) {
      EXPECT_NE(text.find(std::string(key.key.name) + " = "), std::string::npos) << key.path;
    }
  }
}

TEST(NearMiss, FindsTheNearestWithinAThirdOfTheWord) {
  const std::vector<std::string> keys{"restitution", "damping", "step", "top"};
  EXPECT_EQ(nearMiss("resitution", keys), "restitution");
  EXPECT_EQ(nearMiss("setp", keys), "step");
  EXPECT_EQ(nearMiss("dampnig", keys), "damping");
  EXPECT_EQ(nearMiss("viscosity", keys), std::nullopt);
  EXPECT_EQ(didYouMean("stop", keys), "; did you mean \"step\"?");
}

TEST(SceneWriter, SettingsAreWhatIsWritten) {
  Scene scene;
  scene.contacts.restitution = 0.9;
  scene.gas.emplace();
  scene.gas->grid.columns = {{8, 0.012}};
  scene.gas->inlets = {{0.0, 0.02, 1.5, {}}, {0.04, 0.06, {}, 2.0}};
  const std::vector<SceneSetting> settings = sceneSettings(scene);
  for (const SceneSetting& expected : {SceneSetting{"contacts.restitution", "0.9"},
                                       {"gas.grid.columns", "[[8, 0.012]]"},
                                       {"gas.inlets.0.velocity", "1.5"},
                                       {"gas.inlets.1.velocity_umf", "2.0"}})
    EXPECT_NE(std::find(settings.begin(), settings.end(), expected), settings.end()) << expected.path;
  const std::string text = writeScene(scene);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(settings.size()), std::count(text.begin(), text.end(), '#'));
}

}  // namespace
}  // namespace bedmix
