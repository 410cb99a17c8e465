#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "diagnose/effects/catalogue.h"
#include "diagnose/simulate/model_file.h"
#include "experiment/profile.h"
#include "friction/map_export.h"
#include "friction/map_json.h"
#include "friction/map_table.h"
#include "house/program.h"
#include "house/pushed_mass.h"
#include "motor/batch_list.h"
#include "motor/bench.h"
#include "plant/rig.h"
#include "support/temporary.h"

using namespace breakaway::test;

/// The JSON Schemas of resources/schemas against every file of the tree, against what the commands write, and against
/// the readers: what one of them refuses, the schema refuses, too.
class TestSchemas : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void schemas_areSound();
  void filesOfTheTree_hold();
  void linesOfLists_hold();
  void whatCommandsWrite_holds_data();
  void whatCommandsWrite_holds();
  void wrongFiles_areRefused();
  void rightFiles_areTaken();
  void names_areThoseOfTheProgram();

 private:
  QString path(const QString& name) const { return QString::fromStdString(folder_.path(name.toStdString())); }
  QJsonObject baseOf(const QString& kind) const;
  struct Edit {
    QString kind, place;
    QJsonValue value;
  };
  /// What schema and reader have against each base file with its edit.
  struct Said {
    QString schema, reader;
  };
  QList<Said> saidOf(const QList<Edit>& edits) const;

  TemporaryFolder folder_;
};

namespace {

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QString root() {
  return qEnvironmentVariable("BREAKAWAY_SOURCE_DIR");
}

QString schemaPath(const QString& kind) {
  return root() + "/resources/schemas/" + kind + ".schema.json";
}

QJsonObject objectIn(const QByteArray& text) {
  return QJsonDocument::fromJson(text).object();
}

/// For each file nothing, or a line that says what the schema has against it. The validator is python3-jsonschema's.
QStringList faultsOf(const QString& kind, const QStringList& files) {
  static const char* const script = R"(
import json, sys
from jsonschema import Draft202012Validator as Validator
schema = json.load(open(sys.argv[1]))
Validator.check_schema(schema)
for path in sys.argv[2:]:
    faults = sorted(Validator(schema).iter_errors(json.load(open(path))), key=lambda one: list(map(str, one.path)))
    print('; '.join('/'.join(map(str, one.path)) + ': ' + ' '.join(one.message[:200].split()) for one in faults))
)";
  const Outcome outcome = run("python3", QStringList{"-c", script, schemaPath(kind)} + files);
  if (outcome.status != 0) qFatal("%s", qPrintable("python3 with jsonschema (packages.txt): " + outcome.err));
  return outcome.out.split('\n').mid(0, files.size());
}

/// What the program's own reader has against a file; empty: nothing.
QString readersFault(const QString& kind, const std::string& path) {
  const auto said = [](const auto& result) {
    return result ? QString() : QString::fromStdString(result.error().message());
  };
  if (kind == "bench") return said(breakaway::readBench(path));
  if (kind == "rig") return said(breakaway::readRig(path));
  if (kind == "profile") return said(breakaway::readProfile(path));
  if (kind == "map") return said(breakaway::readMap(path));
  if (kind == "model") return said(breakaway::readModel(path));
  if (kind == "manifest") return said(breakaway::readBatchList(*breakaway::readFile(path), path));
  return {};
}

/// "breakaway.bench/1" as "bench"; empty for others.
QString kindOf(const QJsonObject& object) {
  const QString schema = object["schema"].toString();
  return schema.startsWith("breakaway.") ? schema.section('.', 1).section('/', 0, 0) : QString();
}

/// `value` with what stands at `path` ("motor/inertia_kg_m2", "findings/0/effect") replaced, or removed.
QJsonValue changed(const QJsonValue& value, const QStringList& path, const QJsonValue& by) {
  if (path.isEmpty()) return by;
  if (value.isArray()) {
    QJsonArray array = value.toArray();
    const int at = path[0].toInt();
    if (at < array.size())
      array[at] = changed(array[at], path.mid(1), by);
    else
      array.append(by);
    return array;
  }
  QJsonObject object = value.toObject();
  const QJsonValue inner = changed(object[path[0]], path.mid(1), by);
  if (inner.isUndefined())
    object.remove(path[0]);
  else
    object[path[0]] = inner;
  return object;
}

const char* const kinds[] = {"bench", "rig", "map", "model", "diagnosis", "manifest", "result", "profile", "tuning"};

