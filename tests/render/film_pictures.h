// SPDX-License-Identifier: MIT
#pragma once

#include "render/colors.h"
#include "render/picture_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace bedmix::test {

/// Left half black, right half green; the upper half is white from picture to picture in turn.
inline Image halves(Size size, int number) {
  Image image;
  image.resize(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const Rgba color = y < size.height / 2 && number % 2 ? white
                         : x < size.width / 2              ? tracerColor
                                                           : restColor;
      std::copy_n(&color.r, 4, &image.rgba[4 * (static_cast<std::size_t>(y) * size.width + x)]);
    }
  return image;
}

/// Makes a film of so many of them.
template <class Film>
void filmHalves(Result<Film> film, Size size, int pictures) {
  ASSERT_TRUE(film) << film.problems[0].message;
  for (int i = 0; i < pictures; ++i) ASSERT_TRUE(film->add(halves(size, i)));
  ASSERT_TRUE(film->finish());
}

inline void expectNear(Rgba actual, Rgba expected) {
  EXPECT_NEAR(actual.r, expected.r, 3);
  EXPECT_NEAR(actual.g, expected.g, 3);
  EXPECT_NEAR(actual.b, expected.b, 3);
}

}  // namespace bedmix::test
