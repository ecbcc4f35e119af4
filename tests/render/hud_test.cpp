// SPDX-License-Identifier: MIT
#include "render/hud.h"

#include "render/colors.h"
#include "render/hud_rows.h"
#include "render/scales.h"
#include "tests/render/bed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace bedmix {
namespace {

constexpr std::array sizes{Size{240, 420}, Size{1280, 720}, Size{300, 900}, Size{720, 1280}, Size{641, 481}};

std::vector<std::string> hudTexts(const Scene& scene, const Frame& frame, Layers layers) {
  DrawList list;
  drawHud(list, scene, frame, layers, layoutPicture(scene, {240, 420}, layers));
  std::vector<std::string> texts;
  for (const Text& text : list.texts) texts.push_back(text.text);
  return texts;
}

bool contains(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

TEST(HudRows, SayTheStateOfTheBed) {
  const Scene scene = test::flatBed();
  const std::vector<std::string> texts = hudTexts(scene, test::movingFrame(scene, 1.5), defaultLayers);
  EXPECT_EQ(texts[0], "t = 1.50 s");
  EXPECT_EQ(texts[1], "1000 particles");
  EXPECT_EQ(texts[2], "u = 2.0 u_mf");
  EXPECT_EQ(texts[3].rfind("Lacey ", 0), 0u);
  EXPECT_EQ(texts[4].rfind("Ashton ", 0), 0u);
  EXPECT_TRUE(contains(texts, "tracer"));
  EXPECT_TRUE(contains(texts, "rest"));
  EXPECT_TRUE(contains(texts, "20 mm"));
}

TEST(HudRows, LegendArrowIsAsLongAsItsSpeedInTheBed) {
  const Scene scene = test::flatBed();
  const Layers layers{Layer::velocity, Layer::hud};
  for (const Size size : sizes) {
    const Layout layout = layoutPicture(scene, size, layers);
    DrawList list;
    drawHud(list, scene, test::movingFrame(scene), layers, layout);
    const auto label = std::find_if(list.texts.begin(), list.texts.end(),
                                    [](const Text& t) { return t.text.starts_with("solids "); });
    ASSERT_NE(label, list.texts.end());
    const double speed = std::stod(label->text.substr(7));
    const float length = norm(list.lines[0].to - list.lines[0].from);
    EXPECT_NEAR(length, speed * layout.camera.length(arrowScale(scene, Layer::velocity)), 1e-2);
    EXPECT_GT(length, 0.5f * layout.em);
  }
}

TEST(HudRows, LeaveAnUndefinedIndexOpen) {
  const Scene scene = test::gaslessBed();
  const std::vector<std::string> texts =
      hudTexts(scene, test::particlesAt({{0.01f, 0.01f}}, {}), {Layer::hud});
  EXPECT_EQ(texts[0], "t = 0.00 s");
  EXPECT_EQ(texts[2], "Lacey -");
  EXPECT_EQ(texts[3], "Ashton -");
}

TEST(HudRows, CountWhatIsAboveTheView) {
  const Scene scene = test::gaslessBed();
  const Frame frame = test::particlesAt({{0.01f, 0.01f}, {0.02f, 0.60f}}, {{0.03f, 0.70f}});
  EXPECT_TRUE(contains(hudTexts(scene, frame, defaultLayers), "2 above"));
}

TEST(HudRows, AreAsManyAsTheLayoutReckonsWith) {
  const Scene scene = test::flatBed();
  const Layers layers{Layer::particles, Layer::velocity, Layer::gas, Layer::voidage, Layer::hud};
  const HudRowCount rows = hudRowCount(scene, layers);
  // Besides the rows' texts: two ends of the colour bar in one row, and the scale bar's length.
  EXPECT_EQ(hudTexts(scene, test::movingFrame(scene), layers).size(),
            static_cast<std::size_t>(rows.state + rows.legend) + 2);
}

TEST(HudRows, WriteTimesInFull) {
  EXPECT_EQ(timeDecimals(std::array{0.0, 1.0, 7.0}), 1);
  EXPECT_EQ(timeDecimals(std::array{0.0, 0.5, 1.25}), 2);
  EXPECT_EQ(timeDecimals(std::array{0.01}), 2);
  EXPECT_EQ(timeLabel(0.5, 1), "t = 0.5 s");
}

TEST(Layout, ShowsTheWholeBedInEverySize) {
  for (const Scene& scene : {test::flatBed(), test::inclinedBed(), test::gaslessBed()})
    for (const Size size : sizes) {
      const Layout layout = layoutPicture(scene, size, defaultLayers);
      const Vec2f low = layout.camera.toPixel(Vec2{0.0, 0.0});
      const Vec2f high = layout.camera.toPixel(Vec2{scene.bed.width, viewHeight(scene)});
      EXPECT_GE(low.x, layout.view.left);
      EXPECT_LE(high.x, layout.view.right);
      EXPECT_LE(high.x, static_cast<float>(size.width));
      EXPECT_LT(low.y, static_cast<float>(size.height));
      EXPECT_GE(high.y, layout.view.top - 0.5f);
    }
}

TEST(Layout, KeepsTextsInsideThePictureAndOffTheBed) {
  const Scene scene = test::inclinedBed();
  const Layers layers{Layer::particles, Layer::velocity, Layer::gas,
                      Layer::pressure,  Layer::walls,    Layer::hud};
  for (const Size size : sizes) {
    const Layout layout = layoutPicture(scene, size, layers);
    DrawList list;
    drawHud(list, scene, test::movingFrame(scene), layers, layout);
    Hud hud(layout.em);
    const UiMesh& mesh = hud.mesh(size, list.texts);
    ASSERT_FALSE(mesh.vertices.empty());
    const float bedLeft = layout.camera.origin.x;
    for (const UiVertex& v : mesh.vertices) {
      EXPECT_GE(v.at.x, 0.0f);
      EXPECT_LE(v.at.x, static_cast<float>(size.width));
      EXPECT_GE(v.at.y, 0.0f);
      EXPECT_LE(v.at.y, static_cast<float>(size.height));
      const bool beside = v.at.x < bedLeft, above = v.at.y <= layout.view.top;
      const bool below = v.at.y > layout.camera.origin.y;
      EXPECT_TRUE(beside || above || below)
          << size.width << 'x' << size.height << " at " << v.at.x << ", " << v.at.y;
    }
  }
}

TEST(Hud, SetsTextByItsAnchor) {
  Hud hud(20.0f);
  const auto extent = [&](Vec2f anchor) {
    const std::array text{Text{{100.0f, 100.0f}, anchor, ink, "bed"}};
    const UiMesh& mesh = hud.mesh({200, 200}, text);
    Box box{200.0f, 200.0f, 0.0f, 0.0f};
    for (const UiVertex& v : mesh.vertices)
      box = {std::min(box.left, v.at.x), std::min(box.top, v.at.y), std::max(box.right, v.at.x),
             std::max(box.bottom, v.at.y)};
    return box;
  };
  EXPECT_GE(extent({0.0f, 0.0f}).left, 99.0f);
  EXPECT_GE(extent({0.0f, 0.0f}).top, 99.0f);
  EXPECT_LE(extent({1.0f, 1.0f}).right, 101.0f);
  EXPECT_LE(extent({1.0f, 1.0f}).bottom, 101.0f);
  const Box middle = extent({0.5f, 0.5f});
  EXPECT_NEAR(0.5f * (middle.left + middle.right), 100.0f, 2.0f);
}

}  // namespace
}  // namespace bedmix
