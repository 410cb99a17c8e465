#include <QTest>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "experiment/abilities.h"
#include "experiment/profile.h"
#include "experiment/velocity_step.h"
#include "firmware_link/transport/open_board.h"
#include "house/program.h"
#include "plant/rig.h"
#include "support/temporary.h"
#include "support/vesc_fake.h"

using namespace breakaway;
using namespace breakaway::test;
using namespace std::chrono_literals;

namespace {

Rig servo() {
  const auto rig = readRig(qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/presets/servo.rig.json");
  if (!rig) qFatal("%s", rig.error().message().c_str());
  return *rig;
}

std::string address(const VescFake& fake, const std::string& options = "?pole_pairs=7&counts_per_rev=14400") {
  return "vesc:serial:" + fake.path() + options;  // nobody else is asked, which saves half a second each time
}

/// Drives for a while; the samples that came, and how many didn't.
struct Driven {
  std::vector<Sample> samples;
  size_t lost = 0;
  std::string error;
};
Driven drive(Drive& board, double duration_s) {
  Driven driven;
  for (double done_s = 0.0; done_s < duration_s - 1e-9; done_s += 0.05) {
    const auto lost = board.advance(0.05, driven.samples);
    if (!lost) {
      driven.error = lost.error().message();
      break;
    }
    driven.lost += *lost;
  }
  return driven;
}

/// Mean speed by the angle over the second half.
double speedOf(const std::vector<Sample>& samples) {
  const Sample &first = samples[samples.size() / 2], &last = samples.back();
  return (last.angle_rad - first.angle_rad) / (last.time_s - first.time_s);
}

bool releasesWithin(const VescFake& fake, std::chrono::milliseconds most) {
  const auto end = std::chrono::steady_clock::now() + most;
  while (std::chrono::steady_clock::now() < end) {
    if (!fake.powered()) return true;
    std::this_thread::sleep_for(1ms);
  }
  return false;
}

}  // namespace

class TestVescDrive : public QObject {
  Q_OBJECT
 private slots:
  void identity_saysWhoItIs_andWhatItCannotDo();
  void withoutPolePairs_isRefusedInOneLine();
  void silentBoard_isNoDrive();
  void wrongOption_isNamed();
  void values_followTheRotor();
  void withoutEncoder_theCommutationIsTheAngle();
  void oldFirmware_isAskedForAllValues();
  void current_isCommandedAndHeldWithinTheLimit();
  void velocityStep_runsToItsEnd();
  void stop_releasesAtOnce_andStaysReleased();
  void position_isReached();
  void fault_endsWhatRuns_inWords();
  void whenWeDie_itsTimeOutStopsTheMotor();
  void heldUp_theMotorIsStopped_andSaysSo();
  void overSpeed_endsWhatRuns();
  void keptAlive_itTurnsOn();
  void otherBytes_areSkipped();
  void silence_endsInOneLine_andLostSamplesAreCounted();
  void commission_isRefusedInOneLine_andProfilesAreSaved();
  void hangUp_isNamed_andConnectingAgainDoesNotMoveTheMotor();
};

void TestVescDrive::identity_saysWhoItIs_andWhatItCannotDo() {
  const VescFake fake(servo());
  const auto board = openBoard({"serial:" + fake.path() + "?pole_pairs=7&counts_per_rev=14400"});
  VERIFY_OK(board);
  const Identity& identity = (*board)->identity();
  QCOMPARE(identity.device, std::string("VESC 60_MK5 01020304"));
  QCOMPARE(identity.firmware, std::string("VESC 6.05"));
  QVERIFY2(identity.serialNumber.starts_with("01020304") && identity.serialNumber.size() == 24,
           identity.serialNumber.c_str());
  QCOMPARE(identity.supply_V, servo().bridge.supply_V);
  QCOMPARE(identity.countsPerRev, 14400.0);
  QVERIFY(!identity.simulated && !identity.hasIndex);
  QVERIFY2(identity.loopRate_Hz >= 10.0 && identity.loopRate_Hz <= 500.0,
           qPrintable(QString::number(identity.loopRate_Hz)));
  QCOMPARE(obstacleTo(Task::homing, identity), std::string("the board reports no index: homing needs one"));
  for (const Task task : {Task::identification, Task::sweep, Task::tuning, Task::compensation, Task::commissioning})
    QVERIFY(!obstacleTo(task, identity).empty());
  VERIFY_ERROR((*board)->compensate({}), "board: takes no friction compensation");
  ControllerSettings wanted = (*board)->settings();
  wanted.velocity_kp_A_s_per_rad = 0.5;
  wanted.current_limit_A = 3.0;
  const auto accepted = (*board)->configure(wanted);
  VERIFY_OK(accepted);
  QCOMPARE(accepted->velocity_kp_A_s_per_rad, 0.0);  // its gains are its own
  QCOMPARE(accepted->current_limit_A, 3.0);
  const auto ranges = (*board)->settingRanges();
  QCOMPARE(std::count_if(ranges.begin(), ranges.end(), [](const SettingRange& one) { return one.offered; }), 2);
}

void TestVescDrive::withoutPolePairs_isRefusedInOneLine() {
  const VescFake fake(servo());
  VERIFY_ERROR(openBoard({address(fake, "")}),
               "VESC 60_MK5 01020304: tells electrical speed only, so the motor's pole pairs are needed: ?pole_pairs=N "
               "behind the address, or motor.pole_pairs in the bench file");
  BoardRequest request{address(fake, "")};
  request.polePairs = 7;  // from the bench file
  VERIFY_OK(openBoard(request));
}

void TestVescDrive::silentBoard_isNoDrive() {
  const Pty pty;
  VERIFY_ERROR(
      openBoard({"serial:" + pty.path()}),
      "serial port " + pty.path() +
          ": nothing answers as a board: neither Breakaway's firmware nor a VESC; check that it has power, that "
          "this is its port, and the baud rate (115200)");
}

void TestVescDrive::wrongOption_isNamed() {
  VERIFY_ERROR(openBoard({"serial:ttyACM0?pole_pairs=seven"}),
               "board serial:ttyACM0?pole_pairs=seven: has pole_pairs=\"seven\", expected a positive number");
  VERIFY_ERROR(openBoard({"serial:ttyACM0?poles=7"}),
               "board serial:ttyACM0?poles=7: knows no option \"poles\", expected pole_pairs, counts_per_rev or "
               "current_limit_A");
  VERIFY_ERROR(openBoard({"usb:7"}),
               "board usb:7: is no known board, expected simulated, serial:PORT[@BAUD] or tcp:HOST:PORT");
  VERIFY_ERROR(openBoard({"vesc:simulated"}),
               "board vesc:simulated: is no known board, expected simulated, serial:PORT[@BAUD] or tcp:HOST:PORT");
}

void TestVescDrive::values_followTheRotor() {
  const VescFake fake(servo());
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  (*board)->command({Command::Mode::velocity, 30.0, 0.0, false});
  const Driven driven = drive(**board, 0.8);
  QVERIFY2(driven.error.empty(), driven.error.c_str());
  QVERIFY(driven.samples.size() >= 4);  // ten times a second at least, on the busiest machine
  for (size_t k = 1; k < driven.samples.size(); ++k) QVERIFY(driven.samples[k].time_s > driven.samples[k - 1].time_s);
  const Sample& last = driven.samples.back();
  QVERIFY2(std::abs(last.velocity_rad_per_s - fake.velocity_rad_per_s()) < 4.0,
           qPrintable(QString::number(last.velocity_rad_per_s)));
  QVERIFY(last.enabled && last.current_A > 0.1 && last.current_A < 2.0);
  QVERIFY(last.voltage_V > 0.5 && last.voltage_V < 10.0);
  QCOMPARE(last.supply_V, 24.0);
  QCOMPARE(last.velocity_reference_rad_per_s, 30.0);
  const double turns = (last.angle_rad - fake.angle_rad()) / (2.0 * M_PI);
  QVERIFY(std::abs(turns - std::round(turns)) < 0.2);  // the encoder's turn is its own, the angle within it is not
}

void TestVescDrive::withoutEncoder_theCommutationIsTheAngle() {
  const VescFake fake(servo());
  auto board = openBoard({address(fake, "?pole_pairs=7")});
  VERIFY_OK(board);
  QCOMPARE((*board)->identity().countsPerRev, 42.0);
  QVERIFY(!(*board)->identity().can.positions);
  (*board)->command({Command::Mode::velocity, -40.0, 0.0, false});
  const Driven driven = drive(**board, 1.0);
  QVERIFY(driven.samples.back().angle_rad < driven.samples.front().angle_rad - 5.0);
  const double steps = driven.samples.back().angle_rad / (2.0 * M_PI / 42.0);
  QVERIFY(std::abs(steps - std::round(steps)) < 1e-6);
  (*board)->command({Command::Mode::position, 1.0, 0.0, false});
  QVERIFY(releasesWithin(fake, 500ms));
}

void TestVescDrive::oldFirmware_isAskedForAllValues() {
  VescFake fake(servo());
  fake.knowsChoice = false;
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  const Driven driven = drive(**board, 0.3);
  QVERIFY2(driven.error.empty(), driven.error.c_str());
  QVERIFY(driven.samples.size() >= 2);
  QCOMPARE(driven.samples.back().supply_V, 24.0);
}

void TestVescDrive::current_isCommandedAndHeldWithinTheLimit() {
  const VescFake fake(servo());
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  (*board)->command({Command::Mode::current, 1.5, 0.0, false});
  std::vector<Sample> samples;
  VERIFY_OK((*board)->advance(0.05, samples));
  QTRY_VERIFY(!fake.commands().empty() && fake.commands().back() == (std::vector<std::uint8_t>{6, 0, 0, 5, 0xdc}));
  (*board)->command({Command::Mode::current, -100.0, 2.0, false});
  QTRY_COMPARE(fake.commands().back(), (std::vector<std::uint8_t>{6, 0xff, 0xff, 0xf8, 0x30}));  // −2 A
  (*board)->command({Command::Mode::current, 100.0, 0.0, false});
  QTRY_COMPARE(fake.commands().back(), (std::vector<std::uint8_t>{6, 0, 0, 0x13, 0x88}));  // the limit of its own, 5 A
  (*board)->stop("enough");
  QTRY_VERIFY(!fake.powered());
}

void TestVescDrive::velocityStep_runsToItsEnd() {
  const VescFake fake(servo());
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  VelocityStepOptions options;
  options.from_rad_per_s = 15.0;
  options.to_rad_per_s = 35.0;
  options.after_s = 0.8;
  options.before_s = 0.5;
  const auto step = std::make_shared<VelocityStep>(options);
  (*board)->start(step);
  const Driven driven = drive(**board, 1.5);
  QVERIFY2(driven.error.empty(), driven.error.c_str());
  QVERIFY2(step->state() == Procedure::State::finished, step->status().failure.c_str());
  QVERIFY(releasesWithin(fake, 500ms));
  std::vector<Sample> turning;
  for (const Sample& one : driven.samples) {
    if (one.enabled && one.velocity_reference_rad_per_s == 35.0) turning.push_back(one);
  }
  QVERIFY(turning.size() >= 4);
  QVERIFY2(std::abs(speedOf(turning) - 35.0) < 5.0, qPrintable(QString::number(speedOf(turning))));
}

void TestVescDrive::stop_releasesAtOnce_andStaysReleased() {
  const VescFake fake(servo());
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  const auto step = std::make_shared<VelocityStep>();
  (*board)->start(step);
  drive(**board, 0.5);
  QVERIFY(fake.powered());
  (*board)->stop("STOP was pressed");
  QVERIFY(releasesWithin(fake, 500ms));
  QCOMPARE(step->state(), Procedure::State::stopped);
  const Driven after = drive(**board, 0.4);
  QVERIFY(!fake.powered() && !after.samples.empty() && !after.samples.back().enabled);
  size_t stops = 0;
  for (const auto& one : fake.commands()) stops += one == std::vector<std::uint8_t>{6, 0, 0, 0, 0} ? 1 : 0;
  QVERIFY2(stops >= 3, "a stop that got lost would not be said again");
}

void TestVescDrive::position_isReached() {
  const VescFake fake(servo());
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  (*board)->command({Command::Mode::position, 1.0, 0.0, false});
  const Driven driven = drive(**board, 2.0);
  QVERIFY2(driven.error.empty(), driven.error.c_str());
  QVERIFY2(std::abs(std::remainder(driven.samples.back().angle_rad - 1.0, 2.0 * M_PI)) < 0.1,
           qPrintable(QString::number(driven.samples.back().angle_rad)));
}

void TestVescDrive::fault_endsWhatRuns_inWords() {
  VescFake fake(servo());
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  const auto step = std::make_shared<VelocityStep>();
  (*board)->start(step);
  drive(**board, 0.3);
  fake.fault = 2;
  drive(**board, 0.3);
  QCOMPARE(step->state(), Procedure::State::stopped);
  QCOMPARE(step->status().failure,
           std::string("the supply voltage is too low; check the supply and its current limit"));
  fake.fault = 0;
  drive(**board, 0.3);
  QVERIFY(!fake.powered());  // latched
}

void TestVescDrive::whenWeDie_itsTimeOutStopsTheMotor() {
  VescFake fake(servo());
  fake.timeout_s = 0.5;
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  (*board)->command({Command::Mode::velocity, 30.0, 0.0, false});
  drive(**board, 0.2);
  QVERIFY(fake.powered());
  QVERIFY(!releasesWithin(fake, 200ms));  // nobody calls advance(), as if we were dead
  QVERIFY(releasesWithin(fake, 2000ms));
}

void TestVescDrive::heldUp_theMotorIsStopped_andSaysSo() {
  const VescFake fake(servo());
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  const auto step = std::make_shared<VelocityStep>();
  (*board)->start(step);
  drive(**board, 0.2);
  std::this_thread::sleep_for(700ms);
  const Driven driven = drive(**board, 0.1);
  QVERIFY2(driven.error.empty(), driven.error.c_str());
  QVERIFY2(step->status().failure.starts_with("this program was held up for 0."), step->status().failure.c_str());
  QVERIFY(releasesWithin(fake, 500ms));
}

void TestVescDrive::overSpeed_endsWhatRuns() {
  const VescFake fake(servo());
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  ControllerSettings limited = (*board)->settings();
  limited.velocity_limit_rad_per_s = 20.0;
  VERIFY_OK((*board)->configure(limited));
  (*board)->command({Command::Mode::velocity, 100.0, 0.0, false});  // held at the limit
  drive(**board, 0.5);
  QVERIFY(fake.powered());
  (*board)->command({Command::Mode::current, 1.5, 0.0, false});
  QVERIFY2(drive(**board, 0.5).error.empty(), "an over-speed is no lost link");
  QVERIFY(!fake.powered());
}

void TestVescDrive::keptAlive_itTurnsOn() {
  VescFake fake(servo());
  fake.timeout_s = 0.5;
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  (*board)->command({Command::Mode::velocity, 30.0, 0.0, false});
  const Driven driven = drive(**board, 1.0);  // the speed is said once; only signs of life follow
  QVERIFY2(driven.error.empty(), driven.error.c_str());
  QVERIFY(fake.powered());
  size_t speeds = 0, alive = 0;
  for (const auto& one : fake.commands()) {
    speeds += one[0] == 8 ? 1 : 0;
    alive += one[0] == 30 ? 1 : 0;
  }
  QCOMPARE(speeds, size_t(1));
  QVERIFY2(alive >= 3 && alive <= 11, qPrintable(QString::number(alive)));
}

void TestVescDrive::otherBytes_areSkipped() {
  VescFake fake(servo());
  fake.chatters = true;
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  const Driven driven = drive(**board, 0.5);
  QVERIFY2(driven.error.empty(), driven.error.c_str());
  QVERIFY(driven.samples.size() >= 2);
  for (const Sample& one : driven.samples) QCOMPARE(one.supply_V, 24.0);
}

void TestVescDrive::silence_endsInOneLine_andLostSamplesAreCounted() {
  VescFake fake(servo());
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  drive(**board, 0.2);
  const auto step = std::make_shared<VelocityStep>();
  (*board)->start(step);
  fake.mute = true;
  Driven driven = drive(**board, 0.3);
  QVERIFY(driven.error.empty() && driven.lost > 0);
  fake.mute = false;
  driven = drive(**board, 0.2);
  QVERIFY(driven.error.empty() && !driven.samples.empty());
  fake.mute = true;
  driven = drive(**board, 1.0);
  QVERIFY2(QString::fromStdString(driven.error).contains("no answer for 0.5 s"), driven.error.c_str());
  QVERIFY(step->state() == Procedure::State::stopped);
}

void TestVescDrive::commission_isRefusedInOneLine_andProfilesAreSaved() {
  const VescFake fake(servo());
  const TemporaryFolder folder;
  const QString program = builtProgram("breakaway"), board = QString::fromStdString(address(fake));
  const QString here = QString::fromStdString(folder.path());
  const Outcome refused = run(program, {"commission", "--board", board, "--out", "d"}, here);
  QCOMPARE(refused.status, 2);
  QVERIFY2(refused.err.count('\n') == 1 &&
               refused.err.contains("is VESC 60_MK5 01020304, which can't be commissioned: the board reports no index"),
           qPrintable(refused.err));
  QVERIFY(folder.names().isEmpty());
  const Outcome saved = run(program, {"profile", "save", "--board", board, "--profile", "v.profile.json"}, here);
  QVERIFY2(saved.status == 0, qPrintable(saved.err));
  const auto profile = readProfile(folder.path("v.profile.json"));
  VERIFY_OK(profile);
  QCOMPARE(profile->device, std::string("VESC 60_MK5 01020304"));
  QVERIFY(!profile->friction);
}

void TestVescDrive::hangUp_isNamed_andConnectingAgainDoesNotMoveTheMotor() {
  {
    VescFake fake(servo());
    auto board = openBoard({address(fake)});
    VERIFY_OK(board);
    (*board)->command({Command::Mode::velocity, 30.0, 0.0, false});
    drive(**board, 0.2);
    fake.hangUp();
    const Driven driven = drive(**board, 0.5);
    QVERIFY2(QString::fromStdString(driven.error).contains("is gone"), driven.error.c_str());
  }
  const VescFake fake(servo());  // the same board, back again
  auto board = openBoard({address(fake)});
  VERIFY_OK(board);
  drive(**board, 0.4);
  QVERIFY(!fake.powered());
  for (const auto& one : fake.commands()) QCOMPARE(one, (std::vector<std::uint8_t>{6, 0, 0, 0, 0}));
}

QTEST_APPLESS_MAIN(TestVescDrive)
#include "tst_vesc_drive.moc"
