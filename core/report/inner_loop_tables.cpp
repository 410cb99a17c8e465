#include "report/inner_loop_tables.h"

#include <fmt/core.h>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "control/tuning.h"
#include "draw/html_report.h"

namespace breakaway {

namespace {

constexpr double around = 4.2;  // lines up to so many times the bandwidth are worth printing
constexpr double degreesPerRadian = 180.0 / std::numbers::pi;

bool isNear(double bandwidth, double chosen) {
  return bandwidth <= around * chosen && bandwidth >= chosen / around;
}

bool isSame(double a, double b) {
  return std::abs(a - b) < 1e-6 * b;
}

std::string sourceWords(const BandwidthChoice& choice, double board_rad_per_s) {
  const std::string bandwidth = numberText(choice.bandwidth_rad_per_s, 4) + " rad/s, ";
  const std::string boards = numberText(board_rad_per_s, 3) + " rad/s";
  switch (choice.source) {
    case BandwidthSource::chosen:
      return bandwidth + "chosen" + (choice.heldBy.empty() ? "" : ", held by: " + choice.heldBy) +
             "; Breakaway's own boards have " + boards;
    case BandwidthSource::given:
      return bandwidth + "given; Breakaway's own boards have " + boards;
    case BandwidthSource::board:
      break;
  }
  return bandwidth + "as Breakaway's own boards have it";
}

std::string observerLines(const TuningStudy& study, double board_rad_per_s) {
  const bool linear = study.axis == Axis::linear;
  std::string lines = fmt::format("  {:>10} {:>10} {:>22} {:>14}  {}\n", "rad/s", "loop rad/s",
                                  linear ? "yields m/s per N" : "yields rad/s per mNm", "current mA rms", "held by");
  const double perUnit = linear ? 1.0 : 1e-3;
  for (const SpeedObserverRow& row : study.inner.observerRows) {
    const bool board = isSame(row.bandwidth_rad_per_s, board_rad_per_s);
    if (!board && !isNear(row.bandwidth_rad_per_s, study.inner.observer.bandwidth_rad_per_s)) continue;
    const bool holds = row.loopBandwidth_rad_per_s > 0.0;
    const bool used = isSame(row.bandwidth_rad_per_s, study.inner.observer.bandwidth_rad_per_s);
    lines += fmt::format("{} {:>10.4g} {:>10} {:>22} {:>14}  {}{}\n", used ? '*' : ' ', row.bandwidth_rad_per_s,
                         holds ? fmt::format("{:.3g}", row.loopBandwidth_rad_per_s) : "–",
                         holds ? fmt::format("{:.3g}", perUnit * row.yielding_rad_per_s_per_Nm) : "–",
                         holds ? fmt::format("{:.3g}", 1e3 * row.noise.currentReference_A) : "–", row.heldBy,
                         board ? " (the boards' own)" : "");
  }
  return lines;
}

std::string currentLines(const TuningStudy& study, double board_rad_per_s) {
  std::string lines = fmt::format("  {:>10} {:>14} {:>14} {:>14}  {}\n", "rad/s", "phase margin °", "winding mA rms",
                                  "bridge mV rms", "lost");
  for (const CurrentLoopRow& row : study.inner.currentRows) {
    const bool board = isSame(row.bandwidth_rad_per_s, board_rad_per_s);
    if (!board && !isNear(row.bandwidth_rad_per_s, study.inner.current.bandwidth_rad_per_s)) continue;
    const bool stable = std::isfinite(row.current_A) && row.worst.stable;
    lines += fmt::format("  {:>10.4g} {:>14} {:>14} {:>14}  {}{}\n", row.bandwidth_rad_per_s,
                         stable ? fmt::format("{:.3g}", degreesPerRadian * row.worst.phaseMargin_rad) : "–",
                         stable ? fmt::format("{:.3g}", 1e3 * row.current_A) : "–",
                         stable ? fmt::format("{:.3g}", 1e3 * row.voltage_V) : "–",
                         row.lost.empty() ? "nothing" : row.lost, board ? " (the boards' own)" : "");
  }
  return lines;
}

}  // namespace

std::string numberRow(const std::vector<double>& values) {
  std::string line;
  for (size_t k = 0; k < values.size(); ++k) {
    line += k > 0 ? "," : "";
    if (std::isfinite(values[k])) line += fmt::format("{:.9g}", values[k]);
  }
  return line + "\n";
}

std::string speedObserverTable(const TuningStudy& study) {
  std::string table = "bandwidth_rad_per_s,loop_bandwidth_rad_per_s,cutoff_rad_per_s";
  for (const char* what : {"yielding_rad_per_s_per_Nm", "disturbance_estimate_rms_Nm", "current_reference_rms_A",
                           "velocity_rms_rad_per_s", "velocity_estimate_rms_rad_per_s", "voltage_rms_V"})
    table += "," + nameOn(study.axis, what);
  table += ",held_by\n";
  for (const SpeedObserverRow& row : study.inner.observerRows) {
    const double none = row.loopBandwidth_rad_per_s > 0.0 ? 0.0 : NAN;
    std::string line = numberRow(
        {row.bandwidth_rad_per_s, row.loopBandwidth_rad_per_s + none, row.cutoff_rad_per_s + none,
         row.yielding_rad_per_s_per_Nm + none, row.noise.estimate_Nm + none, row.noise.currentReference_A + none,
         row.noise.velocity_rad_per_s + none, row.noise.velocityEstimate_rad_per_s + none, row.noise.voltage_V + none});
    line.back() = ',';
    table += line + row.heldBy + "\n";
  }
  return table;
}

std::string currentLoopTable(const TuningStudy& study) {
  std::string table =
      "bandwidth_rad_per_s,gain_margin,phase_margin_rad,peak_sensitivity,current_rms_A,voltage_rms_V,lost\n";
  for (const CurrentLoopRow& row : study.inner.currentRows) {
    const double none = row.worst.stable ? 0.0 : NAN;
    std::string line =
        numberRow({row.bandwidth_rad_per_s, row.worst.gainMargin + none, row.worst.phaseMargin_rad + none,
                   row.worst.peakSensitivity + none, row.current_A, row.voltage_V});
    line.back() = ',';
    table += line + row.lost + "\n";
  }
  return table;
}

std::string innerLoopWords(const TuningStudy& study) {
  const double T = study.loop.board.tick_s, observer = boardVelocityBandwidth_rad_per_s(T),
               current = boardCurrentBandwidth_rad_per_s(T);
  std::string words =
      "Speed observer: " + sourceWords(study.inner.observer, observer) + ".\n" + observerLines(study, observer);
  const bool wound = !study.inner.currentRows.empty();
  if (wound)
    words += "Current loop: " + sourceWords(study.inner.current, current) + ".\n" + currentLines(study, current);
  const bool asBoards = isSame(study.inner.observer.bandwidth_rad_per_s, observer) &&
                        (!wound || isSame(study.inner.current.bandwidth_rad_per_s, current));
  if (!asBoards)
    words +=
        "These gains ask for a board that is set so, and may swing up on another. Breakaway's own are by profile "
        "restore "
        "--tuning; gains for one that can't be with --board-bandwidths.\n";
  words.pop_back();
  return words;
}

}  // namespace breakaway
