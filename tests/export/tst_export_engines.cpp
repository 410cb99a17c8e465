// Exported joints in their own engines, where these are installed: MuJoCo moves them, URDF's and SDF's libraries read
// them.
#include <QTest>
#include <cmath>

#include "export/exported_models.h"

#ifdef BREAKAWAY_HAS_MUJOCO
#include <mujoco/mujoco.h>
#endif
#ifdef BREAKAWAY_HAS_URDFDOM
#include <urdf_parser/urdf_parser.h>
#endif
#ifdef BREAKAWAY_HAS_SDFORMAT
#include <sdf/sdf.hh>
#endif

using namespace breakaway;
using namespace breakaway::test;

class TestExportEngines : public QObject {
  Q_OBJECT
 private slots:
  void mujoco_movesTheJointAsTheSimulation_data();
  void mujoco_movesTheJointAsTheSimulation();
  void mujoco_movesRealRigs_data();
  void mujoco_movesRealRigs();
  void urdf_isReadByItsLibrary_data() { kinds(); }
  void urdf_isReadByItsLibrary();
  void sdf_isReadByItsLibrary_data() { kinds(); }
  void sdf_isReadByItsLibrary();

 private:
  static void kinds() {
    QTest::addColumn<QString>("kind");
    for (const char* kind : {"current", "linear", "geared", "arm", "voltage"}) QTest::newRow(kind) << kind;
  }
};

namespace {

/// Joints that engines move.
Model jointRig(const QString& kind) {
  Model m;
  m.input = DriveInput::current;
  m.base = {known("inertia_kg_m2", 6e-5), known("viscous_Nm_s_per_rad", 1e-4), known("coulomb_Nm", 0.01),
            known("torque_constant_Nm_per_A", 0.07)};
  if (kind == "linear") {
    m.axis = Axis::linear;
    m.input = DriveInput::torque;
    m.base = {known("mass_kg", 2.0), known("viscous_N_s_per_m", 5.0), known("coulomb_N", 3.0)};
  }
  if (kind == "geared") {
    add(m, "compliance", {2e-5, 300.0, 0.05, 0.0});
    add(m, "constant_load", {0.002});
  }
  if (kind == "arm") {
    m.pendulum = Pendulum{0.05, 0.1, 0.01, 0.3};
    m.base.push_back(known("down_angle_rad", 0.3));
  }
  if (kind == "voltage") {
    m.input = DriveInput::voltage;
    m.base.push_back(known("back_emf_constant_V_s_per_rad", 0.07));
    m.base.push_back(known("resistance_ohm", 1.2));
  }
  return m;
}

#ifdef BREAKAWAY_HAS_MUJOCO
/// Moves the exported joint under a recording's drive from its first position; the furthest that it is from what
/// simulate() makes of the model, as a part of its widest way. -1: MuJoCo refuses it.
double differenceInMujoco(const Model& model, const Recording& recording) {
  constexpr int perRow = 20;
  Bench names;
  names.axis = model.axis;
  names.input = model.input;
  const auto trace = simulate(model, recording, {});
  if (!trace) qFatal("%s", trace.error().message().c_str());
  const TemporaryFolder folder;
  const std::string path = folder.write("axis.xml", exportedAs(model, "mjcf", "axis"));
  char complaint[1000] = "";
  mjModel* joint = mj_loadXML(path.c_str(), nullptr, complaint, sizeof complaint);
  if (joint == nullptr) {
    qWarning("%s", complaint);
    return -1.0;
  }
  mjData* data = mj_makeData(joint);
  const auto time = recording.time(), input = recording.channel(names.inputChannel());
  data->qpos[0] = trace->position[0] + 0.5 * model.count;
  double most = 0.0, low = data->qpos[0], high = low;
  for (size_t k = 0; k + 1 < time.size(); ++k) {
    most = std::max(most, std::abs(data->qpos[0] - 0.5 * model.count - trace->position[k]));
    low = std::min(low, trace->position[k]);
    high = std::max(high, trace->position[k]);
    data->ctrl[0] = input[k];
    joint->opt.timestep = (time[k + 1] - time[k]) / perRow;
    for (int part = 0; part < perRow; ++part) mj_step(joint, data);
  }
  mj_deleteData(data);
  mj_deleteModel(joint);
  return most / (high - low);
}
#endif

}  // namespace

void TestExportEngines::mujoco_movesTheJointAsTheSimulation_data() {
  kinds();
}

