// Models as programs in other languages: run, and held against simulate().
#include <QFile>
#include <QTest>
#include <cmath>

#include "export/exported_models.h"

using namespace breakaway;
using namespace breakaway::test;

class TestExportPrograms : public QObject {
  Q_OBJECT
 private slots:
  void everyEffect_isWrittenOrSaysWhyNot();
  void programs_moveAsTheSimulationDoes_data() { models(); }
  void programs_moveAsTheSimulationDoes();
  void otherTexts_moveAsTheSimulationDoes_data();
  void otherTexts_moveAsTheSimulationDoes();
  void oddPath_staysInTheComment();
  void coasting_isOpenWindings();
  void realRigs_moveInCAsTheSimulationDoes_data();
  void realRigs_moveInCAsTheSimulationDoes();
  void friction_isAFunctionOfAngleSpeedLoadAndTemperature();

 private:
  void models() const;
};

namespace {

/// Rows of what step() takes.
std::string rowsFor(const Model& model, const Drive& drive) {
  const bool supply = model.input == DriveInput::voltage || model.input == DriveInput::duty;
  std::string rows;
  for (size_t k = 0; k < drive.time.size(); ++k) {
    const double dt = k + 1 < drive.time.size() ? drive.time[k + 1] - drive.time[k] : 0.001;
    rows += QString::number(drive.input[k], 'g', 17).toStdString();
    if (model.servo) rows += " 0";
    if (supply) rows += " 24";
    rows += " " + QString::number(dt, 'g', 17).toStdString() + "\n";
  }
  return rows;
}

int inputsOf(const Model& model) {
  const bool supply = model.input == DriveInput::voltage || model.input == DriveInput::duty;
  return 2 + (model.servo ? 1 : 0) + (supply ? 1 : 0);
}

std::string cDriver(const Model& model) {
  const std::string place = model.axis == Axis::rotary ? "angle_rad" : "position_m";
  const std::string speed = model.axis == Axis::rotary ? "velocity_rad_per_s" : "velocity_m_per_s";
  std::string reads, passes;
  for (int k = 0; k < inputsOf(model); ++k) {
    reads += std::string(k > 0 ? " && " : "") + "scanf(\"%lf\", &v[" + std::to_string(k) + "]) == 1";
    passes += ", v[" + std::to_string(k) + "]";
  }
  return "#include <stdio.h>\n#include \"m.h\"\nint main(void) {\n  double v[4];\n  int k;\n"
         "  breakaway_state s = breakaway_start(0.0, 0.0);\n"
         "  for (k = 0; k < 2; ++k) s." +
         place + " -= breakaway_reading(&s);\n  while (" + reads +
         ") {\n    printf(\"%.17g %.17g\\n\", breakaway_reading(&s), s." + speed + ");\n    breakaway_step(&s" +
         passes + ");\n  }\n  return 0;\n}\n";
}

const char* const pythonDriver = R"(
import sys
import m

state = m.start(0.0, 0.0)
place = "angle_rad" if hasattr(state, "angle_rad") else "position_m"
speed = "velocity_rad_per_s" if hasattr(state, "velocity_rad_per_s") else "velocity_m_per_s"
for _ in range(2):
  setattr(state, place, getattr(state, place) - m.reading(state))
for row in open("inputs"):
  print(repr(m.reading(state)), repr(getattr(state, speed)))
  state = m.step(state, *[float(one) for one in row.split()])
)";

