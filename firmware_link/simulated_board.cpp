#include "firmware_link/simulated_board.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "control/board_watch.h"
#include "control/servo_controller.h"
#include "control/tuning.h"
#include "experiment/profile.h"
#include "experiment/servo_settings.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_rig.h"
#include "firmware_link/simulated_shaft.h"
#include "firmware_link/trip_words.h"
#include "plant/rig.h"

namespace breakaway {

namespace {

constexpr double lease_s = 0.2;  // without a word from the host the board opens the windings

ControllerSettings settingsOf(const board::BoardHardware<double>& hardware) {
  ControllerSettings present;
  present.current_limit_A = hardware.start.current_limit_A;
  present.velocity_limit_rad_per_s = hardware.start.gains.velocity_limit_rad_per_s;
  present.velocity_bandwidth_rad_per_s = hardware.servo.velocityBandwidth_rad_per_s;
  present.current_bandwidth_rad_per_s = hardware.servo.current.bandwidth_rad_per_s;
  return withTuning(present, hardware.start);
}

SettingRange offered(const BandwidthRange<double>& range) {
  return {true, range.least_rad_per_s, range.most_rad_per_s};
}

/// The same for every board: what the port says, whatever runs beneath it.
class SimulatedBoard final : public Drive {
 public:
  SimulatedBoard(const Rig& rig, unsigned seed, ShaftWatch shaft)
      : SimulatedBoard(rig, seed, std::move(shaft), hardwareOf<double>(rig)) {}

  const Identity& identity() const override { return identity_; }
  ControllerSettings settings() const override { return settings_; }
  std::vector<SettingRange> settingRanges() const override;
  Result<ControllerSettings> configure(const ControllerSettings& wanted) override;
  Result<void> compensate(const FrictionCompensation& friction) override;
  Result<void> linearise(const DutyCurve& curve) override;
  Result<FrictionCompensation> compensation() override { return friction_; }
  void command(const Command& command) override;
  void start(std::shared_ptr<Procedure> procedure) override;
  void stop(const Saying& reason) override;
  Trip tripped() const override { return tripped_; }
  Result<size_t> advance(double duration_s, std::vector<Sample>& samples) override;

 private:
  SimulatedBoard(const Rig& rig, unsigned seed, ShaftWatch shaft, const board::BoardHardware<double>& hardware)
      : ticks_s_(1.0 / rig.loopRate_Hz),
        rig_(rig, seed),
        controller_(hardware.servo),
        count_rad_(hardware.servo.count_rad),
        mostCurrent_A_(hardware.mostCurrent_A),
        mostVelocity_rad_per_s_(hardware.mostVelocity_rad_per_s),
        watch_(hardware.watch),
        settings_(settingsOf(hardware)),
        identity_{"simulated board, rig " + rig.name,
                  "simulated 0.1.0",
                  true,
                  rig.loopRate_Hz,
                  1.0,
                  rig.bridge.supply_V,
                  rig.encoder.hasIndex},
        shaft_(std::move(shaft)),
        unitPerRad_(rig.unitPerRad()) {
    identity_.axis = rig.axis;
    identity_.countsPerRev =
        rig.axis == Axis::rotary ? rig.encoder.countsPerRev : rig.encoder.countsPerRev / rig.travel.length_m;
    controller_.configure(servoSettings(settings_));
  }
  void obey(const Command& command);
  Sample tick(const SimulatedRig::Reading& reading);
  void watch(const Sample& sample);
  bool heard(bool linkLost);
  void runProcedure(const Sample& sample);
  double silent_s() const { return static_cast<double>(silentTicks_) * ticks_s_; }

