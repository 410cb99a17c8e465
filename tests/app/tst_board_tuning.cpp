// The Tune page's logic without the page: what is known of the motor, what settings would make of it, tuned settings.
#include <QTest>
#include <cmath>

#include "session/board_tuning.h"
#include "session/tuning_preview.h"
#include "stability/margins.h"

using namespace breakaway;

class TestBoardTuning : public QObject {
  Q_OBJECT
 private slots:
  void motor_isTheBestKnown();
  void preview_hasMarginsStepAndTheRule();
  void preview_ofThePositionLoopHasItsOwn();
  void preview_ofAnUnstableLoopHasNoStep();
  void preview_saysWhatIsMissing();
  void friction_isTheBestKnown();
  void frictionOfAStep_foretellsTheNextOne();
  void grades_followTheRules();
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

/// To 20 rad/s, and held there by a current, or by as much of that speed as `part` says.
StepResult measuredStep(double current_A, double part = 1.0) {
  StepResult step;
  for (int k = 0; k < 600; ++k) {
    step.curve.time_s.push_back(1e-3 * k);
    step.curve.velocity_rad_per_s.push_back(20.0 * part);
    step.curve.reference_rad_per_s.push_back(20.0);
    step.curve.current_A.push_back(k < 50 ? 1.0 : current_A);
  }
  step.options.to_rad_per_s = 20.0;
  return step;
}

}  // namespace

void TestBoardTuning::motor_isTheBestKnown() {
  const KnownMotor plate = knownMotor(namePlate(), {}, {}), file = knownMotor(namePlate(), bench(), {}),
                   found = knownMotor(namePlate(), bench(), identification());
  QCOMPARE(plate.source, QString("name plate"));
  QCOMPARE(file.source, QString("bench file"));
  QCOMPARE(found.source, QString("identification"));
  QCOMPARE(file.values.inertia_kg_m2, 6.3e-5);
  QCOMPARE(found.inertia_kg_m2, identification().motor.inertia_kg_m2);
  QVERIFY(std::abs(plate.inertia_kg_m2.high95() / 6e-5 - 1.3) < 1e-6);
  QVERIFY(std::abs(file.torqueConstant_Nm_per_A.low95() / 0.07 - 0.973) < 1e-6);
}

void TestBoardTuning::preview_hasMarginsStepAndTheRule() {
  const KnownMotor motor = knownMotor(namePlate(), {}, identification());
  const TuningPreview preview = previewOf({board(), namePlate(), motor, 0.0, {}});
  QVERIFY2(preview.trouble.isEmpty(), qPrintable(preview.trouble));
  QVERIFY(preview.margins.stable);
  QCOMPARE(preview.margins.phaseMargin_rad, margins(boardLoop(board(), namePlate(), motor)).phaseMargin_rad);
  QVERIFY2(std::abs(preview.alphaGT - 0.04) < 0.005, qPrintable(QString::number(preview.alphaGT)));
  const double last_rad_per_s = preview.step.velocity_rad_per_s.back();
  QVERIFY2(std::abs(last_rad_per_s - 20.0) < 1.0, qPrintable(QString::number(last_rad_per_s)));
}

void TestBoardTuning::preview_ofThePositionLoopHasItsOwn() {
  const KnownMotor motor = knownMotor(namePlate(), {}, identification());
  const auto tuned = tunedSettings(board(), namePlate(), motor, Stiffness::medium);
  QVERIFY(tuned.ok());
  constexpr double to_rad = 0.1;
  const TuningPreview preview = previewOf({board(), *tuned, motor, 0.0, {}, ServoMode::position, to_rad});
  QVERIFY2(preview.trouble.isEmpty(), qPrintable(preview.trouble));
  ServoLoop loop = boardLoop(board(), *tuned, motor);
  loop.mode = ServoMode::position;
  QCOMPARE(preview.margins.phaseMargin_rad, margins(loop).phaseMargin_rad);
  const StepCurve& step = preview.step;
  QCOMPARE(step.reference_rad_per_s.front(), 0.0);
  QCOMPARE(step.reference_rad_per_s.back(), to_rad);
  const double first_rad = step.velocity_rad_per_s.front(), last_rad = step.velocity_rad_per_s.back();
  QVERIFY2(std::abs(first_rad) < 1e-3 && std::abs(last_rad - to_rad) < 0.02 * to_rad,
           qPrintable(QString("%1 to %2").arg(first_rad).arg(last_rad)));
  QVERIFY(preview.figures.rise_s > 0.0 && preview.figures.rise_s < 0.3 && preview.figures.overshoot < 0.3);
}

void TestBoardTuning::preview_ofAnUnstableLoopHasNoStep() {
  ControllerSettings settings = namePlate();
  settings.nominal_inertia_kg_m2 *= 8.0;
  const TuningPreview preview = previewOf({board(), settings, knownMotor(settings, {}, identification()), 0.0, {}});
  QVERIFY(!preview.margins.stable && preview.step.time_s.empty());
  QCOMPARE(gradeOfPhase(preview.margins), Grade::trouble);
}

