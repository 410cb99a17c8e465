// The lease in every state of every procedure: the host freezes, is killed, or the cable is pulled, and the board of
// real pace stops by itself. Board and host run in the board's own time, so that a moment is a tick.
#include <sys/wait.h>
#include <unistd.h>

#include <QTest>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <map>
#include <memory>

#include "experiment/breakaway_sweep.h"
#include "experiment/course.h"
#include "experiment/current_zeroing.h"
#include "experiment/homing.h"
#include "experiment/position_step.h"
#include "experiment/reversal_test.h"
#include "experiment/slow_turns.h"
#include "experiment/spin_test.h"
#include "experiment/velocity_step.h"
#include "experiment/velocity_sweep.h"
#include "experiment/winding_test.h"
#include "firmware_link/board_dictionary.h"
#include "firmware_link/board_link.h"
#include "firmware_link/simulated_firmware.h"
#include "support/firmware_stream.h"
#include "support/sanitized.h"

using namespace breakaway;
using namespace breakaway::test;

class TestLease : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void hostThatIsLost_stopsTheBoardInEveryState_data();
  void hostThatIsLost_stopsTheBoardInEveryState();
};

namespace {

using Make = std::function<std::shared_ptr<Procedure>()>;
constexpr std::uint32_t leaseTicks = 1250, beatEvery = 250, listenEvery = 5;

/// What came of the board's line stays until it is read.
class FarLine final : public ByteStream {
 public:
  explicit FarLine(std::shared_ptr<SimulatedFirmware> board) : board_(std::move(board)) {}
  Result<void> write(std::span<const std::uint8_t> bytes) override {
    board_->receive(bytes);
    return {};
  }
  Result<void> read(std::vector<std::uint8_t>& bytes, double /*wait_s*/) override {
    board_->transmit(bytes);
    return {};
  }

 private:
  std::shared_ptr<SimulatedFirmware> board_;
};

/// A host that runs a procedure on a board of real pace, as BoardDrive does, in the board's time.
class Host {
 public:
  explicit Host(std::shared_ptr<Procedure> procedure)
      : procedure_(std::move(procedure)),
        board_(std::make_shared<SimulatedFirmware>(presetRig("servo"), 1, board::Pace::real, 7)),
        link_(std::make_unique<FarLine>(board_), "board") {
    auto dictionary = BoardDictionary::read(link_);
    if (!dictionary) qFatal("%s", dictionary.error().message().c_str());
    latch_ = dictionary->hello().latch;
    decoder_ = std::make_unique<SampleDecoder>(dictionary->telemetry());
    const auto told = dictionary->write(
        link_, {{"telemetry_channels", static_cast<double>(wire::usualChannels)}, {"telemetry_every", 1.0}});
    if (!told) qFatal("%s", told.error().message().c_str());
    link_.listen([this](const wire::Frame& frame) {
      if (frame.type == static_cast<std::uint8_t>(wire::Type::telemetry)) decoder_->take(frame.body, came_);
    });
    begin();
  }

  bool runs() const { return procedure_->state() == Procedure::State::running; }
  std::string failure() const { return procedure_->status().failure; }
  /// The procedure's state as far as it can be told apart from outside: what it says that it does, and what it
  /// commands.
  std::string state() const {
    std::string words;
    const std::string activity = procedure_->status().activity;
    for (const char c : activity) {
      if (std::isdigit(static_cast<unsigned char>(c)) == 0 && c != '.') words += c;
    }
    const char* way = wanted_.target > 0.0 ? "+" : wanted_.target < 0.0 ? "-" : "0";
    return words + ", mode " + std::to_string(static_cast<int>(wanted_.mode)) + way +
           (wanted_.zeroCurrentSensor ? ", zeroing" : "");
  }

  void tick() {
    const std::uint32_t now = board_->board().ticks();
    if (now % beatEvery == 0) beat();
    if (now % listenEvery == 0) listen();
    board_->tickWithoutSending();
  }

  /// How the host is lost: what the board still hears of it.
  enum class Loss { frozen, killed, pulledCable };