  double ticks_s_;
  SimulatedRig rig_;
  ServoController<double> controller_;
  double count_rad_, mostCurrent_A_, mostVelocity_rad_per_s_;
  BoardWatch<double> watch_;
  ControllerSettings settings_;
  FrictionCompensation friction_;
  Identity identity_;
  ShaftWatch shaft_;
  double unitPerRad_;
  std::shared_ptr<Procedure> procedure_;
  Trip tripped_ = Trip::none;
  uint64_t tickCount_ = 0;
  double owed_s_ = 0.0, commandLimit_A_ = 0.0;
  bool follows_ = false;                    ///< a speed was commanded
  size_t lostTicks_ = 0, silentTicks_ = 0;  ///< not carried by the link: since the host was told, and in a row
};

std::vector<SettingRange> SimulatedBoard::settingRanges() const {
  std::vector<SettingRange> ranges(profileParameters().size());
  for (size_t k = 0; k < ranges.size(); ++k) {
    const auto member = profileParameters()[k].value;
    if (member == &ControllerSettings::observer_cutoff_rad_per_s) ranges[k].most = 0.5 / ticks_s_;
    if (member == &ControllerSettings::current_limit_A) ranges[k].most = mostCurrent_A_;
    if (member == &ControllerSettings::velocity_limit_rad_per_s) ranges[k].most = mostVelocity_rad_per_s_;
    if (member == &ControllerSettings::velocity_bandwidth_rad_per_s)
      ranges[k] = offered(velocityBandwidthRange(ticks_s_));
    if (member == &ControllerSettings::current_bandwidth_rad_per_s)
      ranges[k] = offered(currentBandwidthRange(ticks_s_));
  }
  return ranges;
}

Result<ControllerSettings> SimulatedBoard::configure(const ControllerSettings& wanted) {
  if (auto good = checkSettings(wanted); !good) return good.error();
  const auto ranges = settingRanges();
  for (size_t k = 0; k < ranges.size(); ++k) {
    const auto member = profileParameters()[k].value;
    if (mayBeUnsaid(member) && !(wanted.*member > 0.0)) continue;
    settings_.*member = std::clamp(wanted.*member, ranges[k].least, ranges[k].most);
  }
  controller_.setBandwidths(settings_.velocity_bandwidth_rad_per_s, settings_.current_bandwidth_rad_per_s);
  controller_.configure(servoSettings(settings_));
  return settings_;
}

Result<void> SimulatedBoard::compensate(const FrictionCompensation& friction) {
  using Table = FrictionTable<double>;
  Table table;
  const size_t bins = friction.coulomb_Nm[0].size();
  if (bins > Table::mostBins)
    return Error{"friction compensation", message("has {} bins, the board holds at most {}", bins, Table::mostBins)};
  bool finite = std::isfinite(friction.span_rad) && friction.span_rad >= 0.0 &&
                std::isfinite(friction.indexAngle_rad + friction.blend_rad_per_s + friction.cutoff_rad_per_s) &&
                friction.blend_rad_per_s >= 0.0 && friction.cutoff_rad_per_s >= 0.0 &&
                std::isfinite(friction.stribeck_rad_per_s) && friction.stribeck_rad_per_s >= 0.0;
  const bool hasStatic = !friction.static_Nm[0].empty() || !friction.static_Nm[1].empty();
  for (size_t way = 0; way < 2; ++way) {
    if (friction.coulomb_Nm[way].size() != bins || friction.viscous_Nm_s_per_rad[way].size() != bins ||
        (hasStatic && friction.static_Nm[way].size() != bins))
      return Error{"friction compensation", message("has not as many bins each way")};
    for (size_t k = 0; k < bins; ++k) {
      table.coulomb_Nm[way][k] = friction.coulomb_Nm[way][k];
      table.viscous_Nm_s_per_rad[way][k] = friction.viscous_Nm_s_per_rad[way][k];
      table.static_Nm[way][k] = hasStatic ? friction.static_Nm[way][k] : friction.coulomb_Nm[way][k];
      finite = finite && std::isfinite(table.coulomb_Nm[way][k]) && std::isfinite(table.viscous_Nm_s_per_rad[way][k]) &&
               std::isfinite(table.static_Nm[way][k]);
    }
  }
  if (!finite) return Error{"friction compensation", message("holds a value that is negative or not finite")};
  table.bins = static_cast<int>(bins);
  table.index_rad = friction.indexAngle_rad;
  if (friction.span_rad > 0.0) table.perRad = 1.0 / friction.span_rad;
  table.blend_rad_per_s = friction.blend_rad_per_s;
  table.stribeck_rad_per_s = hasStatic ? friction.stribeck_rad_per_s : 0.0;
  controller_.compensate(table, friction.cutoff_rad_per_s);
  friction_ = friction;
  return {};
}

Result<void> SimulatedBoard::linearise(const DutyCurve& curve) {
  DutyTable<double> table;
  if (curve.points.size() > DutyTable<double>::mostPoints)
    return Error{"bridge's curve", message("has {} points, the board holds at most {}", curve.points.size(),
                                           DutyTable<double>::mostPoints)};
  if (!curve.rises()) return Error{"bridge's curve", message("doesn't rise, expected a strictly rising one")};
  for (const DutyPoint& point : curve.points) {
    table.input[table.points] = point.input;
    table.output[table.points++] = point.output.value;
  }
  controller_.linearise(table);
  return {};
}

void SimulatedBoard::obey(const Command& command) {
  static_assert(static_cast<int>(Command::Mode::position) == static_cast<int>(ServoMode::position));
  commandLimit_A_ = command.current_limit_A;
  follows_ = command.mode == Command::Mode::velocity;
  controller_.command(
      {static_cast<ServoMode>(command.mode), command.target, command.current_limit_A, command.zeroCurrentSensor});
}

void SimulatedBoard::command(const Command& command) {
  if (procedure_ != nullptr && procedure_->state() == Procedure::State::running)
    procedure_->stop(message("another command came"));
  procedure_.reset();
  tripped_ = Trip::none;
  watch_.restart();
  obey(command);
}

void SimulatedBoard::start(std::shared_ptr<Procedure> procedure) {
  command({});
  procedure_ = std::move(procedure);
}

void SimulatedBoard::stop(const Saying& reason) {
  if (procedure_ != nullptr && procedure_->state() == Procedure::State::running) procedure_->stop(reason);
  procedure_.reset();
  obey({});
}

Sample SimulatedBoard::tick(const SimulatedRig::Reading& reading) {
  Sample sample;
  sample.time_s = static_cast<double>(tickCount_++) / identity_.loopRate_Hz;
  sample.angle_rad = static_cast<double>(reading.count) * count_rad_;
  sample.index = reading.index;
  sample.supply_V = reading.supply_V;
  const double bus_V = std::max(sample.supply_V, 1e-3);
  const auto out = controller_.step(sample.angle_rad, reading.current_A, bus_V);
  const double duty = out.enabled ? rig_.realisable(out.duty) : 0.0;
  sample.enabled = out.enabled;
  sample.voltage_V = duty * sample.supply_V;
  sample.current_A = out.current_A;
  sample.velocity_rad_per_s = out.velocity_rad_per_s;
  sample.current_reference_A = out.current_reference_A;
  sample.velocity_reference_rad_per_s = out.velocity_reference_rad_per_s;
  sample.angle_reference_rad = sample.angle_rad + out.angleAhead_rad;
  sample.disturbance_estimate_Nm = out.disturbance_estimate_Nm;
  rig_.drive(out.enabled, duty);
  return sample;
}

void SimulatedBoard::watch(const Sample& sample) {
  const double own_A = settings_.current_limit_A;
  const double limit_A = commandLimit_A_ > 0.0 ? std::min(commandLimit_A_, own_A) : own_A;
  const BoardWatch<double>::Seen seen{
      sample.angle_rad, sample.current_A, sample.current_reference_A, limit_A,  sample.supply_V,
      sample.enabled,   sample.voltage_V, sample.velocity_rad_per_s,  follows_, sample.velocity_reference_rad_per_s};
  const Trip trip = watch_.step(seen);
  const bool runs = procedure_ != nullptr || sample.enabled;
  if (trip == Trip::none || !runs) return;
  const auto& limits = watch_.limits();
  const auto& motor = watch_.motor();
  tripped_ = trip;
  stop(tripWords(trip, {seen.current_A,
                        limits.trip_A,
                        limit_A,
                        seen.supply_V,
                        limits.supply_V,
                        watch_.jumped_rad() / limits.count_rad,
                        limits.blockedFor_s,
                        {seen.voltage_V, seen.current_A, seen.velocity_rad_per_s, motor.velocity_rad_per_s,
                         limits.resistance_ohm, limits.backEmf_V_s_per_rad, limits.trip_A, identity_.axis,
                         motor.current_A, motor.voltage_V, watch_.inductive_V()}}));
}

/// While the link is down the board computes on by itself until its lease runs out.
bool SimulatedBoard::heard(bool linkLost) {
  if (!linkLost) {
    silentTicks_ = 0;
    return true;
  }
  ++lostTicks_;
  ++silentTicks_;
  if (silent_s() > lease_s) stop(linkLossWords(lease_s));
  return false;
}

void SimulatedBoard::runProcedure(const Sample& sample) {
  if (procedure_ == nullptr) return;
  obey(procedure_->step(sample));
  if (procedure_->state() == Procedure::State::running) return;
  procedure_.reset();
  obey({});
}

Result<size_t> SimulatedBoard::advance(double duration_s, std::vector<Sample>& samples) {
  owed_s_ += duration_s;
  const auto ticks = static_cast<size_t>(std::max(0.0, std::floor(owed_s_ / ticks_s_ + 1e-9)));
  owed_s_ -= static_cast<double>(ticks) * ticks_s_;
  samples.reserve(samples.size() + ticks);
  for (size_t k = 0; k < ticks; ++k) {
    const SimulatedRig::Reading reading = rig_.read();
    const Sample sample = tick(reading);
    if (shaft_)
      shaft_({sample.time_s, rig_.shaft_rad() * unitPerRad_, rig_.shaft_rad_per_s() * unitPerRad_, sample.enabled});
    if (heard(reading.linkLost)) samples.push_back(sample);
    watch(sample);
    runProcedure(sample);
  }
  if (silent_s() > lease_s) return Error{"board", linkLossWords(silent_s())};
  return std::exchange(lostTicks_, 0);
}

}  // namespace

Result<std::unique_ptr<Drive>> openDrive(const std::string& uri, unsigned seed) {
  return openWatched(uri, seed, {});
}

namespace {

Result<Rig> rigAt(const std::string& uri) {
  if (!isSimulated(uri)) {
    return Error{"board " + uri,
                 message("is no known board, expected simulated, simulated:PRESET or simulated:FILE.rig.json")};
  }
  const auto file = rigFileOf(uri);
  if (!file) return file.error();
  return readRig(*file);
}

}  // namespace

Result<std::unique_ptr<Drive>> openWatched(const std::string& uri, unsigned seed, ShaftWatch watch) {
  const auto rig = rigAt(uri);
  if (!rig) return rig.error();
  return std::unique_ptr<Drive>(std::make_unique<SimulatedBoard>(*rig, seed, std::move(watch)));
}

Result<std::unique_ptr<Drive>> openPushed(const std::string& uri, unsigned seed, const ShaftPush& push) {
  auto rig = rigAt(uri);
  if (!rig) return rig.error();
  if (rig->axis != Axis::rotary)
    return Error{"board " + uri, message("moves a linear axis, expected a rotor to be pushed")};
  rig->effects.push_back({"external_disturbance",
                          {{"torque_Nm", push.torque_Nm}, {"start_s", push.start_s}, {"duration_s", push.duration_s}}});
  return std::unique_ptr<Drive>(std::make_unique<SimulatedBoard>(*rig, seed, ShaftWatch{}));
}

}  // namespace breakaway
