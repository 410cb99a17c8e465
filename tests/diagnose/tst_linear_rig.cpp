#include <Eigen/Dense>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "base/statistics.h"
#include "diagnose/fit/excitation_seen.h"
#include "diagnose/fit/motion.h"
#include "diagnose/fit/shown_winding.h"
#include "diagnose/screen/linear_rig.h"
#include "support/driven_recording.h"
#include "support/known_servo.h"
#include "support/within.h"

using namespace breakaway;
using namespace breakaway::test;

/// The regression against recordings that the simulator made with known numbers.
class TestLinearRig : public QObject {
  Q_OBJECT
 private slots:
  void base_isRecovered_data();
  void base_isRecovered();
  void electricalSide_isRecovered();
  void backEmfOfAnAxisThatHardlyMoves_isNotKnown();
  void inductance_isOnlyAsSureAsRowsShowIt();
  void effect_isRecoveredWithItsAmplitude_data();
  void effect_isRecoveredWithItsAmplitude();
  void effectThatIsNotThere_hasNoAmplitude_data();
  void effectThatIsNotThere_hasNoAmplitude();
  void everyEffect_givesFiniteColumns_data();
  void everyEffect_givesFiniteColumns();
  void jumpOfTheDrive_isNoBreakaway();
  void rows_belongToTheirWindows();
  void wanderingTorque_isMeasured_data();
  void wanderingTorque_isMeasured();
  void rowsThatAreMissing_areNoWander();
  void wanderThatConceals_isTakenOut();
};