// In this order: later ones read what earlier ones wrote.
const std::pair<const char*, QStringList> writingCommands[] = {
    {"commission --turns 1 --bins 36 --run-s 2 --out c", {"c/bench.json", "c/map.json"}},
    {"commission --turns 2 --bins 36 --run-s 2 --board simulated:linear --out l", {"l/bench.json", "l/map.json"}},
    {"tune --bench c/bench.json --out t", {"t/tuning.json", "t/bench.json"}},
    {"profile save --board simulated --profile p.json", {"p.json"}},
    {"fit --bench b.json --recording r.csv --effects stribeck,coulomb_asymmetry --out m.json", {"m.json"}},
    {"diagnose --bench b.json --recording loaded.csv --out d",
     {"d/diagnosis.json", "d/model.json", "d/base_model.json"}},
    {"batch list.jsonl --out results.jsonl", {}},
};

}  // namespace

void TestSchemas::initTestCase() {
  folder_.write("loaded.csv", loadedMassRecording().toStdString());
  folder_.write("b.json", pushedMassBench().toStdString());
  folder_.write("r.csv", pushedMassRecording(200, {}, "time_s,position_m,force_N", 4e-2).toStdString());
  folder_.write("list.jsonl", R"({"id": 1, "bench": "b.json", "recordings": ["loaded.csv"], "site": "x"})"
                              "\n"
                              R"({"id": "none", "bench": "none.json", "recordings": ["r.csv"]})"
                              "\n");
}

void TestSchemas::schemas_areSound() {
  const QString manual = QString::fromUtf8(contentOf(root() + "/resources/help/files.md"));
  QStringList names;
  for (const char* kind : kinds) {
    names << QString(kind) + ".schema.json";
    QCOMPARE(faultsOf(kind, {}), QStringList());
    const QJsonObject schema = objectIn(contentOf(schemaPath(kind)));
    QCOMPARE(schema["$schema"].toString(), QString("https://json-schema.org/draft/2020-12/schema"));
    QVERIFY2(manual.contains("`" + names.last() + "`"), kind);
  }
  names.sort();
  QCOMPARE(QDir(root() + "/resources/schemas").entryList(QDir::Files, QDir::Name), names);
}

void TestSchemas::filesOfTheTree_hold() {
  QMap<QString, QStringList> files;
  for (const char* place : {"/resources", "/tests"}) {
    QDirIterator walk(root() + place, {"*.json"}, QDir::Files, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
      const QString file = walk.next(), kind = kindOf(objectIn(contentOf(file)));
      if (kind.isEmpty() || kind == "progress") continue;
      QVERIFY2(QFile::exists(schemaPath(kind)), qPrintable(file + " has no schema"));
      if (readersFault(kind, file.toStdString()).isEmpty()) files[kind] << file;
    }
  }
  for (auto kind = files.begin(); kind != files.end(); ++kind) {
    const QStringList faults = faultsOf(kind.key(), kind.value());
    for (int k = 0; k < faults.size(); ++k)
      QVERIFY2(faults[k].isEmpty(), qPrintable(kind.value()[k] + " " + faults[k]));
  }
  QVERIFY(files["bench"].size() >= 12 && files["rig"].size() >= 7);
  QVERIFY(!files["map"].isEmpty() && !files["model"].isEmpty() && files["profile"].size() >= 2);
}

void TestSchemas::linesOfLists_hold() {
  const std::pair<const char*, const char*> lists[] = {{"list", "manifest"}, {"results", "result"}};
  for (const auto& [name, kind] : lists) {
    QStringList files;
    for (const QByteArray& line : contentOf(root() + "/tests/fuzz/corpus/batch_list/" + name).split('\n')) {
      if (line.trimmed().isEmpty() || line.contains("\"diagnosis\"")) continue;  // that one is shortened
      files << QString::fromStdString(folder_.write("line" + std::to_string(files.size()), line.toStdString()));
    }
    QVERIFY(!files.isEmpty());
    for (const QString& fault : faultsOf(kind, files)) QVERIFY2(fault.isEmpty(), qPrintable(fault));
  }
}

void TestSchemas::whatCommandsWrite_holds_data() {
  QTest::addColumn<QString>("words");
  QTest::addColumn<QStringList>("files");
  for (const auto& [words, files] : writingCommands) QTest::newRow(words) << QString(words) << files;
}

