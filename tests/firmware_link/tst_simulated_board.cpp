#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <cmath>

#include "experiment/profile.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/simulated_truth.h"
#include "support/temporary.h"

using namespace breakaway;

class TestSimulatedBoard : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void portsHeaders_reachNoPlant();
  void bareSimulated_isThePresetServo();
  void everyPreset_opensAndHasItsBench();
  void unknownPreset_getsASuggestion();
  void otherUris_areRefused();
  void advance_givesEveryTickOnce();
  void stop_opensTheWindingsAtOnceAndStaysStopped();
  void standingRotor_showsNoMotion();
  void configure_clampsAndRefuses();
  void servosFriction_variesAsPromised();
  void compensation_isCheckedBeforeItIsTaken();
  void compensatedRotor_keepsItsSpeedWithoutCurrentOfItsOwn();
  void compensatedRotor_standsStillWithoutACommand();
  void staticFriction_letsASmallCurrentStartTheRotor();
};

namespace {

std::string source() {
  return qgetenv("BREAKAWAY_SOURCE_DIR").toStdString();
}

std::unique_ptr<Drive> opened(const std::string& uri) {
  auto drive = openDrive(uri, 1);
  if (!drive) qFatal("%s", drive.error().message().c_str());
  return std::move(*drive);
}

/// For what a test's helper needs to go well.
template <typename T>
void orDie(const Result<T>& result) {
  if (!result) qFatal("%s", result.error().message().c_str());
}

/// All headers of the house that `header` includes, directly or not.
void reach(const QString& header, QSet<QString>& reached) {
  if (reached.contains(header)) return;
  reached.insert(header);
  for (const QString& root : {QString("/"), QString("/core/")}) {
    QFile file(QString::fromStdString(source()) + root + header);
    if (!file.open(QIODevice::ReadOnly)) continue;
    static const QRegularExpression include("#include \"([^\"]+)\"");
    for (auto it = include.globalMatch(QString::fromUtf8(file.readAll())); it.hasNext();)
      reach(it.next().captured(1), reached);
  }
}

}  // namespace

void TestSimulatedBoard::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", QByteArray::fromStdString(source() + "/resources"));
}

void TestSimulatedBoard::portsHeaders_reachNoPlant() {
  QSet<QString> reached;
  for (const char* header : {"experiment/drive.h", "firmware_link/simulated_board.h", "firmware_link/presets.h"})
    reach(header, reached);
  for (const QString& procedure :
       QDir(QString::fromStdString(source() + "/core/experiment")).entryList({"*.h", "*.cpp"})) {
    reach("experiment/" + procedure, reached);
  }
  QVERIFY(reached.contains("recording/sample.h") && reached.contains("base/result.h"));
  for (const QString& header : reached) {
    const bool plant = header.startsWith("plant/") || header.contains("simulated_truth");
    QVERIFY2(!plant, qPrintable(header));
  }
  QSet<QString> planted;
  reach("plant/sensors.h", planted);
  QVERIFY(planted.contains("plant/rig.h"));
}

void TestSimulatedBoard::bareSimulated_isThePresetServo() {
  const auto drive = opened("simulated");
  QVERIFY(drive->identity().simulated && drive->identity().hasIndex);
  QCOMPARE(drive->identity().countsPerRev, 14400.0);
  QCOMPARE(drive->identity().loopRate_Hz, 5000.0);
  QVERIFY(!(drive->settings().nominal_torque_constant_Nm_per_A <= 0.0));
}

void TestSimulatedBoard::everyPreset_opensAndHasItsBench() {
  const auto names = presetNames();
  QVERIFY(names.size() >= 2);
  for (const std::string& name : names) {
    QVERIFY2(openDrive("simulated:" + name, 1).ok(), name.c_str());
    QVERIFY2(!benchFileBeside(*rigFileOf("simulated:" + name)).empty(), name.c_str());
  }
}

void TestSimulatedBoard::unknownPreset_getsASuggestion() {
  const auto drive = openDrive("simulated:serwo", 1);
  QVERIFY(!drive.ok());
  QCOMPARE(drive.error().message(),
           std::string("board simulated:serwo: there is no preset serwo, did you mean servo?"));
}

void TestSimulatedBoard::otherUris_areRefused() {
  for (const char* uri : {"", "simulated:", "simulatedx", "serial:/dev/null", "simulated:no/such.rig.json"}) {
    QVERIFY2(!openDrive(uri, 1).ok(), uri);
  }
}

