#include <QTest>
#include <algorithm>
#include <cmath>
#include <map>

#include "diagnose/simulate/model_file.h"
#include "support/driven_recording.h"
#include "support/known_servo.h"
#include "support/rich_excitation.h"
#include "support/temporary.h"
#include "support/within.h"

using namespace breakaway;
using namespace breakaway::test;

/// Effects as a whole simulation shows them: what acts, what the sensors show, and what a restart takes over.
class TestSimulatedEffects : public QObject {
  Q_OBJECT
 private slots:
  void transportDelay_movesTheDriveByWholeRows_data();
  void transportDelay_movesTheDriveByWholeRows();
  void transportDelay_movesTheMotionByWholeRows();
  void commandSaturation_clipsAndRamps();
  void encoderEccentricity_isShownAndTakenBack();
  void encoderEccentricity_isTakenBackAtARestart();
  void currentSensorOffset_isSensedOrTakenFromTheDrive();
  void channelSkew_isSensedOrTakenFromTheDrive();
  void finerRows_converge_data() { effects(); }
  void finerRows_converge();
  void modelFile_keepsTheEffect_data() { effects(); }
  void modelFile_keepsTheEffect();
  void laterMeasurements_changeNothingBeforeTheNextRestart_data() { effects(); }
  void laterMeasurements_changeNothingBeforeTheNextRestart();
  void hiddenState_outlivesARestart();
  void warmWinding_staysWarmOverRestarts();

 private:
  static void effects();
};