namespace {

/// One recording, prepared as the search has it.
struct Prepared {
  std::vector<Track> tracks;
  std::vector<Window> windows;
};

Prepared prepared(const Model& rig, const DrivenRecording& wanted) {
  Prepared out;
  const Recording recording = drivenRecording(rig, wanted);
  out.tracks.push_back(*makeTrack(recording, rig.axis, rig.input, rig.supply_V, rig.count));
  out.tracks.front().motion = motionOf(out.tracks.front());
  out.windows = windowsOf(out.tracks, 0, 0, out.tracks.front().rows(), 1.0);
  return out;
}

/// Least squares of the response on base and further columns.
Eigen::VectorXd solved(const LinearRig& rig, const Eigen::MatrixXd& more) {
  Eigen::MatrixXd all(rig.base().rows(), rig.base().cols() + more.cols());
  all << rig.base(), more;
  const Eigen::VectorXd scale = all.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  return scale.cwiseProduct((all * scale.asDiagonal()).colPivHouseholderQr().solve(rig.response()));
}

/// A wave's cosine and sine, or one set.
Shape shapeAt(const std::vector<double>& p, bool wave) {
  if (!wave) return {p};
  std::vector<double> cosine = p, sine = p;
  cosine[1] = 0.0;
  sine[1] = 1.5707963267948966;
  return {cosine, sine};
}

void addPlanted() {
  QTest::addColumn<DriveInput>("input");
  QTest::addColumn<QString>("name");
  QTest::addColumn<std::vector<double>>("planted");  // in the catalogue's order
  QTest::addColumn<double>("factor");                // of the size at which the search looks
  QTest::addColumn<double>("size");                  // of the drive
  QTest::addColumn<double>("bound");                 // relative
  struct Planted {
    DriveInput input;
    const char* name;
    std::vector<double> parameters;
    double factor, size, bound;
  };
  using enum DriveInput;
  // Where voltage drives, the inductance is free, too, and takes up some of what comes late or grows with current.
  // Small losses of voltage: the columns take the current that would flow without them, and a breakaway can't tell
  // them from friction. A delayed voltage meets a
  // back-EMF that is not late.
  const std::vector<Planted> all{{torque, "cogging", {0.002, 0.8, 9.0}, 3.0, 0.8, 0.02},
                                 {current, "cogging", {0.002, -2.1, 9.0}, 0.5, 0.8, 0.02},
                                 {voltage, "cogging", {0.002, 0.8, 9.0}, 3.0, 1.0, 0.01},
                                 {torque, "quadratic_drag", {2e-5}, 0.2, 1.5, 0.01},
                                 {voltage, "quadratic_drag", {2e-5}, 4.0, 1.5, 0.04},
                                 {torque, "constant_load", {0.003}, 2.0, 1.5, 0.01},
                                 {current, "load_dependent_friction", {0.15, 0.0}, 0.5, 1.5, 0.01},
                                 {voltage, "dead_time", {0.1, 0.05}, 3.0, 3.0, 0.4},
                                 {voltage, "winding_heating", {0.5, 3.0}, 0.3, 1.5, 0.25},
                                 {torque, "encoder_eccentricity", {0.01, 0.8}, 3.0, 1.5, 0.05},
                                 {voltage, "encoder_eccentricity", {0.01, 0.8}, 3.0, 3.0, 0.05},
                                 {torque, "transport_delay", {3e-3}, 1.0, 1.5, 0.01},
                                 {voltage, "transport_delay", {3e-3}, 1.0, 1.5, 0.08}};
  for (const Planted& one : all) {
    const char* drive = one.input == voltage ? "voltage" : one.input == current ? "current" : "torque";
    QTest::newRow((std::string(one.name) + ", " + drive).c_str())
        << one.input << QString(one.name) << one.parameters << one.factor << one.size << one.bound;
  }
}

double amplitudeFound(const Effect& effect, const LinearRig& rig, const std::vector<double>& planted, double factor) {
  const bool wave = effect.name() == "cogging" || effect.name() == "encoder_eccentricity";
  std::vector<double> looked = planted;
  looked.front() *= factor;
  const Shape shape = shapeAt(looked, wave);
  const Eigen::VectorXd x = solved(rig, rig.columnsOf(effect, shape));
  const std::vector<double> amplitude(x.data() + rig.base().cols(), x.data() + x.size());
  const std::vector<double> found = effect.scaled(shape, amplitude);
  if (!wave) return found.front();
  // The part in phase with what was planted.
  return found[0] * std::cos(found[1] - planted[1]);
}

/// A torque that wanders at random, which the recorded drive says nothing about.
void addWander(Track& track, double rms, double time_s) {
  Random random(3);
  const double keep = std::exp(-1e-3 / time_s);
  double wander = rms * random.normal();
  for (double& one : track.input) {
    one -= wander;
    wander = keep * wander + rms * std::sqrt(1.0 - keep * keep) * random.normal();
  }
}

Eigen::VectorXd leftOf(const LinearRig& rig) {
  return rig.response() - rig.base() * solved(rig, Eigen::MatrixXd(rig.response().size(), 0));
}

}  // namespace

Q_DECLARE_METATYPE(breakaway::DriveInput)

void TestLinearRig::base_isRecovered_data() {
  QTest::addColumn<DriveInput>("input");
  QTest::addColumn<bool>("current");
  QTest::newRow("torque") << DriveInput::torque << false;
  QTest::newRow("current") << DriveInput::current << false;
  QTest::newRow("voltage") << DriveInput::voltage << false;
  QTest::newRow("voltage with current") << DriveInput::voltage << true;
}

