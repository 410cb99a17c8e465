#include "recording/import/codesys_trace.h"

#include <vector>

#include "recording/import/signal_log.h"
#include "recording/import/text_layout.h"

namespace breakaway {

namespace {

constexpr size_t mostTraceSignals = 5000;

/// "fActPosition" of "0.Variable; Application.Axis.fActPosition"; empty when the line is of another key.
std::string_view valueOfKey(std::string_view line, std::string_view key) {
  const size_t dot = line.find('.'), mark = line.find(';');
  if (dot == std::string_view::npos || mark == std::string_view::npos || dot > mark) return {};
  if (dot == 0 || line.substr(0, dot).find_first_not_of("0123456789") != std::string_view::npos) return {};
  return line.substr(dot + 1, mark - dot - 1) == key ? withoutBlanks(line.substr(mark + 1)) : std::string_view{};
}

}  // namespace

std::optional<Result<RawTable>> readCodesysTrace(std::string_view text, char lineEnd, const std::string& name) {
  std::string_view rest = text;
  if (withoutBlanks(takeLine(rest, lineEnd)) != "[key]; [value]") return std::nullopt;
  std::vector<Signal> signals;
  TextLayout layout;
  layout.separator = ';';
  std::vector<std::string_view> cells;
  while (!rest.empty()) {
    const std::string_view line = withoutBlanks(takeLine(rest, lineEnd));
    if (const auto variable = valueOfKey(line, "Variable"); !variable.empty()) {
      if (signals.size() >= mostTraceSignals) break;
      signals.push_back({std::string(variable), {}, {}, {}});
    }
    if (!line.starts_with(';') || signals.empty()) continue;
    splitCells(line, layout, cells);
    TextNumber stamp, value;
    if (cells.size() != 3 || readCell(cells[1], layout, stamp) != TextCell::number ||
        readCell(cells[2], layout, value) != TextCell::number)
      continue;
    signals.back().stamps.push_back(stamp.large ? Stamp{stamp.whole, stamp.rest} : Stamp{0, stamp.value});
    signals.back().values.push_back(value.value);
  }
  return tableOfSignals(signals, {"time", {}}, message("a CODESYS trace"), name);
}

}  // namespace breakaway
