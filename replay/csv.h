// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bedmix {

/// Columns of numbers under names. A gap, where a value is undefined, is empty.
struct Table {
  using Column = std::vector<std::optional<double>>;
  std::vector<std::string> names;
  std::vector<Column> columns;  // all of one length

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
  /// The column of that name; null where there is none.
  const Column* find(std::string_view name) const;
  /// Adds a row, of as many values as there are columns.
  void append(std::span<const std::optional<double>> row);
  void append(std::initializer_list<std::optional<double>> row) {
    append(std::span(row.begin(), row.size()));
  }
};

/// Mean of what is defined in a column; empty where nothing is.
std::optional<double> meanOf(const Table::Column& column);

/// Reads a table of numbers: a header, commas, an empty field for a gap. Fails, with line and column, on text
/// that is no number and on rows that are longer or shorter than the header. A last line without its end, as
/// a killed run leaves it, is not counted.
Result<Table> readCsv(const std::filesystem::path& path);

/// Writes such a table row by row: shortest decimals that read back to the same double, one write a row, so
/// that nothing but the row in hand can be lost.
class CsvWriter {
 public:
  /// Makes the file anew and writes the header.
  static Result<CsvWriter> create(const std::filesystem::path& path, std::string_view header);

  std::optional<Diagnostic> row(std::span<const std::optional<double>> values);
  std::optional<Diagnostic> row(std::initializer_list<std::optional<double>> values) {
    return row(std::span(values.begin(), values.size()));
  }

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  CsvWriter(std::filesystem::path path, std::FILE* file) : path_(std::move(path)), file_(file) {}
  std::optional<Diagnostic> line(const std::string& text);

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Closer> file_;
};

/// Writes a whole table in that form.
std::optional<Diagnostic> writeCsv(const std::filesystem::path& path, const Table& table);

}  // namespace bedmix
