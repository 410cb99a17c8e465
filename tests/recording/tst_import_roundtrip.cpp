#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstring>
#include <numbers>

#include "recording/import/import.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// One row of a run of a small motor.
struct Row {
  double time_s, angle_rad, velocity_rad_per_s, current_A, voltage_V;
};

/// A brushed motor driven by voltage steps there and back, 200 Hz.
std::vector<Row> simulatedRun() {
  constexpr double resistance_ohm = 2.4, constant_Nm_per_A = 0.031, inertia_kg_m2 = 2.2e-5, coulomb_Nm = 0.0021;
  constexpr double step_s = 0.005;
  constexpr int substeps = 50;
  std::vector<Row> rows;
  double angle = 0.0, velocity = 0.0;
  for (int k = 0; k < 400; ++k) {
    const double time = step_s * k;
    const double voltage = time < 0.6 ? 3.0 : time < 1.2 ? -4.0 : 2.0;
    rows.push_back({time, angle, velocity, (voltage - constant_Nm_per_A * velocity) / resistance_ohm, voltage});
    for (int m = 0; m < substeps; ++m) {
      const double current = (voltage - constant_Nm_per_A * velocity) / resistance_ohm;
      const double friction = coulomb_Nm * std::tanh(velocity / 0.05);
      velocity += (constant_Nm_per_A * current - friction) / inertia_kg_m2 * step_s / substeps;
      angle += velocity * step_s / substeps;
    }
  }
  return rows;
}

