// SPDX-License-Identifier: MIT
#include "app/view/picture_stream.h"
#include "app/view/stream_client.h"
#include "app/view/stream_message.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>

namespace bedmix {
namespace {

using namespace std::chrono_literals;

Scene emptyBed() {
  Scene scene;
  scene.particles.count = 1;
  return scene;
}

/// One particle that moves when it is told to.
class StillModel final : public ViewModel {
 public:
  StillModel() {
    auto frame = std::make_shared<Frame>();
    frame->position = {{0.05f, 0.05f}};
    frame->velocity = {{}};
    frame->species = {1};
    frame->id = {0};
    beds_.push_back({std::make_shared<const Scene>(emptyBed()), "", frame, {}});
  }
  void refresh(double) override { version_ += isRestless ? 1 : 0; }
  void act(const PanelAction&) override {}
  void describe(PanelModel&) const override {}
  const std::vector<ViewBed>& beds() const override { return beds_; }
  std::uint64_t version() const override { return version_; }
  std::string farewell() const override { return "goodbye"; }

  static inline std::atomic<bool> isRestless = false;

 private:
  std::vector<ViewBed> beds_;
  std::uint64_t version_ = 1;
};

/// Keeps what it is to send.
class KeptOutput final : public StreamOutput {
 public:
  void send(ClientId client, SharedBytes message) override {
    const std::lock_guard lock(mutex_);
    sent_[client].push_back(std::move(message));
    changed_.notify_all();
  }
  void publish(const std::string&, const std::string&, SharedBytes) override {}

  /// The n-th picture for a client, from 0; null where none comes in time.
  SharedBytes picture(ClientId client, std::size_t n, std::chrono::milliseconds patience = 20s) {
    std::unique_lock lock(mutex_);
    const auto pictures = [&] {
      std::vector<SharedBytes> all;
      for (const SharedBytes& message : sent_[client])
        if (kindOf(message) != StreamKind::notice) all.push_back(message);
      return all;
    };
    changed_.wait_for(lock, patience, [&] { return pictures().size() > n; });
    const auto all = pictures();
    return all.size() > n ? all[n] : nullptr;
  }
  static StreamKind kindOf(const SharedBytes& message) { return static_cast<StreamKind>((*message)[0]); }
  static bool isSharp(const SharedBytes& message) { return (*message)[1] != std::byte{0}; }
  static std::uint32_t numberAt(const SharedBytes& message, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value |= std::to_integer<std::uint32_t>((*message)[at + i]) << (8 * i);
    return value;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<ClientId, std::vector<SharedBytes>> sent_;
};

class PictureStreamTest : public ::testing::Test {
 protected:
  PictureStreamTest() {
    StillModel::isRestless = false;
    const auto begun = stream.begin(
        [] {
          SessionOptions options;
          options.size = {640, 360};
          return ViewSession::create(std::make_unique<StillModel>(), options);
        },
        output);
    EXPECT_TRUE(begun);
  }
  void join(ClientId client, Role role, PictureCodec codec) {
    stream.joined(client, role);
    stream.received(client, Hello{codec});
  }
  void acknowledge(ClientId client, const SharedBytes& picture) {
    stream.received(client, Acknowledgement{KeptOutput::numberAt(picture, 4)});
  }

  KeptOutput output;
  PictureStream stream;
};

TEST_F(PictureStreamTest, NothingIsSentWhereNothingChangesButOneSharpPicture) {
  join(1, Role::controller, PictureCodec::jpeg);
  const SharedBytes first = output.picture(1, 0);
  ASSERT_TRUE(first);
  EXPECT_FALSE(KeptOutput::isSharp(first));
  acknowledge(1, first);
  const SharedBytes sharp = output.picture(1, 1);
  ASSERT_TRUE(sharp);
  EXPECT_TRUE(KeptOutput::isSharp(sharp));
  EXPECT_GT(sharp->size(), first->size());
  acknowledge(1, sharp);
  EXPECT_FALSE(output.picture(1, 2, 600ms));
}

TEST_F(PictureStreamTest, AtMostTwoPicturesAreOnTheirWay) {
  StillModel::isRestless = true;
  join(1, Role::controller, PictureCodec::jpeg);
  ASSERT_TRUE(output.picture(1, 1));
  EXPECT_FALSE(output.picture(1, 2, 400ms));
  acknowledge(1, output.picture(1, 1));
  EXPECT_TRUE(output.picture(1, 3)) << "the second stands for the first, too";
}

TEST_F(PictureStreamTest, SlowClientDelaysNoOther) {
  StillModel::isRestless = true;
  join(1, Role::controller, PictureCodec::jpeg);
  join(2, Role::viewer, PictureCodec::jpeg);
  for (std::size_t n = 0; n < 20; ++n) {
    const SharedBytes picture = output.picture(2, n);
    ASSERT_TRUE(picture) << n;
    acknowledge(2, picture);
  }
  EXPECT_FALSE(output.picture(1, 2, 1ms)) << "it has taken nothing";
}

TEST_F(PictureStreamTest, VideoBeginsWithAKeyForEachClient) {
  StillModel::isRestless = true;
  join(1, Role::controller, PictureCodec::h264);
  const SharedBytes first = output.picture(1, 0);
  ASSERT_TRUE(first);
  EXPECT_EQ(KeptOutput::kindOf(first), StreamKind::h264Key);
  acknowledge(1, first);
  const SharedBytes second = output.picture(1, 1);
  ASSERT_TRUE(second);
  EXPECT_EQ(KeptOutput::kindOf(second), StreamKind::h264Next);
  EXPECT_LT(second->size(), first->size());
  join(2, Role::viewer, PictureCodec::h264);
  EXPECT_EQ(KeptOutput::kindOf(output.picture(2, 0)), StreamKind::h264Key);
}

TEST_F(PictureStreamTest, PictureTellsWhichInputItShows) {
  join(1, Role::controller, PictureCodec::jpeg);
  acknowledge(1, output.picture(1, 0));
  stream.received(1, NumberedInput{7, {.at = {10.0f, 10.0f}}});
  for (std::size_t n = 1; n < 10; ++n) {
    const SharedBytes picture = output.picture(1, n);
    ASSERT_TRUE(picture);
    acknowledge(1, picture);
    if (KeptOutput::numberAt(picture, 8) == 7) return;
  }
  FAIL() << "no picture shows the input";
}

TEST_F(PictureStreamTest, SizeFollowsTheWindow) {
  join(1, Role::controller, PictureCodec::h264);
  acknowledge(1, output.picture(1, 0));
  stream.received(1, NumberedInput{1, {.kind = InputEvent::Kind::size, .size = {801, 601}, .scale = 1.0f}});
  for (std::size_t n = 1; n < 10; ++n) {
    const SharedBytes picture = output.picture(1, n);
    ASSERT_TRUE(picture);
    acknowledge(1, picture);
    if ((KeptOutput::numberAt(picture, 12) & 0xffff) == 801) return;
  }
  FAIL() << "no picture of the new size";
}

TEST_F(PictureStreamTest, EndsWithTheModelsLastWord) { EXPECT_EQ(stream.end(), "goodbye"); }

}  // namespace
}  // namespace bedmix
