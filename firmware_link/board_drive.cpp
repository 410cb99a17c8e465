#include "firmware_link/board_drive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/json_text.h"
#include "experiment/profile.h"
#include "firmware_link/board_dictionary.h"
#include "firmware_link/board_link.h"
#include "firmware_link/bridge_upload.h"
#include "firmware_link/fault_words.h"
#include "firmware_link/friction_upload.h"
#include "firmware_link/sample_decoder.h"
#include "firmware_link/wish.h"

namespace breakaway {

namespace {

using Seconds = std::chrono::duration<double>;
using Clock = BoardLink::Clock;

constexpr double beatEvery_s = 0.05;    // of the lease's 0.25 s
constexpr double longSlice_s = 0.05;    // granted while nothing has to react
constexpr double resendAfter_s = 0.02;  // on a local link an answer takes far less
constexpr double unbounded = 1e9;       // what a board names as a parameter's most that has none
constexpr double patience_s = 3.0;      // for a granted slice, however slow its emulator

using NamedValues = std::vector<std::pair<std::string, double>>;

/// `settings` with what a board answered.
ControllerSettings withAnswer(ControllerSettings settings, const NamedValues& asked, const std::vector<double>& told) {
  for (const auto& [name, value] : profileParameters()) {
    for (std::size_t k = 0; k < told.size(); ++k) {
      if (asked[k].first == name) settings.*value = told[k];
    }
  }
  return settings;
}

class BoardDrive final : public Drive {
 public:
  static Result<std::unique_ptr<Drive>> open(std::unique_ptr<ByteStream> stream, const BoardDriveOptions& options);

  const Identity& identity() const override { return identity_; }
  ControllerSettings settings() const override { return settings_; }
  std::vector<SettingRange> settingRanges() const override;
  Result<ControllerSettings> configure(const ControllerSettings& wanted) override;
  Result<void> compensate(const FrictionCompensation& friction) override;
  Result<FrictionCompensation> compensation() override;
  Result<void> linearise(const DutyCurve& curve) override;
  void command(const Command& command) override;
  void start(std::shared_ptr<Procedure> procedure) override;
  void stop(const Saying& reason) override;
  Trip tripped() const override { return tripped_; }
  Result<size_t> advance(double duration_s, std::vector<Sample>& samples) override;

 private:
  BoardDrive(BoardLink link, BoardDictionary dictionary, const BoardDriveOptions& options)
      : options_(options),
        link_(std::move(link)),
        dictionary_(std::move(dictionary)),
        decoder_(dictionary_.telemetry()),
        granted_(dictionary_.can(wire::Hello::grantedPace)),
        rate_Hz_(static_cast<double>(dictionary_.hello().loopRate_Hz)),
        boot_(dictionary_.hello().boot),
        latch_(dictionary_.hello().latch) {}

  Result<void> greet();
  Result<void> grant(std::size_t ticks);
  Result<void> runTo(std::uint64_t until);
  Result<void> wait(double duration_s);
  void beat(std::uint64_t until);
  void prepareWish();
  void begin(const Command& command, std::shared_ptr<Procedure> procedure);
  Result<void> hear(double wait_s);
  void heard(const wire::Frame& frame);
  void wishAnswered(const wire::Frame& frame);
  void alive(const wire::Alive& alive);
  void take(std::span<const std::uint8_t> body);
  void followZeroing();
  void runProcedure(const Sample& sample);
  void endProcedure(const Saying& reason);
  void faultCame(const wire::Fault& fault);
  Result<void> askForFault();
  Error broken(const Error& error);

  BoardDriveOptions options_;
  BoardLink link_;
  BoardDictionary dictionary_;
  SampleDecoder decoder_;
  Identity identity_;
  ControllerSettings settings_;
  FaultLimits limits_;
  bool granted_;
  double rate_Hz_;
  std::uint16_t boot_, latch_;

  std::shared_ptr<Procedure> procedure_;
  unsigned legOfProcedure_ = 0;  ///< the last one that was wished for
  Wish wish_;
  Clock::time_point beatSent_;