  /// Empty when the board stops in time and nothing moves it again.
  std::string lose(Loss loss) {
    const std::uint32_t heard = lastBeat_;
    if (loss == Loss::pulledCable) {  // half a frame
      const std::uint8_t part[] = {5, 1, 5, 44, 1, 2, 4};
      board_->receive(part);
    }
    while (board_->board().ticks() - heard < leaseTicks + 2) {
      board_->tickWithoutSending();
      const std::uint32_t silent = board_->board().ticks() - heard;
      if (silent <= leaseTicks - 2 && !board_->board().acts()) return "stopped long before its lease was over";
      if (silent > leaseTicks + 1 && (board_->enabled() || board_->board().acts())) return "goes on after its lease";
    }
    const auto fault = faultOf();
    if (!fault || fault->code != wire::FaultCode::leaseExpired) return "stopped for another reason";
    if (fault->tick - heard > leaseTicks + 1) return "stopped late";
    return loss == Loss::frozen ? goesOn() : connectsAnew();
  }

 private:
  void begin() {
    wanted_ = {};
    command(wire::MotorCommand::fresh);
  }
  void beat() {
    static_cast<void>(link_.post(wire::Type::heartbeat, bodyOf(wire::Heartbeat{})));
    lastBeat_ = board_->board().ticks();
  }
  void command(std::uint8_t further = 0) {
    wire::MotorCommand frame;
    frame.mode = static_cast<wire::MotorCommand::Mode>(wanted_.mode);
    frame.flags = static_cast<std::uint8_t>(wire::MotorCommand::watched | further |
                                            (wanted_.zeroCurrentSensor ? wire::MotorCommand::zeroCurrentSensor : 0));
    frame.latch = latch_;
    frame.target = static_cast<float>(wanted_.target);
    frame.current_limit_A = static_cast<float>(wanted_.current_limit_A);
    static_cast<void>(link_.post(wire::Type::command, bodyOf(frame)));
  }
  void listen() {
    static_cast<void>(link_.take(0.0));
    const Command before = wanted_;
    for (const Sample& sample : came_) {
      if (runs()) wanted_ = procedure_->step(sample);
    }
    came_.clear();
    if (!(wanted_ == before)) command();
  }

  std::optional<wire::Fault> faultOf() {
    if (!link_.clear()) return {};
    const auto body = link_.ask(wire::Type::fault, std::span<const std::uint8_t>{}, {0.01, 1});
    wire::Fault fault;
    if (!body || !wire::readMessage(*body, fault)) return {};
    return fault;
  }
  bool moves(int ticks) {
    for (int k = 0; k < ticks; ++k) {
      if (k % 100 == 0) static_cast<void>(link_.post(wire::Type::heartbeat, bodyOf(wire::Heartbeat{})));
      board_->tickWithoutSending();
      if (board_->enabled() || board_->board().acts()) return true;
    }
    return false;
  }
  /// The host wakes up and goes on as if nothing had been.
  std::string goesOn() {
    if (moves(200)) return "heartbeats alone start it again";
    command();
    if (moves(200)) return "a command from before starts it again";
    return {};
  }
  std::string connectsAnew() {
    BoardLink anew(std::make_unique<FarLine>(board_), "board");
    if (!anew.clear()) return "no line";
    const auto hello = anew.ask<wire::Hello>(wire::Type::hello, BoardLink::Patience{0.01, 3});
    if (!hello) return "doesn't answer a new connection";
    if (hello->latch == latch_) return "has the latch of before";
    if (moves(200)) return "a new connection starts it again";
    command();  // what the old one had still on its way
    if (moves(200)) return "what the old connection said starts it again";
    return {};
  }

  std::shared_ptr<Procedure> procedure_;
  std::shared_ptr<SimulatedFirmware> board_;
  BoardLink link_;
  std::unique_ptr<SampleDecoder> decoder_;
  std::vector<Sample> came_;
  Command wanted_;
  std::uint16_t latch_ = 0;
  std::uint32_t lastBeat_ = 0;
};

/// Loses the host in a copy of this process, so that the procedure goes on here.
std::string outcomeOf(Host& host, Host::Loss loss) {
  std::array<int, 2> line{};
  if (::pipe(line.data()) != 0) return "no pipe";
  const pid_t copy = ::fork();
  if (copy == 0) {
    const std::string wrong = host.lose(loss);
    static_cast<void>(!::write(line[1], wrong.data(), wrong.size()));
    ::_exit(wrong.empty() ? 0 : 1);
  }
  ::close(line[1]);
  std::array<char, 200> text{};
  const ssize_t size = ::read(line[0], text.data(), text.size());
  ::close(line[0]);
  int status = -1;
  ::waitpid(copy, &status, 0);
  if (status == 0) return {};
  return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : "the copy ended by itself";
}

BreakawaySweepOptions quickBreakaways() {
  BreakawaySweepOptions options;
  options.bins = 12;
  options.turns = 1;
  options.indexAngle_rad = 1.234;
  options.torqueConstant_Nm_per_A = options.backEmfConstant_V_s_per_rad = 0.07;
  options.resistance_ohm = 1.2;
  options.deadZone_V = 0.24;
  options.inertia_kg_m2 = 6e-5;
  options.countsPerRev = 14400;
  options.zeroEvery_s = 4.0;
  return options;
}

CourseOptions moves() {
  CourseOptions options;
  options.zeroing_s = 0.2;
  options.before = {Command::Mode::velocity, 10.0, 0.0, false};
  options.before_s = 0.4;
  options.duration_s = 0.6;
  options.command = [](double time_s, const Sample& start) {
    return time_s < 0.3 ? Command{Command::Mode::position, start.angle_rad, 0.0, false}
                        : Command{Command::Mode::current, 0.4, 0.0, false};
  };
  return options;
}

}  // namespace