void TestSimulatedBoard::advance_givesEveryTickOnce() {
  const auto drive = opened("simulated");
  std::vector<Sample> samples;
  for (int k = 0; k < 1000; ++k) QVERIFY(drive->advance(0.00031, samples).ok());
  QCOMPARE(samples.size(), size_t{1550});
  for (size_t k = 0; k < samples.size(); ++k)
    QVERIFY(std::abs(samples[k].time_s - static_cast<double>(k) / 5000.0) < 1e-12);
}

void TestSimulatedBoard::stop_opensTheWindingsAtOnceAndStaysStopped() {
  const auto drive = opened("simulated");
  std::vector<Sample> samples;
  drive->command({Command::Mode::velocity, 50.0, 0.0, false});
  QVERIFY(drive->advance(1.0, samples).ok());
  QVERIFY(samples.back().enabled && samples.back().velocity_rad_per_s > 40.0);
  drive->stop("pressed");
  samples.clear();
  QVERIFY(drive->advance(2.0, samples).ok());
  for (const Sample& sample : samples) QVERIFY(!sample.enabled && sample.voltage_V == 0.0);
  QVERIFY(std::abs(samples.back().velocity_rad_per_s) < 0.01);
}

void TestSimulatedBoard::standingRotor_showsNoMotion() {
  const auto drive = opened("simulated");
  std::vector<Sample> samples;
  QVERIFY(drive->advance(2.0, samples).ok());
  drive->command({Command::Mode::voltage, 0.3, 0.0, false});
  QVERIFY(drive->advance(2.0, samples).ok());
  for (const Sample& sample : samples) QCOMPARE(sample.angle_rad, samples.front().angle_rad);
}

void TestSimulatedBoard::configure_clampsAndRefuses() {
  const auto drive = opened("simulated");
  ControllerSettings settings = drive->settings();
  settings.current_limit_A = 1e6;
  settings.observer_cutoff_rad_per_s = 1e6;
  const auto accepted = drive->configure(settings);
  QVERIFY(accepted.ok());
  QVERIFY(accepted->current_limit_A < 20.0);
  QCOMPARE(accepted->observer_cutoff_rad_per_s, 2500.0);
  const auto ranges = drive->settingRanges();
  QCOMPARE(ranges.size(), profileParameters().size());
  for (size_t k = 0; k < ranges.size(); ++k) {
    const double value = (*accepted).*profileParameters()[k].value;
    QVERIFY(ranges[k].offered && value >= ranges[k].least && value <= ranges[k].most);
    if (profileParameters()[k].value == &ControllerSettings::current_limit_A) QCOMPARE(ranges[k].most, value);
  }
  settings.velocity_kp_A_s_per_rad = -1.0;
  QVERIFY(!drive->configure(settings).ok());
  QCOMPARE(drive->settings(), *accepted);
}

void TestSimulatedBoard::servosFriction_variesAsPromised() {
  const auto truth = trueMap("simulated", 360, 10.0);
  QVERIFY(truth.ok());
  for (size_t way = 0; way < 2; ++way) {
    double sum = 0.0, squares = 0.0;
    for (const MapBin& bin : truth->bins) sum += bin.way[way].static_Nm.value / 360.0;
    for (const MapBin& bin : truth->bins) squares += std::pow(bin.way[way].static_Nm.value - sum, 2) / 360.0;
    const double relative = std::sqrt(squares) / sum;
    QVERIFY2(relative >= 0.10 && relative < 0.3, qPrintable(QString::number(relative)));
  }
}

void TestSimulatedBoard::compensation_isCheckedBeforeItIsTaken() {
  const auto drive = opened("simulated");
  FrictionCompensation friction;
  for (auto* way : {&friction.coulomb_Nm, &friction.viscous_Nm_s_per_rad}) way->fill(std::vector<double>(180, 1e-5));
  VERIFY_OK(drive->compensate(friction));
  VERIFY_OK(drive->compensate({}));
  FrictionCompensation uneven = friction, large = friction, broken = friction;
  uneven.viscous_Nm_s_per_rad[1].pop_back();
  VERIFY_ERROR(drive->compensate(uneven), "friction compensation: has not as many bins each way");
  for (auto* way : {&large.coulomb_Nm, &large.viscous_Nm_s_per_rad}) way->fill(std::vector<double>(257, 1e-5));
  VERIFY_ERROR(drive->compensate(large), "friction compensation: has 257 bins, the board holds at most 256");
  broken.coulomb_Nm[0][3] = std::nan("");
  VERIFY_ERROR(drive->compensate(broken), "friction compensation: holds a value that is negative or not finite");
  FrictionCompensation halfStatic = friction;
  halfStatic.static_Nm[0].assign(180, 1e-5);
  VERIFY_ERROR(drive->compensate(halfStatic), "friction compensation: has not as many bins each way");
  broken = friction;
  broken.stribeck_rad_per_s = -1.0;
  VERIFY_ERROR(drive->compensate(broken), "friction compensation: holds a value that is negative or not finite");
  broken = friction;
  broken.cutoff_rad_per_s = -1.0;
  VERIFY_ERROR(drive->compensate(broken), "friction compensation: holds a value that is negative or not finite");
}