namespace {

Track trackOf(const Model& model, const Recording& recording) {
  return *makeTrack(recording, model.axis, model.input, model.supply_V, model.count);
}

double rmsDifference(std::span<const double> a, std::span<const double> b) {
  double squares = 0.0;
  for (size_t k = 0; k < a.size(); ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(squares / static_cast<double>(a.size()));
}

/// The servo with one effect that its drives reach: at its typical size, or where those lie outside the short motion.
Model withOne(const Effect& effect) {
  const std::map<std::string_view, std::vector<double>> within{{"command_saturation", {0.25, 15.0}},
                                                               {"end_stop", {0.05, 0.2, 1.0, 1e-4}},
                                                               {"external_disturbance", {0.004, 0.4, 1.1}}};
  const auto it = within.find(effect.name());
  Model model = servoModel(DriveInput::voltage);
  model.effects = {effectTerm(
      effect, it != within.end() ? it->second : typicalParameters(effect, richExcitation(DriveInput::voltage)))};
  return model;
}

}  // namespace

void TestSimulatedEffects::effects() {
  QTest::addColumn<QString>("name");
  for (const Effect* effect : catalogue())
    QTest::newRow(std::string(effect->name()).c_str()) << QString::fromStdString(std::string(effect->name()));
}

void TestSimulatedEffects::transportDelay_movesTheDriveByWholeRows_data() {
  QTest::addColumn<int>("rows");
  for (const int rows : {1, 2, 7, 40}) QTest::newRow(qPrintable(QString::number(rows))) << rows;
}

void TestSimulatedEffects::transportDelay_movesTheDriveByWholeRows() {
  QFETCH(int, rows);
  const Model model = servoWith(DriveInput::torque, "transport_delay", {1e-3 * rows});
  const Track track = trackOf(model, drivenRecording(model, {.hold_s = 1e-3}));
  for (const size_t from : {size_t(0), size_t(2000)}) {
    const Simulator simulator(model, track, from, 4000);
    for (size_t k = from; k < 4000; ++k) {
      const double commanded = track.input[std::max<size_t>(k, static_cast<size_t>(rows)) - static_cast<size_t>(rows)];
      COMPARE_WITHIN(simulator.input(k), commanded, 1e-11);
    }
  }
}

void TestSimulatedEffects::transportDelay_movesTheMotionByWholeRows() {
  const Model prompt = servoModel(DriveInput::voltage),
              late = servoWith(DriveInput::voltage, "transport_delay", {9e-3});
  std::vector<double> time, volts, zeros(3000, 0.0);
  for (size_t k = 0; k < 3000; ++k) {
    time.push_back(1e-3 * static_cast<double>(k));
    volts.push_back(k < 50 ? 0.0 : mixedDrive(time.back(), 0.3));
  }
  const auto recording = *Recording::seal("r.csv", {{"time_s", time}, {"angle_rad", zeros}, {"voltage_V", volts}});
  const auto before = simulate(prompt, recording, {}), after = simulate(late, recording, {});
  VERIFY_OK(before);
  VERIFY_OK(after);
  double largest = 0.0, shifted = 0.0;
  for (size_t k = 9; k < 3000; ++k) {
    COMPARE_WITHIN(after->position[k], before->position[k - 9], 1e-8);
    largest = std::max(largest, std::abs(before->position[k]));
    shifted = std::max(shifted, std::abs(before->position[k] - after->position[k]));
  }
  QVERIFY2(largest > 1.0 && shifted > 0.05, qPrintable(QString("%1 %2").arg(largest).arg(shifted)));
}

void TestSimulatedEffects::commandSaturation_clipsAndRamps() {
  const double limit = 0.015, slew = 0.9;  // Nm, Nm/s
  const Model model = servoWith(DriveInput::torque, "command_saturation", {limit, slew});
  const Track track = trackOf(model, drivenRecording(model, {}));
  const Simulator simulator(model, track, 0, track.rows() - 1);
  size_t clipped = 0, ramped = 0, free = 0;
  double reached = std::clamp(track.input[0], -limit, limit);  // at the end of the row before
  for (size_t k = 1; k + 1 < track.rows(); ++k) {
    const double u = simulator.input(k), told = std::clamp(track.input[k], -limit, limit);
    // The mean of a course in 1000 parts of a row.
    const double step = slew * (track.time[k + 1] - track.time[k]) / 1000.0;
    double mean = 0.0, now = reached;
    for (int part = 0; part < 1000; ++part) {
      const double next = now + std::clamp(told - now, -step, step);
      mean += 0.5 * (now + next) / 1000.0;
      now = next;
    }
    COMPARE_WITHIN(u, mean, 1e-9);
    reached = now;
    ramped += std::abs(now - told) > 1e-9;
    clipped += std::abs(u) >= limit - 1e-12;
    free += std::abs(u - track.input[k]) < 1e-12;
  }
  QVERIFY2(clipped > 200 && ramped > 200 && free > 200,
           qPrintable(QString("%1 %2 %3").arg(clipped).arg(ramped).arg(free)));
}

void TestSimulatedEffects::encoderEccentricity_isShownAndTakenBack() {
  const double A = 0.02, phase = 0.7;
  const Model model = servoWith(DriveInput::torque, "encoder_eccentricity", {A, phase});
  const Track track = trackOf(model, drivenRecording(model, {.seconds = 1.0}));
  const Simulator simulator(model, track, 0, track.rows() - 1);
  for (double angle = -7.0; angle < 7.0; angle += 0.1) {
    COMPARE_WITHIN(simulator.shown(angle), angle + A * std::cos(angle - phase), 1e-15);
    COMPARE_WITHIN(simulator.truePosition(simulator.shown(angle)), angle, 2.0 * A * A * A);
  }
}

void TestSimulatedEffects::encoderEccentricity_isTakenBackAtARestart() {
  const Model model = servoWith(DriveInput::voltage, "encoder_eccentricity", {0.05, 0.7}),
              blind = servoModel(DriveInput::voltage);
  const Recording recording = drivenRecording(model, {.size = 1.5});
  const auto truth = simulate(model, recording, {}), restarted = simulate(model, recording, {.restartEvery_s = 0.5}),
             wrong = simulate(blind, recording, {.restartEvery_s = 0.5});
  VERIFY_OK(truth);
  VERIFY_OK(restarted);
  VERIFY_OK(wrong);
  const double own = rmsDifference(restarted->position, recording.channel("angle_rad")),
               without = rmsDifference(wrong->position, recording.channel("angle_rad"));
  QVERIFY2(own < 2e-3 && without > 5.0 * own && without > 5e-3, qPrintable(QString("%1 %2").arg(own).arg(without)));
  QVERIFY(rmsDifference(restarted->velocity, truth->velocity) < 0.1);
}

void TestSimulatedEffects::currentSensorOffset_isSensedOrTakenFromTheDrive() {
  const Model volts = servoWith(DriveInput::voltage, "current_sensor_offset", {0.03}),
              amperes = servoWith(DriveInput::current, "current_sensor_offset", {0.03});
  const Track byVoltage = trackOf(volts, drivenRecording(volts, {.seconds = 1.0})),
              byCurrent = trackOf(amperes, drivenRecording(amperes, {.seconds = 1.0}));
  const Simulator sensing(volts, byVoltage, 0, 999), driving(amperes, byCurrent, 0, 999);
  COMPARE_WITHIN(sensing.sensed(0.4, 25.0), 0.43, 1e-15);
  for (size_t k = 0; k < 999; ++k) {
    QCOMPARE(sensing.input(k), byVoltage.input[k]);
    COMPARE_WITHIN(driving.input(k), byCurrent.input[k] - 0.03, 1e-15);
  }
}

void TestSimulatedEffects::channelSkew_isSensedOrTakenFromTheDrive() {
  const Model volts = servoWith(DriveInput::voltage, "channel_skew", {2e-3}),
              amperes = servoWith(DriveInput::current, "channel_skew", {3e-3});
  const Track byVoltage = trackOf(volts, drivenRecording(volts, {.seconds = 1.0})),
              byCurrent = trackOf(amperes, drivenRecording(amperes, {.seconds = 1.0}));
  const Simulator sensing(volts, byVoltage, 0, 999), driving(amperes, byCurrent, 0, 999);
  COMPARE_WITHIN(sensing.sensed(0.4, 25.0), 0.35, 1e-15);
  for (size_t k = 0; k + 4 < 999; ++k) COMPARE_WITHIN(driving.input(k), byCurrent.input[k + 3], 1e-12);
}

void TestSimulatedEffects::finerRows_converge() {
  QFETCH(QString, name);
  const Model model = withOne(*findEffect(name.toStdString()));
  const auto motion = [&model](double row_s) {
    const Recording recording = drivenRecording(model, {.seconds = 2.4, .row_s = row_s, .current = false});
    std::vector<double> angle;
    const auto all = recording.channel("angle_rad");
    for (size_t k = 0; k < all.size(); k += static_cast<size_t>(std::lround(4e-3 / row_s))) angle.push_back(all[k]);
    return angle;
  };
  const auto truth = motion(6.25e-5);
  const auto [lowest, highest] = std::minmax_element(truth.begin(), truth.end());
  const double travel = *highest - *lowest, coarse = rmsDifference(motion(2e-3), truth),
               fine = rmsDifference(motion(2.5e-4), truth);
  const QString errors = QString("%1 with 2 ms, %2 with 0.25 ms, of %3 rad").arg(coarse).arg(fine).arg(travel);
  QVERIFY2(travel > 0.2, qPrintable(errors));
  QVERIFY2(coarse < 0.05 * travel, qPrintable(errors));
  QVERIFY2(fine < 2e-3 * travel, qPrintable(errors));
  QVERIFY2(fine < 0.6 * coarse + 1e-4 * travel, qPrintable(errors));
}

void TestSimulatedEffects::modelFile_keepsTheEffect() {
  QFETCH(QString, name);
  const TemporaryFolder folder;
  const Model model = withOne(*findEffect(name.toStdString()));
  VERIFY_OK(writeModel(model, folder.path("model.json")));
  const auto back = readModel(folder.path("model.json"));
  VERIFY_OK(back);
  QCOMPARE(back->effects, model.effects);
  const Recording recording = drivenRecording(model, {.seconds = 1.0});
  const auto before = simulate(model, recording, {.restartEvery_s = 0.4}),
             after = simulate(*back, recording, {.restartEvery_s = 0.4});
  VERIFY_OK(before);
  VERIFY_OK(after);
  QCOMPARE(after->position, before->position);
  QCOMPARE(after->current_A, before->current_A);
  // The effect does something: without it the same drive gives another picture.
  const Recording without = drivenRecording(servoModel(DriveInput::voltage), {.seconds = 6.0, .size = 4.0});
  const Recording with = drivenRecording(model, {.seconds = 6.0, .size = 4.0});
  const double difference = rmsDifference(with.channel("angle_rad"), without.channel("angle_rad")) +
                            rmsDifference(with.channel("current_A"), without.channel("current_A"));
  QVERIFY2(difference > 1e-4, qPrintable(QString::number(difference)));
}

void TestSimulatedEffects::laterMeasurements_changeNothingBeforeTheNextRestart() {
  QFETCH(QString, name);
  const Model model = withOne(*findEffect(name.toStdString()));
  const Recording recording = drivenRecording(model, {.seconds = 2.0});
  const auto before = simulate(model, recording, {.restartEvery_s = 0.5});
  VERIFY_OK(before);
  QCOMPARE(before->restarts.size(), size_t(4));
  const size_t used = before->restarts[2], next = before->restarts[3];
  std::vector<Channel> channels = recording.channels();
  for (Channel& one : channels) {
    if (one.name != "angle_rad" && one.name != "current_A") continue;
    for (size_t k = used + 1; k < one.values.size(); ++k)
      one.values[k] += 0.3 + 0.002 * std::sin(7.0 * static_cast<double>(k));
  }
  const auto after = simulate(model, *Recording::seal("tampered.csv", channels), {.restartEvery_s = 0.5});
  VERIFY_OK(after);
  QCOMPARE(after->restarts, before->restarts);
  for (size_t k = 0; k < next; ++k) {
    COMPARE_WITHIN(after->position[k], before->position[k], 1e-12);
    COMPARE_WITHIN(after->current_A[k], before->current_A[k], 1e-11);
  }
  QVERIFY(std::abs(after->position[next] - before->position[next]) > 0.01);  // here it is measured again
}

void TestSimulatedEffects::hiddenState_outlivesARestart() {
  Model model = servoWith(DriveInput::voltage, "compliance", {2e-5, 80.0, 0.05, 0.0});
  model.effects.push_back(effectTerm(*findEffect("winding_heating"), {0.5, 3.0}));
  const Track track = trackOf(model, drivenRecording(model, {.seconds = 1.0}));
  Simulator simulator(model, track, 0, track.rows() - 1);
  MotionState state;
  simulator.run(state, 0, 600);
  const MotionState restarted = simulator.restart(600, state);
  QVERIFY(state.memory[4] > 1e-3);  // what heated the winding, A²: carried over
  QCOMPARE(restarted.memory[4], state.memory[4]);
  // The load is found from the motion: its place relative to the motor, and its speed.
  COMPARE_WITHIN(restarted.memory[0], state.memory[0], 0.02 * std::abs(state.memory[0]) + 1e-4);
  COMPARE_WITHIN(restarted.memory[1], state.memory[1], 0.05 * std::abs(state.memory[1]) + 0.05);
  COMPARE_WITHIN(restarted.position, state.position, 1e-3);
  COMPARE_WITHIN(restarted.velocity, state.velocity, 0.3);
}

void TestSimulatedEffects::warmWinding_staysWarmOverRestarts() {
  const Model model = servoWith(DriveInput::voltage, "winding_heating", {5.0, 2.0});
  const Recording recording = drivenRecording(model, {.size = 1.5});
  const auto free = simulate(model, recording, {}), restarted = simulate(model, recording, {.restartEvery_s = 0.25}),
             cold = simulate(servoModel(DriveInput::voltage), recording, {.restartEvery_s = 0.25});
  VERIFY_OK(free);
  VERIFY_OK(restarted);
  VERIFY_OK(cold);
  const double own = rmsDifference(restarted->position, free->position),
               without = rmsDifference(cold->position, free->position);
  QVERIFY2(own < 0.2 * without, qPrintable(QString("%1 %2").arg(own).arg(without)));
}

QTEST_APPLESS_MAIN(TestSimulatedEffects)
#include "tst_simulated_effects.moc"
