// SPDX-License-Identifier: MIT
#include "render/panel/panel.h"

#include "tests/render/bed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>

namespace bedmix {
namespace {

constexpr Size size{1280, 720};

InputEvent pointer(Vec2f at, unsigned buttons, bool isTouch = false) {
  return {.at = at, .buttons = buttons, .isTouch = isTouch};
}

Vec2f middle(const Box& box) { return {0.5f * (box.left + box.right), 0.5f * (box.top + box.bottom)}; }

/// The actions of one kind.
template <class Kind>
std::vector<Kind> of(const std::vector<PanelAction>& actions) {
  std::vector<Kind> found;
  for (const PanelAction& action : actions)
    if (const auto* kind = std::get_if<Kind>(&action.what)) found.push_back(*kind);
  return found;
}

/// A panel before a bed, as the program would show it.
class PanelTest : public ::testing::Test {
 protected:
  PanelTest() {
    model.missing.resize(modelTable<Layer>.size());
    model.inlets.push_back({"0 to 96 mm", 1.0, 2.0});
    model.fastestInlet = 4.0;
    model.time = model.end = 1.0;
    model.style.layers = {Layer::particles, Layer::walls};
    model.grid = samplingGrid(scene);
    place();
    settle();
  }
  void place() {
    model.beds = {
        {&scene, &frame, layoutPicture(std::span(&scene, 1), panel.bedPart(), model.style).beds.front()}};
  }
  void settle() {
    for (int i = 0; i < 3; ++i) panel.update(model, {}, 0.03);
  }
  std::vector<PanelAction> send(std::vector<InputEvent> events) { return panel.update(model, events, 0.03); }
  std::vector<PanelAction> click(Vec2f at, bool isTouch = false) {
    return send({pointer(at, 0, isTouch), pointer(at, 1, isTouch), pointer(at, 0, isTouch)});
  }
  Vec2f placeOf(const char* label) { return middle(panel.item(label).value()); }

  Scene scene = test::flatBed();
  Frame frame = test::movingFrame(scene, 1.0);
  PanelModel model;
  ControlPanel panel{size, 1.0f};
};

TEST_F(PanelTest, FastClickIsNotLost) {
  const auto plays = of<PanelAction::Play>(click(placeOf("play")));
  ASSERT_EQ(plays.size(), 1u);
  EXPECT_TRUE(plays[0].on);
  model.isPlaying = true;
  const auto pauses = of<PanelAction::Play>(click(placeOf("play"), true));
  ASSERT_EQ(pauses.size(), 1u) << "by a finger, which comes from nowhere";
  EXPECT_FALSE(pauses[0].on);
}

TEST_F(PanelTest, ClickElsewhereDoesNothing) { EXPECT_TRUE(click({1279.0f, 719.0f}).empty()); }

TEST_F(PanelTest, SliderOfAnInletChangesItsVelocity) {
  const Box slider = panel.item("velocity 1").value();
  const float y = middle(slider).y;
  send({pointer({slider.left + 10.0f, y}, 0), pointer({slider.left + 10.0f, y}, 1)});
  const auto changes = of<PanelAction::Change>(send({pointer({slider.right - 1.0f, y}, 1)}));
  ASSERT_FALSE(changes.empty());
  const std::vector<Override>& values = changes.back().values;
  ASSERT_EQ(values.size(), 2u);
  EXPECT_EQ(values[0].path, "gas.inlets.0.velocity_umf");
  EXPECT_EQ(values[0].value, "");
  EXPECT_EQ(values[1].path, "gas.inlets.0.velocity");
  EXPECT_NEAR(std::stod(values[1].value), 4.0, 1e-9);
}

TEST_F(PanelTest, SpaceBarPlaysAndArrowsStepThroughARecording) {
  EXPECT_EQ(
      of<PanelAction::Play>(send({{.kind = InputEvent::Kind::key, .key = PanelKey::space, .isDown = true}}))
          .size(),
      1u);
  model.isLive = false;
  model.frames = 11;
  send({{.kind = InputEvent::Kind::key, .key = PanelKey::space, .isDown = false}});
  const auto steps =
      of<PanelAction::Step>(send({{.kind = InputEvent::Kind::key, .key = PanelKey::left, .isDown = true}}));
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].frames, -1);
}

TEST_F(PanelTest, ParticleUnderThePointerIsPicked) {
  const Vec2f at = model.beds[0].layout.camera.toPixel(frame.position[321]);
  const auto picks = of<PanelAction::Pick>(click(at));
  ASSERT_EQ(picks.size(), 1u);
  EXPECT_EQ(picks[0].particle, (PickedParticle{0, frame.id[321]}));
  const auto none = of<PanelAction::Pick>(click(model.beds[0].layout.camera.toPixel(Vec2{0.5, 2.0})));
  ASSERT_EQ(none.size(), 1u);
  EXPECT_FALSE(none[0].particle) << "beside all of them";
}