void TestBoardTuning::preview_saysWhatIsMissing() {
  Identity identity = board();
  identity.loopRate_Hz = 0.0;
  const TuningPreview preview = previewOf({identity, namePlate(), knownMotor(namePlate(), bench(), {}), 0.0, {}});
  QVERIFY2(preview.trouble.contains("tick_s"), qPrintable(preview.trouble));
}

void TestBoardTuning::friction_isTheBestKnown() {
  const LoopMotor motor = knownMotor(namePlate(), bench(), {}).values;
  const auto known = [&motor](const std::optional<Bench>& file, const Commission& found,
                              const std::vector<StepResult>& steps) {
    return knownFriction(file, found, steps, motor);
  };
  Commission checked;
  checked.wiring.emplace().breakaway_A = {Estimate{0.4, 0.01}, Estimate{0.3, 0.01}};
  const StepResult step = measuredStep(0.25), early = measuredStep(0.25, 0.4);
  Commission found = identification();
  found.motor.coulomb_Nm = {0.0168, 1e-4};
  QCOMPARE(known({}, {}, {}).source, FrictionSource::none);
  QCOMPARE(known({}, {}, {}).coulomb_Nm, 0.0);
  QCOMPARE(known({}, checked, {}).source, FrictionSource::wiring);
  QCOMPARE(known({}, checked, {}).coulomb_Nm, 0.07 * 0.35);
  QCOMPARE(known(bench(), checked, {}).coulomb_Nm, 0.017);
  QCOMPARE(known(bench(), checked, {step}).source, FrictionSource::step);
  QVERIFY(std::abs(known(bench(), checked, {step}).coulomb_Nm - (0.07 * 0.25 - 2e-5 * 20.0)) < 1e-9);
  QCOMPARE(known(bench(), {}, {early}).source, FrictionSource::benchFile);  // it never came to its speed
  QCOMPARE(known(bench(), found, {step}).coulomb_Nm, 0.0168);
  // A standing shaft bears what its map says, else what the wiring check saw, but never less than a moving one.
  QCOMPARE(known(bench(), found, {}).static_Nm, 0.0168);
  found.wiring = checked.wiring;
  QCOMPARE(known(bench(), found, {}).static_Nm, 0.07 * 0.35);
  found.facts.add({Known::map});
  found.map.bins.resize(1);
  found.map.bins[0].way[0].static_Nm.value = 0.020;
  found.map.bins[0].way[1].static_Nm.value = 0.022;
  QCOMPARE(known(bench(), found, {}).static_Nm, 0.021);
}

/// A board that rubs, of which no friction is known: with what a velocity step showed, the position step is foretold.
void TestBoardTuning::frictionOfAStep_foretellsTheNextOne() {
  constexpr double rubs_Nm = 0.017;
  const KnownMotor motor = knownMotor(namePlate(), bench(), {});
  const auto tuned = tunedSettings(board(), namePlate(), motor, Stiffness::medium);
  QVERIFY(tuned.ok());
  const auto foretold = [&](double friction_Nm, ServoMode mode) {
    return previewOf({board(), *tuned, motor, friction_Nm, {}, mode, 0.1});
  };
  const TuningPreview made = foretold(rubs_Nm, ServoMode::velocity);
  const KnownFriction seen = knownFriction({}, {}, {{made.step, made.figures, {}, *tuned}}, motor.values);
  QVERIFY2(std::abs(seen.coulomb_Nm / rubs_Nm - 1.0) < 0.05, qPrintable(QString::number(seen.coulomb_Nm)));
  const double rise_s = foretold(rubs_Nm, ServoMode::position).figures.settling_s;
  const double withIt_s = foretold(seen.coulomb_Nm, ServoMode::position).figures.settling_s;
  const double without_s = foretold(0.0, ServoMode::position).figures.settling_s;
  QVERIFY2(std::abs(withIt_s / rise_s - 1.0) < 0.1, qPrintable(QString("%1 for %2").arg(withIt_s).arg(rise_s)));
  QVERIFY2(without_s < 0.9 * rise_s, qPrintable(QString("%1 for %2").arg(without_s).arg(rise_s)));
}

void TestBoardTuning::grades_followTheRules() {
  LoopMargins found;
  found.stable = true;
  const auto phase = [&found](double degrees) {
    found.phaseMargin_rad = degrees * M_PI / 180.0;
    return gradeOfPhase(found);
  };
  QVERIFY(phase(46.0) == Grade::good && phase(44.0) == Grade::warning && phase(29.0) == Grade::trouble);
  QVERIFY(gradeOfAlphaGT(0.29) == Grade::good && gradeOfAlphaGT(0.31) == Grade::warning);
  QVERIFY(gradeOfNoise(0.019, 1.0) == Grade::good && gradeOfNoise(0.06, 1.0) == Grade::trouble);
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
