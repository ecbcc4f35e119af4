// SPDX-License-Identifier: MIT
#include "replay/foreign/lammps_index.h"

#include "replay/foreign/line_reader.h"
#include "replay/foreign/word_reader.h"

#include <fmt/format.h>

#include <utility>

namespace bedmix {

namespace {

template <class T>
T number(WordReader& words) {
  words.findInLine();
  return words.number<T>();
}

template <class T>
T onlyNumber(std::string_view line, const SourceLocation& at) {
  WordReader words(line, at);
  const T value = number<T>(words);
  words.endLine();
  return value;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t\r");
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

class Indexer {
 public:
  explicit Indexer(const std::filesystem::path& path) : path_(path), lines_(path) {}

  LammpsIndex run() {
    while (readItem()) {
    }
    return std::move(index_);
  }

 private:
  /// False where the file ends in it.
  bool readItem() {
    std::string head;
    if (cutBy_) {
      head = *std::exchange(cutBy_, std::nullopt);
    } else if (const auto line = lines_.next()) {
      head = trimmed(*line);
    } else {
      return false;
    }
    constexpr std::string_view mark = "ITEM: ";
    if (!head.starts_with(mark)) refuseHead(head);
    const std::string_view item = std::string_view(head).substr(mark.size());

    if (item.starts_with("ATOMS")) return readParticles(item.substr(5));
    if (item.starts_with("BOX BOUNDS")) return readBox(item.substr(10));
    const SourceLocation at = lines_.at();
    const auto value = lines_.next();
    if (!value) return false;
    if (item == "TIMESTEP") {
      step_ = onlyNumber<std::int64_t>(*value, lines_.at());
    } else if (item == "NUMBER OF ATOMS") {
      particles_ = onlyNumber<std::uint32_t>(*value, lines_.at());
    } else if (item == "TIME") {
      time_ = onlyNumber<double>(*value, lines_.at());
    } else if (item == "UNITS") {
      if (trimmed(*value) != "si")
        throw ForeignError(lines_.at(), fmt::format("units are '{}'; only si is read", trimmed(*value)));
    } else if (item != "LABEL") {
      throw ForeignError(at,
                         fmt::format("'{}' is not known; what is read are dumps of particles, of the styles "
                                     "custom and atom",
                                     item));
    }
    return true;
  }

  bool readBox(std::string_view kind) {
    WordReader words(kind, lines_.at());
    if (words.findInLine() && (words.rest().starts_with("xy") || words.rest().starts_with("abc")))
      throw ForeignError(lines_.at(), "the box is triclinic; only orthogonal ones are read");
    box_.emplace();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto line = lines_.next();
      if (!line) return false;
      WordReader bounds(*line, lines_.at());
      box_->low[axis] = number<double>(bounds);
      box_->high[axis] = number<double>(bounds);
      bounds.endLine();
    }
    return true;
  }

  bool readParticles(std::string_view columns) {
    if (!step_ || !particles_ || !box_)
      throw ForeignError(lines_.at(),
                         "particles without a step, their number and a box; the file is damaged");
    if (unfinished_ && *step_ > unfinished_->first) throw unfinished_->second;
    unfinished_.reset();
    if (index_.columns.empty()) {
      index_.columns = columns;
      index_.columnsAt = lines_.at();
    } else if (index_.columns != columns) {
      throw ForeignError(lines_.at(),
                         "the columns are others than in the snapshot before; "
                         "split the file here and read one of the parts");
    }
    LammpsSnapshot now{*step_, time_, *box_, *particles_, 0, lines_.line() + 1, lines_.offset(), 0};
    for (std::size_t row = 0; row < now.particles; ++row) {
      const auto line = lines_.next();
      if (!line) return false;
      if (!line->starts_with("ITEM:")) continue;
      cutBy_ = trimmed(*line);
      unfinished_.emplace(
          now.step, ForeignError(lines_.at(), fmt::format("step {} has {} of its {} particles", now.step, row,
                                                          now.particles)));
      break;
    }
    now.size = static_cast<std::size_t>(lines_.offset() - now.offset);
    if (!unfinished_) index_.snapshots.push_back(now);
    step_.reset();
    time_.reset();
    particles_.reset();
    box_.reset();
    return true;
  }

  [[noreturn]] void refuseHead(std::string_view head) const {
    if (lines_.line() == 1)
      throw ForeignError(path_, "is no text dump of LAMMPS or LIGGGHTS: it does not begin with ITEM:");
    throw ForeignError(lines_.at(), fmt::format("'{}' stands where an ITEM: should; the file is damaged",
                                                head.substr(0, 40)));
  }

  std::filesystem::path path_;
  LineReader lines_;
  LammpsIndex index_;

  // What the items of the snapshot at hand have said so far.
  std::optional<std::int64_t> step_;
  std::optional<double> time_;
  std::optional<std::size_t> particles_;
  std::optional<ForeignBox> box_;

  // A snapshot in whose midst another begins, as after a run that was killed and resumed: its step, what is
  // wrong where no later one rewrites it, and the line that cuts it off.
  std::optional<std::pair<std::int64_t, ForeignError>> unfinished_;
  std::optional<std::string> cutBy_;
};

}  // namespace

LammpsIndex indexLammpsDump(const std::filesystem::path& path) { return Indexer(path).run(); }

}  // namespace bedmix