void TestLease::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestLease::hostThatIsLost_stopsTheBoardInEveryState_data() {
  QTest::addColumn<Make>("make");
  QTest::addColumn<int>("states");  // at least
  const auto row = [](const char* name, int states, const Make& make) { QTest::newRow(name) << make << states; };
  row("current zeroing", 2, [] { return std::make_shared<CurrentZeroing>(); });
  row("winding test", 5, [] {
    WindingTestOptions options;
    options.ramps = 2;
    options.square_s = 1.0;
    return std::make_shared<WindingTest>(options);
  });
  row("spin test", 3, [] {
    SpinTestOptions options;
    options.cycles = 1;
    return std::make_shared<SpinTest>(options);
  });
  row("reversal test", 2, [] {
    ReversalTestOptions options;
    options.current_A = 0.6;
    options.highest_rad_per_s = 60.0;
    options.reversals = 4;
    return std::make_shared<ReversalTest>(options);
  });
  row("velocity step", 2, [] { return std::make_shared<VelocityStep>(); });
  row("position step", 2, [] { return std::make_shared<PositionStep>(PositionStepOptions{}); });
  row("homing", 4, [] { return std::make_shared<Homing>(); });
  row("velocity sweep", 5, [] {
    VelocitySweepOptions options;
    options.speeds_rad_per_s = {20.0};
    options.run_s = 1.0;
    options.bins = 36;
    return std::make_shared<VelocitySweep>(options);
  });
  row("breakaway sweep", 6, [] { return std::make_shared<BreakawaySweep>(quickBreakaways()); });
  row("slow turns", 3, [] {
    SlowTurnsOptions options;
    options.speeds_rad_per_s = {3.0};
    return std::make_shared<SlowTurns>(options);
  });
  row("course", 4, [] { return std::make_shared<Course>(moves()); });
}

void TestLease::hostThatIsLost_stopsTheBoardInEveryState() {
  QFETCH(Make, make);
  QFETCH(int, states);
  constexpr std::array<int, 3> moments{1, 60, 700};  // ticks since the state began
  const size_t tried = sanitized ? 1 : moments.size();
  Host host(make());
  std::map<std::string, int> lasted;  // the longest that each state has lasted, ticks
  std::string state;
  int since = 0, losses = 0;
  for (int tick = 0; tick < 600000; ++tick) {
    host.tick();
    if (!host.runs()) break;
    const std::string now = host.state();
    since = now == state ? since + 1 : 0;
    state = now;
    int& longest = lasted[state];
    if (since <= longest && since > 0) continue;
    longest = since;
    const auto last = moments.begin() + static_cast<std::ptrdiff_t>(tried);
    if (std::find(moments.begin(), last, since) == last) continue;
    for (const auto loss : {Host::Loss::frozen, Host::Loss::killed, Host::Loss::pulledCable}) {
      const std::string wrong = outcomeOf(host, loss);
      ++losses;
      QVERIFY2(wrong.empty(), qPrintable(QString("%1 ticks into \"%2\", loss %3: %4")
                                             .arg(since)
                                             .arg(QString::fromStdString(state))
                                             .arg(static_cast<int>(loss))
                                             .arg(QString::fromStdString(wrong))));
    }
  }
  QVERIFY2(host.failure().empty(), host.failure().c_str());
  QVERIFY(!host.runs());
  qInfo("%zu states, lost %d times", lasted.size(), losses);
  QVERIFY2(static_cast<int>(lasted.size()) >= states, qPrintable(QString::number(lasted.size())));
  QVERIFY2(losses >= 3 * states, qPrintable(QString::number(losses)));
}

QTEST_APPLESS_MAIN(TestLease)
#include "tst_lease.moc"
