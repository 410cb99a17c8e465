#include <QTest>
#include <cmath>

#include "experiment/current_zeroing.h"
#include "experiment/homing.h"
#include "experiment/profile.h"
#include "firmware_link/board_drive.h"
#include "firmware_link/simulated_board.h"
#include "support/firmware_stream.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestBoardDrive : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void identityAndSettings_comeOverTheWire();
  void serialNumber_isToldByABoardThatHasOne();
  void configure_givesWhatTheBoardAccepted();
  void bandwidths_areTakenWithinTheirRangeAndUsed();
  void advance_givesEveryTickOnceAsTheBoardInProcess();
  void stop_opensTheWindingsAndStays();
  void homing_findsTheIndexAsInProcess();
  void compensation_isWrittenReadBackAndUsed();
  void bridgesCurve_isTakenAndUsed();
  void trip_stopsTheProcedureInWords();
  void positionAfterManyTurns_isHeldToTheCount();
  void silentBoard_isOneLine();
  void unpluggedBoard_stopsTheProcedure();
  void poweringUpAnew_isNoticedAndNotArmed();
};

namespace {

struct Opened {
  std::shared_ptr<FirmwareStream::Far> far;
  std::unique_ptr<Drive> drive;
};

Opened opened(const std::string& preset = "servo") {
  Opened made{std::make_shared<FirmwareStream::Far>(presetRig(preset)), nullptr};
  auto drive = openBoardDrive(std::make_unique<FirmwareStream>(made.far), {});
  if (!drive) qFatal("%s", drive.error().message().c_str());
  made.drive = std::move(*drive);
  return made;
}

std::vector<Sample> advanced(Drive& drive, double duration_s) {
  std::vector<Sample> samples;
  const auto lost = drive.advance(duration_s, samples);
  if (!lost) qFatal("%s", lost.error().message().c_str());
  if (*lost != 0) qFatal("lost %zu samples", *lost);
  return samples;
}

}  // namespace

void TestBoardDrive::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestBoardDrive::identityAndSettings_comeOverTheWire() {
  const auto board = opened();
  const auto inProcess = openDrive("simulated", 1);
  QVERIFY(board.drive->identity().device.find("servo") != std::string::npos);
  QCOMPARE(board.drive->identity().countsPerRev, (*inProcess)->identity().countsPerRev);
  QCOMPARE(board.drive->identity().loopRate_Hz, (*inProcess)->identity().loopRate_Hz);
  QVERIFY(board.drive->identity().hasIndex && board.drive->identity().simulated);
  const ControllerSettings told = board.drive->settings(), own = (*inProcess)->settings();
  QVERIFY(std::abs(told.velocity_kp_A_s_per_rad / own.velocity_kp_A_s_per_rad - 1.0) < 1e-6);
  QVERIFY(std::abs(told.nominal_inertia_kg_m2 / own.nominal_inertia_kg_m2 - 1.0) < 1e-6);
  QVERIFY(std::abs(told.current_limit_A / own.current_limit_A - 1.0) < 1e-6);
}

void TestBoardDrive::serialNumber_isToldByABoardThatHasOne() {
  const auto none = opened();
  QCOMPARE(none.drive->identity().serialNumber, std::string());
  const std::string longest(wire::SerialNumber::length, '7');
  for (const std::string& serial : {std::string("0042"), longest}) {
    const auto far = std::make_shared<FirmwareStream::Far>(presetRig("servo"), 1, serial);
    const auto drive = openBoardDrive(std::make_unique<FirmwareStream>(far), {});
    VERIFY_OK(drive);
    QCOMPARE((*drive)->identity().serialNumber, serial);
    QCOMPARE((*drive)->identity().device, none.drive->identity().device);
    QVERIFY(mayBeSame((*drive)->identity(), none.drive->identity()));  // which doesn't say that it is another one
  }
}

