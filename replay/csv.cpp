// SPDX-License-Identifier: MIT
#include "replay/csv.h"

#include "replay/file_trouble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

namespace bedmix {

namespace {

std::string systemReason() { return std::strerror(errno); }

std::vector<std::string_view> fields(std::string_view line) {
  std::vector<std::string_view> list;
  for (std::size_t from = 0;;) {
    const std::size_t comma = line.find(',', from);
    list.push_back(line.substr(from, comma - from));
    if (comma == std::string_view::npos) return list;
    from = comma + 1;
  }
}

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Appends one line to the table, or says what is wrong with it.
std::optional<Diagnostic> addRow(Table& table, std::string_view line, const SourceLocation& at) {
  const std::vector<std::string_view> row = fields(line);
  if (row.size() != table.names.size())
    return Diagnostic{at,
                      fmt::format("{} fields where the header has {}; the file is damaged, derive it again "
                                  "with bedmix replay",
                                  row.size(), table.names.size()),
                      Trouble::file};
  for (std::size_t c = 0; c < row.size(); ++c) {
    const std::optional<double> value = number(row[c]);
    if (!value && !row[c].empty())
      return Diagnostic{{at.file, at.line, static_cast<int>(row[c].data() - line.data()) + 1},
                        fmt::format("'{}' is not a number", row[c]),
                        Trouble::file};
    table.columns[c].push_back(value);
  }
  return std::nullopt;
}

}  // namespace

const Table::Column* Table::find(std::string_view name) const {
  const auto at = std::find(names.begin(), names.end(), name);
  return at == names.end() ? nullptr : &columns[static_cast<std::size_t>(at - names.begin())];
}

void Table::append(std::span<const std::optional<double>> row) {
  for (std::size_t c = 0; c < columns.size(); ++c) columns[c].push_back(row[c]);
}

std::optional<double> meanOf(const Table::Column& column) {
  double sum = 0.0;
  std::size_t defined = 0;
  for (const std::optional<double>& value : column)
    if (value) {
      sum += *value;
      ++defined;
    }
  if (defined == 0) return std::nullopt;
  return sum / static_cast<double>(defined);
}

Result<Table> readCsv(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return fileTrouble(path, "cannot be read: " + systemReason());
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) return fileTrouble(path, "cannot be read: " + systemReason());

  Table table;
  SourceLocation at{path.string(), 0, 1};
  std::string_view rest = text;
  for (std::size_t end; (end = rest.find('\n')) != std::string_view::npos; rest.remove_prefix(end + 1)) {
    const std::string_view line = rest.substr(0, end);
    if (++at.line == 1) {
      for (std::string_view name : fields(line)) table.names.emplace_back(name);
      table.columns.resize(table.names.size());
    } else if (auto problem = addRow(table, line, at)) {
      return *problem;
    }
  }
  if (at.line == 0) return fileTrouble(path, "has no header line, so it is not a table of bedmix");
  return table;
}

Result<CsvWriter> CsvWriter::create(const std::filesystem::path& path, std::string_view header) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return fileTrouble(path, "cannot be written: " + systemReason());
  CsvWriter writer(path, file);
  if (auto problem = writer.line(std::string(header) + '\n')) return *problem;
  return writer;
}

std::optional<Diagnostic> CsvWriter::row(std::span<const std::optional<double>> values) {
  std::string text;
  for (const std::optional<double>& value : values) {
    if (value) fmt::format_to(std::back_inserter(text), "{}", *value);
    text += ',';
  }
  text.back() = '\n';
  return line(text);
}

std::optional<Diagnostic> CsvWriter::line(const std::string& text) {
  const bool written =
      std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size() && std::fflush(file_.get()) == 0;
  if (written) return std::nullopt;
  return fileTrouble(
      path_, "cannot be written: " + systemReason() + "; what stands in it is whole up to its last line");
}

std::optional<Diagnostic> writeCsv(const std::filesystem::path& path, const Table& table) {
  Result<CsvWriter> csv = CsvWriter::create(path, fmt::format("{}", fmt::join(table.names, ",")));
  if (!csv) return csv.problems.front();
  std::vector<std::optional<double>> row(table.columns.size());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    for (std::size_t c = 0; c < row.size(); ++c) row[c] = table.columns[c][i];
    if (auto problem = csv->row(row)) return problem;
  }
  return std::nullopt;
}

}  // namespace bedmix
