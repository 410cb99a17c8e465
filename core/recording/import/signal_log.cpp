#include "recording/import/signal_log.h"

#include <cmath>
#include <cstdlib>

#include "recording/import/column_name.h"

namespace breakaway {

namespace {

/// The signal whose stamps the rows have.
const Signal* baseOf(const std::vector<Signal>& signals) {
  const Signal *longest = nullptr, *position = nullptr;
  for (const Signal& signal : signals) {
    if (longest == nullptr || signal.values.size() > longest->values.size()) longest = &signal;
    const std::string to = understandName(signal.name, signal.unit).to;
    const bool angle = (to == "angle_rad" || to == "position_m") && signal.values.size() > 1;
    if (angle && (position == nullptr || signal.values.size() > position->values.size())) position = &signal;
  }
  return position != nullptr ? position : longest;
}

RawColumn columnOf(const Signal& signal, const std::vector<Stamp>& stamps) {
  RawColumn column{{signal.name, {}}, {}};
  column.unit = signal.unit;
  column.channel.values.reserve(stamps.size());
  size_t next = 0;
  double held = NAN;
  for (const Stamp& now : stamps) {
    while (next < signal.stamps.size() && signal.stamps[next] <= now) held = signal.values[next++];
    column.channel.values.push_back(held);
  }
  return column;
}

}  // namespace

Result<RawTable> tableOfSignals(const std::vector<Signal>& signals, const StampColumn& time, const Message& what,
                                const std::string& name) {
  const Signal* base = baseOf(signals);
  if (base == nullptr || base->values.size() < 2) return Error{name, message("is {} without numbers over time", what)};
  constexpr size_t mostValues = size_t{1} << 28;
  if (signals.size() > mostValues / base->values.size())
    return Error{name, message("has too many signals: {} over {} stamps", signals.size(), base->values.size())};
  RawTable table;
  RawColumn stamps{{time.name, {}}, {}};
  stamps.unit = time.unit;
  stamps.clock = time.clock;
  constexpr int64_t beyondDigits = 100'000'000'000;  // in s, a double loses what matters
  const int64_t first = base->stamps.front().whole, origin = time.clock || std::abs(first) >= beyondDigits ? first : 0;
  stamps.origin = static_cast<double>(origin);
  for (const Stamp& stamp : base->stamps)
    stamps.channel.values.push_back(static_cast<double>(stamp.whole - origin) + stamp.rest);
  table.columns.push_back(std::move(stamps));
  for (const Signal& signal : signals) {
    if (!signal.values.empty()) table.columns.push_back(columnOf(signal, base->stamps));
  }
  table.remarks.push_back(message("{} of {} signals, over the stamps of {}; the others hold their last value", what,
                                  table.columns.size() - 1, base->name));
  return table;
}

}  // namespace breakaway