void TestExportEngines::mujoco_movesTheJointAsTheSimulation() {
#ifndef BREAKAWAY_HAS_MUJOCO
  QSKIP("MuJoCo (libmujoco-dev) is not installed");
#else
  QFETCH(QString, kind);
  const Model model = jointRig(kind);
  const double peak = kind == "linear" ? 20.0 : kind == "voltage" ? 4.0 : 0.6;
  std::string csv = kind == "linear"    ? "time_s,force_N,position_m\n"
                    : kind == "voltage" ? "time_s,voltage_V,angle_rad\n"
                                        : "time_s,current_A,angle_rad\n";
  for (int k = 0; k < 1000; ++k) {
    const double t = 1e-3 * k;
    const double input = k < 5 ? 0.0 : k < 200 ? peak : k < 400 ? -peak : peak * std::sin(9.0 * t * t);
    csv += QString("%1,%2,0\n").arg(t, 0, 'g', 17).arg(input, 0, 'g', 17).toStdString();
  }
  const auto recording = readCsvText(csv, "r.csv");
  VERIFY_OK(recording);
  const double most = differenceInMujoco(model, *recording);
  qInfo("MuJoCo differs by %.2g of the widest way", most);
  QVERIFY(most >= 0.0 && most < 2e-3);  // its friction gives way a little where ours stands
#endif
}

void TestExportEngines::mujoco_movesRealRigs_data() {
  QTest::addColumn<QString>("bench");
  QTest::addColumn<QString>("recording");
  QTest::addColumn<QString>("effects");
  QTest::newRow("EMPS") << "emps/emps.bench.json"
                        << "emps/DATA_EMPS.csv"
                        << "constant_load";
  QTest::newRow("XL330") << "bam_xl330/xl330.bench.json"
                         << "bam_xl330/sin_time_square_kp400.csv"
                         << "";
}

/// What a rig's fitted model does under the recorded drive, in MuJoCo and in simulate().
void TestExportEngines::mujoco_movesRealRigs() {
#ifndef BREAKAWAY_HAS_MUJOCO
  QSKIP("MuJoCo (libmujoco-dev) is not installed");
#else
  NEEDS_REAL_RECORDINGS();
  QFETCH(QString, bench);
  QFETCH(QString, recording);
  QFETCH(QString, effects);
  const auto [model, rows] = fittedRig(bench, recording, effects);
  const double most = differenceInMujoco(model, rows);
  qInfo("MuJoCo differs by %.2g of the widest way", most);
  QVERIFY(most >= 0.0 && most < 0.02);
#endif
}

void TestExportEngines::urdf_isReadByItsLibrary() {
#ifndef BREAKAWAY_HAS_URDFDOM
  QSKIP("urdfdom (liburdfdom-dev) is not installed");
#else
  QFETCH(QString, kind);
  const Model model = jointRig(kind);
  const auto robot = urdf::parseURDF(exportedAs(model, "urdf", "axis"));
  QVERIFY(robot != nullptr);
  const auto joint = robot->getJoint("axis_joint");
  QVERIFY(joint != nullptr && joint->dynamics != nullptr);
  QCOMPARE(joint->type, kind == "linear" ? urdf::Joint::PRISMATIC : urdf::Joint::CONTINUOUS);
  QCOMPARE(joint->dynamics->damping, *model.baseValue(motorNames(model.axis).viscous));
  QCOMPARE(joint->dynamics->friction, *model.baseValue(motorNames(model.axis).coulomb));
  QVERIFY(robot->getLink("axis")->inertial->mass > 0.0);
#endif
}

void TestExportEngines::sdf_isReadByItsLibrary() {
#ifndef BREAKAWAY_HAS_SDFORMAT
  QSKIP("sdformat (libsdformat-dev) is not installed");
#else
  QFETCH(QString, kind);
  const Model model = jointRig(kind);
  sdf::Root root;
  const sdf::Errors errors = root.LoadSdfString(exportedAs(model, "sdf", "axis"));
  QVERIFY2(errors.empty(), errors.empty() ? "" : errors[0].Message().c_str());
  const sdf::Joint* joint = root.Model()->JointByName("axis_joint");
  QVERIFY(joint != nullptr);
  QCOMPARE(joint->Type(), kind == "linear" ? sdf::JointType::PRISMATIC : sdf::JointType::REVOLUTE);
  QCOMPARE(joint->Axis()->Damping(), *model.baseValue(motorNames(model.axis).viscous));
  QCOMPARE(joint->Axis()->Friction(), *model.baseValue(motorNames(model.axis).coulomb));
  const sdf::Joint* spring = root.Model()->JointByName("axis_spring");
  QCOMPARE(spring != nullptr, kind == "geared");
  if (spring != nullptr) QVERIFY(std::abs(spring->Axis()->SpringStiffness() - 2e-5 * 300.0 * 300.0) < 1e-9);
#endif
}

QTEST_APPLESS_MAIN(TestExportEngines)
#include "tst_export_engines.moc"
