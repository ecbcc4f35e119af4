// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/view_model.h"
#include "engine/core/diagnostic.h"
#include "render/painter.h"
#include "render/panel/input_event.h"
#include "render/panel/panel.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bedmix {

/// What a person has saved.
struct SavedFile {
  std::string name;  // in the session's folder
  std::filesystem::path path;
};

struct SessionOptions {
  Size size{1280, 720};
  float scale = 1.0f;  // px of the picture per px that texts are laid out in
  Style style;
  std::filesystem::path folder;  // of what is saved; made when it is needed
  int threads = 1;               // of the rasterizer
};

/// Model, panel and painter: what the screen shows, from input to pixels. Knows no browser and no clock, so
/// that a script and a test can do what a person does. Used by one thread.
class ViewSession {
 public:
  static Result<ViewSession> create(std::unique_ptr<ViewModel> model, const SessionOptions& options);
  ~ViewSession();
  ViewSession(ViewSession&&) noexcept;
  ViewSession& operator=(ViewSession&&) noexcept;

  /// Takes input in its order and lets `seconds` go by; draws into `image`, of the present size, where there
  /// is something new to see, and says whether it did.
  bool draw(std::span<const InputEvent> events, double seconds, Image& image);

  ViewModel& model();
  const ControlPanel& panel() const;
  Size size() const;
  std::string_view cursor() const;
  bool wantsKeyboard() const;
  /// What has been saved since this was asked last.
  std::vector<SavedFile> takeSaved();

 private:
  struct State;
  explicit ViewSession(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