void TestBoardDrive::configure_givesWhatTheBoardAccepted() {
  const auto board = opened();
  ControllerSettings settings = board.drive->settings();
  settings.current_limit_A = 1e6;
  settings.observer_cutoff_rad_per_s = 1e6;
  const auto accepted = board.drive->configure(settings);
  VERIFY_OK(accepted);
  QVERIFY(accepted->current_limit_A < 20.0);
  QCOMPARE(accepted->observer_cutoff_rad_per_s, 2500.0);
  const auto ranges = board.drive->settingRanges();
  QCOMPARE(ranges.size(), profileParameters().size());
  for (size_t k = 0; k < ranges.size(); ++k) {
    const auto setting = profileParameters()[k].value;
    QVERIFY(ranges[k].offered && (*accepted).*setting >= ranges[k].least && (*accepted).*setting <= ranges[k].most);
    if (setting == &ControllerSettings::current_limit_A) QCOMPARE(ranges[k].most, accepted->current_limit_A);
    if (setting == &ControllerSettings::velocity_kp_A_s_per_rad) QVERIFY(std::isinf(ranges[k].most));
  }
  settings.velocity_kp_A_s_per_rad = -1.0;
  VERIFY_ERROR(board.drive->configure(settings), "settings: hold a value that is negative or not finite");
  QCOMPARE(board.drive->settings(), *accepted);
}

/// A faster current loop brings more of the sensor's noise into the voltage, a faster observer more rounding into the
/// speed.
void TestBoardDrive::bandwidths_areTakenWithinTheirRangeAndUsed() {
  const auto board = opened();
  ControllerSettings settings = board.drive->settings();
  QCOMPARE(settings.velocity_bandwidth_rad_per_s, 400.0);
  QCOMPARE(settings.current_bandwidth_rad_per_s, 300.0);
  const auto scatterOf = [](const std::vector<Sample>& samples, double Sample::*what) {
    const auto n = static_cast<double>(samples.size());
    double mean = 0.0, squares = 0.0;
    for (const Sample& one : samples) mean += one.*what / n;
    for (const Sample& one : samples) squares += std::pow(one.*what - mean, 2) / n;
    return std::sqrt(squares);
  };
  const auto scatterWith = [&](const ControllerSettings& wanted, const Command& command, double Sample::*what) {
    if (auto taken = board.drive->configure(wanted); !taken) qFatal("%s", taken.error().message().c_str());
    board.drive->command(command);
    advanced(*board.drive, 1.0);
    return scatterOf(advanced(*board.drive, 0.4), what);
  };
  const Command stands{Command::Mode::current, 0.1, 0.0, false}, turns{Command::Mode::velocity, 20.0, 0.0, false};
  const double usual_V = scatterWith(settings, stands, &Sample::voltage_V);
  settings.current_bandwidth_rad_per_s = 1500.0;
  const double quick_V = scatterWith(settings, stands, &Sample::voltage_V);
  QVERIFY2(quick_V > 2.5 * usual_V && quick_V < 8.0 * usual_V,
           qPrintable(QString("%1 V, then %2 V").arg(usual_V).arg(quick_V)));
  const double usual = scatterWith(settings, turns, &Sample::velocity_rad_per_s);
  settings.current_bandwidth_rad_per_s = 0.0;  // unsaid: stays
  settings.velocity_bandwidth_rad_per_s = 1e6;
  const auto accepted = board.drive->configure(settings);
  VERIFY_OK(accepted);
  QCOMPARE(accepted->current_bandwidth_rad_per_s, 1500.0);
  QVERIFY(std::abs(accepted->velocity_bandwidth_rad_per_s - 5000.0) < 1.0);  // one over the tick
  settings.velocity_bandwidth_rad_per_s = 1600.0;
  const double noisy = scatterWith(settings, turns, &Sample::velocity_rad_per_s);
  QVERIFY2(noisy > 1.5 * usual, qPrintable(QString("%1 rad/s, then %2").arg(usual).arg(noisy)));
  settings.current_bandwidth_rad_per_s = 1e-3;
  const auto least = board.drive->configure(settings);
  VERIFY_OK(least);
  QVERIFY(std::abs(least->current_bandwidth_rad_per_s - 30.0) < 1e-3);
}

