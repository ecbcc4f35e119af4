// SPDX-License-Identifier: MIT
#include "render/picture_workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <set>
#include <vector>

namespace bedmix {
namespace {

Image& numbered(PictureWorkers& workers, int number) {
  Image& image = workers.next();
  image.resize({1, 1});
  image.rgba[0] = static_cast<std::uint8_t>(number);
  return image;
}

TEST(PictureWorkers, OneThreadTakesThemInOrder) {
  PictureWorkers workers(1);
  std::vector<int> seen;
  for (int i = 0; i < 100; ++i) {
    numbered(workers, i);
    workers.submit(
        [&seen](const Image& picture) -> Result<Done> {
          seen.push_back(picture.rgba[0]);
          return Done{};
        },
        i % 3);
  }
  ASSERT_TRUE(workers.finish());
  std::vector<int> expected;
  for (int i = 0; i < 100; ++i) expected.insert(expected.end(), static_cast<std::size_t>(i % 3), i);
  EXPECT_EQ(seen, expected);
}

TEST(PictureWorkers, SeveralThreadsTakeEachOnce) {
  PictureWorkers workers(4);
  std::vector<std::atomic<int>> seen(200);
  for (int i = 0; i < 200; ++i) {
    numbered(workers, i);
    workers.submit([&seen](const Image& picture) -> Result<Done> {
      ++seen[picture.rgba[0]];
      return Done{};
    });
  }
  ASSERT_TRUE(workers.finish());
  for (const auto& times : seen) EXPECT_EQ(times, 1);
}

TEST(PictureWorkers, AFewImagesGoRound) {
  PictureWorkers workers(2);
  std::set<const Image*> images;
  for (int i = 0; i < 100; ++i) {
    images.insert(&numbered(workers, i));
    EXPECT_EQ(&workers.next(), &workers.next());
    workers.submit([](const Image&) -> Result<Done> { return Done{}; });
  }
  ASSERT_TRUE(workers.finish());
  EXPECT_LE(images.size(), 4u);
}

TEST(PictureWorkers, TheEarliestFailureIsKept) {
  PictureWorkers workers(2);
  std::mutex mutex;
  std::condition_variable changed;
  bool secondFailed = false;
  numbered(workers, 0);
  workers.submit([&](const Image&) -> Result<Done> {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return secondFailed; });
    return Diagnostic{{"0"}, "first", Trouble::file};
  });
  numbered(workers, 1);
  workers.submit([&](const Image&) -> Result<Done> {
    const std::lock_guard lock(mutex);
    secondFailed = true;
    changed.notify_all();
    return Diagnostic{{"1"}, "second", Trouble::file};
  });
  const Result<Done> done = workers.finish();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.problems[0].message, "first");
  EXPECT_TRUE(workers.failed());
}

TEST(PictureWorkers, NothingIsDoneAfterAFailure) {
  PictureWorkers workers(1);
  int done = 0;
  for (int i = 0; i < 50; ++i) {
    numbered(workers, i);
    workers.submit(
        [&done](const Image& picture) -> Result<Done> {
          ++done;
          if (picture.rgba[0] == 10) return Diagnostic{{}, "full", Trouble::file};
          return Done{};
        },
        2);
  }
  EXPECT_FALSE(workers.finish());
  EXPECT_EQ(done, 21);
}

}  // namespace
}  // namespace bedmix