void TestLinearRig::base_isRecovered() {
  QFETCH(DriveInput, input);
  QFETCH(bool, current);
  const Model truth = servoModel(input);
  Model believed = truth;
  for (Parameter& one : believed.base) {
    if (one.name == "inertia_kg_m2" || one.name == "viscous_Nm_s_per_rad" || one.name == "coulomb_Nm") one.value *= 1.2;
  }
  const Prepared data = prepared(truth, {.seconds = 12.0, .current = current});
  const LinearRig rig(believed, data.tracks, data.windows);
  const Eigen::VectorXd solution = solved(rig, Eigen::MatrixXd(rig.response().size(), 0));
  const Eigen::VectorXd x = rig.physical(solution);
  const Physics p = voltageDriven();
  // The back-EMF damps, late by L/R: that is the less of inertia.
  const double emf = input == DriveInput::voltage ? p.torqueConstant * p.backEmf / p.resistance : 0.0;
  VERIFY_WITHIN(x[0], p.inertia - emf * p.inductance / p.resistance, 0.01);
  VERIFY_WITHIN(x[1], p.viscous + emf, 0.01);
  VERIFY_WITHIN(x[2], p.coulomb, 0.01);
  const double left = (rig.response() - rig.base() * solution).norm() / rig.response().norm();
  QVERIFY2(left < 5e-3, qPrintable(QString::number(left)));
}

void TestLinearRig::electricalSide_isRecovered() {
  const Model truth = servoModel(DriveInput::voltage);
  const Prepared data = prepared(truth, {.seconds = 12.0});
  const LinearRig rig(truth, data.tracks, data.windows);
  const Eigen::VectorXd x = solved(rig, Eigen::MatrixXd(rig.response().size(), 0));
  const Physics p = voltageDriven();
  VERIFY_WITHIN(x[3], 1.0 / p.resistance, 0.02);
  VERIFY_WITHIN(x[4], -p.backEmf / p.resistance, 0.02);
}

/// Friction that gives like a spring, and a coarse encoder, whose steps are most of the speed that it shows.
void TestLinearRig::backEmfOfAnAxisThatHardlyMoves_isNotKnown() {
  Model truth = servoWith(DriveInput::voltage, "presliding", {0.3, 0.3});
  truth.count = turn_rad / 500.0;
  const auto shown = shownWinding(prepared(truth, {.seconds = 12.0, .size = 0.25}).tracks);
  QVERIFY(shown);
  const double off = std::abs(shown->backEmf.value - voltageDriven().backEmf);
  QVERIFY2(off < 3.0 * shown->backEmf.standardError,
           qPrintable(QString("%1 by %2 V s/rad off").arg(shown->backEmf.value).arg(shown->backEmf.standardError)));
}

/// Of rows much longer than the winding's lag (1 ms) hardly any tells how long that is.
void TestLinearRig::inductance_isOnlyAsSureAsRowsShowIt() {
  const double truth_H = voltageDriven().inductance;
  Model truth = servoModel(DriveInput::voltage);
  truth.count = turn_rad / 4000.0;
  for (const double row_s : {1e-3, 8e-3}) {
    const auto shown = shownWinding(prepared(truth, {.seconds = 12.0, .row_s = row_s, .hold_s = row_s}).tracks);
    QVERIFY(shown);
    const QString said = QString("%1 to %2 H").arg(shown->leastInductance_H).arg(shown->mostInductance_H);
    QVERIFY2(shown->leastInductance_H < 1.3 * truth_H && shown->mostInductance_H > truth_H / 1.3, qPrintable(said));
    QVERIFY2((shown->mostInductance_H > 10.0 * shown->leastInductance_H) == (row_s > 2e-3), qPrintable(said));
  }
}

void TestLinearRig::effect_isRecoveredWithItsAmplitude_data() {
  addPlanted();
}

void TestLinearRig::effect_isRecoveredWithItsAmplitude() {
  QFETCH(DriveInput, input);
  QFETCH(QString, name);
  QFETCH(std::vector<double>, planted);
  QFETCH(double, factor);
  QFETCH(double, size);
  QFETCH(double, bound);
  const Effect& effect = *findEffect(name.toStdString());
  const Model truth = servoWith(input, name.toLatin1().constData(), planted);
  const Prepared data = prepared(truth, {.seconds = 12.0, .size = size});
  const LinearRig rig(servoModel(input), data.tracks, data.windows);
  VERIFY_WITHIN(amplitudeFound(effect, rig, planted, factor), planted.front(), bound);
}

