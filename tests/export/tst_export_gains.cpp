// Gains for other boards: units by hand, loops that feed back the same, and what is refused.
#include <QFile>
#include <QTest>
#include <cmath>
#include <complex>
#include <numbers>

#include "export/gains.h"
#include "house/program.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestExportGains : public QObject {
  Q_OBJECT
 private slots:
  void feedbackIsTheObservedLoops();
  void eachBoard_getsItsUnits();
  void withoutAnObserver_gainsAreTheTunedOnes();
  void command_writesSaysAndRefuses();
};

namespace {

constexpr double pi = std::numbers::pi;

TunedGains someGains() {
  return {.name = "a servo",
          .velocityKp_A_s_per_rad = 0.047,
          .positionKp_A_per_rad = 2.4,
          .positionKd_A_s_per_rad = 0.09,
          .cutoff_rad_per_s = 183.0,
          .inertia_kg_m2 = 6e-5,
          .torqueConstant_Nm_per_A = 0.07,
          .currentLimit_A = 4.0,
          .speedFilter_rad_per_s = 400.0,
          .currentBandwidth_rad_per_s = 300.0,
          .resistance_ohm = 1.2,
          .inductance_H = 0.0011};
}

/// The value that a line `NAME = VALUE` sets.
double valueOf(const std::string& text, const QString& name) {
  for (const QString& line : QString::fromStdString(text).split('\n')) {
    if (line.startsWith(name + " = ")) return line.mid(name.size() + 3).split(' ')[0].remove(';').toDouble();
  }
  return std::nan("");
}

bool near(double a, double b) {
  return std::abs(a - b) <= 1e-5 * std::max(std::abs(a), std::abs(b));
}

GainsExport exported(const TunedGains& gains, const char* form) {
  const auto done = exportGains(gains, form, "t.json", 7.0);
  if (!done) qFatal("%s", done.error().message().c_str());
  return *done;
}

}  // namespace

/// From ω to i by the observer's own equations, solved for i at some frequencies.
void TestExportGains::feedbackIsTheObservedLoops() {
  const TunedGains g = someGains();
  const SameFeedback velocity = velocityFeedback(g), position = positionFeedback(g);
  for (const double frequency : {3.0, 80.0, 900.0}) {
    const std::complex<double> s(0.0, frequency), filter = g.cutoff_rad_per_s / (s + g.cutoff_rad_per_s);
    // i = i_c + τ̂/Kt,  τ̂ = filter (Kt i + g J ω) − g J ω
    const std::complex<double> ofSpeed =
        (filter - 1.0) * g.cutoff_rad_per_s * g.inertia_kg_m2 / g.torqueConstant_Nm_per_A;
    const std::complex<double> current = (-g.velocityKp_A_s_per_rad + ofSpeed) / (1.0 - filter);
    const std::complex<double> sameI = -(velocity.p + velocity.i / s + velocity.d * s);
    QVERIFY(std::abs(current - sameI) < 1e-9 * std::abs(sameI));
    const std::complex<double> placed =
        (-g.positionKp_A_per_rad - g.positionKd_A_s_per_rad * s + ofSpeed * s) / (1.0 - filter);
    const std::complex<double> pid = -(position.p + position.i / s + position.d * s);
    QVERIFY(std::abs(placed - pid) < 1e-9 * std::abs(pid));
  }
}

void TestExportGains::eachBoard_getsItsUnits() {
  const double p = 0.047 + 183.0 * 6e-5 / 0.07, i = 183.0 * 0.047;
  const std::string simple = exported(someGains(), "simplefoc").text;
  QVERIFY(near(valueOf(simple, "motor.PID_velocity.P"), p));
  QVERIFY(near(valueOf(simple, "motor.PID_velocity.I"), i));
  QVERIFY(near(valueOf(simple, "// motor.PID_velocity.P"), 1.2 * p));
  QVERIFY(near(valueOf(simple, "motor.LPF_velocity.Tf"), 1.0 / 400.0));
  QVERIFY(near(valueOf(simple, "motor.P_angle.P"), 2.4 / 0.09));
  QVERIFY(near(valueOf(simple, "motor.PID_current_q.I"), 300.0 * 1.2));

  // One turn a second is 2π rad/s.
  const std::string odrive = exported(someGains(), "odrive").text;
  const QString of = "odrv0.axis0.controller.config.";
  QVERIFY(near(valueOf(odrive, of + "vel_gain"), p * 0.07 * 2 * pi));
  QVERIFY(near(valueOf(odrive, of + "vel_integrator_gain"), i * 0.07 * 2 * pi));
  QVERIFY(near(valueOf(odrive, of + "pos_gain"), 2.4 / 0.09));

  // An error of 1 rad/s is 7·60/2π electrical rpm, and asks for p amperes of 4.
  const std::string vesc = exported(someGains(), "vesc").text;
  const double erpm = 7.0 * 60.0 / (2 * pi);
  QVERIFY(near(valueOf(vesc, "s_pid_kp") * erpm / 20.0 * 4.0, p));
  QVERIFY(near(valueOf(vesc, "s_pid_ki") * erpm / 20.0 * 4.0, i));
  QVERIFY(near(valueOf(vesc, "p_pid_kp") * 180.0 / pi * 4.0, 2.4 + 183.0 * 0.09));
  QVERIFY(near(valueOf(vesc, "p_pid_ki") * 180.0 / pi * 4.0, 183.0 * 2.4));
  QVERIFY(near(valueOf(vesc, "p_pid_kd") * 180.0 / pi * 4.0, 0.09 + 183.0 * 6e-5 / 0.07));
  QCOMPARE(valueOf(vesc, "p_pid_kd_proc"), 0.0);  // what it is delivered with would add to the damping
  QVERIFY(near(valueOf(vesc, "foc_current_kp"), 300.0 * 0.0011));
  QVERIFY(near(valueOf(vesc, "l_current_max"), 4.0) && near(valueOf(vesc, "si_motor_poles"), 14.0));
}

