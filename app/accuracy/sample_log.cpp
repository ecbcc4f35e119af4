// SPDX-License-Identifier: MIT
#include "app/accuracy/sample_log.h"

#include "replay/file_trouble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

namespace bedmix {

namespace {

constexpr std::string_view keyColumns = "version,scene,panel,setting,reference,sample,failure";
constexpr std::size_t keys = 7;

std::string header() {
  std::string text(keyColumns);
  for (const Measure& m : measures) text += fmt::format(",{}", m.name);
  return text + '\n';
}

std::string field(std::string_view text) {
  if (text.find_first_of(",\"\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : c == '\n' ? " " : std::string(1, c);
  return quoted + '"';
}

std::vector<std::string> fields(std::string_view line) {
  std::vector<std::string> list(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      const bool inside = quoted && i + 1 < line.size() && line[i + 1] == '"';
      if (inside)
        list.back() += line[++i];
      else
        quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      list.emplace_back();
    } else {
      list.back() += line[i];
    }
  }
  return list;
}

template <class T>
std::optional<T> number(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Sample> sampleOf(const std::vector<std::string>& row) {
  const auto panel = std::find(panelNames.begin(), panelNames.end(), row[2]);
  const auto index = number<int>(row[5]);
  if (panel == panelNames.end() || !index) return std::nullopt;
  Sample sample{{static_cast<Panel>(panel - panelNames.begin()), row[3], row[4], *index}, row[6], {}};
  for (std::size_t m = 0; m < measures.size(); ++m) {
    const std::string& text = row[keys + m];
    if (text.empty()) continue;
    const auto value = number<double>(text);
    if (!value) return std::nullopt;
    sample.values[measures[m].name] = *value;
  }
  return sample;
}

std::string systemReason() { return std::strerror(errno); }

}  // namespace

Result<SampleLog> SampleLog::open(const std::filesystem::path& path, std::string version, std::string scene,
                                  bool resume) {
  SampleLog log;
  log.path_ = path;
  log.version_ = std::move(version);
  log.scene_ = std::move(scene);
  std::string whole = header();
  if (resume) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
      return fileTrouble(path, "cannot be read: " + systemReason() + "; leave out --resume to begin anew");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!text.starts_with(whole))
      return fileTrouble(path, "has another header than this version's; leave out --resume to begin anew");
    std::string_view rest(text);
    rest.remove_prefix(whole.size());
    int line = 1;
    for (std::size_t end; (end = rest.find('\n')) != std::string_view::npos; rest.remove_prefix(end + 1)) {
      const std::vector<std::string> row = fields(rest.substr(0, end));
      ++line;
      std::optional<Sample> sample;
      if (row.size() == keys + measures.size()) sample = sampleOf(row);
      if (!sample)
        return Diagnostic{{path.string(), line, 1}, "is no sample; remove the line", Trouble::file};
      whole += std::string(rest.substr(0, end + 1));
      if (row[0] == log.version_ && row[1] == log.scene_) log.samples_.push_back(std::move(*sample));
    }
  }
  std::error_code error;
  if (resume) std::filesystem::resize_file(path, whole.size(), error);
  if (error) return fileTrouble(path, "cannot be written: " + error.message());
  log.file_.reset(std::fopen(path.c_str(), resume ? "ab" : "wb"));
  if (!log.file_) return fileTrouble(path, "cannot be written: " + systemReason());
  if (resume) return log;
  if (auto problem = log.write(whole)) return *problem;
  return log;
}

std::optional<Diagnostic> SampleLog::add(Sample sample) {
  std::string text = fmt::format(
      "{},{},{},{},{},{},{}", field(version_), scene_, panelNames[static_cast<std::size_t>(sample.key.panel)],
      field(sample.key.setting), field(sample.key.reference), sample.key.index, field(sample.failure));
  for (const Measure& m : measures) {
    text += ',';
    if (const auto at = sample.values.find(m.name); at != sample.values.end())
      fmt::format_to(std::back_inserter(text), "{}", at->second);
  }
  samples_.push_back(std::move(sample));
  return write(text + '\n');
}

std::optional<Diagnostic> SampleLog::write(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size() && std::fflush(file_.get()) == 0)
    return std::nullopt;
  return fileTrouble(
      path_, "cannot be written: " + systemReason() + "; what stands in it is whole up to its last line");
}

}  // namespace bedmix