void TestLinearRig::effectThatIsNotThere_hasNoAmplitude_data() {
  addPlanted();
}

void TestLinearRig::effectThatIsNotThere_hasNoAmplitude() {
  QFETCH(DriveInput, input);
  QFETCH(QString, name);
  QFETCH(std::vector<double>, planted);
  QFETCH(double, size);
  const Effect& effect = *findEffect(name.toStdString());
  if (name == "transport_delay") return;  // its size is kept away from zero
  const Prepared data = prepared(servoModel(input), {.seconds = 12.0, .size = size});
  const LinearRig rig(servoModel(input), data.tracks, data.windows);
  COMPARE_WITHIN(amplitudeFound(effect, rig, planted, 1.0), 0.0,
                 (input == DriveInput::voltage ? 0.2 : 0.02) * planted.front());
}

void TestLinearRig::everyEffect_givesFiniteColumns_data() {
  QTest::addColumn<QString>("name");
  for (const Effect* effect : catalogue())
    QTest::newRow(std::string(effect->name()).c_str()) << QString::fromStdString(std::string(effect->name()));
}

void TestLinearRig::everyEffect_givesFiniteColumns() {
  QFETCH(QString, name);
  const Effect& effect = *findEffect(name.toStdString());
  const Model model = servoModel(DriveInput::voltage);
  const Prepared data = prepared(model, {.seconds = 6.0});
  const LinearRig rig(model, data.tracks, data.windows);
  for (const Shape& shape : effect.shapes(excitationOf(data.tracks, model))) {
    const Eigen::MatrixXd columns = rig.columnsOf(effect, shape);
    QCOMPARE(columns.rows(), rig.response().size());
    QCOMPARE(columns.cols(), static_cast<Eigen::Index>(shape.size()));
    QVERIFY(columns.allFinite());
  }
}

/// A coarse encoder shows motion some time after the drive jumped: then the drive is not what began it.
void TestLinearRig::jumpOfTheDrive_isNoBreakaway() {
  Model truth = servoModel(DriveInput::torque);
  truth.count = 2.0 * std::numbers::pi / 100.0;
  const Prepared data = prepared(truth, {.seconds = 24.0, .size = 0.5, .pulses = true});
  const LinearRig rig(truth, data.tracks, data.windows);
  const Eigen::VectorXd x = rig.physical(solved(rig, Eigen::MatrixXd(rig.response().size(), 0)));
  VERIFY_WITHIN(x[0], torqueDriven().inertia, 0.03);
  VERIFY_WITHIN(x[2], torqueDriven().coulomb, 0.03);
}

void TestLinearRig::rows_belongToTheirWindows() {
  const Model model = servoModel(DriveInput::torque);
  const Prepared data = prepared(model, {.seconds = 6.0});
  const LinearRig rig(model, data.tracks, data.windows);
  QCOMPARE(rig.windows(), data.windows.size());
  QCOMPARE(rig.window().size(), static_cast<size_t>(rig.response().size()));
  QCOMPARE(rig.base().rows(), rig.response().size());
  std::vector<size_t> rows(rig.windows(), 0);
  for (const size_t window : rig.window()) ++rows.at(window);
  QVERIFY(*std::max_element(rows.begin(), rows.end()) > 10);
  QVERIFY(rig.samples() >= static_cast<double>(rig.response().size()) && rig.samples() <= 6000.0);
}

void TestLinearRig::wanderingTorque_isMeasured_data() {
  QTest::addColumn<double>("rms");
  QTest::addColumn<double>("time_s");
  QTest::newRow("2 % of the friction, quick") << 2.4e-4 << 0.05;
  QTest::newRow("5 % of the friction, slow") << 6e-4 << 0.5;
}

