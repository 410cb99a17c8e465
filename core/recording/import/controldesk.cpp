#include "recording/import/controldesk.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "recording/import/column_name.h"
#include "recording/import/signal_log.h"
#include "recording/import/text_layout.h"

namespace breakaway {

namespace {

constexpr size_t mostCaptureSignals = 5000;

/// What parts the cells, if the text has ControlDesk's line of names near its beginning.
std::optional<char> separatorOf(std::string_view text, char lineEnd) {
  constexpr int searchedLines = 200;
  for (int k = 0; k < searchedLines && !text.empty(); ++k) {
    std::string_view line = withoutBlanks(takeLine(text, lineEnd));
    if (line.starts_with('"')) line.remove_prefix(1);
    if (!line.starts_with("trace_names")) continue;
    line.remove_prefix(std::string_view("trace_names").size());
    if (line.starts_with('"')) line.remove_prefix(1);
    if (!line.empty() && std::string_view(",;\t").find(line.front()) != std::string_view::npos) return line.front();
  }
  return std::nullopt;
}

class Sections {
 public:
  explicit Sections(char separator) { layout_.separator = separator; }

  void take(std::string_view line) {
    if (withoutBlanks(line).empty()) {
      inRows_ = false;
      return;
    }
    layout_.decimalComma = layout_.separator != ',' && line.find(',') != std::string_view::npos;
    splitCells(line, layout_, cells_);
    const std::string_view label = cells_.front();
    if (label == "trace_names") {
      names_ = texts();
      paths_.clear();
      units_.clear();
      inRows_ = false;
    } else if (label == "path") {
      paths_ = texts();
    } else if (label == "unit" || label == "units") {
      units_ = texts();
    } else if (label == "trace_values") {
      beginRows();
      takeRow();
    } else if (inRows_ && label.empty()) {
      takeRow();
    }
  }

  std::vector<Signal> signals;
  std::string timeUnit = "s";

 private:
  std::vector<std::string> texts() const { return {cells_.begin(), cells_.end()}; }

  static std::string at(const std::vector<std::string>& texts, size_t k) {
    return k < texts.size() && texts[k] != "-" ? texts[k] : std::string();
  }

  void beginRows() {
    inRows_ = true;
    first_ = signals.size();
    if (!at(units_, 1).empty()) timeUnit = at(units_, 1);
    for (size_t c = 2; c < names_.size() && signals.size() < mostCaptureSignals; ++c)
      signals.push_back({nameInModel(names_[c], at(paths_, c)), at(units_, c), {}, {}});
  }

  void takeRow() {
    TextNumber number;
    if (cells_.size() < 3 || readCell(cells_[1], layout_, number) != TextCell::number) return;
    const Stamp stamp = number.large ? Stamp{number.whole, number.rest} : Stamp{0, number.value};
    for (size_t c = 2; c < cells_.size() && first_ + c - 2 < signals.size(); ++c) {
      if (readCell(cells_[c], layout_, number) != TextCell::number) continue;
      signals[first_ + c - 2].stamps.push_back(stamp);
      signals[first_ + c - 2].values.push_back(number.value);
    }
  }

  TextLayout layout_;
  std::vector<std::string_view> cells_;
  std::vector<std::string> names_, paths_, units_;
  size_t first_ = 0;  ///< the section's first signal
  bool inRows_ = false;
};

}  // namespace

std::optional<Result<RawTable>> readControlDeskText(std::string_view text, char lineEnd, const std::string& name) {
  const auto separator = separatorOf(text, lineEnd);
  if (!separator) return std::nullopt;
  Sections sections(*separator);
  while (!text.empty()) sections.take(takeLine(text, lineEnd));
  return tableOfSignals(sections.signals, {"time", sections.timeUnit}, message("a ControlDesk recording"), name);
}

std::string nameInModel(std::string_view name, std::string_view path) {
  std::string plain(name), block(path);
  for (std::string* text : {&plain, &block}) std::erase(*text, '"');
  while (!block.empty() && block.back() == '/') block.pop_back();
  if (block.empty() || knowsQuantity(plain)) return plain;
  const size_t slash = block.rfind('/');
  block = slash == std::string::npos ? block : block.substr(slash + 1);
  const bool firstPort = plain == "Out1" || plain == "In1" || plain.empty();
  return firstPort || block == plain ? block : block + "/" + plain;
}

}  // namespace breakaway