/// The furthest that rows of text lie from what the simulation made, as a part of its widest way; -1: not the same
/// rows.
double difference(const QString& text, const std::vector<std::pair<double, double>>& simulated) {
  const QStringList rows = text.split('\n', Qt::SkipEmptyParts);
  if (static_cast<size_t>(rows.size()) != simulated.size()) return -1.0;
  double most = 0.0, way = 0.0, fastest = 0.0;
  for (const auto& [place, speed] : simulated) {
    way = std::max(way, std::abs(place));
    fastest = std::max(fastest, std::abs(speed));
  }
  for (size_t k = 0; k < simulated.size(); ++k) {
    const QStringList words = rows[static_cast<qsizetype>(k)].split(' ');
    most = std::max({most, std::abs(words[0].toDouble() - simulated[k].first) / way,
                     std::abs(words[1].toDouble() - simulated[k].second) / fastest});
  }
  return std::isfinite(most) && way > 0.0 ? most : -1.0;
}

}  // namespace

void TestExportPrograms::models() const {
  QTest::addColumn<QString>("kind");
  QTest::addColumn<QString>("effects");
  const auto row = [](const char* kind, const char* effects) {
    QTest::newRow(qPrintable(QString("%1: %2").arg(kind, effects))) << kind << effects;
  };
  for (const char* kind : {"voltage", "duty", "current", "arm", "linear", "servo", "biased"}) row(kind, "");
  row("current", "constant_load 0.002");
  row("current", "coulomb_asymmetry 0.002");
  row("current", "viscous_asymmetry 1e-5");
  row("voltage", "stribeck 0.004 2 2");
  row("current", "stribeck 0.004 2 1");
  row("linear", "stribeck 1.5 0.02 1.4");
  row("current", "presliding 5 0.3");
  row("voltage", "presliding 5 0.3");
  row("current", "quadratic_drag 1e-7");
  row("current", "position_dependent_friction 0.002 0.4 3");
  row("linear", "position_dependent_friction 0.7 0.4 0.01");
  row("current", "position_dependent_viscous 1e-5 0.3 2");
  row("current", "load_dependent_friction 0.05 0");
  row("arm", "load_dependent_friction 0.05 0.5");
  row("current", "friction_warmup 0.003 1");
  row("voltage", "rising_stiction 0.003 0.1 1");
  row("current", "imbalance 0.003 0.5 1");
  row("voltage", "cogging 0.002 0.7 12");
  row("linear", "cogging 1 0.7 0.02");
  row("voltage", "torque_ripple 0.05 0.2 6");
  row("current", "torque_saturation 0.02");
  row("voltage", "dead_time 0.4 0.1");
  row("duty", "dead_time 0.4 0.1");
  row("current", "current_sensor_offset 0.05");
  row("voltage", "winding_heating 0.05 5");
  row("duty", "supply_sag 0.3 24");
  row("current", "encoder_eccentricity 0.01 0.3");
  row("voltage", "command_saturation 4 500");
  row("current", "backlash 2e-5 0.02 20 0.3");
  row("voltage", "compliance 2e-5 300 0.05 0");
  row("current", "compliance 2e-5 300 0.05 0.003");
  row("current", "end_stop 20 3 1 0.01");
  row("current", "transport_delay 0.0035");
  row("voltage", "transport_delay 0.0035");
  row("voltage",
      "stribeck 0.004 2 2, cogging 0.002 0.7 12, cogging 0.001 0.1 24, dead_time 0.4 0.1, friction_warmup "
      "0.003 1");
  row("current", "stribeck 0.004 2 2, compliance 2e-5 300 0.05 0, viscous_asymmetry 1e-5, transport_delay 0.0035");
  row("linear", "stribeck 1.5 0.02 2, coulomb_asymmetry 0.8, cogging 1 0.7 0.02, load_dependent_friction 0.05 0");
  row("servo", "stribeck 0.02 0.5 2, coulomb_asymmetry 0.004");
}

void TestExportPrograms::everyEffect_isWrittenOrSaysWhyNot() {
  int lacking = 0;
  for (const Effect* effect : catalogue()) {
    const Values some(effect->parameters(Axis::rotary).size(), 0.5);
    const Written written = effect->written(some, Axis::rotary);
    if (!written.lacking.empty()) ++lacking;
    QVERIFY2(written.lacking != "it is not written down", std::string(effect->name()).c_str());
  }
  QCOMPARE(lacking, 2);
}

