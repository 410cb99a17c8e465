#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>
#include <cmath>

#include "figures/all_figures.h"
#include "figures/compensation_figures.h"
#include "figures/figure_files.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/simulated_shaft.h"
#include "support/temporary.h"

using namespace breakaway;

class TestFigures : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void everyFigure_isThereOnce();
  void everyFile_isWrittenAndReadsBack();
  void twoWayPulses_errFiveTimesLessWithFAndB();
  void fromStandstill_theMapDoesWhatTheAverageCant();
  void viscousTerm_mattersMoreTheFasterItTurns();
  void coulombAndViscous_areTheRigsOwn();
  void positionStep_arrivesWithoutOvershoot();
  void feedback_holdsTheRamp();
  void measuredMap_beatsTheAverageTwice();
  void evenRotor_gainsLittleFromItsMap();
  void bridge_losesTheRigsDeadZone();
  void currentSensor_showsItsZeroAndItsNoise();
  void currentStep_isTheOneForetold();
  void index_isAtOnePlaceBothWays();
  void constantSpeedOverTime_averagesToTheSweepsLine();
  void methodsAAndB_giveOneTorque();
  void externalTorque_isSeenByTheBoard();
  void externalTorque_movesACompensatedRotorAsOneWithoutFriction();
  void feedback_holdsTheSpeedAgainstATorqueFromOutside();
  void unpushedBoard_showsNoPulse();
  void linearAxis_isNotPushed();
  void breakawayMap_hasBandsAroundTheRigsMean();
  void slowPoles_areDampedAtTheTunedCutoff();
  void fAlone_lagsWhereFAndBLeads();
  void manual_knowsEveryFigure();
  void brokenColumn_isRefused();

 private:
  const BenchFigure& named(const std::string& name) const;
  double number(const std::string& figure, const std::string& name) const;
  std::vector<BenchFigure> figures_;
};

namespace {

AllFiguresOptions coarse() {
  AllFiguresOptions options;
  options.bins = 72;
  options.speedRun_s = 6.0;
  return options;
}

Result<CommissionedBench> commissioned(const std::string& uri, unsigned seed) {
  auto drive = openDrive(uri, seed);
  if (!drive) return drive.error();
  CommissionOptions options;
  options.sweeps.bins = 72;
  options.sweeps.speedRun_s = 6.0;
  options.keepRecordings = false;
  return commissionBench(std::move(*drive), options);
}

}  // namespace

const BenchFigure& TestFigures::named(const std::string& name) const {
  for (const BenchFigure& one : figures_) {
    if (one.name == name) return one;
  }
  qFatal("no figure %s", name.c_str());
}

double TestFigures::number(const std::string& figure, const std::string& name) const {
  for (const auto& [known, value] : named(figure).keyNumbers) {
    if (known == name) return value;
  }
  qFatal("figure %s has no number %s", figure.c_str(), name.c_str());
}

void TestFigures::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
  auto bench = openDrive("simulated:servo", 11), uneven = openDrive("simulated:uneven", 12);
  VERIFY_OK(bench);
  VERIFY_OK(uneven);
  const OpenPushed pushed = [](const ExternalPulse& pulse) {
    return openPushed("simulated:servo", 11, {pulse.torque_Nm, pulse.start_s, pulse.duration_s});
  };
  auto figures = measureFigures(std::move(*bench), std::move(*uneven), pushed, coarse());
  VERIFY_OK(figures);
  figures_ = std::move(*figures);
}

void TestFigures::everyFigure_isThereOnce() {
  QStringList names;
  for (const BenchFigure& one : figures_) {
    names << QString::fromStdString(one.name);
    QVERIFY2(!one.columns.empty() && !one.columns.front().values.empty(), one.name.c_str());
    QVERIFY2(!one.says.empty() && !one.figure.title.empty() && !one.keyNumbers.empty(), one.name.c_str());
  }
  QCOMPARE(names.removeDuplicates(), 0);
  for (const char* name : {"bridge-duty",
                           "current-sensor",
                           "current-step",
                           "index-passes",
                           "constant-velocity-speed",
                           "constant-velocity-torque",
                           "root-locus-slow",
                           "external-torque",
                           "external-torque-response",
                           "external-torque-held",
                           "friction-methods",
                           "breakaway-map",
                           "constant-velocity",
                           "root-locus",
                           "one-pulse",
                           "two-way-pulses-1",
                           "two-way-pulses-2",
                           "two-way-pulses-3",
                           "two-way-pulses-4",
                           "two-way-pulses-error",
                           "position-step",
                           "velocity-ramp",
                           "static-friction-cw",
                           "static-friction-ccw",
                           "viscous-cw",
                           "viscous-ccw",
                           "total-viscous",
                           "overall-friction",
                           "slow-motion"}) {
    QVERIFY2(names.contains(name), name);
  }
}