void TestBoardDrive::advance_givesEveryTickOnceAsTheBoardInProcess() {
  const auto board = opened();
  const auto inProcess = openDrive("simulated", 1);
  for (Drive* drive : {board.drive.get(), inProcess->get()}) drive->command({Command::Mode::voltage, 2.0, 0.0, false});
  std::vector<Sample> wired, direct;
  for (int k = 0; k < 300; ++k) {
    QVERIFY(board.drive->advance(0.00031, wired).ok());
    QVERIFY((*inProcess)->advance(0.00031, direct).ok());
  }
  QCOMPARE(wired.size(), direct.size());
  for (std::size_t k = 0; k < wired.size(); ++k) {
    QCOMPARE(wired[k].time_s, direct[k].time_s);
    QVERIFY(std::abs(wired[k].angle_rad - direct[k].angle_rad) < 2.5 * 2.0 * M_PI / 14400.0);
    QVERIFY(std::abs(wired[k].current_A - direct[k].current_A) < 0.02);  // the converter's step is 0.0066 A
    QVERIFY(std::abs(wired[k].voltage_V - direct[k].voltage_V) < 0.02);
    QVERIFY(std::abs(wired[k].velocity_rad_per_s - direct[k].velocity_rad_per_s) < 0.5);
    QCOMPARE(wired[k].enabled, direct[k].enabled);
  }
  QVERIFY(wired.back().velocity_rad_per_s > 10.0);
}

void TestBoardDrive::stop_opensTheWindingsAndStays() {
  const auto board = opened();
  board.drive->command({Command::Mode::velocity, 50.0, 0.0, false});
  auto samples = advanced(*board.drive, 1.0);
  QVERIFY(samples.back().enabled && samples.back().velocity_rad_per_s > 40.0);
  board.drive->stop("pressed");
  samples = advanced(*board.drive, 2.0);
  for (const Sample& sample : samples) QVERIFY(!sample.enabled && sample.voltage_V == 0.0);
  board.drive->command({Command::Mode::velocity, 20.0, 0.0, false});
  samples = advanced(*board.drive, 1.0);
  QVERIFY(samples.back().enabled && std::abs(samples.back().velocity_rad_per_s - 20.0) < 2.0);
}

static Estimate homed(Drive& drive, QString& failure) {
  const auto homing = std::make_shared<Homing>();
  drive.start(homing);
  std::vector<Sample> samples;
  while (homing->state() == Procedure::State::running) {
    const auto lost = drive.advance(0.05, samples);
    if (!lost || *lost != 0) break;
    samples.clear();
  }
  failure = QString::fromStdString(homing->status().failure);
  return homing->indexAngle_rad();
}

void TestBoardDrive::homing_findsTheIndexAsInProcess() {
  const auto board = opened();
  const auto inProcess = openDrive("simulated", 1);
  QString wiredFailure, directFailure;
  const Estimate wired = homed(*board.drive, wiredFailure), direct = homed(**inProcess, directFailure);
  QVERIFY2(wiredFailure.isEmpty(), qPrintable(wiredFailure));
  const double count_rad = 2.0 * M_PI / 14400.0;
  QVERIFY2(std::abs(wired.value - direct.value) < 3.0 * count_rad,
           qPrintable(QString("%1 %2").arg(wired.value).arg(direct.value)));
}

