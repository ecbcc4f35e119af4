// SPDX-License-Identifier: MIT
#include "render/surface.h"

#include "render/colors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bedmix {
namespace {

constexpr Size size{640, 400};
constexpr Rgba green{0, 160, 60, 255};

Image drawn(const DrawList& list) {
  Result<Surface> surface = Surface::create(0);
  EXPECT_TRUE(surface);
  Image image;
  image.resize(size);
  surface->begin(image, white);
  surface->draw(list);
  surface->end();
  return image;
}

DrawList discs(std::vector<Disc> all) {
  DrawList list;
  list.clip = {0.0f, 0.0f, static_cast<float>(size.width), static_cast<float>(size.height)};
  list.discs = std::move(all);
  return list;
}

/// By how much a pixel of this colour covers white at most differs from the formula, of 255: the part of a
/// pixel that is covered is half a pixel plus what its middle is inside the edge.
int worstError(const Image& image, const Disc& disc) {
  int worst = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const float dx = static_cast<float>(x) + 0.5f - disc.at.x,
                  dy = static_cast<float>(y) + 0.5f - disc.at.y;
      const float cover = std::clamp(disc.radius + 0.5f - std::hypot(dx, dy), 0.0f, 1.0f);
      const Rgba got = image.at(x, y);
      const auto error = [&](std::uint8_t channel, std::uint8_t full) {
        return std::abs(static_cast<int>(channel) -
                        static_cast<int>(std::lround(255.0f + cover * (static_cast<float>(full) - 255.0f))));
      };
      worst = std::max({worst, error(got.r, disc.color.r), error(got.g, disc.color.g),
                        error(got.b, disc.color.b), 255 - got.a});
    }
  return worst;
}

// Small ones inside are points of OpenGL, the others two triangles: nobody may see which.
TEST(Surface, DrawsDiscsOfAnySizeAnywhereAlike) {
  for (const Disc& disc : {Disc{{100.3f, 80.7f}, 2.6f, green}, Disc{{100.0f, 80.5f}, 0.4f, green},
                           Disc{{320.2f, 200.1f}, 125.0f, green}, Disc{{320.2f, 200.1f}, 126.9f, green},
                           Disc{{320.2f, 200.1f}, 180.0f, green}, Disc{{0.4f, 399.5f}, 9.3f, green},
                           Disc{{-3.0f, 200.0f}, 9.0f, green}, Disc{{643.0f, 403.0f}, 9.0f, green},
                           Disc{{1.0f, 1.0f}, 40.0f, green}, Disc{{-100.0f, 200.0f}, 160.0f, green}})
    EXPECT_LE(worstError(drawn(discs({disc})), disc), 1)
        << disc.at.x << ' ' << disc.at.y << ' ' << disc.radius;
}

TEST(Surface, KeepsTheOrderOfDiscsOfAllSizes) {
  const Rgba red{200, 0, 0, 255};
  const Image image = drawn(discs({{{320.0f, 200.0f}, 150.0f, green},
                                   {{320.0f, 200.0f}, 20.0f, red},
                                   {{300.0f, 200.0f}, 150.0f, green},
                                   {{200.0f, 200.0f}, 20.0f, red}}));
  EXPECT_EQ(image.at(320, 200), green);
  EXPECT_EQ(image.at(200, 200), red);
}

TEST(Surface, ClipsDiscsAtThePixel) {
  DrawList list = discs({{{320.0f, 200.0f}, 12.0f, green}});
  list.clip = {318.0f, 0.0f, 640.0f, 202.0f};
  const Image image = drawn(list);
  EXPECT_EQ(image.at(318, 201), green);
  EXPECT_EQ(image.at(317, 201), white);
  EXPECT_EQ(image.at(318, 202), white);
}

TEST(Surface, LaysTranslucentColoursOverEachOther) {
  DrawList list = discs({});
  const Rgba half{255, 0, 0, 128};
  list.triangles.push_back({{0.0f, 0.0f}, {640.0f, 0.0f}, {0.0f, 400.0f}, half});
  const Rgba once = drawn(list).at(10, 10);
  EXPECT_EQ(once.r, 255);
  EXPECT_NEAR(once.g, 127, 1);
  EXPECT_EQ(once.a, 255);
  list.triangles.push_back(list.triangles.front());
  EXPECT_NEAR(drawn(list).at(10, 10).g, 63, 1);
}

}  // namespace
}  // namespace bedmix
