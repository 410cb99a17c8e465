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
  auto figures = measureFigures(std::move(*bench), std::move(*uneven), coarse());
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
  for (const char* name :
       {"constant-velocity", "root-locus", "one-pulse", "two-way-pulses-1", "two-way-pulses-2", "two-way-pulses-3",
        "two-way-pulses-4", "two-way-pulses-error", "position-step", "velocity-ramp", "static-friction-cw",
        "static-friction-ccw", "viscous-cw", "viscous-ccw", "total-viscous", "overall-friction", "slow-motion"}) {
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