void TestFigures::everyFile_isWrittenAndReadsBack() {
  test::TemporaryFolder folder;
  VERIFY_OK(writeFigures(figures_, folder.path("out")));
  QFile index(QString::fromStdString(folder.path("out/figures.json")));
  QVERIFY(index.open(QIODevice::ReadOnly));
  const auto listed = QJsonDocument::fromJson(index.readAll()).object()["figures"].toArray();
  QCOMPARE(static_cast<size_t>(listed.size()), figures_.size());
  for (const BenchFigure& one : figures_) {
    const std::string path = folder.path("out/" + one.name);
    const QImage png(QString::fromStdString(path + ".png"));
    QVERIFY2(png.width() > 500 && png.height() > 400, one.name.c_str());
    const auto svg = readFile(path + ".svg"), csv = readFile(path + ".csv");
    QVERIFY(svg.ok() && svg->starts_with("<svg"));
    QVERIFY(csv.ok());
    const auto lines = QString::fromStdString(*csv).split('\n', Qt::SkipEmptyParts);
    QCOMPARE(static_cast<size_t>(lines.size()), one.columns.front().values.size() + 1);
    for (const QString& line : lines.mid(1)) {
      for (const QString& cell : line.split(',')) {
        bool isNumber = false;
        QVERIFY2(std::isfinite(cell.toDouble(&isNumber)) && isNumber, qPrintable(cell));
      }
    }
  }
  // Nothing temporary stays.
  const auto files = QDir(QString::fromStdString(folder.path("out"))).entryList(QDir::Files);
  QCOMPARE(static_cast<size_t>(files.size()), 3 * figures_.size() + 2);
}

void TestFigures::twoWayPulses_errFiveTimesLessWithFAndB() {
  for (const char* figure : {"two-way-pulses-2", "two-way-pulses-3", "two-way-pulses-4"}) {
    const double gain = number(figure, "none_over_f_and_b");
    QVERIFY2(gain > 5.0 && gain < 1000.0, qPrintable(QString::number(gain)));
    const double none = number(figure, "velocity_error_none_rad_per_s");
    const double coulomb = number(figure, "velocity_error_f_rad_per_s");
    QVERIFY2(coulomb < 0.5 * none && coulomb > 0.5, figure);
  }
}

void TestFigures::fromStandstill_theMapDoesWhatTheAverageCant() {
  // Within a turn the rotor's unevenness doesn't average out.
  const double none = number("two-way-pulses-1", "velocity_error_none_rad_per_s");
  const double average = number("two-way-pulses-1", "none_over_f_and_b");
  const double map = none / number("two-way-pulses-1", "velocity_error_map_rad_per_s");
  QVERIFY2(average > 5.0 && average < 12.0, qPrintable(QString::number(average)));
  QVERIFY2(map > 8.0 && map < 100.0, qPrintable(QString::number(map)));
}

void TestFigures::viscousTerm_mattersMoreTheFasterItTurns() {
  const auto& error = columnOf(named("two-way-pulses-error"), "f_rad_per_s");
  QCOMPARE(error.size(), size_t{4});
  QVERIFY(error[1] < error[2] && error[2] < error[3]);
}

void TestFigures::coulombAndViscous_areTheRigsOwn() {
  const auto near = [this](const char* name, double truth, double part) {
    const double value = number("constant-velocity", name);
    return std::abs(value / truth - 1.0) < part && value != truth;
  };
  QVERIFY(near("coulomb_cw_Nm", 0.017, 0.02));
  QVERIFY(near("coulomb_ccw_Nm", 0.0165, 0.02));
  QVERIFY(near("viscous_cw_Nm_s_per_rad", 2.0e-5, 0.08));
  QVERIFY(near("viscous_ccw_Nm_s_per_rad", 2.1e-5, 0.08));
}

void TestFigures::positionStep_arrivesWithoutOvershoot() {
  QVERIFY(number("position-step", "overshoot_deg") < 0.5);
  QVERIFY(std::abs(number("position-step", "error_at_end_deg")) < 0.1);
  const double rise_s = number("position-step", "rise_s");
  QVERIFY2(rise_s > 0.04 && rise_s < 0.2, qPrintable(QString::number(rise_s)));
}

void TestFigures::feedback_holdsTheRamp() {
  const double held = number("velocity-ramp", "with_feedback_error_after_ramp_rad_per_s");
  QVERIFY2(held > 0.005 && held < 0.2, qPrintable(QString::number(held)));
  QVERIFY(number("velocity-ramp", "alone_error_after_ramp_rad_per_s") > 5.0 * held);
}

