// Models as joints of robot simulators: what their files hold, and what they say is lost.
#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

#include "export/exported_models.h"

using namespace breakaway;
using namespace breakaway::test;

class TestExportJoints : public QObject {
  Q_OBJECT
 private slots:
  void joints_holdTheBaseInTheirUnits_data();
  void joints_holdTheBaseInTheirUnits();
  void joints_sayWhatTheyLose();
  void mujocoHoldsLoadStopWeightAndBackEmf();
  void isaacLab_tellsStaticFromSliding();
};

namespace {

/// The attributes of an XML element, the n-th of its name.
QMap<QString, QString> element(const std::string& text, const QString& name, int which = 0) {
  QXmlStreamReader xml(QString::fromStdString(text));
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement || xml.name() != name || which-- > 0) continue;
    QMap<QString, QString> found;
    for (const auto& one : xml.attributes()) found[one.name().toString()] = one.value().toString();
    const QString inside = xml.readElementText(QXmlStreamReader::IncludeChildElements);
    found["text"] = inside.trimmed();
    return found;
  }
  return {};
}

}  // namespace

void TestExportJoints::joints_holdTheBaseInTheirUnits_data() {
  QTest::addColumn<QString>("kind");
  for (const char* kind : {"current", "linear", "voltage"}) QTest::newRow(kind) << kind;
}

void TestExportJoints::joints_holdTheBaseInTheirUnits() {
  QFETCH(QString, kind);
  const Model model = rig(kind).model;
  const bool linear = model.axis == Axis::linear;
  const double inertia = model.base[0].value, viscous = model.base[1].value, coulomb = model.base[2].value;
  const std::string mjcf = exportedAs(model, "mjcf"), urdf = exportedAs(model, "urdf"), sdf = exportedAs(model, "sdf");
  for (const std::string& text : {mjcf, urdf, sdf}) QVERIFY2(wellFormed(text), text.c_str());
  const auto joint = element(mjcf, "joint");
  QCOMPARE(joint["type"], QString(linear ? "slide" : "hinge"));
  QCOMPARE(joint["armature"].toDouble(), inertia);
  QCOMPARE(joint["damping"].toDouble(), viscous);
  QCOMPARE(joint["frictionloss"].toDouble(), coulomb);
  if (kind == "current") QCOMPARE(element(mjcf, "motor")["gear"].toDouble(), 0.07);
  if (kind == "voltage") {
    const auto general = element(mjcf, "general");
    QVERIFY(near(general["gainprm"].toDouble(), 0.07 / 1.2));
    QVERIFY(near(general["biasprm"].split(' ')[2].toDouble(), -0.07 * 0.069 / 1.2));
  }
  QCOMPARE(element(urdf, "joint")["type"], QString(linear ? "prismatic" : "continuous"));
  QCOMPARE(element(urdf, "dynamics")["damping"].toDouble(), viscous);
  QCOMPARE(element(urdf, "dynamics")["friction"].toDouble(), coulomb);
  QCOMPARE(linear ? element(urdf, "mass")["value"].toDouble() : element(urdf, "inertia")["iyy"].toDouble(), inertia);
  QCOMPARE(element(sdf, "joint")["type"], QString(linear ? "prismatic" : "revolute"));
  QCOMPARE(element(sdf, "damping")["text"].toDouble(), viscous);
  QCOMPARE(element(sdf, "friction")["text"].toDouble(), coulomb);
  QCOMPARE(element(sdf, linear ? "mass" : "iyy")["text"].toDouble(), inertia);
}

