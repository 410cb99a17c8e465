#include <QTest>
#include <cmath>

#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/motion.h"
#include "diagnose/fit/noise_floor.h"
#include "diagnose/fit/parameter_vector.h"
#include "diagnose/fit/window_residual.h"
#include "support/driven_recording.h"
#include "support/known_servo.h"
#include "support/rich_excitation.h"

using namespace breakaway;
using namespace breakaway::test;

/// Derivatives along the linearised motion against those by simulation. They only steer the search for the best
/// parameters, so that directions count.
class TestWindowResidual : public QObject {
  Q_OBJECT
 private slots:
  void linearColumns_pointWhereSimulatedOnesDo_data();
  void linearColumns_pointWhereSimulatedOnesDo();
  void whatRestsAtTheStart_keepsResting();
  void modelThatSticks_hasTheReadingsFloor();
};

namespace {

constexpr double step = 1e-4;
constexpr double leastCosine = 0.8;
constexpr double leastNorm = 0.5, mostNorm = 2.0;  ///< in that of the simulated column

/// Columns that are too small to steer by have no direction to speak of.
constexpr double leastOfLargest = 1e-3;

}  // namespace

void TestWindowResidual::linearColumns_pointWhereSimulatedOnesDo_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"supply_sag", "dead_time", "winding_heating", "cogging", "torque_ripple", "quadratic_drag",
                           "load_dependent_friction", "constant_load", "stribeck", "cogging+stribeck+supply_sag",
                           "transport_delay+load_dependent_friction+cogging", "dead_time+torque_ripple+quadratic_drag"})
    QTest::newRow(name) << QString(name);
}

void TestWindowResidual::linearColumns_pointWhereSimulatedOnesDo() {
  QFETCH(QString, name);
  Model model = servoModel(DriveInput::voltage);
  model.supply_V = 24.0;  // and a typical sag's own supply is another
  for (const QString& one : name.split('+')) {
    const Effect& effect = *findEffect(one.toStdString());
    model.effects.push_back(effectTerm(effect, typicalParameters(effect, richExcitation(DriveInput::voltage))));
  }
  const Recording recording = drivenRecording(model, {.seconds = 2.4, .size = 4.0});
  Track track = *makeTrack(recording, model.axis, model.input, model.supply_V, model.count);
  track.motion = motionOf(track);
  const std::vector<Track> tracks{track};
  const Window window{0, 200, 900};
  const MotionState hidden = hiddenStates(model, tracks, {window}).front();
  WindowResidual residual(tracks.front(), window, {1.0, 1.0});
  residual.fit(model, hidden);
  if (residual.remembers()) QSKIP("takes its derivatives by simulation");
  const ParameterVector parameters(model, Freedom{}, 0.05, 50.0);
  const Eigen::VectorXd x = parameters.start();
  std::vector<Eigen::VectorXd> exact, linear;
  double largest = 0.0;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    Eigen::VectorXd near = x;
    near[k] += step;
    exact.push_back(residual.column(parameters.at(near), hidden, step));
    linear.push_back(residual.linearColumn(parameters.at(near), step));
    largest = std::max(largest, exact.back().norm());
  }
  for (size_t k = 0; k < exact.size(); ++k) {
    if (exact[k].norm() < leastOfLargest * largest) continue;
    const double cosine = exact[k].dot(linear[k]) / (exact[k].norm() * linear[k].norm());
    const double ratio = linear[k].norm() / exact[k].norm();
    const std::string said = parameters.name(static_cast<Eigen::Index>(k)) + ": cosine " + std::to_string(cosine) +
                             ", norm " + std::to_string(ratio);
    QVERIFY2(cosine > leastCosine && ratio > leastNorm && ratio < mostNorm, said.c_str());
  }
}

/// Each fit moves the start on; the least speed would end the rest that friction has grown with.
void TestWindowResidual::whatRestsAtTheStart_keepsResting() {
  const Model model = servoWith(DriveInput::torque, "rising_stiction", {0.008, 0.2, 2.0});
  const Recording recording = drivenRecording(model, {.seconds = 4.0});
  Track track = *makeTrack(recording, model.axis, model.input, model.supply_V, model.count);
  track.motion = motionOf(track);
  const std::vector<Track> tracks{track};
  const Window window{0, 2800, 3400};  // the drive pauses from 2.4 to 3 s
  const MotionState hidden = hiddenStates(model, tracks, {window}).front();
  QVERIFY(hidden.rest_s > 0.2);
  WindowResidual residual(tracks.front(), window, {1.0, 0.0});
  for (int k = 0; k < 4; ++k) {
    residual.fit(model, hidden);
    const double rms =
        residual.residual().head(residual.positions()).norm() / std::sqrt(static_cast<double>(residual.positions()));
    QVERIFY2(rms < 1e-4, qPrintable(QString("%1 rad after fit %2").arg(rms).arg(k + 1)));
  }
}

/// A model with far too much friction rests where the rig moves, and a rotor at rest is read without any error: that
/// is no floor for what moved.
void TestWindowResidual::modelThatSticks_hasTheReadingsFloor() {
  const Model rig = servoModel(DriveInput::torque);
  const Recording recording = drivenRecording(rig, {.seconds = 4.0});
  Track track = *makeTrack(recording, rig.axis, rig.input, rig.supply_V, rig.count);
  track.motion = motionOf(track);
  const std::vector<Track> tracks{track};
  Model stuck = rig;
  for (Parameter& one : stuck.base) {
    if (one.name == motorNames(rig.axis).coulomb) one.value *= 100.0;
  }
  const std::vector<Window> windows = windowsOf(tracks, 0, 0, track.rows(), 0.25);
  QVERIFY(windows.size() > 8);
  QVERIFY(noiseFloor(stuck, tracks, windows, 1) > 0.5 * track.readingNoise());
}

QTEST_APPLESS_MAIN(TestWindowResidual)
#include "tst_window_residual.moc"