void TestSchemas::whatCommandsWrite_holds() {
  QFETCH(QString, words);
  QFETCH(QStringList, files);
  const Outcome outcome = run(builtProgram("breakaway"), words.split(' '), path({}));
  QVERIFY2(outcome.status == 0, qPrintable(outcome.err));
  if (words.startsWith("batch")) {
    int lines = 0;
    for (const QByteArray& line : contentOf(path("results.jsonl")).trimmed().split('\n')) {
      const std::string file = folder_.write("result" + std::to_string(lines++), line.toStdString());
      QCOMPARE(faultsOf("result", {QString::fromStdString(file)}), QStringList{""});
      const QJsonObject diagnosis = objectIn(line)["diagnosis"].toObject();
      if (diagnosis.isEmpty()) continue;
      folder_.write("diagnosis", QJsonDocument(diagnosis).toJson().toStdString());
      QCOMPARE(faultsOf("diagnosis", {path("diagnosis")}), QStringList{""});
    }
    QCOMPARE(lines, 2);
  }
  for (const QString& file : files) {
    const QString kind = kindOf(objectIn(contentOf(path(file))));
    QVERIFY2(!kind.isEmpty(), qPrintable(file));
    const QStringList faults = faultsOf(kind, {path(file)});
    QVERIFY2(faults == QStringList{""}, qPrintable(file + " " + faults.join(' ')));
  }
}

/// A file of that kind that is as it must be.
QJsonObject TestSchemas::baseOf(const QString& kind) const {
  const QString presets = root() + "/resources/presets/", corpus = root() + "/tests/fuzz/corpus/";
  if (kind == "bench") return objectIn(contentOf(presets + "servo.bench.json"));
  if (kind == "linear bench") return objectIn(contentOf(presets + "linear.bench.json"));
  if (kind == "servo bench")
    return objectIn(R"({"schema": "breakaway.bench/1", "drive": {"input": "angle_reference_rad"}, "controller":
      {"mode": "position", "kp_Nm_per_rad": 2, "kd_Nm_s_per_rad": 0.1, "rate_Hz": 100}})");
  if (kind == "rig") return objectIn(contentOf(presets + "servo.rig.json"));
  if (kind == "linear rig") return objectIn(contentOf(presets + "linear.rig.json"));
  if (kind == "map") return objectIn(contentOf(path("c/map.json")));
  if (kind == "linear map") return objectIn(contentOf(path("l/map.json")));
  if (kind == "model") return objectIn(contentOf(path("m.json")));
  if (kind == "profile") return objectIn(contentOf(corpus + "profile/table.json"));
  if (kind == "tuning") return objectIn(contentOf(path("t/tuning.json")));
  if (kind == "diagnosis") return objectIn(contentOf(path("d/diagnosis.json")));
  if (kind == "manifest") return {{"id", "a"}, {"bench", "b.json"}, {"recordings", QJsonArray{"r.csv"}}};
  return {{"id", "a"}, {"error", "b.json: cannot be read"}};
}

/// The last word of an edit's kind is its schema's.
QList<TestSchemas::Said> TestSchemas::saidOf(const QList<Edit>& edits) const {
  QList<Said> said(edits.size());
  for (const char* kind : kinds) {
    QStringList files;
    QList<Said*> theirs;
    for (int k = 0; k < edits.size(); ++k) {
      if (edits[k].kind.section(' ', -1) != kind) continue;
      const QJsonObject object = changed(baseOf(edits[k].kind), edits[k].place.split('/'), edits[k].value).toObject();
      const std::string file = folder_.write("edit" + std::to_string(k) + ".json",
                                             QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString());
      files << QString::fromStdString(file);
      theirs << &said[k];
      said[k].reader = readersFault(kind, file);
    }
    const QStringList faults = files.isEmpty() ? QStringList() : faultsOf(kind, files);
    for (int k = 0; k < files.size(); ++k) theirs[k]->schema = faults[k];
  }
  return said;
}

static QString inWords(const QString& kind, const QString& place, const QJsonValue& value) {
  return kind + " " + place + " " + QString::fromUtf8(QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact));
}

