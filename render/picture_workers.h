// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/image.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace bedmix {

/// Threads that make something of pictures while the next ones are drawn. A fixed number of images goes round
/// between them and the one who draws, so pictures are never copied and memory is bounded. One thread takes
/// the pictures in order. A failure is kept for finish(), and later pictures are dropped.
class PictureWorkers {
 public:
  /// What a thread does with a picture.
  using Work = std::function<Result<Done>(const Image&)>;

  explicit PictureWorkers(int threads);
  ~PictureWorkers();  // drops what has not begun
  PictureWorkers(PictureWorkers&&) noexcept;
  PictureWorkers& operator=(PictureWorkers&&) noexcept;

  /// An image to draw into, of any size and content; waits until one is free. The same one until submit().
  Image& next();
  /// Hands it over, to be worked on `times` times.
  void submit(Work work, std::int64_t times = 1);
  /// Whether something has failed, and going on is in vain.
  bool failed() const;
  /// Waits until all is done; what failed, of the earliest picture.
  Result<Done> finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
