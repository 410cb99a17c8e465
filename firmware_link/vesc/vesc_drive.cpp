#include "firmware_link/vesc/vesc_drive.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/json_text.h"
#include "experiment/profile.h"
#include "firmware_link/vesc/vesc_angle.h"
#include "firmware_link/vesc/vesc_line.h"

namespace breakaway {

namespace {

using Clock = VescLine::Clock;

constexpr double aliveEvery_s = 0.1;
constexpr double silence_s = 0.5;      // without an answer the link counts as lost
constexpr double stopRepeats_s = 0.2;  // nothing is acknowledged, so a stop is said again with each question
constexpr double tripShare = 1.25;     // of a limit
constexpr double mostDuty = 0.95;

Clock::duration seconds(double duration_s) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(duration_s));
}

double secondsBetween(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

std::uint32_t neededFields(const VescOptions& options) {
  const std::uint32_t angle = options.countsPerRev ? vescField::position : vescField::tachometer;
  return (vescField::wanted & ~(vescField::tachometer | vescField::position)) | angle;
}

class VescDrive final : public Drive {
 public:
  VescDrive(VescLine line, VescPayload question, Identity identity, const VescOptions& options)
      : line_(std::move(line)),
        question_(std::move(question)),
        identity_(std::move(identity)),
        polePairs_(*options.polePairs),
        hasEncoder_(options.countsPerRev.has_value()),
        needed_(neededFields(options)) {
    settings_.current_limit_A = options.currentLimit_A;
    start_ = nextQuestion_ = heard_ = Clock::now();
  }
  ~VescDrive() override { line_.say(vescSetCurrent(0.0)); }

  const Identity& identity() const override { return identity_; }
  ControllerSettings settings() const override { return settings_; }
  std::vector<SettingRange> settingRanges() const override;
  Result<ControllerSettings> configure(const ControllerSettings& wanted) override;
  void command(const Command& command) override;
  void start(std::shared_ptr<Procedure> procedure) override;
  void stop(const Saying& reason) override;
  Result<size_t> advance(double duration_s, std::vector<Sample>& samples) override;

 private:
  void obey(const Command& command);
  void ask(Clock::time_point now);
  void hear(const VescPayload& payload, std::vector<Sample>& samples);
  void take(const VescValues& values, std::vector<Sample>& samples);
  Sample sampleOf(const VescValues& values, Clock::time_point heard);
  void watch(const Sample& sample, const VescValues& values);
  void heldUp(Clock::time_point now);
  void runProcedure(const Sample& sample);
  double limit_A() const;
  double electrical_rpm(double velocity_rad_per_s) const {
    return velocity_rad_per_s * 30.0 / std::numbers::pi * polePairs_;
  }

  VescLine line_;
  VescPayload question_;
  Identity identity_;
  double polePairs_;
  bool hasEncoder_;
  std::uint32_t needed_;
  ControllerSettings settings_;
  std::shared_ptr<Procedure> procedure_;
  Command command_;
  VescAngle angle_;
  double supply_V_ = 0.0, lastTime_s_ = 0.0;
  bool asked_ = false;
  size_t lost_ = 0;
  Clock::time_point start_, nextQuestion_, askedAt_, heard_, alive_, stopSaidUntil_;
};

std::vector<SettingRange> VescDrive::settingRanges() const {
  std::vector<SettingRange> ranges;
  for (const auto& [name, member] : profileParameters()) {
    const bool offered =
        member == &ControllerSettings::current_limit_A || member == &ControllerSettings::velocity_limit_rad_per_s;
    ranges.push_back({offered});
  }
  return ranges;
}

/// A VESC keeps its gains to itself; what this side watches over is all that can be set.
Result<ControllerSettings> VescDrive::configure(const ControllerSettings& wanted) {
  for (const double value : {wanted.current_limit_A, wanted.velocity_limit_rad_per_s}) {
    if (!std::isfinite(value) || value < 0.0)
      return Error{"settings", message("hold a value that is negative or not finite")};
  }
  settings_.current_limit_A = wanted.current_limit_A;
  settings_.velocity_limit_rad_per_s = wanted.velocity_limit_rad_per_s;
  return settings_;
}

double VescDrive::limit_A() const {
  const double own = settings_.current_limit_A, further = command_.current_limit_A;
  return further > 0.0 ? std::min(further, own) : own;
}

/// Nothing is repeated but a stop: a command that was said again could start a motor whose board has reset itself.
void VescDrive::obey(const Command& command) {
  if (command == command_) return;
  command_ = command;
  const double speedLimit = settings_.velocity_limit_rad_per_s;
  switch (command.mode) {
    case Command::Mode::voltage:
      line_.say(vescSetDuty(supply_V_ > 1.0 ? std::clamp(command.target / supply_V_, -mostDuty, mostDuty) : 0.0));
      break;
    case Command::Mode::current:
      line_.say(vescSetCurrent(std::clamp(command.target, -limit_A(), limit_A())));
      break;
    case Command::Mode::velocity:
      line_.say(vescSetSpeed(
          electrical_rpm(speedLimit > 0.0 ? std::clamp(command.target, -speedLimit, speedLimit) : command.target)));
      break;
    case Command::Mode::position: {
      const double degrees = command.target * 180.0 / std::numbers::pi;
      line_.say(hasEncoder_ ? vescSetPosition(degrees - 360.0 * std::floor(degrees / 360.0)) : vescSetCurrent(0.0));
      if (!hasEncoder_) command_ = {};
      break;
    }
    case Command::Mode::off:
      line_.say(vescSetCurrent(0.0));
      stopSaidUntil_ = Clock::now() + seconds(stopRepeats_s);
      break;
  }
  alive_ = Clock::now();
}

void VescDrive::command(const Command& command) {
  if (procedure_ != nullptr && procedure_->state() == Procedure::State::running)
    procedure_->stop(message("another command came"));
  procedure_.reset();
  obey(command);
}

void VescDrive::start(std::shared_ptr<Procedure> procedure) {
  command({});
  procedure_ = std::move(procedure);
}

void VescDrive::stop(const Saying& reason) {
  command_ = {};
  line_.say(vescSetCurrent(0.0));
  stopSaidUntil_ = Clock::now() + seconds(stopRepeats_s);
  if (procedure_ != nullptr && procedure_->state() == Procedure::State::running) procedure_->stop(reason);
  procedure_.reset();
}

void VescDrive::ask(Clock::time_point now) {
  const auto period = seconds(1.0 / identity_.loopRate_Hz);
  if (asked_) ++lost_;  // the last question had its time
  nextQuestion_ += period;
  while (nextQuestion_ <= now) {
    nextQuestion_ += period;
    ++lost_;
  }
  const bool powered = command_.mode != Command::Mode::off;
  if (!powered && now < stopSaidUntil_) line_.say(vescSetCurrent(0.0));
  if (powered && now - alive_ >= seconds(aliveEvery_s)) {
    line_.say(vescRequest(VescMessage::alive));
    alive_ = now;
  }
  line_.say(question_);
  asked_ = true;
  askedAt_ = now;
}

Sample VescDrive::sampleOf(const VescValues& values, Clock::time_point heard) {
  Sample sample;
  sample.time_s =
      std::max(lastTime_s_ + 1e-6, 0.5 * (secondsBetween(start_, askedAt_) + secondsBetween(start_, heard)));
  lastTime_s_ = sample.time_s;
  sample.velocity_rad_per_s = values.electricalSpeed_rpm * std::numbers::pi / 30.0 / polePairs_;
  const double within_rad = values.position_deg * std::numbers::pi / 180.0;
  sample.angle_rad = hasEncoder_ ? angle_.step(within_rad, sample.velocity_rad_per_s, sample.time_s)
                                 : commutationAngle_rad(values.tachometer, polePairs_);
  sample.current_A = values.iq_A;
  sample.supply_V = supply_V_ = values.supply_V;
  sample.voltage_V = values.duty * values.supply_V;
  sample.enabled = command_.mode != Command::Mode::off && values.fault == 0;
  sample.angle_reference_rad = command_.mode == Command::Mode::position ? command_.target : sample.angle_rad;
  if (command_.mode == Command::Mode::velocity) sample.velocity_reference_rad_per_s = command_.target;
  if (command_.mode == Command::Mode::current)
    sample.current_reference_A = std::clamp(command_.target, -limit_A(), limit_A());
  return sample;
}

void VescDrive::watch(const Sample& sample, const VescValues& values) {
  const bool runs = procedure_ != nullptr || command_.mode != Command::Mode::off;
  if (!runs) return;
  if (values.fault != 0) return stop(vescFaultWords(values.fault));
  const double speedLimit = settings_.velocity_limit_rad_per_s;
  if (speedLimit > 0.0 && std::abs(sample.velocity_rad_per_s) > tripShare * speedLimit) {
    return stop(message("over-speed: {:.1f} rad/s with a limit of {:.1f} rad/s; ask for less, or raise the limit",
                        std::abs(sample.velocity_rad_per_s), speedLimit));
  }
  if (std::abs(sample.current_A) <= tripShare * limit_A()) return;
  stop(message(
      "over-current: {:.1f} A measured with a limit of {:.1f} A; raise the limit, or set the same one in the VESC",
      std::abs(sample.current_A), limit_A()));
}

void VescDrive::runProcedure(const Sample& sample) {
  if (procedure_ == nullptr) return;
  obey(procedure_->step(sample));
  if (procedure_->state() == Procedure::State::running) return;
  procedure_.reset();
  obey({});
}

void VescDrive::hear(const VescPayload& payload, std::vector<Sample>& samples) {
  if (!asked_) return;
  const auto values = readVescValues(payload);
  if (values && values->has(needed_)) take(*values, samples);
}

void VescDrive::take(const VescValues& values, std::vector<Sample>& samples) {
  asked_ = false;
  heard_ = Clock::now();
  const Sample sample = sampleOf(values, heard_);
  samples.push_back(sample);
  watch(sample, values);
  runProcedure(sample);
}

/// Nobody has let time pass, and so nobody has kept the motor alive: whether it still runs is the VESC's affair.
void VescDrive::heldUp(Clock::time_point now) {
  const double late_s = secondsBetween(nextQuestion_, now);
  if (late_s <= silence_s) return;
  heard_ = nextQuestion_ = now;
  asked_ = false;
  if (procedure_ == nullptr && command_.mode == Command::Mode::off) return;
  stop(message("this program was held up for {:.1f} s, so the motor was stopped", late_s));
}

Result<size_t> VescDrive::advance(double duration_s, std::vector<Sample>& samples) {
  auto now = Clock::now();
  const auto end = now + seconds(duration_s);
  heldUp(now);
  do {
    if (now >= nextQuestion_) {
      while (asked_) {
        const auto overdue = line_.rescue();
        if (!overdue) break;
        hear(*overdue, samples);
      }
      ask(now);
    }
    if (const auto payload = line_.hear(std::min(end, nextQuestion_))) hear(*payload, samples);
    now = Clock::now();
    if (line_.broken()) {
      stop(line_.broken()->said());
      return *line_.broken();
    }
    if (secondsBetween(heard_, now) > silence_s) {
      const Message words = message(
          "the link to the VESC is lost: no answer for 0.5 s; without a word from here it releases the motor after its "
          "own time-out. Check cable and power, then connect again");
      stop(words);
      return Error{identity_.device, words};
    }
  } while (now < end);
  return std::exchange(lost_, 0);
}

std::optional<VescPayload> answerTo(VescLine& line, const VescPayload& question, double wait_s) {
  line.say(question);
  const auto end = Clock::now() + seconds(wait_s);
  while (auto payload = line.hear(end)) {
    if (payload->front() == question.front()) return payload;
  }
  while (auto payload = line.rescue()) {
    if (payload->front() == question.front()) return payload;
  }
  return {};
}

/// How often a second it answers, rounded down to a plain number that leaves it half of its time.
double answersPerSecond(VescLine& line, const VescPayload& question) {
  constexpr int times = 10;
  const auto begin = Clock::now();
  for (int k = 0; k < times; ++k) answerTo(line, question, 0.1);
  const double possible_Hz = 0.5 * times / secondsBetween(begin, Clock::now());
  double rate_Hz = 10.0;
  for (const double one_Hz : {20.0, 50.0, 100.0, 200.0, 250.0, 400.0, 500.0}) {
    if (one_Hz <= possible_Hz) rate_Hz = one_Hz;
  }
  return rate_Hz;
}

std::string deviceName(const VescVersion& version) {
  return fmt::format("VESC {} {:02x}{:02x}{:02x}{:02x}", version.hardware, version.identity[0], version.identity[1],
                     version.identity[2], version.identity[3]);
}

/// Its processor's, in hexadecimal; empty where it says none.
std::string serialNumberOf(const VescVersion& version) {
  std::string text;
  for (const std::uint8_t byte : version.identity) text += fmt::format("{:02x}", byte);
  return text.find_first_not_of('0') == std::string::npos ? std::string() : text;
}

std::string firmwareName(const VescVersion& version) {
  return fmt::format("VESC {}.{:02}", version.major, version.minor);
}

}  // namespace