  std::vector<Sample> came_;  ///< since advance() was called last
  double zero_A_ = 0.0, zeroSum_A_ = 0.0;
  std::size_t zeroCount_ = 0;
  bool zeroes_ = false;
  std::size_t lost_ = 0;
  double owed_s_ = 0.0;
  std::optional<std::uint32_t> stands_;  ///< the tick at which the board last said that it stands
  bool faultUnknown_ = false;
  Trip tripped_ = Trip::none;
  std::optional<Error> broken_;
};

double since_s(Clock::time_point then) {
  return Seconds(Clock::now() - then).count();
}

Result<std::unique_ptr<Drive>> BoardDrive::open(std::unique_ptr<ByteStream> stream, const BoardDriveOptions& options) {
  BoardLink link(std::move(stream), options.place);
  auto dictionary = BoardDictionary::read(link);
  if (!dictionary) return dictionary.error();
  auto drive = std::unique_ptr<BoardDrive>(new BoardDrive(std::move(link), std::move(*dictionary), options));
  if (auto greeted = drive->greet(); !greeted) return greeted.error();
  return std::unique_ptr<Drive>(std::move(drive));
}

Result<void> BoardDrive::greet() {
  const wire::Hello& hello = dictionary_.hello();
  identity_ = {asUtf8(dictionary_.device()),
               asUtf8(dictionary_.firmware()),
               dictionary_.can(wire::Hello::simulated),
               rate_Hz_,
               static_cast<double>(hello.countsPerRev),
               static_cast<double>(hello.supply_V),
               dictionary_.can(wire::Hello::hasIndex)};
  identity_.serialNumber = asUtf8(dictionary_.serialNumber());
  identity_.can.compensates = dictionary_.can(wire::Hello::friction);
  identity_.can.runsLegs = dictionary_.can(wire::Hello::legs);
  NamedValues known;
  std::vector<std::string> names;
  for (const auto& [name, member] : profileParameters()) {
    if (mayBeUnsaid(member) && dictionary_.find(name) == nullptr) continue;  // an older board
    known.emplace_back(name, 0.0);
    names.emplace_back(name);
  }
  const auto values = dictionary_.values(link_, names);
  if (!values) return values.error();
  settings_ = withAnswer({}, known, *values);
  const auto limits = dictionary_.values(link_, {"current_trip_A", "blocked_for_s", "lease_s", "current_zero_A"});
  if (!limits) return limits.error();
  limits_ = {(*limits)[0], (*limits)[1], (*limits)[2], identity_.supply_V, decoder_.count_rad(), identity_.axis};
  zero_A_ = (*limits)[3];
  link_.listen([this](const wire::Frame& frame) { heard(frame); });
  const auto stopped = link_.ask<wire::Alive>(wire::Type::stop);
  if (!stopped) return stopped.error();
  alive(*stopped);
  decoder_.begin(stopped->tick);
  const auto written = dictionary_.write(
      link_, {{"telemetry_channels", static_cast<double>(options_.channels)}, {"telemetry_every", 1.0}});
  return written ? Result<void>{} : written.error();
}

Error BoardDrive::broken(const Error& error) {
  endProcedure(error.fact);
  broken_ = error;
  return error;
}

std::vector<SettingRange> BoardDrive::settingRanges() const {
  std::vector<SettingRange> ranges;
  for (const auto& [name, member] : profileParameters()) {
    const BoardParameter* entry = dictionary_.find(name);
    const bool offered = entry != nullptr && entry->writable;
    ranges.push_back({offered, offered ? entry->least : 0.0,
                      offered && entry->most < unbounded ? entry->most : std::numeric_limits<double>::infinity()});
  }
  return ranges;
}

Result<ControllerSettings> BoardDrive::configure(const ControllerSettings& wanted) {
  if (auto good = checkSettings(wanted); !good) return good.error();
  NamedValues values;
  for (const auto& [name, member] : profileParameters()) {
    const bool asked = !mayBeUnsaid(member) || (wanted.*member > 0.0 && dictionary_.find(name) != nullptr);
    if (asked) values.emplace_back(name, wanted.*member);
  }
  const auto accepted = dictionary_.write(link_, values);
  if (!accepted) return accepted.error();
  settings_ = withAnswer(settings_, values, *accepted);
  return settings_;
}

Result<void> BoardDrive::compensate(const FrictionCompensation& friction) {
  if (!dictionary_.can(wire::Hello::friction)) return Error{options_.place, message("takes no friction compensation")};
  return uploadFriction(link_, friction,
                        {dictionary_.hello().frictionBins, dictionary_.can(wire::Hello::staticFriction)});
}

Result<FrictionCompensation> BoardDrive::compensation() {
  if (!dictionary_.can(wire::Hello::friction)) return Error{options_.place, message("takes no friction compensation")};
  return downloadFriction(link_, dictionary_.can(wire::Hello::staticFriction));
}

Result<void> BoardDrive::linearise(const DutyCurve& curve) {
  if (!dictionary_.can(wire::Hello::bridgeCurve)) return Error{options_.place, message("takes no curve of its bridge")};
  return uploadBridge(link_, curve);
}

void BoardDrive::begin(const Command& command, std::shared_ptr<Procedure> procedure) {
  endProcedure(message("another command came"));
  tripped_ = Trip::none;
  procedure_ = std::move(procedure);
  legOfProcedure_ = 0;
  if (procedure_ != nullptr && identity_.can.runsLegs) procedure_->leaveLegsToDrive();
  wish_.begin(command);
  if (granted_ || broken_) return;  // it goes out with the next grant
  prepareWish();
  if (auto sent = link_.flush(); !sent) broken(sent.error());
}

void BoardDrive::command(const Command& command) {
  begin(command, nullptr);
}

void BoardDrive::start(std::shared_ptr<Procedure> procedure) {
  begin({}, std::move(procedure));
}

void BoardDrive::endProcedure(const Saying& reason) {
  if (procedure_ != nullptr && procedure_->state() == Procedure::State::running) procedure_->stop(reason);
  procedure_.reset();
}

void BoardDrive::stop(const Saying& reason) {
  endProcedure(reason);
  wish_.rest();
  if (broken_) return;
  const auto stopped = link_.ask<wire::Alive>(wire::Type::stop);
  if (!stopped) {
    broken(stopped.error());
    return;
  }
  alive(*stopped);
}

void BoardDrive::prepareWish() {
  wish_.prepare(link_, {procedure_ != nullptr, latch_, decoder_.count_rad()});
}

void BoardDrive::wishAnswered(const wire::Frame& frame) {
  const auto refused = wish_.answered(frame);
  if (!refused) return;
  if (*refused == wire::Code::latched) {
    faultUnknown_ = true;
  } else {
    endProcedure(message("the board refused a command"));
    wish_.want(Command{});
  }
}

/// An answer to a heartbeat or a stop.
void BoardDrive::alive(const wire::Alive& alive) {
  if (alive.boot != boot_) {
    broken(
        {options_.place,
         message("was powered up anew in the middle: its motor is off and it has forgotten what it was told; check its "
                 "supply, then connect and home again")});
    return;
  }
  stands_ = alive.tick;
  if (alive.latch == latch_) return;
  if (alive.fault != wire::FaultCode::none || procedure_ != nullptr || wish_.command().mode != Command::Mode::off) {
    faultUnknown_ = true;
  } else {
    latch_ = alive.latch;
  }
}

void BoardDrive::faultCame(const wire::Fault& fault) {
  if (fault.latch == latch_ && !faultUnknown_) return;
  const bool known = fault.latch == latch_;
  latch_ = fault.latch;
  faultUnknown_ = false;
  if (known) return;
  tripped_ = tripOf(fault.code);
  endProcedure(faultWords(fault, limits_));
  wish_.rest();
}

Result<void> BoardDrive::askForFault() {
  const auto body = link_.ask(wire::Type::fault, std::span<const std::uint8_t>{});
  if (!body) return broken(body.error());
  wire::Fault fault;
  if (!wire::readMessage(*body, fault)) return {};
  faultUnknown_ = true;
  faultCame(fault);
  // Stopped by a STOP of somebody else: the latch is told with the next answer.
  const auto told = link_.ask<wire::Alive>(wire::Type::heartbeat, wire::Heartbeat{});
  if (!told) return broken(told.error());
  if (told->latch != latch_) {
    latch_ = told->latch;
    endProcedure(message("somebody else stopped the motor"));
    wish_.rest();
  }
  faultUnknown_ = false;
  return {};
}

void BoardDrive::heard(const wire::Frame& frame) {
  const auto answers = [&frame](wire::Type type) {
    return frame.type == (static_cast<std::uint8_t>(type) | wire::answerBit);
  };
  if (frame.type == static_cast<std::uint8_t>(wire::Type::telemetry)) {
    take(frame.body);
  } else if (frame.type == static_cast<std::uint8_t>(wire::Type::faultHappened)) {
    wire::Fault fault;
    if (wire::readMessage(frame.body, fault)) faultCame(fault);
  } else if (Wish::isAnswered(frame)) {
    wishAnswered(frame);
  } else if (answers(wire::Type::heartbeat) && !frame.body.empty() && frame.body[0] == 0) {
    wire::Alive told;
    if (wire::readMessage(frame.body.subspan(1), told)) alive(told);
  }
}

void BoardDrive::take(std::span<const std::uint8_t> body) {
  const std::size_t before = came_.size();
  lost_ += decoder_.take(body, came_);
  for (std::size_t k = before; k < came_.size(); ++k) {
    Sample& sample = came_[k];
    sample.legPhase = wish_.leg() ? SampleDecoder::phaseOf(sample.legPhase, wish_.oddLeg()) : std::uint8_t(0);
    if (decoder_.unzeroed()) sample.current_A -= zero_A_;
    followZeroing();
    if (zeroes_ && !sample.enabled) {
      zeroSum_A_ += sample.current_A;
      ++zeroCount_;
    }
    runProcedure(sample);
    followZeroing();
  }
}

/// The board averages a few ticks earlier or later than it was told here; what a procedure has seen of the zeroing is
/// what counts for it, so the zero of the samples is taken on this side too. The board's own serves its current loop.
void BoardDrive::followZeroing() {
  const bool wanted = wish_.command().zeroCurrentSensor && wish_.command().mode == Command::Mode::off;
  if (zeroes_ && !wanted && zeroCount_ > 0) zero_A_ += zeroSum_A_ / static_cast<double>(zeroCount_);
  if (zeroes_ != wanted) {
    zeroSum_A_ = 0.0;
    zeroCount_ = 0;
  }
  zeroes_ = wanted;
}

void BoardDrive::runProcedure(const Sample& sample) {
  if (procedure_ == nullptr) return;
  const Command next = procedure_->step(sample);
  if (procedure_->state() != Procedure::State::running) {
    procedure_.reset();
    wish_.rest();
    wish_.sendAnew();
  } else if (const Leg* leg = procedure_->leg(); leg == nullptr) {
    wish_.want(next);
  } else if (procedure_->legNumber() != legOfProcedure_) {
    legOfProcedure_ = procedure_->legNumber();
    wish_.want(*leg);
  }
}

Result<void> BoardDrive::hear(double wait_s) {
  if (auto took = link_.take(wait_s); !took) return broken(took.error());
  if (broken_) return *broken_;
  return faultUnknown_ ? askForFault() : Result<void>{};
}

void BoardDrive::beat(std::uint64_t until) {
  link_.prepare(wire::Type::heartbeat, bodyOf(wire::Heartbeat{static_cast<std::uint32_t>(until)}));
  beatSent_ = Clock::now();
}

Result<void> BoardDrive::grant(std::size_t ticks) {
  const std::uint64_t end = decoder_.next() + ticks;
  while (decoder_.next() < end) {
    const double slice_s = procedure_ != nullptr && !wish_.leg() ? options_.slice_s : longSlice_s;
    const auto slice = static_cast<std::uint64_t>(std::max(1.0, std::floor(slice_s * rate_Hz_ + 1e-9)));
    if (auto ran = runTo(std::min(end, decoder_.next() + slice)); !ran) return ran;
  }
  return {};
}

/// Lets the board run up to `until` and takes its samples.
Result<void> BoardDrive::runTo(std::uint64_t until) {
  const auto begun = Clock::now();
  const std::size_t wishes = wish_.changes();
  const bool leg = wish_.leg().has_value();
  stands_.reset();
  prepareWish();
  beat(until);
  if (auto sent = link_.flush(); !sent) return broken(sent.error());
  while (decoder_.next() < until) {
    if (auto taken = hear(resendAfter_s); !taken) return taken;
    if (leg && wish_.changes() != wishes) break;  // its end came before the slice's: the board stands there
    if (stands_ && static_cast<std::int32_t>(*stands_ - static_cast<std::uint32_t>(until)) >= 0) {
      // It has run so far, and what it sent of that has come or is gone.
      lost_ += decoder_.passTo(static_cast<std::uint32_t>(until));
      break;
    }
    if (since_s(beatSent_) < resendAfter_s) continue;
    if (link_.silent_s() > patience_s || since_s(begun) > 10.0 * patience_s)
      return broken({options_.place, linkLossWords(link_.silent_s())});
    prepareWish();
    beat(until);
    if (auto sent = link_.flush(); !sent) return broken(sent.error());
  }
  return {};
}

Result<void> BoardDrive::wait(double duration_s) {
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(Seconds(duration_s));
  for (;;) {
    prepareWish();
    if (since_s(beatSent_) >= beatEvery_s) beat(0);
    if (auto sent = link_.flush(); !sent) return broken(sent.error());
    const double left_s = Seconds(end - Clock::now()).count();
    if (auto taken = hear(std::clamp(left_s, 0.0, 0.01)); !taken) return taken;
    if (link_.silent_s() > options_.silence_s) return broken({options_.place, linkLossWords(link_.silent_s())});
    if (Clock::now() >= end) return {};
  }
}

Result<size_t> BoardDrive::advance(double duration_s, std::vector<Sample>& samples) {
  if (broken_) return *broken_;
  Result<void> ran;
  if (granted_) {
    owed_s_ += duration_s;
    const auto ticks = static_cast<size_t>(std::max(0.0, std::floor(owed_s_ * rate_Hz_ + 1e-9)));
    owed_s_ -= static_cast<double>(ticks) / rate_Hz_;
    ran = grant(ticks);
  } else {
    ran = wait(duration_s);
  }
  samples.insert(samples.end(), came_.begin(), came_.end());
  came_.clear();
  if (!ran) return ran.error();
  return std::exchange(lost_, 0);
}

}  // namespace

Result<bool> speaksWire(ByteStream& stream, double most_s) {
  constexpr double perTry_s = 0.15;
  std::array<std::uint8_t, wire::mostFrame + 1> question{};  // a zero first, for whatever came before
  const std::size_t size =
      wire::FrameEncoder::encode({static_cast<std::uint8_t>(wire::Type::hello), 0, {}}, std::span(question).subspan(1));
  wire::FrameDecoder decoder;
  const auto begun = Clock::now();
  while (since_s(begun) < most_s) {
    if (auto sent = stream.write(std::span(question).first(size + 1)); !sent) return sent.error();
    const auto asked = Clock::now();
    do {
      std::vector<std::uint8_t> came;
      if (auto read = stream.read(came, perTry_s); !read) return read.error();
      for (const std::uint8_t byte : came) {
        if (decoder.take(byte)) return true;
      }
    } while (since_s(asked) < perTry_s);
  }
  return false;
}

Result<std::unique_ptr<Drive>> openBoardDrive(std::unique_ptr<ByteStream> stream, const BoardDriveOptions& options) {
  return BoardDrive::open(std::move(stream), options);
}

}  // namespace breakaway