void TestExportGains::withoutAnObserver_gainsAreTheTunedOnes() {
  TunedGains plain = someGains();
  plain.cutoff_rad_per_s = 0.0;
  plain.velocityKi_A_per_rad = 3.0;
  const GainsExport simple = exported(plain, "simplefoc");
  QVERIFY(near(valueOf(simple.text, "motor.PID_velocity.P"), 0.047));
  QVERIFY(near(valueOf(simple.text, "motor.PID_velocity.I"), 3.0));
  QVERIFY(simple.text.find("disturbance observer, which") == std::string::npos);
  for (const char* form : {"simplefoc", "odrive", "vesc"}) {
    const GainsExport observed = exported(someGains(), form);
    QVERIFY(!observed.notes.empty() && observed.notes[0].starts_with("Lost: the disturbance observer"));
    for (const std::string& note : observed.notes) QVERIFY(observed.text.find(note) != std::string::npos);
  }
}

void TestExportGains::command_writesSaysAndRefuses() {
  const TemporaryFolder folder;
  const auto said = [&folder](const QString& words) {
    return run(builtProgram("breakaway"), words.split(' '), QString::fromStdString(folder.path()));
  };
  folder.write("b.json", R"({"schema": "breakaway.bench/1", "name": "a servo", "encoder": {"counts_per_rev": 14400},
        "drive": {"input": "current_A", "supply_V": 24}, "motor": {"torque_constant_Nm_per_A": 0.07,
        "resistance_ohm": 1.2, "inductance_H": 0.0011, "inertia_kg_m2": 6e-5},
        "controller": {"mode": "open_loop", "current_limit_A": 4}})");
  QCOMPARE(said("tune --bench b.json --board-bandwidths --out t").status, 0);
  const Outcome done = said("export --tuning t/tuning.json --as vesc --pole-pairs 7 --out g.txt");
  QVERIFY2(done.status == 0 && done.out.contains("Lost: the disturbance observer"), qPrintable(done.err));
  const auto text = readFile(folder.path("g.txt"));
  QVERIFY(text.ok() && near(valueOf(*text, "foc_current_ki"), 300.0 * 1.2) && valueOf(*text, "s_pid_kp") > 0.0);
  const Outcome given = said("profile restore --board simulated --tuning t/tuning.json");
  QVERIFY2(given.status == 0 && given.out.contains("velocity_bandwidth_rad_per_s: 400 accepted") &&
               given.out.contains("nominal_inertia_kg_m2: 6e-05 accepted") && !given.out.contains("limit"),
           qPrintable(given.out + given.err));
  const Outcome both = said("profile restore --board simulated --profile p.json --tuning t/tuning.json");
  QVERIFY2(both.status == 2 && both.err.contains("--tuning: takes the place of --profile"), qPrintable(both.err));
  const Outcome piped = said("export --tuning t/tuning.json --as odrive --out -");
  QVERIFY(piped.status == 0 && piped.out.contains("vel_gain = "));

  const auto refused = [&](const QString& words, const QString& line) {
    const Outcome outcome = said("export " + words + " --out none");
    const QByteArray about = (words + ": " + outcome.err).toUtf8();
    QVERIFY2(outcome.status == 2 && outcome.err.count('\n') == 1 && outcome.err.contains(line), about.constData());
    QVERIFY2(!QFile::exists(QString::fromStdString(folder.path("none"))), about.constData());
  };
  const std::string tuning = *readFile(folder.path("t/tuning.json"));
  const auto changed = [&](const char* name, const char* what, const char* with) {
    QString edited = QString::fromStdString(tuning);
    folder.write(name, edited.replace(what, with).toStdString());
  };
  changed("nokp.json", "\"kp_A_s_per_rad\"", "\"kp\"");
  changed("text.json", "\"current_limit_A\": 4.0", "\"current_limit_A\": \"four\"");
  changed("none.json", "\"current_limit_A\": 4.0", "\"current_limit_A\": 0.0");
  changed("linear.json", "\"inertia_kg_m2\": {", "\"mass_kg\": {");
  refused("--tuning t/tuning.json --as vesc", "--pole-pairs: is missing");
  refused("--tuning t/tuning.json --as moteus", "moteus not in {simplefoc,odrive,vesc}");
  refused("--tuning b.json --as odrive", "b.json, field schema: is \"breakaway.bench/1\"");
  refused("--tuning nokp.json --as odrive", "nokp.json, field controller.kp_A_s_per_rad: is missing");
  refused("--tuning text.json --as odrive", "text.json, field controller.current_limit_A: expected a number");
  refused("--tuning none.json --as vesc --pole-pairs 7", "none.json, field controller.current_limit_A: is 0");
  refused("--tuning linear.json --as odrive", "linear.json, field motor.mass_kg");
  refused("--tuning nowhere.json --as odrive", "nowhere.json: cannot be read");
  refused("--tuning t/tuning.json --as odrive --name x", "--name: goes with --map and --model only");
}

QTEST_APPLESS_MAIN(TestExportGains)
#include "tst_export_gains.moc"