void TestSchemas::wrongFiles_areRefused() {
  QList<Edit> edits;
  const auto row = [&edits](const char* kind, const char* place, const QJsonValue& value) {
    edits << Edit{kind, place, value};
  };
  const QJsonValue none = QJsonValue::Undefined;
  row("bench", "schema", "breakaway.bench/2");
  row("bench", "schema", none);
  row("bench", "drive", none);
  row("bench", "drive/input", none);
  row("bench", "drive/input", "force_N");
  row("bench", "drive/input", "volts");
  row("bench", "drive/supply_V", 0);
  row("bench", "drive/current_gain_interval", 0.6);
  row("bench", "drive/duty_curve", QJsonArray{QJsonArray{0.1, 0.0}});
  row("bench", "axis", "circular");
  row("bench", "motor/inertia_kgm2", 1e-5);
  row("bench", "motor/inertia_kg_m2", -1e-5);
  row("bench", "motor/resistance_ohm", "1.2");
  row("bench", "motor/resistance_ohm", QJsonValue::Null);
  row("bench", "motor/coulomb_Nm", -0.1);
  row("bench", "motor/mass_kg", 1);
  row("bench", "motor/pole_pairs", 2.5);
  row("bench", "encoder/counts_per_m", 100);
  row("bench", "encoder/counts_per_rev", 0);
  row("bench", "trusted", QJsonArray{"inertia"});
  row("bench", "trusted", QJsonArray{"controller.kp_Nm_per_rad"});
  row("bench", "load", QJsonObject{{"pendulum", QJsonObject{{"mass_kg", 1}}}});
  row("bench", "controller", QJsonObject{{"mode", "torque"}});
  row("bench", "controller", QJsonObject{{"mode", "velocity"}, {"kp_A_per_rad", 1}});
  row("bench", "motor_seriel", "0117");
  row("linear bench", "motor/inertia_kg_m2", 1e-5);
  row("linear bench", "drive/input", "torque_Nm");
  row("linear bench", "load", QJsonObject{{"pendulum", QJsonObject{{"mass_kg", 1}, {"length_m", 1}}}});
  row("servo bench", "controller/mode", "velocity");
  row("servo bench", "controller/current_limit_A", 1);
  row("servo bench", "controller/kp_Nm_per_rad", 0);
  row("servo bench", "controller/kp_A_s_per_rad", 1);
  row("rig", "schema", none);
  row("rig", "loop_rate_Hz", 100);
  row("rig", "loop_rate_Hz", none);
  row("rig", "motor/inductance_H", none);
  row("rig", "motor/mass_kg", 1);
  row("rig", "friction/static_cw", none);
  row("rig", "friction/coulomb_ccw/mean", -0.1);
  row("rig", "friction/coulomb_ccw/harmonics", QJsonArray{QJsonArray{1.5, 0.1, 0.0}});
  row("rig", "friction/coulomb_ccw/harmonics", QJsonArray{QJsonArray{1, 0.1}});
  row("rig", "friction/scatter_rms", 0.4);
  row("rig", "friction/stribeck_velocity_m_per_s", 1);
  row("rig", "position_force", QJsonObject{});
  row("rig", "travel", QJsonObject{{"length_m", 1}});
  row("rig", "encoder/counts_per_rev", 32);
  row("rig", "encoder/quadrature_error_counts", 0.6);
  row("rig", "current_sensor/adc_bits", 12.5);
  row("rig", "current_sensor/gain_error", 0.6);
  row("rig", "bridge/supply_V", none);
  row("rig", "bridge/dead_zone_duty", 0.7);
  row("rig", "coupling", QJsonObject{{"stiffness_Nm_per_rad", 1}});
  row("rig", "effects", QJsonArray{QJsonObject{{"effect", "backlash"}}});
  row("rig", "effects", QJsonArray{QJsonObject{{"effect", "cogging"}, {"parameters", QJsonObject{{"amplitude", 1}}}}});
  row("rig", "faults", QJsonArray{QJsonObject{{"fault", "link"}}});
  row("rig", "faults", QJsonArray{QJsonObject{{"fault", "supply_drop"}, {"part", 1.5}}});
  row("rig", "faults", QJsonArray{QJsonObject{{"fault", "blocked"}, {"position_m", 1.5}}});
  row("rig", "wiring", QJsonArray{QJsonObject{{"fault", "counts_factor"}}});
  row("rig", "wiring", QJsonArray{QJsonObject{{"fault", "counts_factor"}, {"value", 0}}});
  row("rig", "wiring", QJsonArray{QJsonObject{{"fault", "stop_at_m"}, {"value", 1}}});
  row("linear rig", "travel", none);
  row("linear rig", "travel/length_m", 200);
  row("linear rig", "effects", QJsonArray{QJsonObject{{"effect", "cogging"}}});
  row("linear rig", "wiring", QJsonArray{QJsonObject{{"fault", "pendulum_Nm"}, {"value", 1}}});
  row("linear rig", "position_torque", QJsonObject{});
  row("map", "schema", "breakaway.model/1");
  row("map", "bins", QJsonArray{});
  row("map", "bins/3/static_cw_Nm", none);
  row("map", "bins/3/static_cw_Nm", "0.02");
  row("map", "bins/3/samples_cw", -1);
  row("map", "turns", -1);
  row("map", "turns", 2);  // and no repeatability
  row("map", "total_velocity_rad_per_s", none);
  row("map", "coulomb_average_Nm/value", none);
  row("map", "axis", "linear");
  row("linear map", "repeatability/cw/rms_difference_N", none);
  row("linear map", "bins/0/position_m", none);
  row("model", "axis", none);
  row("model", "input", "torque_Nm");
  row("model", "base", none);
  row("model", "base/mass_kg/ci95", QJsonArray{1.0});
  row("model", "base/mass_kg/value", "95");
  row("model", "effects/0/effect", "stribek");
  row("model", "effects/0/parameters", none);
  row("model", "supply_V", 0);
  row("model", "restart_horizon_s", -1);
  row("profile", "firmware", none);
  row("profile", "parameters/velocity_kp_A_s_per_rad", none);
  row("profile", "parameters/current_limit_A", -1);
  row("profile", "parameters/current_limit", 1);
  row("profile", "friction_table/index_angle_rad", none);
  row("profile", "friction_table/coulomb_cw_Nm", QJsonArray{"x"});
  row("manifest", "id", true);
  row("manifest", "bench", none);
  row("manifest", "recordings", "r.csv");
  row("manifest", "recordings", QJsonArray{});
  row("manifest", "heldout", QJsonArray{1});
  row("result", "error", none);
  row("result", "diagnosis", QJsonObject{{"schema", "breakaway.diagnosis/1"}});
  row("result", "id", none);
  row("diagnosis", "verdict", "good");
  row("diagnosis", "verdict", "nothing_missing");  // with a finding
  row("diagnosis", "findings", QJsonArray{});      // and named
  row("diagnosis", "findings/0/share", 1.5);
  row("diagnosis", "findings/0/parameters", QJsonObject{});
  row("diagnosis", "findings/0/effect", "magic");
  row("diagnosis", "fit/heldout/before", -1);
  row("diagnosis", "fit/channel", "angle");
  row("diagnosis", "wander/rms_N", none);
  row("diagnosis", "base/coulomb", QJsonObject{{"value", 1}});
  row("diagnosis", "made/inputs/0/sha256", "abc");
  row("diagnosis", "made", none);
  row("tuning", "stiffness", "hard");
  row("tuning", "controller/kp_A_s_per_rad", none);
  row("tuning", "position_controller/mode", "velocity");
  row("tuning", "velocity/worst/gain_margin", "large");
  row("tuning", "motor/inertia_kg_m2", none);
  const QList<Said> said = saidOf(edits);
  for (int k = 0; k < edits.size(); ++k) {
    const auto& [kind, place, value] = edits[k];
    QVERIFY2(!said[k].schema.isEmpty(), qPrintable("the schema takes " + inWords(kind, place, value)));
    const bool isRead = !QStringList{"diagnosis", "tuning", "result"}.contains(kind);
    QVERIFY2(!isRead || !said[k].reader.isEmpty(), qPrintable("the program takes " + inWords(kind, place, value)));
  }
}