void TestExportJoints::joints_sayWhatTheyLose() {
  double peak = 0.0;
  const Model model = modelOf("current", "stribeck 0.004 2 2, cogging 0.002 0.7 12, constant_load 0.003", peak);
  for (const char* form : {"mjcf", "urdf", "sdf", "isaaclab"}) {
    const auto done = exportModel(model, form, {.model = "m--1.json"});
    QVERIFY(done.ok());
    std::string said;
    for (const std::string& note : done->notes) {
      said += note + "\n";
      QVERIFY2(done->text.find(note) != std::string::npos, note.c_str());
    }
    QVERIFY2(said.find("cogging (amplitude_Nm 0.002, phase_rad 0.7, order 12)") != std::string::npos, said.c_str());
    QVERIFY(said.find("stribeck (excess_Nm 0.004, velocity_rad_per_s 2, exponent 2)") != std::string::npos);
    QCOMPARE(said.find("constant_load") == std::string::npos, std::string(form) == "mjcf");
    if (std::string(form) != "isaaclab") QVERIFY(wellFormed(done->text));
  }
  // Nothing is said of a model that a joint holds whole.
  const auto whole = exportModel(rig("linear").model, "sdf", {.model = "m.json"});
  QVERIFY(whole.ok() && whole->notes.empty());
}

void TestExportJoints::mujocoHoldsLoadStopWeightAndBackEmf() {
  double peak = 0.0;
  const std::string geared =
      exportedAs(modelOf("current",
                         "compliance 2e-5 300 0.05 0, constant_load 0.003, end_stop 20 3 1 0.01, "
                         "command_saturation 0.5 100",
                         peak),
                 "mjcf");
  QVERIFY(near(element(geared, "joint")["armature"].toDouble(), 4e-5));
  QCOMPARE(element(geared, "joint")["range"].split(' ')[1].toDouble(), 3.0);
  const auto spring = element(geared, "joint", 1);
  QVERIFY(near(spring["stiffness"].toDouble(), 2e-5 * 300 * 300));
  QVERIFY(near(spring["damping"].toDouble(), 2 * 0.05 * 300 * 2e-5));
  QCOMPARE(element(geared, "motor")["ctrlrange"], QString("-0.5 0.5"));
  QCOMPARE(element(geared, "general")["biasprm"].split(' ')[0].toDouble(), -0.003);

  const std::string arm = exportedAs(rig("arm").model, "mjcf");
  const auto body = element(arm, "inertial");
  const double mass = body["mass"].toDouble(), depth = -body["pos"].split(' ')[2].toDouble();
  QVERIFY(near(mass * depth, (0.05 + 0.005) * 0.1));
  QVERIFY(near(body["diaginertia"].split(' ')[1].toDouble() + mass * depth * depth, (0.05 + 0.01 / 3) * 0.01));
  QCOMPARE(element(arm, "joint")["ref"].toDouble(), 0.3);
  QVERIFY(near(element(arm, "joint")["armature"].toDouble(), 6e-5));

  const auto servo = element(exportedAs(rig("servo").model, "mjcf"), "position");
  QCOMPARE(servo["kp"].toDouble(), 1.5);
  QCOMPARE(servo["kv"].toDouble(), 0.02);
  QCOMPARE(servo["forcerange"], QString("-0.8 0.8"));
}

void TestExportJoints::isaacLab_tellsStaticFromSliding() {
  double peak = 0.0;
  const QString text = QString::fromStdString(exportedAs(modelOf("servo", "stribeck 0.02 0.5 2", peak), "isaaclab"));
  const auto field = [&text](const char* name) {
    const auto match = QRegularExpression(QString("\\b%1=([^,]+),").arg(name)).match(text);
    return match.captured(1).toDouble();
  };
  QVERIFY(near(field("friction"), 0.04));
  QVERIFY(near(field("dynamic_friction"), 0.02));
  QVERIFY(near(field("viscous_friction"), 2e-4));
  QVERIFY(near(field("armature"), 6e-4));
  QVERIFY(near(field("stiffness"), 1.5));
  QVERIFY(near(field("damping"), 0.02));
  QVERIFY(near(field("effort_limit_sim"), 0.8));
  if (python().isEmpty()) QSKIP("there is no python3");
  const TemporaryFolder folder;
  folder.write("inputs", text.toStdString());
  QCOMPARE(outputOf(folder, python(), {"-c", "import ast, sys; ast.parse(sys.stdin.read())"}), QString());
}

QTEST_APPLESS_MAIN(TestExportJoints)
#include "tst_export_joints.moc"
