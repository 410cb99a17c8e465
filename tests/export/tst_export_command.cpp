// `breakaway export --model`: what it writes, says and refuses.
#include <QFile>
#include <QTest>

#include "export/exported_models.h"
#include "friction/map_export.h"
#include "support/noisy_map.h"

using namespace breakaway;
using namespace breakaway::test;

class TestExportCommand : public QObject {
  Q_OBJECT
 private slots:
  void command_writesSaysAndRefuses();
};

void TestExportCommand::command_writesSaysAndRefuses() {
  double peak = 0.0;
  const Model model = modelOf("current", "stribeck 0.004 2 2, cogging 0.002 0.7 12", peak);
  const TemporaryFolder folder;
  folder.write("m.json", modelText(model));
  std::string csv = "time_s,current_A,angle_rad\n";
  const Drive drive = driveOf(peak, 700);
  const auto motion = simulated(model, drive);
  for (size_t k = 0; k < motion.size(); ++k)
    csv += QString("%1,%2,%3\n")
               .arg(drive.time[k], 0, 'g', 17)
               .arg(drive.input[k], 0, 'g', 17)
               .arg(motion[k].first, 0, 'g', 17)
               .toStdString();
  folder.write("r.csv", csv);
  const auto exported = [&folder](const QString& words) {
    return run(builtProgram("breakaway"), ("export " + words).split(' '), QString::fromStdString(folder.path()));
  };
  const auto content = [&folder](const char* name) {
    QFile file(QString::fromStdString(folder.path(name)));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
  };
  Outcome done = exported("--model m.json --as mjcf --out joint.xml --recording r.csv");
  QVERIFY2(done.status == 0, qPrintable(done.err));
  for (const char* words : {"Lost: cogging (amplitude_Nm 0.002", "Lost: stribeck (", "On r.csv, in windows of 0.5 s",
                            "joint.xml: the model as mjcf"})
    QVERIFY2(done.out.contains(words), qPrintable(done.out));
  QVERIFY(content("joint.xml").contains("On r.csv, in windows of 0.5 s") &&
          content("joint.xml").contains("model=\"joint\""));
  done = exported("--model m.json --as c --out -");
  QVERIFY(done.status == 0 && done.out.contains("breakaway_step") && done.out.contains("All of the model's effects"));
  QCOMPARE(exported("--model m.json --as matlab --out axis_3.m").status, 0);
  QVERIFY(content("axis_3.m").startsWith("classdef axis_3\n"));
  // Names that the language or the program itself has are none for a class.
  for (const char* taken : {"friction.m", "while.m", "inertia_kg_m2.m", "s.m", "drive.m", "3.m"}) {
    done = exported(QString("--model m.json --as matlab --out ") + taken);
    QVERIFY2(content(taken).startsWith("classdef breakaway\n") && done.out.contains("keep it as breakaway.m"), taken);
  }
  QCOMPARE(exported("--model m.json --as modelica --out load.mo").status, 0);
  QVERIFY(content("load.mo").contains("\npackage breakaway\n"));
  QVERIFY(exported("--model m.json --as python --out my-motor.py").out.contains("Python imports it only from"));
  QVERIFY(!exported("--model m.json --as python --out motor.py").out.contains("Python imports"));
  QCOMPARE(exported("--model m.json --as c --name left --out left.h").status, 0);
  QVERIFY(content("left.h").contains("left_state left_start("));

  QVERIFY(exportMap(noisyMap(0.02, 1), "json", folder.path("map.json")).ok());
  QCOMPARE(exported("--map map.json --as c-header --name left --out left_map.h").status, 0);
  QVERIFY(content("left_map.h").contains("#define LEFT_MAP_BINS "));
  QCOMPARE(exported("--map map.json --as modelica --name Left --out Left.mo").status, 0);
  QVERIFY(content("Left.mo").contains("\npackage Left\n"));

  const auto refused = [&](const QString& words, const QString& line) {
    const Outcome outcome = exported(words + " --out none");
    const QByteArray about = (words + ": " + outcome.err).toUtf8();
    QVERIFY2(outcome.status == 2 && outcome.err.count('\n') == 1 && outcome.err.contains(line), about.constData());
    QVERIFY2(!QFile::exists(QString::fromStdString(folder.path("none"))), about.constData());
  };
  refused("--model m.json --as modelica --name while", "--name: is \"while\", which the language keeps for itself");
  refused("--model m.json --as matlab --name friction",
          "--name: is \"friction\", which is the name of something in it");
  folder.write("bench.json", R"({"schema": "breakaway.bench/1"})");
  folder.write("lacking.json", R"({"schema": "breakaway.model/1", "axis": "rotary", "input": "current_A"})");
  folder.write("odd.json", R"({"schema": "breakaway.model/1", "axis": "rotary", "input": "current_A",
    "base": {"inertia_kg_m2": {"value": 1, "ci95": [1, 1]}}, "effects": [{"effect": "stribeck", "parameters": {}}]})");
  refused("--model m.json --as simulink", "simulink not in {mjcf,isaaclab,urdf,sdf,c,python,modelica,matlab}");
  refused("--model bench.json --as c", "bench.json, field schema: is \"breakaway.bench/1\"");
  refused("--model lacking.json --as c", "lacking.json, field base: is missing");
  refused("--model odd.json --as urdf", "odd.json, effect stribeck: has no parameter excess_Nm");
  folder.write("duty.json", R"({"schema": "breakaway.model/1", "axis": "rotary", "input": "angle_reference_rad",
    "base": {"inertia_kg_m2": {"value": 1, "ci95": [1, 1]}, "kp_duty_per_rad": {"value": 2, "ci95": [2, 2]}},
    "effects": []})");
  refused("--model duty.json --as mjcf", "duty.json, field supply_V: is missing");
  refused("--model nowhere.json --as sdf", "nowhere.json: cannot be read");
  refused("--model m.json --as c --name 3rd", "--name: is \"3rd\"");
  refused("--map map.json --as c-header --name 3rd", "--name: is \"3rd\"");
  refused("--map map.json --as modelica --name model", "--name: is \"model\", which the language keeps");
  refused("--map map.json --as csv --name left", "--name: goes with c-header and modelica only");
  refused("--as c", "--map");
}

QTEST_APPLESS_MAIN(TestExportCommand)
#include "tst_export_command.moc"