/// Speed lost in 0.1 s of current mode without a current of its own, from 60 rad/s.
static double lostSpeed(const FrictionCompensation& friction) {
  const auto drive = opened("simulated");
  orDie(drive->compensate(friction));
  std::vector<Sample> samples;
  drive->command({Command::Mode::velocity, 60.0, 0.0, false});
  orDie(drive->advance(1.0, samples));
  const double before = samples.back().velocity_rad_per_s;
  drive->command({Command::Mode::current, 0.0, 0.0, false});
  orDie(drive->advance(0.1, samples));
  return before - samples.back().velocity_rad_per_s;
}

void TestSimulatedBoard::compensatedRotor_keepsItsSpeedWithoutCurrentOfItsOwn() {
  FrictionCompensation friction;
  friction.coulomb_Nm.fill({0.0168});
  friction.viscous_Nm_s_per_rad.fill({2.05e-5});
  const double lost = lostSpeed({}), kept = lostSpeed(friction);
  QVERIFY2(lost > 15.0 && lost < 60.0, qPrintable(QString::number(lost)));
  QVERIFY2(std::abs(kept) < 0.3 * lost, qPrintable(QString::number(kept)));
}

/// The servo's own friction, as if measured without error.
static FrictionCompensation trueFriction(bool withStatic) {
  const auto truth = trueMap("simulated", 180, 10.0);
  FrictionCompensation friction;
  for (size_t way = 0; way < 2; ++way) {
    for (const MapBin& bin : truth->bins) {
      friction.coulomb_Nm[way].push_back(bin.way[way].coulomb_Nm.value);
      friction.viscous_Nm_s_per_rad[way].push_back(bin.way[way].viscous_Nm_s_per_rad.value);
      if (withStatic) friction.static_Nm[way].push_back(bin.way[way].static_Nm.value);
    }
  }
  friction.indexAngle_rad = 1.234;  // the preset's, the encoder counts from power-up
  if (withStatic) friction.stribeck_rad_per_s = 1.5;
  return friction;
}

/// Angle by which the rotor goes within a second of one command after it has turned and come to rest.
static double wayGone(const FrictionCompensation& friction, const Command& command) {
  const auto drive = opened("simulated");
  orDie(drive->compensate(friction));
  std::vector<Sample> samples;
  drive->command({Command::Mode::velocity, 5.0, 0.0, false});
  orDie(drive->advance(0.7, samples));
  drive->command({Command::Mode::off, 0.0, 0.0, true});
  orDie(drive->advance(0.5, samples));
  const double before = samples.back().angle_rad;
  drive->command(command);
  orDie(drive->advance(1.0, samples));
  return samples.back().angle_rad - before;
}

void TestSimulatedBoard::compensatedRotor_standsStillWithoutACommand() {
  const auto friction = trueFriction(true);
  for (const auto mode : {Command::Mode::current, Command::Mode::velocity}) {
    const double gone = wayGone(friction, {mode, 0.0, 0.0, false});
    QVERIFY2(std::abs(gone) < 0.001, qPrintable(QString::number(gone)));  // two counts
  }
}

void TestSimulatedBoard::staticFriction_letsASmallCurrentStartTheRotor() {
  const Command small{Command::Mode::current, 0.04, 0.0, false};  // a sixth of what friction takes
  const double without = wayGone(trueFriction(false), small), with = wayGone(trueFriction(true), small);
  QCOMPARE(without, 0.0);
  QVERIFY2(with > 1.0, qPrintable(QString::number(with)));
}

QTEST_APPLESS_MAIN(TestSimulatedBoard)
#include "tst_simulated_board.moc"