void TestBoardDrive::compensation_isWrittenReadBackAndUsed() {
  const auto lost = [](const FrictionCompensation& friction) {
    const auto board = opened();
    const auto taken = board.drive->compensate(friction);
    if (!taken) qFatal("%s", taken.error().message().c_str());
    board.drive->command({Command::Mode::velocity, 60.0, 0.0, false});
    const double before = advanced(*board.drive, 1.0).back().velocity_rad_per_s;
    board.drive->command({Command::Mode::current, 0.0, 0.0, false});
    return before - advanced(*board.drive, 0.1).back().velocity_rad_per_s;
  };
  FrictionCompensation friction;
  friction.coulomb_Nm.fill(std::vector<double>(180, 0.0168));
  friction.viscous_Nm_s_per_rad.fill(std::vector<double>(180, 2.05e-5));
  const double without = lost({}), with = lost(friction);
  QVERIFY(without > 15.0 && without < 60.0);
  QVERIFY(std::abs(with) < 0.3 * without);
  const auto board = opened();
  friction.indexAngle_rad = 100.0;
  VERIFY_OK(board.drive->compensate(friction));
  const auto back = board.drive->compensation();
  VERIFY_OK(back);
  QCOMPARE(back->coulomb_Nm[1].size(), std::size_t(180));
  QVERIFY(std::abs(back->coulomb_Nm[1][179] - 0.0168) < 1e-8);
  QVERIFY(std::abs(back->indexAngle_rad - (100.0 - 15.0 * 2.0 * M_PI)) < 1e-5);
  QVERIFY(back->static_Nm[0].empty() && back->stribeck_rad_per_s == 0.0);
  FrictionCompensation sticking = friction;
  sticking.static_Nm.fill(std::vector<double>(180, 0.022));
  sticking.static_Nm[1][7] = 0.023;
  sticking.stribeck_rad_per_s = 1.5;
  VERIFY_OK(board.drive->compensate(sticking));
  const auto whole = board.drive->compensation();
  VERIFY_OK(whole);
  QVERIFY(whole->static_Nm[0].size() == 180 && std::abs(whole->static_Nm[1][7] - 0.023) < 1e-8);
  QCOMPARE(whole->stribeck_rad_per_s, 1.5);
  VERIFY_OK(board.drive->compensate(friction));
  QVERIFY(board.drive->compensation()->static_Nm[0].empty());
  sticking.static_Nm[0].pop_back();
  VERIFY_ERROR(board.drive->compensate(sticking), "friction compensation: has not as many bins each way");
  FrictionCompensation large = friction, uneven = friction;
  uneven.viscous_Nm_s_per_rad[1].pop_back();
  VERIFY_ERROR(board.drive->compensate(uneven), "friction compensation: has not as many bins each way");
  for (auto* way : {&large.coulomb_Nm, &large.viscous_Nm_s_per_rad}) way->fill(std::vector<double>(257, 1e-5));
  VERIFY_ERROR(board.drive->compensate(large), "friction compensation: has 257 bins, the board holds at most 256");
}

void TestBoardDrive::bridgesCurve_isTakenAndUsed() {
  const auto board = opened();
  const auto asked_V = [&board] {
    board.drive->command({Command::Mode::voltage, 2.4, 0.0, false});
    return advanced(*board.drive, 0.05).back().voltage_V;
  };
  DutyCurve curve;
  for (const auto& [input, output] : {std::pair{0.02, 0.0}, {0.3, 0.2}, {0.7, 0.6}}) {
    DutyPoint& point = curve.points.emplace_back();
    point.input = input;
    point.output.value = output;
  }
  const double step_V = 24.0 * 1.01 / 4800.0;
  QVERIFY(std::abs(asked_V() - 2.4) < step_V);
  VERIFY_OK(board.drive->linearise(curve));
  QVERIFY(std::abs(asked_V() - 24.0 * 0.16) < step_V);
  DutyCurve falls = curve, many = curve;
  falls.points[2].output.value = 0.1;
  VERIFY_ERROR(board.drive->linearise(falls), "bridge's curve: doesn't rise, expected a strictly rising one");
  many.points.resize(17, curve.points.back());
  VERIFY_ERROR(board.drive->linearise(many), "bridge's curve: has 17 points, the board holds at most 16");
  QVERIFY(std::abs(asked_V() - 24.0 * 0.16) < step_V);
  VERIFY_OK(board.drive->linearise({}));
  QVERIFY(std::abs(asked_V() - 2.4) < step_V);
}