Result<std::unique_ptr<Drive>> openVesc(std::unique_ptr<ByteStream>& stream, const VescOptions& options) {
  VescLine line(std::move(stream));
  line.fill();
  std::optional<VescVersion> version;
  for (int attempt = 0; attempt < 2 && !version && !line.broken(); ++attempt) {
    const auto answer = answerTo(line, vescRequest(VescMessage::firmwareVersion), options.answerWait_s);
    if (answer) version = readVescVersion(*answer);
  }
  if (line.broken()) return *line.broken();
  if (!version) {
    stream = line.release();
    return std::unique_ptr<Drive>();
  }
  Identity identity;
  identity.device = asUtf8(deviceName(*version));
  identity.firmware = asUtf8(firmwareName(*version));
  identity.serialNumber = serialNumberOf(*version);
  if (!options.polePairs) {
    return Error{identity.device, message("tells electrical speed only, so the motor's pole pairs are needed: "
                                          "?pole_pairs=N behind the address, or motor.pole_pairs in the bench file")};
  }
  line.say(vescSetCurrent(0.0));  // whatever it was doing for somebody else
  VescPayload question = vescSelectValues(vescField::wanted);
  auto first = answerTo(line, question, options.answerWait_s);
  if (!first) {  // firmware from before there was a choice
    question = vescRequest(VescMessage::values);
    first = answerTo(line, question, options.answerWait_s);
  }
  const auto values = first ? readVescValues(*first) : std::nullopt;
  if (!values || !values->has(neededFields(options)))
    return Error{identity.device,
                 message("does not answer with the values that are needed; its firmware is {}", identity.firmware)};
  identity.supply_V = values->supply_V;
  identity.countsPerRev = options.countsPerRev.value_or(6.0 * *options.polePairs);
  identity.can = {false, false, false, false, options.countsPerRev.has_value()};
  identity.loopRate_Hz = answersPerSecond(line, question);
  if (line.broken()) return *line.broken();
  return std::unique_ptr<Drive>(
      std::make_unique<VescDrive>(std::move(line), std::move(question), std::move(identity), options));
}

}  // namespace breakaway