void TestFigures::measuredMap_beatsTheAverageTwice() {
  const double gain = number("slow-motion", "average_over_map");
  QVERIFY2(gain > 2.0 && gain < 20.0, qPrintable(QString::number(gain)));
}

void TestFigures::evenRotor_gainsLittleFromItsMap() {
  test::TemporaryFolder folder;
  auto text = readFile(qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/presets/servo.rig.json");
  VERIFY_OK(text);
  auto rig = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
  auto friction = rig["friction"].toObject();
  for (const QString& name : friction.keys()) {
    if (!friction[name].isObject()) continue;
    friction[name] = QJsonObject{{"mean", friction[name].toObject()["mean"]}, {"harmonics", QJsonArray()}};
  }
  rig["friction"] = friction;
  rig["position_torque"] = QJsonObject{{"harmonics_Nm", QJsonArray()}};
  const std::string uri = "simulated:" + folder.write("even.rig.json", QJsonDocument(rig).toJson().toStdString());
  auto bench = commissioned(uri, 13);
  VERIFY_OK(bench);
  const auto figure = slowMotionFigure(*bench);
  VERIFY_OK(figure);
  for (const auto& [name, value] : figure->keyNumbers) {
    if (name == "average_over_map") QVERIFY2(value > 0.7 && value < 1.5, qPrintable(QString::number(value)));
  }
}

void TestFigures::bridge_losesTheRigsDeadZone() {
  const double zone = number("bridge-duty", "dead_zone_duty");
  QVERIFY2(std::abs(zone - 0.01) < 0.0005 && zone != 0.01, qPrintable(QString::number(zone)));
  const double off = number("bridge-duty", "rms_off_the_curve_duty");
  QVERIFY2(off > 1e-6 && off < 0.1 * number("bridge-duty", "rms_off_an_ideal_bridge_duty"),
           qPrintable(QString::number(off)));
}

void TestFigures::currentSensor_showsItsZeroAndItsNoise() {
  QVERIFY(std::abs(number("current-sensor", "zero_A") - 0.05) < 0.002);
  // The rig's noise and the converter's step of 6.6 mA.
  const double noise = number("current-sensor", "noise_rms_A");
  QVERIFY2(noise > 0.0165 && noise < 0.018, qPrintable(QString::number(noise)));
  const double gain = number("current-sensor", "gain"), doubt = number("current-sensor", "gain_std");
  QVERIFY(doubt > 0.0 && std::abs(gain - 1.0) < 2.0 * doubt);
  QVERIFY(number("current-sensor", "rms_off_the_line_A") < 0.5 * noise);
}

void TestFigures::currentStep_isTheOneForetold() {
  const double measured_s = number("current-step", "measured_63_s"),
               foretold_s = number("current-step", "foretold_63_s");
  QVERIFY2(std::abs(measured_s - foretold_s) < 1e-4, qPrintable(QString::number(measured_s - foretold_s)));
  QVERIFY2(measured_s > 2e-4 && measured_s < 2e-3, qPrintable(QString::number(measured_s)));
  const double step = number("current-step", "to_A") - number("current-step", "from_A");
  QVERIFY(step > 0.1);
  const double off = number("current-step", "rms_off_the_foretold_A");
  QVERIFY2(off > 1e-4 && off < 0.05 * step, qPrintable(QString::number(off)));
  QVERIFY(std::abs(number("current-step", "error_at_end_A")) < 0.1 * step);
}

void TestFigures::index_isAtOnePlaceBothWays() {
  QCOMPARE(number("index-passes", "passages_cw"), 12.0);
  QCOMPARE(number("index-passes", "passages_ccw"), 12.0);
  QVERIFY(std::abs(number("index-passes", "ways_apart_counts")) < 1.0);
  for (const double place : columnOf(named("index-passes"), "place_counts")) QVERIFY(std::abs(place) < 2.0);
}

void TestFigures::constantSpeedOverTime_averagesToTheSweepsLine() {
  const double line = number("constant-velocity-torque", "line_Nm");
  for (const char* name : {"mean_motor_Nm", "mean_observed_Nm"}) {
    const double torque = number("constant-velocity-torque", name);
    QVERIFY2(std::abs(torque / line - 1.0) < 0.03 && torque != line, name);
  }
  const double speed = number("constant-velocity-speed", "mean_rad_per_s");
  QVERIFY(std::abs(speed / number("constant-velocity-speed", "reference_rad_per_s") - 1.0) < 0.01);
}

void TestFigures::methodsAAndB_giveOneTorque() {
  QVERIFY(number("friction-methods", "torque_rms_Nm") > 0.01);
  QVERIFY(number("friction-methods", "difference_part") < 1e-12);
  const double single = number("friction-methods", "difference_single_precision_part");
  QVERIFY2(single > 1e-9 && single < 1e-4, qPrintable(QString::number(single)));
}

void TestFigures::externalTorque_isSeenByTheBoard() {
  const double pulse = number("external-torque", "pulse_Nm"), seen = number("external-torque", "observed_Nm");
  QVERIFY2(std::abs(seen / pulse - 1.0) < 0.1, qPrintable(QString::number(seen / pulse)));
  QVERIFY(std::abs(number("external-torque", "observed_before_Nm")) < 0.1 * pulse);
}

void TestFigures::externalTorque_movesACompensatedRotorAsOneWithoutFriction() {
  const double none = number("external-torque-response", "velocity_error_none_rad_per_s");
  for (const char* part : {"velocity_error_f_and_b_rad_per_s", "velocity_error_map_rad_per_s"}) {
    const double error = number("external-torque-response", part);
    QVERIFY2(error > 0.05 && error < 0.2 * none, part);
  }
}

void TestFigures::feedback_holdsTheSpeedAgainstATorqueFromOutside() {
  const double held = number("external-torque-held", "with_feedback_at_its_end_rad_per_s");
  const double alone = number("external-torque-held", "alone_at_its_end_rad_per_s");
  QVERIFY2(alone > 5.0 && std::abs(held) < 0.2 * alone, qPrintable(QString::number(held)));
}

void TestFigures::unpushedBoard_showsNoPulse() {
  // The same figures of a board that nobody pushes.
  auto bench = commissioned("simulated:servo", 14);
  VERIFY_OK(bench);
  const OpenPushed unpushed = [](const ExternalPulse&) { return openDrive("simulated:servo", 14); };
  const auto figures = externalTorqueFigures(*bench, unpushed);
  VERIFY_OK(figures);
  for (const auto& [name, value] : figures->front().keyNumbers) {
    if (name == "observed_Nm") QVERIFY2(std::abs(value) < 0.004, qPrintable(QString::number(value)));
  }
}

void TestFigures::linearAxis_isNotPushed() {
  VERIFY_ERROR(openPushed("simulated:linear", 1, {0.01, 1.0, 0.1}),
               "board simulated:linear: moves a linear axis, expected a rotor to be pushed");
}

void TestFigures::breakawayMap_hasBandsAroundTheRigsMean() {
  QVERIFY(std::abs(number("breakaway-map", "mean_cw_Nm") / 0.022 - 1.0) < 0.03);
  QVERIFY(std::abs(number("breakaway-map", "mean_ccw_Nm") / 0.021 - 1.0) < 0.03);
  for (const Curve& curve : named("breakaway-map").figure.curves) {
    QCOMPARE(curve.low.size(), curve.y.size());
    for (size_t k = 0; k < curve.y.size(); ++k) QVERIFY(curve.low[k] < curve.y[k] && curve.y[k] < curve.high[k]);
  }
}

void TestFigures::slowPoles_areDampedAtTheTunedCutoff() {
  QVERIFY(number("root-locus-slow", "slowest_pole_per_s") < -20.0);
  const double damping = number("root-locus-slow", "least_damping");
  QVERIFY2(damping > 0.707 && damping <= 1.0, qPrintable(QString::number(damping)));
}

void TestFigures::fAlone_lagsWhereFAndBLeads() {
  // Without B·ω the rotor is too slow, with it the place's friction makes it too fast: errors of opposite sign.
  QVERIFY(number("two-way-pulses-2", "mean_error_f_rad_per_s") < 0.0);
  QVERIFY(number("two-way-pulses-2", "mean_error_f_and_b_rad_per_s") >
          number("two-way-pulses-2", "mean_error_f_rad_per_s"));
}

void TestFigures::manual_knowsEveryFigure() {
  const auto manual = readFile(qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/help/figures.md");
  VERIFY_OK(manual);
  const auto rows = QString::fromStdString(*manual);
  for (const BenchFigure& one : figures_) {
    const auto name = QString::fromStdString(one.name);
    const bool numbered = name.startsWith("two-way-pulses-") && name != "two-way-pulses-error";
    const bool ccw = name.endsWith("-ccw");  // beside its cw
    QVERIFY2(numbered || ccw || rows.contains("`" + name + "`"), one.name.c_str());
  }
}

void TestFigures::brokenColumn_isRefused() {
  test::TemporaryFolder folder;
  std::vector<BenchFigure> figures{named("one-pulse")};
  figures[0].columns[1].values[4] = std::nan("");
  VERIFY_ERROR(writeFigures(figures, folder.path("out")), "one-pulse: column pulse_A has no number in row 5");
  figures[0].columns[1].values.pop_back();
  QVERIFY(!writeFigures(figures, folder.path("out")).ok());
  QVERIFY(!QDir(QString::fromStdString(folder.path("out"))).exists());
}

QTEST_APPLESS_MAIN(TestFigures)
#include "tst_figures.moc"
