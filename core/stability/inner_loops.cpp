#include "stability/inner_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "control/tuning.h"
#include "stability/reach.h"
#include "stability/root_locus.h"

namespace breakaway {

namespace {

constexpr double lowestPerTick = 0.02, highestPerTick = 1.0;  // w·T
constexpr size_t yieldFrequencies = 200;
constexpr double bearable = 1.1;  // of the least yielding
constexpr double inductanceDoubt = 0.2;
constexpr double warmer = 1.24;  // copper, 0.0039/K over 60 K

/// The winding and its controller at standstill, tick by tick as in CurrentController::step(); the measured current is
/// an input where the loop is cut.
DiscreteSystem currentLoop(const ServoLoop& loop, bool cut) {
  const double T = loop.board.tick_s, R = loop.motor.resistance_ohm, decay = std::exp(-R * T / loop.motor.inductance_H);
  const auto& c = loop.board.current;
  const Eigen::Index delayed = loop.delay_ticks, states = 2 + delayed;  // current, integral, commands under way
  const double gain = c.inductance_H * c.bandwidth_rad_per_s, growth = c.resistance_ohm * c.bandwidth_rad_per_s * T;
  // Columns: states, then the inputs reference and error (or, where it is cut, the measured current).
  Eigen::RowVectorXd measured = Eigen::RowVectorXd::Unit(states + 2, states + 1);
  if (!cut) measured[0] = 1.0;
  const Eigen::RowVectorXd reference = Eigen::RowVectorXd::Unit(states + 2, states),
                           integral = Eigen::RowVectorXd::Unit(states + 2, 1);
  const Eigen::RowVectorXd voltage = c.resistance_ohm * reference + gain * (reference - measured) + integral;
  Eigen::MatrixXd next = Eigen::MatrixXd::Zero(states, states + 2);
  const Eigen::RowVectorXd acting =
      delayed > 0 ? Eigen::RowVectorXd(Eigen::RowVectorXd::Unit(states + 2, states - 1)) : voltage;
  next.row(0) = decay * Eigen::RowVectorXd::Unit(states + 2, 0) + (1.0 - decay) / R * acting;
  next.row(1) = integral + growth * (reference - measured);
  for (Eigen::Index k = 0; k < delayed; ++k)
    next.row(2 + k) = k == 0 ? voltage : Eigen::RowVectorXd(Eigen::RowVectorXd::Unit(states + 2, 1 + k));
  Eigen::MatrixXd out(2, states + 2);
  out << Eigen::RowVectorXd::Unit(states + 2, 0), voltage;
  if (!cut) return {next.leftCols(states), next.rightCols(2), out.leftCols(states), out.rightCols(2), T};
  return {next.leftCols(states), next.rightCols(1), -out.topLeftCorner(1, states), Eigen::MatrixXd::Zero(1, 1), T};
}

class Chooser {
 public:
  Chooser(const ServoLoop& loop, const Estimate& inertia, const Estimate& torqueConstant,
          const AutoTuningOptions& options, const InnerLoopOptions& inner)
      : loop_(loop),
        inertia_(inertia),
        torqueConstant_(torqueConstant),
        options_(options),
        inner_(inner),
        wanted_(wantedMargins(options.stiffness)) {
    loop_.mode = ServoMode::velocity;
    const double stall_A = wound() && inner.supply_V > 0.0 ? inner.supply_V / loop.motor.resistance_ohm : 0.0;
    if (!(loop_.settings.current_limit_A > 0.0)) loop_.settings.current_limit_A = stall_A;
  }

  Result<InnerLoops> choose();

 private:
  bool wound() const { return loop_.current == CurrentPath::winding; }
  double tick_s() const { return loop_.board.tick_s; }
  BandwidthChoice chooseCurrent();
  BandwidthChoice chooseObserver(const std::vector<SpeedObserverRow>& rows) const;
  CurrentLoopRow currentRow(double bandwidth_rad_per_s) const;
  Result<SpeedObserverRow> observerRow(double bandwidth_rad_per_s) const;