void TestLinearRig::wanderingTorque_isMeasured() {
  QFETCH(double, rms);
  QFETCH(double, time_s);
  Model truth = servoModel(DriveInput::torque);
  truth.count = 2.0 * std::numbers::pi / 8192.0;
  Prepared data = prepared(truth, {.seconds = 40.0});
  const auto noiseOf = [&] { return LinearRig(truth, data.tracks, data.windows, Torque::wandering).noise(); };
  const TorqueNoise none = noiseOf();
  QVERIFY2(none.rms < 0.2 * rms, qPrintable(QString::number(none.rms)));
  addWander(data.tracks.front(), rms, time_s);
  const TorqueNoise found = noiseOf();
  QVERIFY2(found.rms > 0.5 * rms && found.rms < 2.0 * rms, qPrintable(QString::number(found.rms)));
  // Rows that take it into account are independent of one another.
  const LinearRig rig(truth, data.tracks, data.windows, Torque::wandering);
  const Eigen::VectorXd left = leftOf(rig);
  double products = 0.0;
  for (Eigen::Index r = 0; r + 1 < left.size(); ++r) products += left[r] * left[r + 1];
  const double correlation = products / left.squaredNorm();
  QVERIFY2(std::abs(correlation) < 0.25, qPrintable(QString::number(correlation)));
}

/// The drive changes in every row, so that nobody knows what it did in the missing ones.
void TestLinearRig::rowsThatAreMissing_areNoWander() {
  Model truth = servoModel(DriveInput::torque);
  truth.count = 2.0 * std::numbers::pi / 8192.0;
  const Recording whole = drivenRecording(truth, {.seconds = 40.0, .hold_s = 1e-3});
  std::vector<Channel> kept;
  for (const Channel& channel : whole.channels()) {
    kept.push_back({channel.name, {}});
    for (size_t k = 0; k < whole.rows(); ++k) {
      if (k % 211 != 100) kept.back().values.push_back(channel.values[k]);
    }
  }
  Prepared data;
  data.tracks.push_back(*makeTrack(*Recording::seal("lossy.csv", kept), truth.axis, truth.input, {}, truth.count));
  data.tracks.front().motion = motionOf(data.tracks.front());
  data.windows = windowsOf(data.tracks, 0, 0, data.tracks.front().rows(), 1.0);
  const auto noiseOf = [&] { return LinearRig(truth, data.tracks, data.windows, Torque::wandering).noise(); };
  const double rms = 2.4e-4;
  const TorqueNoise none = noiseOf();
  QVERIFY2(none.rms < 0.2 * rms, qPrintable(QString::number(none.rms)));
  addWander(data.tracks.front(), rms, 0.05);
  const TorqueNoise found = noiseOf();
  QVERIFY2(found.rms > 0.5 * rms && found.rms < 2.0 * rms, qPrintable(QString::number(found.rms)));
}

void TestLinearRig::wanderThatConceals_isTakenOut() {
  const Effect& effect = *findEffect("cogging");
  const std::vector<double> planted{3e-4, 0.8, 9.0};  // 2.5 % of the friction, under a wander of 5 %
  const Model truth = servoWith(DriveInput::torque, "cogging", planted);
  Prepared data = prepared(truth, {.seconds = 12.0, .size = 0.8});
  addWander(data.tracks.front(), 6e-4, 0.1);
  const Model believed = servoModel(DriveInput::torque);
  const LinearRig steady(believed, data.tracks, data.windows);
  const LinearRig rig(believed, data.tracks, data.windows, Torque::wandering);
  const double without = std::abs(amplitudeFound(effect, steady, planted, 1.0) / planted.front() - 1.0);
  const double with = std::abs(amplitudeFound(effect, rig, planted, 1.0) / planted.front() - 1.0);
  QVERIFY2(with < 0.4 && with < 0.25 * without, qPrintable(QString("%1 of %2").arg(with).arg(without)));
}

QTEST_APPLESS_MAIN(TestLinearRig)
#include "tst_linear_rig.moc"
