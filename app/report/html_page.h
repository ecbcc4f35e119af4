// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bedmix {

/// A web page that is one file: pictures and films stand inside it, nothing is fetched, no script runs. Texts
/// are taken literally.
class HtmlPage {
 public:
  explicit HtmlPage(std::string_view title);

  /// Left out where nothing follows before the next one.
  void heading(std::string_view text);
  void subheading(std::string_view text);
  void paragraph(std::string_view text);
  /// Rows of one length with the head; the first column names the row. Nothing without rows.
  void table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows);
  /// Text as it was typed, long lines broken.
  void verbatim(std::string_view text);
  /// A PNG, `width` mm wide where there is room. `alt` says in words what it shows, `caption` stands below
  /// it.
  Result<Done> picture(const std::filesystem::path& png, double width, std::string_view alt,
                       std::string_view caption);
  /// An MP4 with controls.
  Result<Done> film(const std::filesystem::path& mp4, std::string_view alt, std::string_view caption);

  /// The page; it appears whole or not at all.
  Result<Done> write(const std::filesystem::path& path) const;

 private:
  void add(std::string_view html);
  Result<Done> figure(const std::filesystem::path& file, std::string_view before, std::string_view after,
                      std::string_view caption);

  std::string title_, body_, heading_;
};

/// As text in HTML, quotes included.
std::string htmlText(std::string_view text);
/// Of bytes, as data URIs want it.
std::string base64(std::string_view bytes);

}  // namespace bedmix
