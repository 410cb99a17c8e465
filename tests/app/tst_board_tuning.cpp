// The Tune page's logic without the page: what is known of the motor, the margins' line, tuned settings.
#include <QTest>

#include "session/board_tuning.h"
#include "stability/margins.h"

using namespace breakaway;

class TestBoardTuning : public QObject {
  Q_OBJECT
 private slots:
  void motor_isTheBestKnown();
  void marginLine_saysMarginsAndTheRule();
  void marginLine_saysWhenTheLoopIsUnstable();
  void marginLine_saysWhatIsMissing();
  void tunedSettings_keepTheirMarginsOnTheBoard();
  void knowingLess_tunesSlower();
};

namespace {

Identity board() {
  return {"board", "1", false, 5000.0, 14400.0, 24.0, true};
}

ControllerSettings namePlate() {
  ControllerSettings settings;
  settings.velocity_kp_A_s_per_rad = 0.05;
  settings.velocity_ki_A_per_rad = 0.1;
  settings.observer_cutoff_rad_per_s = 200.0;
  settings.nominal_inertia_kg_m2 = 6e-5;
  settings.nominal_torque_constant_Nm_per_A = 0.07;
  settings.current_limit_A = 4.0;
  settings.velocity_limit_rad_per_s = 100.0;
  return settings;
}

Bench bench() {
  Bench bench;
  bench.motor = {0.07, 0.07, 1.2, 0.0011, 6.3e-5, 2e-5, 0.017};
  return bench;
}

Commission identification() {
  Commission found;
  found.facts.add({Known::motor});
  found.motor.torqueConstant_Nm_per_A = found.motor.backEmfConstant_V_s_per_rad = {0.0702, 1e-4};
  found.motor.resistance_ohm = {1.21, 0.01};
  found.shownResistance_ohm = 1.21;
  found.motor.inductance_H = {0.0011, 1e-5};
  found.motor.inertia_kg_m2 = {6.05e-5, 3e-7};
  found.motor.viscous_Nm_s_per_rad = {2e-5, 1e-6};
  found.noiseRms_A = 0.017;
  return found;
}

}  // namespace

void TestBoardTuning::motor_isTheBestKnown() {
  const KnownMotor plate = knownMotor(namePlate(), {}, {}), file = knownMotor(namePlate(), bench(), {}),
                   found = knownMotor(namePlate(), bench(), identification());
  QCOMPARE(plate.source, QString("name plate"));
  QCOMPARE(file.source, QString("bench file"));
  QCOMPARE(found.source, QString("identified"));
  QCOMPARE(file.values.inertia_kg_m2, 6.3e-5);
  QCOMPARE(found.inertia_kg_m2, identification().motor.inertia_kg_m2);
  QVERIFY(std::abs(plate.inertia_kg_m2.high95() / 6e-5 - 1.3) < 1e-6);
  QVERIFY(std::abs(file.torqueConstant_Nm_per_A.low95() / 0.07 - 0.973) < 1e-6);
}

void TestBoardTuning::marginLine_saysMarginsAndTheRule() {
  const ServoLoop loop = boardLoop(board(), namePlate(), knownMotor(namePlate(), {}, identification()));
  const LoopMargins found = margins(loop);
  const QString line = marginWords(loop);
  QVERIFY2(line.contains(QString("Phase margin %1°").arg(found.phaseMargin_rad * 180.0 / M_PI, 0, 'f', 0)),
           qPrintable(line));
  QVERIFY2(line.contains(QString("gain margin %1").arg(found.gainMargin, 0, 'f', 1)), qPrintable(line));
  QVERIFY2(line.contains("αgT 0.04"), qPrintable(line));
}

void TestBoardTuning::marginLine_saysWhenTheLoopIsUnstable() {
  ControllerSettings settings = namePlate();
  settings.nominal_inertia_kg_m2 *= 8.0;
  QVERIFY(marginWords(boardLoop(board(), settings, knownMotor(settings, {}, identification()))).startsWith("Unstable"));
}

void TestBoardTuning::marginLine_saysWhatIsMissing() {
  Identity identity = board();
  identity.loopRate_Hz = 0.0;
  const QString line = marginWords(boardLoop(identity, namePlate(), knownMotor(namePlate(), bench(), {})));
  QVERIFY2(line.contains("tick_s"), qPrintable(line));
}

void TestBoardTuning::tunedSettings_keepTheirMarginsOnTheBoard() {
  for (const Stiffness stiffness : {Stiffness::soft, Stiffness::medium, Stiffness::stiff}) {
    const KnownMotor motor = knownMotor(namePlate(), {}, identification());
    const auto tuned = tunedSettings(board(), namePlate(), motor, stiffness);
    QVERIFY2(tuned.ok(), tuned.ok() ? "" : tuned.error().message().c_str());
    const LoopMargins found = margins(boardLoop(board(), *tuned, motor));
    QVERIFY(found.stable && found.peakSensitivity <= wantedMargins(stiffness).peakSensitivity);
    QVERIFY(found.peakSensitivity > 0.9 * wantedMargins(stiffness).peakSensitivity);
    QCOMPARE(tuned->velocity_ki_A_per_rad, 0.0);
    QCOMPARE(tuned->current_limit_A, namePlate().current_limit_A);
    QCOMPARE(tuned->velocity_limit_rad_per_s, namePlate().velocity_limit_rad_per_s);
    QCOMPARE(tuned->nominal_inertia_kg_m2, 6.05e-5);
    QVERIFY(tuned->position_kp_A_per_rad > 0.0 && tuned->position_kd_A_s_per_rad > 0.0);
  }
}

void TestBoardTuning::knowingLess_tunesSlower() {
  const auto gain = [](const KnownMotor& motor) {
    const auto tuned = tunedSettings(board(), namePlate(), motor, Stiffness::medium);
    return tuned ? tuned->observer_cutoff_rad_per_s : 0.0;
  };
  const double found = gain(knownMotor(namePlate(), bench(), identification())),
               plate = gain(knownMotor(namePlate(), {}, {}));
  QVERIFY(plate > 20.0 && plate < 0.9 * found);
}

QTEST_APPLESS_MAIN(TestBoardTuning)
#include "tst_board_tuning.moc"