void TestSchemas::rightFiles_areTaken() {
  QList<Edit> edits;
  const auto row = [&edits](const char* kind, const char* place, const QJsonValue& value) {
    edits << Edit{kind, place, value};
  };
  for (const char* kind : {"bench", "linear bench", "servo bench", "rig", "linear rig", "model", "profile"})
    row(kind, "comment", "ours");
  for (const char* kind : {"map", "linear map", "diagnosis", "tuning", "manifest", "result"}) row(kind, "site", "Graz");
  row("bench", "motor", QJsonValue::Undefined);
  row("bench", "axis", QJsonValue::Undefined);
  row("bench", "motor/comment", QJsonArray{"why", 1});
  row("bench", "controller", QJsonObject{{"mode", "open_loop"}, {"kp_whatever", 1}});
  row("bench", "load", QJsonObject{{"pendulum", QJsonObject{{"mass_kg", 0}, {"length_m", 1}}}});
  row("servo bench", "trusted", QJsonArray{"controller.kp_Nm_per_rad", "controller.delay_s"});
  row("rig", "effects",
      QJsonArray{QJsonObject{{"effect", "cogging"}, {"parameters", QJsonObject{{"order", 7}}}},
                 QJsonObject{{"effect", "dead_time"}}});
  row("rig", "faults", QJsonArray{QJsonObject{{"fault", "blocked"}, {"angle_rad", -1}, {"start_s", 3}}});
  row("rig", "wiring",
      QJsonArray{QJsonObject{{"fault", "counts_factor"}, {"value", 4}, {"from_s", 60}},
                 QJsonObject{{"fault", "lead_off"}}});
  row("rig", "coupling", QJsonObject{{"stiffness_Nm_per_rad", 1}, {"load_inertia_kg_m2", 1e-4}, {"gap_rad", 0.01}});
  row("linear rig", "wiring", QJsonArray{QJsonObject{{"fault", "load_N"}, {"value", -1}}});
  row("linear rig", "encoder/index_m", QJsonValue::Undefined);
  row("profile", "friction_table", QJsonValue::Undefined);
  row("manifest", "heldout", QJsonArray{});
  const QList<Said> said = saidOf(edits);
  for (int k = 0; k < edits.size(); ++k) {
    const auto& [kind, place, value] = edits[k];
    QVERIFY2(said[k].schema.isEmpty() && said[k].reader.isEmpty(),
             qPrintable(inWords(kind, place, value) + ": " + said[k].schema + said[k].reader));
  }
}