  ServoLoop loop_;
  Estimate inertia_, torqueConstant_;
  AutoTuningOptions options_;
  InnerLoopOptions inner_;
  WantedMargins wanted_;
};

CurrentLoopRow Chooser::currentRow(double bandwidth_rad_per_s) const {
  CurrentLoopRow row;
  row.bandwidth_rad_per_s = bandwidth_rad_per_s;
  ServoLoop loop = loop_;
  loop.board.current.bandwidth_rad_per_s = bandwidth_rad_per_s;
  row.worst.stable = true;
  for (const double ofL : {1.0 - inductanceDoubt, 1.0 + inductanceDoubt}) {
    for (const double ofR : {1.0, warmer}) {
      ServoLoop corner = loop;
      corner.motor.inductance_H *= ofL;
      corner.motor.resistance_ohm *= ofR;
      const LoopMargins found = margins(closedCurrentLoop(corner), openCurrentLoop(corner));
      if (row.lost.empty()) row.lost = lossOfMargins(found, wanted_);
      if (!found.stable || (row.worst.stable && found.peakSensitivity > row.worst.peakSensitivity)) row.worst = found;
    }
  }
  const double error = options_.noise.current_rms_A, limit_A = loop.settings.current_limit_A;
  const auto rms = stationaryRms(closedCurrentLoop(loop), Eigen::Vector2d(0.0, error * error));
  row.current_A = rms ? (*rms)[0] : std::numeric_limits<double>::quiet_NaN();
  row.voltage_V = rms ? (*rms)[1] : std::numeric_limits<double>::quiet_NaN();
  if (!row.lost.empty()) return row;
  if (limit_A > 0.0 && row.current_A > wanted_.noiseShare * limit_A) row.lost = "noise of the current";
  if (inner_.supply_V > 0.0 && row.voltage_V > wanted_.noiseShare * inner_.supply_V) row.lost = "noise of the voltage";
  return row;
}

BandwidthChoice Chooser::chooseCurrent() {
  BandwidthChoice board{boardCurrentBandwidth_rad_per_s(tick_s()), BandwidthSource::board, {}};
  if (inner_.current_rad_per_s > 0.0) return {inner_.current_rad_per_s, BandwidthSource::given, {}};
  if (inner_.asBoards || !wound()) return board;
  const Reach reach = farthest(lowestPerTick / tick_s(), highestPerTick / tick_s(),
                               [this](double bandwidth) { return currentRow(bandwidth).lost; });
  return reach.most > 0.0 ? BandwidthChoice{reach.most, BandwidthSource::chosen, reach.heldBy} : board;
}

Result<SpeedObserverRow> Chooser::observerRow(double bandwidth_rad_per_s) const {
  SpeedObserverRow row;
  row.bandwidth_rad_per_s = bandwidth_rad_per_s;
  ServoLoop loop = loop_;
  loop.board.velocityBandwidth_rad_per_s = bandwidth_rad_per_s;
  const auto tuning = tuneVelocity(loop, inertia_, torqueConstant_, options_);
  if (!tuning) return tuning.error();
  row.loopBandwidth_rad_per_s = tuning->bandwidth_rad_per_s;
  row.heldBy = tuning->heldBy;
  if (!(row.loopBandwidth_rad_per_s > 0.0)) return row;
  row.cutoff_rad_per_s = tuning->loop.settings.observer_cutoff_rad_per_s;
  row.noise = tuning->noise;
  const auto yielding = response(closedLoop(tuning->loop), static_cast<Eigen::Index>(LoopInput::load),
                                 static_cast<Eigen::Index>(LoopOutput::velocity),
                                 decades(0.01 * row.cutoff_rad_per_s, std::numbers::pi / tick_s(), yieldFrequencies));
  for (const auto& one : yielding)
    row.yielding_rad_per_s_per_Nm = std::max(row.yielding_rad_per_s_per_Nm, std::abs(one));
  return row;
}

BandwidthChoice Chooser::chooseObserver(const std::vector<SpeedObserverRow>& rows) const {
  if (inner_.observer_rad_per_s > 0.0) return {inner_.observer_rad_per_s, BandwidthSource::given, {}};
  BandwidthChoice board{boardVelocityBandwidth_rad_per_s(tick_s()), BandwidthSource::board, {}};
  if (inner_.asBoards || !(loop_.settings.current_limit_A > 0.0)) return board;
  double least = HUGE_VAL;
  for (const SpeedObserverRow& row : rows) {
    if (row.loopBandwidth_rad_per_s > 0.0) least = std::min(least, row.yielding_rad_per_s_per_Nm);
  }
  for (const SpeedObserverRow& row : rows) {
    if (row.loopBandwidth_rad_per_s > 0.0 && row.yielding_rad_per_s_per_Nm <= bearable * least)
      return {row.bandwidth_rad_per_s, BandwidthSource::chosen, row.heldBy};
  }
  return board;
}

Result<InnerLoops> Chooser::choose() {
  InnerLoops found;
  found.current = chooseCurrent();
  if (wound()) {
    for (const double one : bandwidthsAround(boardCurrentBandwidth_rad_per_s(tick_s()), tick_s(), inner_.rows))
      found.currentRows.push_back(currentRow(one));
  }
  loop_.board.current.bandwidth_rad_per_s = found.current.bandwidth_rad_per_s;
  for (const double one : bandwidthsAround(boardVelocityBandwidth_rad_per_s(tick_s()), tick_s(), inner_.rows)) {
    auto row = observerRow(one);
    if (!row) return row.error();
    found.observerRows.push_back(std::move(*row));
  }
  found.observer = chooseObserver(found.observerRows);
  return found;
}

}  // namespace

std::string_view nameOf(BandwidthSource source) {
  constexpr std::array<std::string_view, 3> names{"chosen", "given", "board"};
  return names[static_cast<size_t>(source)];
}

DiscreteSystem closedCurrentLoop(const ServoLoop& loop) {
  return currentLoop(loop, false);
}

DiscreteSystem openCurrentLoop(const ServoLoop& loop) {
  return currentLoop(loop, true);
}

Result<InnerLoops> chooseInnerLoops(const ServoLoop& loop, const Estimate& inertia_kg_m2,
                                    const Estimate& torqueConstant_Nm_per_A, const AutoTuningOptions& options,
                                    const InnerLoopOptions& inner) {
  return Chooser(loop, inertia_kg_m2, torqueConstant_Nm_per_A, options, inner).choose();
}

}  // namespace breakaway
