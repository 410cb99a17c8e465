// Models that tests export, by name, and what simulate() makes of them.
#pragma once

#include <QProcess>
#include <QStandardPaths>
#include <QStringList>
#include <QXmlStreamReader>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/effects/catalogue.h"
#include "diagnose/simulate/model_file.h"
#include "diagnose/simulate/simulation.h"
#include "export/model_export.h"
#include "house/program.h"
#include "recording/csv.h"
#include "support/real_recordings.h"
#include "support/temporary.h"

namespace breakaway::test {

using Values = std::vector<double>;

/// A model with effects, by name and values in their order.
struct Rig {
  Model model;
  double peak = 1.0;  ///< of the input
};

inline Parameter known(const std::string& name, double value) {
  return {name, value, value, value};
}

inline Rig rig(const QString& kind) {
  Rig one;
  Model& m = one.model;
  m.base = {known("inertia_kg_m2", 6e-5), known("viscous_Nm_s_per_rad", 2e-5), known("coulomb_Nm", 0.01)};
  if (kind.startsWith("linear")) {
    m.axis = Axis::linear;
    m.base = {known("mass_kg", 2.0), known("viscous_N_s_per_m", 5.0), known("coulomb_N", 3.0)};
    one.peak = 20.0;
  }
  if (kind == "voltage" || kind == "duty") {
    m.input = kind == "duty" ? DriveInput::duty : DriveInput::voltage;
    m.supply_V = 24.0;
    for (const Parameter& extra : {known("torque_constant_Nm_per_A", 0.07),
                                   known("back_emf_constant_V_s_per_rad", 0.069), known("resistance_ohm", 1.2)})
      m.base.push_back(extra);
    if (kind == "voltage") m.base.push_back(known("inductance_H", 0.0011));
    one.peak = kind == "duty" ? 0.25 : 6.0;
  }
  if (kind == "biased") {
    m.input = DriveInput::current;
    m.base.push_back(known("torque_constant_Nm_per_A", 0.07));
    m.base.push_back(known(biasName(m.axis), 1e-4));
    one.peak = 0.6;
  }
  if (kind == "current") {
    m.input = DriveInput::current;
    m.base.push_back(known("torque_constant_Nm_per_A", 0.07));
    one.peak = 0.6;
  }
  if (kind == "arm") {
    m.input = DriveInput::current;
    m.base = {known("inertia_kg_m2", 6e-5), known("viscous_Nm_s_per_rad", 2e-4), known("coulomb_Nm", 0.01),
              known("torque_constant_Nm_per_A", 0.07), known("down_angle_rad", 0.3)};
    m.pendulum = Pendulum{0.05, 0.1, 0.01, 0.3};
    one.peak = 1.0;
  }
  if (kind == "servo") {
    m.input = DriveInput::torque;
    m.servo = ServoLaw{.rate_Hz = 500.0};
    m.base = {known("inertia_kg_m2", 6e-4), known("viscous_Nm_s_per_rad", 2e-4), known("coulomb_Nm", 0.02),
              known("kp_Nm_per_rad", 1.5),  known("kd_Nm_s_per_rad", 0.02),      known("torque_limit_Nm", 0.8),
              known("delay_s", 0.004)};
    one.peak = 0.5;
  }
  return one;
}

inline void add(Model& model, const char* effect, const Values& values) {
  EffectTerm term{effect, {}};
  const auto specs = findEffect(effect)->parameters(model.axis);
  for (size_t k = 0; k < values.size(); ++k) term.parameters.push_back(known(specs[k].name, values[k]));
  model.effects.push_back(term);
}

/// Pushes both ways, lets go, and creeps; at a time step that is no round number.
struct Drive {
  std::vector<double> time, input;
};
inline Drive driveOf(double peak, int rows = 800) {
  Drive drive;
  for (int k = 0; k < rows; ++k) {
    const double t = 0.00103 * k;
    const double push = k < 5 ? 0.0 : k < 200 ? 1.0 : k < 380 ? -1.0 : k < 520 ? 0.0 : std::sin(9.0 * t * t);
    drive.time.push_back(t);
    drive.input.push_back(peak * push);
  }
  return drive;
}

inline std::string inputName(const Model& model) {
  Bench names;
  names.axis = model.axis;
  names.input = model.input;
  names.servo = model.servo;
  return names.inputChannel();
}

/// What the simulation makes of a recording's drive: shown place and velocity, row by row.
inline std::vector<std::pair<double, double>> simulated(const Model& model, const Recording& recording) {
  const auto trace = simulate(model, recording, {});
  if (!trace) qFatal("%s", trace.error().message().c_str());
  std::vector<std::pair<double, double>> out;
  out.reserve(trace->position.size());
  for (size_t k = 0; k < trace->position.size(); ++k) out.emplace_back(trace->position[k], trace->velocity[k]);
  return out;
}

/// The same of a drive.
inline std::vector<std::pair<double, double>> simulated(const Model& model, const Drive& drive) {
  std::string csv = "time_s," + inputName(model) + (model.axis == Axis::rotary ? ",angle_rad\n" : ",position_m\n");
  for (size_t k = 0; k < drive.time.size(); ++k)
    csv += QString::number(drive.time[k], 'g', 17).toStdString() + "," +
           QString::number(drive.input[k], 'g', 17).toStdString() + ",0\n";
  const auto recording = readCsvText(csv, "r.csv");
  if (!recording) qFatal("%s", recording.error().message().c_str());
  return simulated(model, *recording);
}

/// A rig() with effects: "NAME VALUE…, NAME VALUE…".
inline Model modelOf(const QString& kind, const QString& effects, double& peak) {
  Rig one = rig(kind);
  for (const QString& effect : effects.split(", ", Qt::SkipEmptyParts)) {
    const QStringList words = effect.split(' ');
    Values values;
    for (const QString& word : words.mid(1)) values.push_back(word.toDouble());
    add(one.model, qPrintable(words[0]), values);
  }
  peak = one.peak;
  return one.model;
}

inline std::string exportedAs(const Model& model, const char* form, const char* name = "breakaway") {
  const auto done = exportModel(model, form, {.model = "m.json", .name = name});
  if (!done) qFatal("%s", done.error().message().c_str());
  return done->text;
}

inline QString python() {
  return QStandardPaths::findExecutable("python3");
}

/// Runs a program with the file `inputs` of the folder as its standard input.
inline QString outputOf(const TemporaryFolder& folder, const QString& program, const QStringList& words) {
  QProcess process;
  process.setWorkingDirectory(QString::fromStdString(folder.path()));
  process.setStandardInputFile(QString::fromStdString(folder.path("inputs")));
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(program, words);
  if (!process.waitForFinished(60000)) return "it never ended";
  return QString::fromUtf8(process.readAll());
}

inline bool near(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

inline bool wellFormed(const std::string& text) {
  QXmlStreamReader xml(QString::fromStdString(text));
  while (!xml.atEnd()) xml.readNext();
  return !xml.hasError();
}

/// A real rig's recording, and the model that the command fits to it.
struct FittedRig {
  Model model;
  Recording recording;
};

/// `bench` and `recording` in the folder of real recordings; `effects` as `fit` takes them, or none.
inline FittedRig fittedRig(const QString& bench, const QString& recording, const QString& effects) {
  const QString from = QString::fromStdString(realRecordings()) + "/";
  const TemporaryFolder folder;
  QStringList words{"fit", "--bench", from + bench, "--recording", from + recording, "--out", "model.json"};
  if (!effects.isEmpty()) words << "--effects" << effects;
  const Outcome fit = run(builtProgram("breakaway"), words, QString::fromStdString(folder.path()));
  if (fit.status != 0) qFatal("%s", qPrintable(fit.err));
  const auto model = readModel(folder.path("model.json"));
  const auto rows = readCsv((from + recording).toStdString());
  if (!model || !rows) qFatal("a fitted rig can't be read");
  return {*model, *rows};
}

}  // namespace breakaway::test