static QStringList textsIn(const QJsonValue& array) {
  QStringList texts;
  for (const auto& one : array.toArray()) texts << one.toString();
  texts.sort();
  return texts;
}

static QJsonValue at(QJsonValue value, const QString& place) {
  for (const QString& name : place.split('/')) value = value.isArray() ? value.toArray().at(name.toInt()) : value[name];
  return value;
}

void TestSchemas::names_areThoseOfTheProgram() {
  const auto schema = [](const char* kind) { return QJsonValue(objectIn(contentOf(schemaPath(kind)))); };
  QStringList effects;
  for (const breakaway::Effect* one : breakaway::catalogue())
    effects << QString::fromUtf8(one->name().data(), static_cast<qsizetype>(one->name().size()));
  effects.sort();
  QCOMPARE(textsIn(at(schema("model"), "properties/effects/items/properties/effect/enum")), effects);
  QCOMPARE(textsIn(at(schema("diagnosis"), "properties/findings/items/properties/effect/enum")), effects);

  QMap<QString, QStringList> concealed, known;
  for (const auto& kind : at(schema("rig"), "else/properties/effects/items/oneOf").toArray()) {
    QStringList& names = concealed[at(kind, "properties/effect/const").toString()];
    names = at(kind, "properties/parameters/properties").toObject().keys();
    names.removeAll("comment");
    names.removeAll("made");
  }
  for (const breakaway::RigEffectKind& kind : breakaway::rigEffectKinds()) {
    QStringList& names = known[QString::fromStdString(kind.effect)];
    for (const auto& [name, value] : kind.parameters) names << QString::fromStdString(name);
    names.sort();
  }
  QCOMPARE(concealed, known);

  QStringList parameters;
  for (const breakaway::ProfileParameter& one : breakaway::profileParameters()) {
    const QString path = QString("properties/parameters/properties/") + one.name;
    QVERIFY2(at(schema("profile"), path).isObject(), one.name);
    if (!breakaway::mayBeUnsaid(one.value)) parameters << one.name;
  }
  parameters.sort();
  QCOMPARE(textsIn(at(schema("profile"), "properties/parameters/required")), parameters);

  for (const breakaway::Axis axis : {breakaway::Axis::rotary, breakaway::Axis::linear}) {
    breakaway::FrictionMap map;
    map.axis = axis;
    QStringList columns;
    for (const breakaway::MapColumn& one : breakaway::mapTable(map)) columns << QString::fromStdString(one.name);
    columns.removeIf([](const QString& name) { return name.startsWith("outlier"); });
    columns.sort();
    const QString part = axis == breakaway::Axis::linear ? "allOf/0/then" : "allOf/0/else";
    QCOMPARE(textsIn(at(schema("map"), part + "/properties/bins/items/required")), columns);
  }
}

QTEST_GUILESS_MAIN(TestSchemas)
#include "tst_schemas.moc"