void TestBoardDrive::trip_stopsTheProcedureInWords() {
  Rig rig = presetRig("servo");
  RigFault fault;
  fault.kind = FaultKind::supplyDrop;
  fault.start_s = 1.0;
  fault.part = 0.5;
  rig.faults = {fault};
  const auto far = std::make_shared<FirmwareStream::Far>(rig);
  auto drive = openBoardDrive(std::make_unique<FirmwareStream>(far), {});
  VERIFY_OK(drive);
  const auto homing = std::make_shared<Homing>();
  (*drive)->start(homing);
  const auto samples = advanced(**drive, 2.0);
  QCOMPARE(homing->state(), Procedure::State::stopped);
  QCOMPARE(homing->status().failure,
           std::string("the supply dropped to 12.0 V of 24.0 V; check the power supply and its current limit"));
  QVERIFY(!samples.back().enabled);
  QVERIFY(std::any_of(samples.begin(), samples.end(), [](const Sample& sample) { return sample.enabled; }));
}

void TestBoardDrive::positionAfterManyTurns_isHeldToTheCount() {
  const auto board = opened();
  board.drive->command({Command::Mode::velocity, 150.0, 0.0, false});
  double angle_rad = advanced(*board.drive, 30.0).back().angle_rad;
  QVERIFY(angle_rad > 4000.0);
  angle_rad = std::round(angle_rad) + 100.0;
  ControllerSettings settings = board.drive->settings();
  settings.position_ki_A_per_rad_s = 20.0 * settings.position_kp_A_per_rad;
  VERIFY_OK(board.drive->configure(settings));
  board.drive->command({Command::Mode::position, angle_rad, 0.0, false});
  const Sample last = advanced(*board.drive, 5.0).back();
  QVERIFY2(std::abs(last.angle_rad - angle_rad) < 0.01, qPrintable(QString::number(last.angle_rad - angle_rad)));
  QVERIFY(std::abs(last.angle_reference_rad - angle_rad) < 1e-5);
}

void TestBoardDrive::silentBoard_isOneLine() {
  const auto far = std::make_shared<FirmwareStream::Far>(presetRig("servo"));
  far->silent = true;
  const auto drive = openBoardDrive(std::make_unique<FirmwareStream>(far), {.place = "board serial:/dev/ttyX"});
  VERIFY_ERROR(drive,
               "board serial:/dev/ttyX: does not answer (hello, asked 6 times in 1.5 s); check power, cable and port, "
               "and that it is a board of this kind");
}

void TestBoardDrive::unpluggedBoard_stopsTheProcedure() {
  const auto board = opened();
  const auto homing = std::make_shared<Homing>();
  board.drive->start(homing);
  advanced(*board.drive, 0.2);
  board.far->unplugged = true;
  std::vector<Sample> samples;
  VERIFY_ERROR(board.drive->advance(0.1, samples), "board: is gone");
  QCOMPARE(homing->state(), Procedure::State::stopped);
  QVERIFY(!board.drive->advance(0.1, samples).ok());
}

void TestBoardDrive::poweringUpAnew_isNoticedAndNotArmed() {
  const auto board = opened();
  const auto homing = std::make_shared<Homing>();
  board.drive->start(homing);
  advanced(*board.drive, 0.5);
  board.far->powerUpAnew();
  std::vector<Sample> samples;
  const auto lost = board.drive->advance(0.1, samples);
  QVERIFY(!lost.ok());
  QVERIFY2(lost.error().message().find("powered up anew") != std::string::npos, lost.error().message().c_str());
  QCOMPARE(homing->state(), Procedure::State::stopped);
  QVERIFY(!board.far->board->board().acts());
}

QTEST_APPLESS_MAIN(TestBoardDrive)
#include "tst_board_drive.moc"
