// SPDX-License-Identifier: MIT
#pragma once

#include "render/movie.h"

#include <memory>

namespace bedmix {

/// Encodes a movie in a thread of its own. A few pictures wait at most; add() then waits too. A failure is
/// kept for finish(), and later pictures are dropped.
class EncodingThread {
 public:
  explicit EncodingThread(Movie movie);
  ~EncodingThread();  // ends the thread; without finish() no film is left
  EncodingThread(EncodingThread&&) noexcept;
  EncodingThread& operator=(EncodingThread&&) noexcept;

  void add(const Image& picture);
  /// Whether encoding has failed, and adding is in vain.
  bool failed() const;
  Result<Done> finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
