// SPDX-License-Identifier: MIT
#include "app/report/html_page.h"

#include "render/part_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

// Readable on a phone (a table scrolls in itself) and on paper (nothing is torn apart).
constexpr std::string_view style = R"(
:root { color-scheme: light; }
body { margin: 0 auto; padding: 1rem; max-width: 46rem; background: #fff; color: #1a1a1a;
  font: 1rem/1.5 system-ui, "DejaVu Sans", Arial, sans-serif; overflow-wrap: break-word; }
h1 { font-size: 1.6rem; line-height: 1.25; margin: .5rem 0 1rem; }
h2 { font-size: 1.25rem; margin: 2.5rem 0 .75rem; border-bottom: 1px solid #ccc; padding-bottom: .25rem; }
h3 { font-size: 1rem; margin: 1.5rem 0 .5rem; }
p { max-width: 42rem; }
figure { margin: 1rem 0 1.5rem; }
figure img, figure video { display: block; max-width: 100%; height: auto; }
.wide { overflow-x: auto; }
.wide img { width: 100%; min-width: 36rem; max-width: none; }
figcaption { font-size: .875rem; color: #444; margin-top: .5rem; max-width: 42rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .9375rem; margin: .5rem 0 1rem; }
th, td { text-align: left; vertical-align: top; padding: .25rem .9rem .25rem 0; border-bottom: 1px solid #ddd; }
th { font-weight: 600; }
tbody th { font-weight: 400; color: #444; }
pre { white-space: pre-wrap; background: #f6f6f6; padding: .75rem; font: .8125rem/1.45 "DejaVu Sans Mono",
  Menlo, Consolas, monospace; }
@media print {
  body { max-width: none; padding: 0; font-size: 10pt; }
  h2, h3 { break-after: avoid; }
  .wide img { min-width: 0; }
  figure, tr { break-inside: avoid; }
  .screen { display: none; }
}
)";

constexpr double widest = 150.0;  // mm, of a picture that a phone may shrink; a wider one scrolls in itself

Result<std::string> bytesOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad())
    return Diagnostic{{path.string()}, std::string("cannot be read: ") + std::strerror(errno), Trouble::file};
  return bytes;
}

}  // namespace

std::string htmlText(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        // Control characters have no place in a page, not even escaped.
        result += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c;
    }
  }
  return result;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

HtmlPage::HtmlPage(std::string_view title) : title_(htmlText(title)) {
  body_ = fmt::format("<h1>{}</h1>\n", title_);
}

void HtmlPage::heading(std::string_view text) { heading_ = fmt::format("<h2>{}</h2>\n", htmlText(text)); }
void HtmlPage::subheading(std::string_view text) { add(fmt::format("<h3>{}</h3>\n", htmlText(text))); }
void HtmlPage::paragraph(std::string_view text) { add(fmt::format("<p>{}</p>\n", htmlText(text))); }
void HtmlPage::verbatim(std::string_view text) { add(fmt::format("<pre>{}</pre>\n", htmlText(text))); }

void HtmlPage::add(std::string_view html) {
  body_ += std::exchange(heading_, {});
  body_ += html;
}

void HtmlPage::table(const std::vector<std::string>& head,
                     const std::vector<std::vector<std::string>>& rows) {
  if (rows.empty()) return;
  add("<div class=\"scroll\"><table>\n<thead><tr>");
  for (const std::string& cell : head) body_ += fmt::format("<th scope=\"col\">{}</th>", htmlText(cell));
  body_ += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows) {
    body_ += fmt::format("<tr><th scope=\"row\">{}</th>", htmlText(row.front()));
    for (std::size_t i = 1; i < row.size(); ++i) body_ += fmt::format("<td>{}</td>", htmlText(row[i]));
    body_ += "</tr>\n";
  }
  body_ += "</tbody>\n</table></div>\n";
}

Result<Done> HtmlPage::figure(const fs::path& file, std::string_view before, std::string_view after,
                              std::string_view caption) {
  const auto bytes = bytesOf(file);
  if (!bytes) return bytes.problems;
  add(before);
  body_ += base64(*bytes);
  body_ += after;
  body_ += fmt::format("\n<figcaption>{}</figcaption></figure>\n", htmlText(caption));
  return Done{};
}

Result<Done> HtmlPage::picture(const fs::path& png, double width, std::string_view alt,
                               std::string_view caption) {
  const bool wide = width > widest;
  const std::string size = wide ? "" : fmt::format(" style=\"width: {:.0f}mm\"", width);
  return figure(png,
                fmt::format("<figure{}><img src=\"data:image/png;base64,", wide ? " class=\"wide\"" : ""),
                fmt::format("\" alt=\"{}\"{} />", htmlText(alt), size), caption);
}

Result<Done> HtmlPage::film(const fs::path& mp4, std::string_view alt, std::string_view caption) {
  return figure(mp4,
                "<figure><video class=\"screen\" controls=\"controls\" loop=\"loop\" "
                "playsinline=\"playsinline\" src=\"data:video/mp4;base64,",
                fmt::format("\" aria-label=\"{}\"></video>", htmlText(alt)), caption);
}

Result<Done> HtmlPage::write(const fs::path& path) const {
  PartFile part(path);
  std::ofstream file(part.path(), std::ios::binary);
  file << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\" />\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" />\n<title>"
       << title_ << "</title>\n<style>" << style << "</style>\n</head>\n<body>\n"
       << body_ << "</body>\n</html>\n";
  file.close();
  if (file.fail()) return part.failure(std::strerror(errno));
  return part.keep();
}

}  // namespace bedmix