void TestExportPrograms::programs_moveAsTheSimulationDoes() {
  QFETCH(QString, kind);
  QFETCH(QString, effects);
  double peak = 0.0;
  const Model model = modelOf(kind, effects, peak);
  const Drive drive = driveOf(peak);
  const auto expected = simulated(model, drive);
  const TemporaryFolder folder;
  folder.write("inputs", rowsFor(model, drive));
  folder.write("m.h", exportedAs(model, "c"));
  folder.write("main.c", exportedAs(model, "c") + cDriver(model));  // in a header unused constants go unnoticed
  const QString complaints =
      outputOf(folder, "cc", {"-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "main.c", "-o", "main", "-lm"});
  QVERIFY2(complaints.isEmpty(), qPrintable(complaints));
  const QString said = outputOf(folder, QString::fromStdString(folder.path("main")), {});
  const double inC = difference(said, expected);
  qInfo("C differs by %.2g of the widest way", inC);
  QVERIFY2(inC >= 0.0 && inC < 1e-9, qPrintable(said.left(300)));
  if (python().isEmpty()) QSKIP("there is no python3");
  folder.write("m.py", exportedAs(model, "python"));
  folder.write("main.py", pythonDriver);
  const Drive some = driveOf(peak, 450);
  folder.write("inputs", rowsFor(model, some));
  const QString inPython = outputOf(folder, python(), {"main.py"});
  const double there = difference(inPython, simulated(model, some));
  qInfo("Python differs by %.2g", there);
  QVERIFY2(there >= 0.0 && there < 1e-9, qPrintable(inPython.left(600)));
}

void TestExportPrograms::otherTexts_moveAsTheSimulationDoes_data() {
  QTest::addColumn<QString>("form");
  QTest::addColumn<QString>("kind");
  QTest::addColumn<QString>("effects");
  for (const char* form : {"modelica", "matlab"}) {
    const auto row = [form](const char* kind, const char* effects) {
      QTest::newRow(qPrintable(QString("%1, %2: %3").arg(form, kind, effects))) << form << kind << effects;
    };
    row("voltage", "stribeck 0.004 2 1.5, cogging 0.002 0.7 12, dead_time 0.4 0.1, winding_heating 0.05 5");
    row("current", "presliding 5 0.3, friction_warmup 0.003 1");
    row("linear", "stribeck 1.5 0.02 2, end_stop 2000 0.1 1 10");
    row("current", "compliance 2e-5 300 0.05 0.003, transport_delay 0.0035");
    row("current", "backlash 2e-5 0.02 20 0.3");
    row("voltage", "transport_delay 0.0035");
    row("servo", "stribeck 0.02 0.5 2");
  }
}

void TestExportPrograms::otherTexts_moveAsTheSimulationDoes() {
  if (python().isEmpty()) QSKIP("there is no python3");
  QFETCH(QString, form);
  QFETCH(QString, kind);
  QFETCH(QString, effects);
  double peak = 0.0;
  const Model model = modelOf(kind, effects, peak);
  const Drive drive = driveOf(peak, 700);
  const TemporaryFolder folder;
  folder.write("inputs", rowsFor(model, drive));
  folder.write("m", exportedAs(model, qPrintable(form)));
  const QString reader = qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/tests/export/read_as_python.py";
  const QString said = outputOf(folder, python(), {reader, form, "m", "inputs"});
  const double most = difference(said, simulated(model, drive));
  qInfo("%s differs by %.2g of the widest way", qPrintable(form), most);
  QVERIFY2(most >= 0.0 && most < 1e-9, qPrintable(said.left(600)));
}

void TestExportPrograms::oddPath_staysInTheComment() {
  const Model model = rig("current").model;
  const ModelExportOptions options{.model = "a */ b -->\nint x;\t--.json"};
  const TemporaryFolder folder;
  folder.write("inputs", "");
  folder.write("m.h", exportModel(model, "c", options)->text);
  const QString said =
      outputOf(folder, "cc", {"-std=c99", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-x", "c", "m.h"});
  QVERIFY2(said.isEmpty(), qPrintable(said));
  for (const char* form : {"mjcf", "urdf", "sdf"}) QVERIFY(wellFormed(exportModel(model, form, options)->text));
  for (const char* form : {"python", "isaaclab", "matlab", "modelica"})
    QVERIFY(!QString::fromStdString(exportModel(model, form, options)->text).contains("\nint x"));
}

/// A third of the time no current flows, and an encoder rounds down.
void TestExportPrograms::coasting_isOpenWindings() {
  double peak = 0.0;
  Model model = modelOf("voltage", "cogging 0.002 0.7 12", peak);
  model.count = 0.01;
  const Drive drive = driveOf(peak);
  const auto open = [](size_t k) { return k > 150 && k < 400; };
  std::string csv = "time_s,voltage_V,angle_rad,enabled\n", rows;
  for (size_t k = 0; k < drive.time.size(); ++k) {
    const QString time = QString::number(drive.time[k], 'g', 17), volts = QString::number(drive.input[k], 'g', 17);
    csv += QString("%1,%2,0,%3\n").arg(time, volts).arg(open(k) ? 0 : 1).toStdString();
    const double dt = k + 1 < drive.time.size() ? drive.time[k + 1] - drive.time[k] : 0.001;
    rows += QString("%1 %2 %3\n").arg(volts).arg(open(k) ? 1 : 0).arg(dt, 0, 'g', 17).toStdString();
  }
  const auto recording = readCsvText(csv, "r.csv");
  VERIFY_OK(recording);
  const auto trace = simulate(model, *recording, {});
  VERIFY_OK(trace);
  std::vector<std::pair<double, double>> expected;
  expected.reserve(trace->position.size());
  for (size_t k = 0; k < trace->position.size(); ++k) expected.emplace_back(trace->position[k], trace->velocity[k]);
  const TemporaryFolder folder;
  folder.write("inputs", rows);
  folder.write("m.h", exportedAs(model, "c"));
  folder.write("main.c",
               "#include <stdio.h>\n#include \"m.h\"\nint main(void) {\n  double u, dt;\n  int open;\n"
               "  breakaway_state s = breakaway_start(0.005, 0.0);\n"
               "  while (scanf(\"%lf %d %lf\", &u, &open, &dt) == 3) {\n"
               "    printf(\"%.17g %.17g\\n\", breakaway_reading(&s), s.velocity_rad_per_s);\n"
               "    if (open) breakaway_coast(&s, dt); else breakaway_step(&s, u, 24.0, dt);\n  }\n  return 0;\n}\n");
  const QString complaints =
      outputOf(folder, "cc", {"-std=c99", "-Wall", "-Wextra", "-Werror", "main.c", "-o", "main", "-lm"});
  QVERIFY2(complaints.isEmpty(), qPrintable(complaints));
  const QString said = outputOf(folder, QString::fromStdString(folder.path("main")), {});
  const double most = difference(said, expected);
  QVERIFY2(most >= 0.0 && most < 1e-9, qPrintable(said.left(300)));
}

void TestExportPrograms::realRigs_moveInCAsTheSimulationDoes_data() {
  QTest::addColumn<QString>("bench");
  QTest::addColumn<QString>("recording");
  QTest::addColumn<QString>("effects");
  QTest::newRow("EMPS") << "emps/emps.bench.json"
                        << "emps/DATA_EMPS.csv"
                        << "viscous_asymmetry,constant_load";
  QTest::newRow("XL330") << "bam_xl330/xl330.bench.json"
                         << "bam_xl330/sin_time_square_kp400.csv"
                         << "stribeck";
}

/// The fitted model of a real rig under the recorded drive, whole recordings long.
void TestExportPrograms::realRigs_moveInCAsTheSimulationDoes() {
  NEEDS_REAL_RECORDINGS();
  QFETCH(QString, bench);
  QFETCH(QString, recording);
  QFETCH(QString, effects);
  const auto [model, rows] = fittedRig(bench, recording, effects);
  const auto expected = simulated(model, rows);
  const TemporaryFolder folder;
  const auto time = rows.time(), input = rows.channel(inputName(model));
  Drive drive{{time.begin(), time.end()}, {input.begin(), input.end()}};
  folder.write("inputs", rowsFor(model, drive));
  folder.write("m.h", exportedAs(model, "c"));
  // The simulation begins in the middle of the first count.
  const std::string begin = QString::number(expected[0].first + 0.5 * model.count, 'g', 17).toStdString();
  QString driver = QString::fromStdString(cDriver(model));
  driver.replace("breakaway_start(0.0, 0.0)", "breakaway_start(" + QString::fromStdString(begin) + ", 0.0)");
  driver.replace("for (k = 0; k < 2; ++k)", "for (k = 0; k < 0; ++k)");
  folder.write("main.c", exportedAs(model, "c") + driver.toStdString());
  const QString complaints =
      outputOf(folder, "cc", {"-std=c99", "-Wall", "-Wextra", "-O1", "main.c", "-o", "main", "-lm"});
  QVERIFY2(complaints.isEmpty(), qPrintable(complaints));
  const QString said = outputOf(folder, QString::fromStdString(folder.path("main")), {});
  const double most = difference(said, expected);
  qInfo("C differs by %.2g of the widest way over %zu rows", most, expected.size());
  QVERIFY2(most >= 0.0 && most < 1e-9, qPrintable(said.left(300)));
}

/// By hand: viscous, Coulomb, Stribeck's excess, the warming and the load's share.
void TestExportPrograms::friction_isAFunctionOfAngleSpeedLoadAndTemperature() {
  double peak = 0.0;
  const Model model = modelOf(
      "current", "stribeck 0.004 2 2, friction_warmup 0.003 10, load_dependent_friction 0.05 0, cogging 0.002 0.5 12",
      peak);
  const TemporaryFolder folder;
  folder.write("inputs", "");
  folder.write("m.h", exportedAs(model, "c"));
  folder.write(
      "main.c",
      "#include <stdio.h>\n#include \"m.h\"\nint main(void) {\n"
      "  printf(\"%.12g %.12g %.12g %.12g\\n\", breakaway_friction(0.1, 3.0, 0.02, 5.0, 0.0),\n"
      "         breakaway_friction(0.1, -3.0, 0.02, 5.0, 0.0), breakaway_friction(0.1, 0.0, -0.02, 1e9, 0.0),\n"
      "         breakaway_load(0.1, 0.0, 0.0, 0.0));\n  return 0;\n}\n");
  const QString complaints =
      outputOf(folder, "cc", {"-std=c99", "-Wall", "-Wextra", "-Werror", "main.c", "-o", "main", "-lm"});
  QVERIFY2(complaints.isEmpty(), qPrintable(complaints));
  const QStringList found = outputOf(folder, QString::fromStdString(folder.path("main")), {}).simplified().split(' ');
  QCOMPARE(found.size(), qsizetype{4});
  const double moving = 2e-5 * 3.0 + 0.01 + 0.004 * std::exp(-2.25) + 0.003 * std::exp(-0.5) + 0.05 * 0.02;
  QVERIFY(near(found[0].toDouble(), moving));
  QVERIFY(near(found[1].toDouble(), -moving));
  QVERIFY(near(found[2].toDouble(), -(0.01 + 0.004 + 0.05 * 0.02)));
  QVERIFY(near(found[3].toDouble(), -0.002 * std::cos(12 * 0.1 - 0.5)));
}

QTEST_APPLESS_MAIN(TestExportPrograms)
#include "tst_export_programs.moc"