__attribute__((format(printf, 1, 2))) std::string text(const char* format, ...) {
  char buffer[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

/// A tool's form: what stands before the rows, one row, what the map says, and how fine each channel is.
struct Form {
  const char* name;
  std::string head;
  std::string (*row)(const Row&);
  const char* map;
  double start_s;                                                      ///< of the recording's time
  double time_s, angle_rad, velocity_rad_per_s, current_A, voltage_V;  ///< resolutions; 0: the form doesn't have it
};

long long microseconds(double time_s) {
  return std::llround(time_s * 1e6);
}

double wrappedDegrees(double angle_rad) {
  const double turns = angle_rad / turn;
  return 360.0 * (turns - std::floor(turns));
}

std::vector<Form> forms() {
  return {
      {"VESC Tool",
       "ms_today;input_voltage;current_motor;current_in;d_axis_current;q_axis_current;erpm;duty_cycle;tachometer;fault_"
       "code;\n",
       [](const Row& r) {
         return text("%lld;24.0;%.4f;0.1;0.02;%.4f;%.0f;%.4f;%.0f;0;\n", 36000000 + microseconds(r.time_s) / 1000,
                     std::abs(r.current_A), r.current_A, r.velocity_rad_per_s * 60.0 / turn * 7.0, r.voltage_V / 24.0,
                     std::floor(r.angle_rad / turn * 42.0));
       },
       R"({"pole_pairs": 7})", 36000.0, 1e-6, turn / 42.0, turn / 60.0 / 7.0, 1e-4, 0.0},
      {"ODrive",
       "time "
       "(s),axis0.pos_vel_mapper.pos_rel,axis0.encoder.pos_estimate,axis0.encoder.vel_estimate,axis0.motor.foc.Iq_"
       "measured\n",
       [](const Row& r) {
         return text("%.6f,0,%.6f,%.5f,%.5f\n", r.time_s, r.angle_rad / turn, r.velocity_rad_per_s / turn, r.current_A);
       },
       "", 0.0, 1e-6, turn * 1e-6, turn * 1e-5, 1e-5, 0.0},
      {"moteus",
       "timestamp\tservo_stats.mode\tservo_stats.position\tservo_stats.velocity\tservo_stats.q_A\tservo_stats.d_A\n",
       [](const Row& r) {
         return text("%.6f\t10\t%.7f\t%.6f\t%.4f\t0.0\n", r.time_s + 12.5, r.angle_rad / turn,
                     r.velocity_rad_per_s / turn, r.current_A);
       },
       "", 12.5, 1e-6, turn * 1e-7, turn * 1e-6, 1e-4, 0.0},
      {"SimpleFOC", "MOT: Enable driver.\nMOT: Ready.\n",
       [](const Row& r) {
         return text("%.4f\t%.4f\t0.0000\t%.2f\t0.10\t%.4f\t%.4f\n", r.voltage_V, r.voltage_V, r.current_A * 1e3,
                     r.velocity_rad_per_s, r.angle_rad);
       },
       R"({"sample_time_s": 0.005})", 0.0, 1e-9, 1e-4, 1e-4, 1e-5, 1e-4},
      {"Serial Studio", "RX Date/Time,Motor/Angle (deg),Motor/Speed (rpm),Motor/Current (mA)\n",
       [](const Row& r) {
         const long long ms = microseconds(r.time_s) / 1000;
         return text("2024/05/01 10:20:%02lld::%03lld,%.3f,%.3f,%.2f\n", 10 + ms / 1000, ms % 1000,
                     r.angle_rad * 360.0 / turn, r.velocity_rad_per_s * 60.0 / turn, r.current_A * 1e3);
       },
       "", 0.0, 1e-6, turn / 360e3, turn / 60e3, 1e-5, 0.0},
      {"PlotJuggler", "__time,/joint_states/motor/position,/joint_states/motor/velocity,/motor/current\n",
       [](const Row& r) {
         return text("%.6f,%.7f,%.6f,%.6f\n", 1714558810.0 + r.time_s, r.angle_rad, r.velocity_rad_per_s, r.current_A);
       },
       "", 0.0, 2e-6, 1e-7, 1e-6, 1e-6, 0.0},
      {"rostopic", "%time,field.header.stamp,field.name0,field.position0,field.velocity0\n",
       [](const Row& r) {
         return text("%lld,0,motor,%.7f,%.6f\n", 1714558810123456789LL + std::llround(r.time_s * 1e9), r.angle_rad,
                     r.velocity_rad_per_s);
       },
       "", 0.0, 1e-9, 1e-7, 1e-6, 0.0, 0.0},
      {"ros2 topic echo", "",
       [](const Row& r) {
         const long long ns = 1714558810123456789LL + std::llround(r.time_s * 1e9);
         return text(
             "header:\n  stamp:\n    sec: %lld\n    nanosec: %lld\n  frame_id: ''\nname:\n- motor\n- arm\nposition:\n- "
             "%.9f\n- "
             "0.5\nvelocity:\n- %.7f\n- 0.0\neffort: []\n---\n",
             ns / 1000000000, ns % 1000000000, r.angle_rad, r.velocity_rad_per_s);
       },
       "", 0.0, 1e-9, 1e-9, 1e-7, 0.0, 0.0},
      {"ControlDesk",
       "raster,HostService\ntrace_names,Time,Out1,Speed,Current,Out1\npath,,Model Root/Shaft angle,Model Root,Model "
       "Root,Model "
       "Root/Voltage\nunit,s,deg,rpm,mA,V\ntrace_values\n",
       [](const Row& r) {
         return text(",%.4f,%.4f,%.3f,%.2f,%.3f\n", r.time_s, r.angle_rad * 360.0 / turn,
                     r.velocity_rad_per_s * 60.0 / turn, r.current_A * 1e3, r.voltage_V);
       },
       "", 0.0, 1e-9, turn / 360e4, turn / 60e3, 1e-5, 1e-3},
      {"Dynamixel", "Time_ms,Present_Position,Present_Velocity,Present_Current\n",
       [](const Row& r) {
         const auto current = std::llround(r.current_A * 1e3 / 2.69);
         const auto velocity = std::llround(r.velocity_rad_per_s * 60.0 / turn / 0.229);
         return text("%.3f,%.0f,%lld,%lld\n", r.time_s * 1e3, std::floor(r.angle_rad / turn * 4096.0),
                     velocity < 0 ? velocity + 4294967296LL : velocity, current < 0 ? current + 65536 : current);
       },
       "", 0.0, 1e-6, turn / 4096.0, 0.229 * turn / 60.0, 2.69e-3, 0.0},
      {"Betaflight",
       "\"Product\",\"Blackbox flight data recorder\"\nloopIteration, time (us), gyroADC[0], motor[0], eRPM[0]\n",
       [](const Row& r) {
         return text("%lld, %lld, -3, 900, %.0f\n", microseconds(r.time_s) / 125, microseconds(r.time_s),
                     r.velocity_rad_per_s * 60.0 / turn * 7.0 / 100.0);
       },
       R"({"pole_pairs": 7})", 0.0, 1e-6, 0.0, 100.0 * turn / 60.0 / 7.0, 0.0, 0.0},
      {"German Excel, Windows-1252", "Zeit [s];Winkel [\xB0];Drehzahl [U/min];Strom [mA];Spannung [V]\r\n",
       [](const Row& r) {
         std::string line = text("%.4f;%.4f;%.3f;%.2f;%.3f\r\n", r.time_s, r.angle_rad * 360.0 / turn,
                                 r.velocity_rad_per_s * 60.0 / turn, r.current_A * 1e3, r.voltage_V);
         std::replace(line.begin(), line.end(), '.', ',');
         return line;
       },
       "", 0.0, 1e-9, turn / 360e4, turn / 60e3, 1e-5, 1e-3},
      {"LabVIEW",
       "LabVIEW "
       "Measurement\t\nSeparator\tTab\nX_Columns\tNo\n***End_of_Header***\t\n\t\nChannels\t2\t\t\nY_Unit_"
       "Label\tV\tdeg\t\nX0\t0.0\t0.0\t\n"
       "Delta_X\t0.005\t0.005\t\n***End_of_Header***\t\t\t\nX_Value\tVoltage\tAngle\tComment\n",
       [](const Row& r) { return text("\t%.4f\t%.4f\n", r.voltage_V, r.angle_rad * 360.0 / turn); }, "", 0.0, 1e-9,
       turn / 360e4, 0.0, 0.0, 1e-4},
      {"Arduino's monitor", "10:20:09.000 -> Ready.\n10:20:09.100 -> angle,rpm\n",
       [](const Row& r) {
         const long long ms = microseconds(r.time_s) / 1000;
         return text("10:20:%02lld.%03lld -> %.2f,%.2f\n", 10 + ms / 1000, ms % 1000, wrappedDegrees(r.angle_rad),
                     r.velocity_rad_per_s * 60.0 / turn);
       },
       R"({"columns": {"angle": {"to": "angle_rad", "unit": "deg"}}})", 0.0, 1e-6, turn / 36e3, turn / 6e3, 0.0, 0.0},
  };
}

}  // namespace

/// A simulated run, written in a tool's own form, comes back as the same recording.
class TestImportRoundtrip : public QObject {
  Q_OBJECT
 private slots:
  void run_comesBackThroughEachForm_data();
  void run_comesBackThroughEachForm();
  void joinedFiles_followOneAnother();
  void splitLog_isOneRecordingPerValue();
  void gearSignAndDerivative_areApplied();
  void speed_isIntegratedOnRequest();

 private:
  TemporaryFolder folder_;
};

void TestImportRoundtrip::run_comesBackThroughEachForm_data() {
  QTest::addColumn<int>("form");
  const auto all = forms();
  for (size_t k = 0; k < all.size(); ++k) QTest::newRow(all[k].name) << int(k);
}

void TestImportRoundtrip::run_comesBackThroughEachForm() {
  QFETCH(int, form);
  const Form one = forms()[static_cast<size_t>(form)];
  const auto run = simulatedRun();
  std::string content = one.head;
  for (const Row& row : run) content += one.row(row);
  ImportMap map;
  if (*one.map != '\0') map = *readImportMapText(one.map, "map");
  const auto imported = importRecording(folder_.write("log.csv", content), map);
  VERIFY_OK(imported);
  const Recording& recording = imported->recording;
  QCOMPARE(recording.rows(), run.size());
  const auto compare = [&](const char* name, double resolution, double Row::*wanted, double offset) {
    if (resolution == 0.0) return true;
    if (!recording.has(name)) return qWarning("no %s", name), false;
    for (size_t k = 0; k < run.size(); ++k) {
      const double got = recording.channel(name)[k], expected = run[k].*wanted + offset;
      if (std::abs(got - expected) <= 1.01 * resolution + 1e-9) continue;
      qWarning("%s, row %zu: %.9g, expected %.9g", name, k + 1, got, expected);
      return false;
    }
    return true;
  };
  QVERIFY(compare("time_s", one.time_s, &Row::time_s, one.start_s));
  QVERIFY(compare("angle_rad", one.angle_rad, &Row::angle_rad, 0.0));
  QVERIFY(compare("velocity_rad_per_s", one.velocity_rad_per_s, &Row::velocity_rad_per_s, 0.0));
  QVERIFY(compare("current_A", one.current_A, &Row::current_A, 0.0));
  QVERIFY(compare("voltage_V", one.voltage_V, &Row::voltage_V, 0.0));
  QCOMPARE(recording.has("angle_rad"), one.angle_rad != 0.0);
}

void TestImportRoundtrip::joinedFiles_followOneAnother() {
  const std::string first = folder_.write("a.csv", "time_s,angle_rad\n0,1\n0.1,2\n0.2,3\n");
  folder_.write("b.csv", "time_s,angle_rad\n0,4\n0.1,5\n0.2,6\n");
  const auto map = readImportMapText(R"({"join": ["b.csv"]})", "map");
  VERIFY_OK(map);
  const auto imported = importRecording(first, *map);
  VERIFY_OK(imported);
  QCOMPARE(imported->recording.rows(), size_t(6));
  QVERIFY(std::abs(imported->recording.time()[3] - 1.2) < 1e-12);
  QCOMPARE(imported->recording.channel("angle_rad")[5], 6.0);
}

void TestImportRoundtrip::splitLog_isOneRecordingPerValue() {
  const std::string log = folder_.write("s.csv", "time_s,angle_rad,run\n0,1,1\n0.1,2,1\n0,3,2\n0.1,4,2\n0.2,5,2\n");
  const auto map = readImportMapText(R"({"split": "run"})", "map");
  VERIFY_OK(map);
  const auto parts = importRecordings(log, *map);
  VERIFY_OK(parts);
  QCOMPARE(parts->size(), size_t(2));
  QCOMPARE((*parts)[0].recording.rows(), size_t(2));
  QCOMPARE((*parts)[1].recording.rows(), size_t(3));
  QCOMPARE((*parts)[1].recording.channel("angle_rad")[2], 5.0);
}

void TestImportRoundtrip::gearSignAndDerivative_areApplied() {
  const std::string log = folder_.write("g.csv", "time_s,angle_deg,torque_Nm\n0,0,5\n0.1,180,5\n0.2,360,5\n");
  const auto map =
      readImportMapText(R"({"gear_ratio": 10, "sign": {"torque_Nm": -1}, "differentiate": "angle_deg"})", "map");
  VERIFY_OK(map);
  const auto imported = importRecording(log, *map);
  VERIFY_OK(imported);
  const Recording& recording = imported->recording;
  QVERIFY(std::abs(recording.channel("angle_rad")[2] - 10.0 * turn) < 1e-9);
  QVERIFY(std::abs(recording.channel("torque_Nm")[0] + 0.5) < 1e-12);
  QVERIFY(std::abs(recording.channel("velocity_rad_per_s")[1] - 50.0 * turn) < 1e-9);
}

void TestImportRoundtrip::speed_isIntegratedOnRequest() {
  const std::string log = folder_.write("i.csv", "time_s,speed_rpm\n0,60\n0.5,60\n1.0,60\n");
  const auto alone = importRecording(log);
  VERIFY_OK(alone);
  QVERIFY(!alone->recording.has("angle_rad"));
  const auto map = readImportMapText(R"({"integrate": "speed_rpm"})", "map");
  VERIFY_OK(map);
  const auto imported = importRecording(log, *map);
  VERIFY_OK(imported);
  QVERIFY(std::abs(imported->recording.channel("angle_rad")[2] - turn) < 1e-12);
}

QTEST_APPLESS_MAIN(TestImportRoundtrip)
#include "tst_import_roundtrip.moc"
