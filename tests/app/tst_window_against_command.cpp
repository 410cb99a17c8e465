// The window makes the command's job: the same rig, options and seed give the same map, averages and bench in both.
#include <QTest>

#include "app/window_support.h"
#include "base/atomic_file.h"
#include "commission/commission.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_board.h"
#include "friction/map_export.h"
#include "session/bench_runs.h"
#include "session/language.h"
#include "support/sanitized.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestWindowAgainstCommand : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void sameRigAndSeed_giveTheSame_data();
  void sameRigAndSeed_giveTheSame();
};

namespace {

constexpr unsigned seed = 5;
constexpr double asFastAsItCan = 1e6;
constexpr int patience_ms = 300'000;

/// A simulated board on which time passes only from a start to the next stop: what either side does meanwhile, and how
/// long it takes, draws nothing from its noise.
class PausedDrive : public Drive {
 public:
  explicit PausedDrive(std::unique_ptr<Drive> board) : board_(std::move(board)) {}

  const Identity& identity() const override { return board_->identity(); }
  ControllerSettings settings() const override { return board_->settings(); }
  Result<ControllerSettings> configure(const ControllerSettings& wanted) override { return board_->configure(wanted); }
  Result<void> compensate(const FrictionCompensation& friction) override { return board_->compensate(friction); }
  Result<void> linearise(const DutyCurve& curve) override { return board_->linearise(curve); }
  Result<FrictionCompensation> compensation() override { return board_->compensation(); }
  void command(const Command& command) override { board_->command(command); }
  void start(std::shared_ptr<Procedure> procedure) override {
    passes_ = true;
    board_->start(std::move(procedure));
  }
  void stop(const Saying& reason) override {
    passes_ = false;
    board_->stop(reason);
  }
  Result<size_t> advance(double duration_s, std::vector<Sample>& samples) override {
    return passes_ ? board_->advance(duration_s, samples) : Result<size_t>(0);
  }

 private:
  std::unique_ptr<Drive> board_;
  bool passes_ = false;
};

std::unique_ptr<Drive> pausedBoard(const std::string& uri) {
  auto board = openDrive(uri, seed);
  if (!board) qFatal("%s", board.error().message().c_str());
  return std::make_unique<PausedDrive>(std::move(*board));
}

SweepSettings quick() {
  SweepSettings sweeps;
  sweeps.bins = 36;
  sweeps.turns = 2;
  sweeps.speedRun_s = 2.0;
  return sweeps;
}

/// As `breakaway commission` does it on a preset.
Commission byCommand(const std::string& uri) {
  const auto bench = readBench(benchFileBeside(*rigFileOf(uri)));
  if (!bench) qFatal("%s", bench.error().message().c_str());
  CommissionOptions options;
  options.bench = *bench;
  options.rig = bench->name;
  options.sweeps = quick();
  options.keepRecordings = false;
  const auto drive = pausedBoard(uri);
  auto done = commission(*drive, options);
  if (!done) qFatal("%s", done.error().message().c_str());
  return std::move(*done);
}

/// As the window does it, button by button.
Commission byWindow(const std::string& uri, const std::vector<RunKind>& buttons) {
  Messages messages;
  Connection connection(messages, {asFastAsItCan, 0.005, 600.0});
  BenchRuns bench(connection, messages);
  connection.adopt(pausedBoard(uri), QString::fromStdString(uri));
  for (const RunKind kind : buttons) {
    bench.make(kind, quick());
    const bool ended =
        QTest::qWaitFor([&] { return connection.run().kind == kind && !connection.run().running(); }, patience_ms);
    if (!ended) qFatal("it doesn't end: %s", qPrintable(connection.stateWords()));
  }
  return bench.known();
}

/// bench.json, map.csv and map.json as text.
std::array<std::string, 3> files(const Commission& known) {
  const TemporaryFolder folder;
  const bool written = writeBench(known.bench, folder.path("bench.json")).ok() &&
                       exportMap(known.map, "csv", folder.path("map.csv")).ok() &&
                       exportMap(known.map, "json", folder.path("map.json")).ok();
  if (!written) qFatal("the files can't be written");
  return {*readFile(folder.path("bench.json")), *readFile(folder.path("map.csv")), *readFile(folder.path("map.json"))};
}

}  // namespace

void TestWindowAgainstCommand::initTestCase() {
  speak(Language::german);  // files stay English
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestWindowAgainstCommand::sameRigAndSeed_giveTheSame_data() {
  QTest::addColumn<QString>("uri");
  QTest::addColumn<QList<int>>("buttons");
  const QList<int> one{static_cast<int>(RunKind::trial)};
  const QList<int> all{static_cast<int>(RunKind::identification), static_cast<int>(RunKind::homing),
                       static_cast<int>(RunKind::velocitySweep), static_cast<int>(RunKind::breakaway),
                       static_cast<int>(RunKind::trial)};
  QTest::newRow("rotor, at one go") << "simulated:servo" << one;
  QTest::newRow("rotor, button by button") << "simulated:servo" << all;
  if (!sanitized) QTest::newRow("linear axis, at one go") << "simulated:linear" << one;
  QTest::newRow("linear axis, button by button") << "simulated:linear" << all;
}

void TestWindowAgainstCommand::sameRigAndSeed_giveTheSame() {
  QFETCH(QString, uri);
  QFETCH(QList<int>, buttons);
  std::vector<RunKind> kinds;
  for (const int button : buttons) kinds.push_back(static_cast<RunKind>(button));
  const Commission command = byCommand(uri.toStdString()), window = byWindow(uri.toStdString(), kinds);

  QVERIFY(window.knows(Known::comparison) && window.tunedForUse);
  QVERIFY(!command.map.bins.empty() && command.coulombAverage_Nm()->value > 0.0);
  QCOMPARE(window.coulombAverage_Nm(), command.coulombAverage_Nm());
  QCOMPARE(window.viscousAverage_Nm_s_per_rad(), command.viscousAverage_Nm_s_per_rad());
  QCOMPARE(window.motor.torqueConstant_Nm_per_A, command.motor.torqueConstant_Nm_per_A);
  QCOMPARE(window.motor.currentGain, command.motor.currentGain);
  QCOMPARE(window.motor.inertia_kg_m2, command.motor.inertia_kg_m2);
  QCOMPARE(window.map.stribeckVelocity_rad_per_s, command.map.stribeckVelocity_rad_per_s);
  QCOMPARE(window.remarks, command.remarks);
  QCOMPARE(window.compensatedRun->with_rad_per_s, command.compensatedRun->with_rad_per_s);
  const auto shown = files(window), written = files(command);
  for (size_t k = 0; k < shown.size(); ++k) QCOMPARE(shown[k], written[k]);
}

JOURNEY_MAIN(TestWindowAgainstCommand)
#include "tst_window_against_command.moc"