TEST_F(PanelTest, LineOfTheSamplingCellsFollowsThePointer) {
  model.style.layers.add(Layer::sampling);
  const Camera& camera = model.beds[0].layout.camera;
  const int columns = model.grid.columns;
  const Vec2f line =
      camera.toPixel(Vec2{scene.bed.width / columns, 0.52 * scene.bed.height / model.grid.rows});
  send({pointer(line, 0)});
  EXPECT_EQ(panel.cursor(), "ew-resize");
  send({pointer(line, 1)});
  const Vec2f halfway = camera.toPixel(Vec2{0.5 * scene.bed.width / columns, 0.0});
  const auto cells = of<PanelAction::Resample>(send({pointer({halfway.x, line.y}, 1)}));
  ASSERT_FALSE(cells.empty());
  EXPECT_EQ(cells.back().columns, 2 * columns);
  EXPECT_EQ(cells.back().rows, model.grid.rows);
  EXPECT_TRUE(of<PanelAction::Pick>(send({pointer({halfway.x, line.y}, 0)})).empty());
}

TEST_F(PanelTest, LayersThatCannotBeShownCannotBeChosen) {
  const auto chosen = of<PanelAction::Restyle>(click(placeOf("velocity")));
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_TRUE(chosen[0].style.layers.has(Layer::velocity));
  EXPECT_TRUE(chosen[0].style.layers.has(Layer::particles));
  model.missing[static_cast<std::size_t>(Layer::velocity)] = "for a reason";
  EXPECT_TRUE(of<PanelAction::Restyle>(click(placeOf("velocity"))).empty());
}

TEST_F(PanelTest, OnlyOneFieldColoursTheGas) {
  model.style.layers.add(Layer::pressure);
  const auto chosen = of<PanelAction::Restyle>(click(placeOf("voidage")));
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_TRUE(chosen[0].style.layers.has(Layer::voidage));
  EXPECT_FALSE(chosen[0].style.layers.has(Layer::pressure));
}

TEST_F(PanelTest, SameInputGivesTheSameMesh) {
  ControlPanel other(size, 1.0f);
  for (int i = 0; i < 3; ++i) other.update(model, {}, 0.03);
  const std::vector<InputEvent> input{pointer(placeOf("play"), 0), pointer(placeOf("play"), 1)};
  panel.update(model, input, 0.03);
  other.update(model, input, 0.03);
  const UiMesh &a = panel.mesh(), &b = other.mesh();
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  EXPECT_GT(a.vertices.size(), 100u);
  for (std::size_t i = 0; i < a.vertices.size(); ++i) EXPECT_EQ(a.vertices[i].at, b.vertices[i].at);
  EXPECT_EQ(a.indices, b.indices);
}

TEST_F(PanelTest, IsBelowTheBedOnAPhoneAndScrollsByFinger) {
  panel = ControlPanel({1170, 2532}, 3.0f);
  place();
  settle();
  EXPECT_GT(panel.panelPart().top, 1000.0f);
  EXPECT_EQ(panel.bedPart().right, 1170.0f);
  const Box before = panel.item("Picture").value();
  // Beside the buttons, where there is nothing to press.
  const Vec2f from{1120.0f, placeOf("play").y};
  send({pointer(from, 0, true)});
  send({pointer(from, 1, true)});
  for (int k = 1; k <= 5; ++k) send({pointer({from.x, from.y - 60.0f * static_cast<float>(k)}, 1, true)});
  send({pointer({from.x, from.y - 300.0f}, 0, true)});
  settle();
  EXPECT_NEAR(panel.item("Picture").value().top, before.top - 300.0f, 2.0f);
}

/// Whatever a hand or a hostile page does, what is asked for makes sense.
TEST_F(PanelTest, RandomInputIsSafe) {
  model.style.layers.add(Layer::sampling);
  model.picked = PickedParticle{0, 7};
  model.parameters.push_back({sceneValues(scene).front(), ""});
  std::uint32_t state = 1;
  const auto random = [&](std::uint32_t n) {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) % n;
  };
  std::vector<InputEvent> events;
  for (int i = 0; i < 20000; ++i) {
    InputEvent event;
    event.kind = static_cast<InputEvent::Kind>(random(6));
    event.at = {static_cast<float>(random(1400)) - 60.0f, static_cast<float>(random(800)) - 40.0f};
    event.buttons = random(8);
    event.isTouch = random(4) == 0;
    event.turn = {0.0f, static_cast<float>(random(200)) - 100.0f};
    event.key = static_cast<PanelKey>(random(panelKeyNames.size()));
    event.isDown = random(2) == 0;
    event.text = random(2) == 0 ? "-1e9" : "\xf0\x9f\x98\x80";
    events.push_back(event);
    if (random(10) != 0) continue;
    for (const PanelAction& action : send(std::exchange(events, {}))) {
      if (const auto* cells = std::get_if<PanelAction::Resample>(&action.what)) {
        EXPECT_GE(cells->columns, 1);
        EXPECT_GE(cells->rows, 1);
        EXPECT_GE(cells->minParticles, 1);
      }
      if (const auto* speed = std::get_if<PanelAction::Speed>(&action.what)) {
        EXPECT_GE(speed->speed, 0.0);
      }
    }
  }
}

TEST_F(PanelTest, RefusedInputOfNoKeyIsSafe) {
  EXPECT_TRUE(send({{.kind = InputEvent::Kind::leave}, {.kind = InputEvent::Kind::text, .text = "\xc3\xa4"}})
                  .empty());
  EXPECT_FALSE(panel.wantsKeyboard());
}

}  // namespace
}  // namespace bedmix
