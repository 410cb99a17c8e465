#include <QTest>

#include "base/json_object.h"
#include "base/json_text.h"
#include "support/temporary.h"

using namespace breakaway;

class TestJsonObject : public QObject {
  Q_OBJECT
 private slots:
  void nameThatIsNoUtf8_isReplaced();
  void firstFault_isTheOneReported();
  void everyFault_namesItsField_data();
  void everyFault_namesItsField();
  void text_mustBeAnObject_data();
  void text_mustBeAnObject();
  void comment_isAllowedEverywhere();
  void nearestName_forgivesOneSlip_data();
  void nearestName_forgivesOneSlip();
};

/// Reads an object with one field of each kind and returns its line.
static std::string lineOf(const std::string& text) {
  auto root = JsonObject::fromText(text, "f.json");
  if (!root) return root.error().message();
  root->number("mass_kg", 1.0, Allowed::positive);
  root->number("friction_Nm", 1.0, Allowed::nonNegative);
  root->text("name", "");
  root->flag("on", true);
  root->texts("names");
  root->rows("waves", 2);
  JsonObject inner = root->object("inner", false);
  inner.number("length_m", 1.0);
  for (JsonObject& one : root->objects("effects")) one.text("effect");
  const auto done = root->finish();
  return done ? "" : done.error().message();
}

void TestJsonObject::firstFault_isTheOneReported() {
  QCOMPARE(lineOf(R"({"mass_kg": "x", "on": 1})"),
           std::string("f.json, field mass_kg: expected a positive number, found the text \"x\""));
}

void TestJsonObject::everyFault_namesItsField_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* text, const char* line) { QTest::newRow(text) << text << line; };
  row(R"({})", "");
  row(R"({"mass_kg": 0})", "f.json, field mass_kg: expected a positive number, found the number 0");
  row(R"({"friction_Nm": -1})",
      "f.json, field friction_Nm: expected a number that is not negative, found the number -1");
  row(R"({"mass_kg": null})", "f.json, field mass_kg: expected a positive number, found a value of type null");
  row(R"({"name": 3})", "f.json, field name: expected a text, found the number 3");
  row(R"({"on": "yes"})", "f.json, field on: expected true or false, found the text \"yes\"");
  row(R"({"names": ["a", 1]})", "f.json, field names: expected an array of texts, found a value of type array");
  row(R"({"waves": [[1, 2], [1]]})", "f.json, field waves: expected an array of rows of 2 numbers");
  row(R"({"inner": 1})", "f.json, field inner: expected an object, found the number 1");
  row(R"({"inner": {"length_m": true}})",
      "f.json, field inner.length_m: expected a number, found a value of type boolean");
  row(R"({"inner": {"lenght_m": 1}})", "f.json, field inner.lenght_m: is an unknown field, did you mean length_m?");
  row(R"({"new\nline": 1})",
      "f.json, field new\\x0aline: is an unknown field, expected one of: mass_kg, friction_Nm, name, on, names, waves, "
      "inner, effects");
  row(R"({"effects": [{"effect": "a"}, {}]})", "f.json, field effects[1].effect: is missing, expected a text");
  row(R"({"mass": 1})",
      "f.json, field mass: is an unknown field, expected one of: mass_kg, friction_Nm, name, on, names, waves, inner, "
      "effects");
  row(R"({"masskg": 1})", "f.json, field masskg: is an unknown field, did you mean mass_kg?");
}

void TestJsonObject::everyFault_namesItsField() {
  QFETCH(QString, text);
  QFETCH(QString, line);
  QCOMPARE(QString::fromStdString(lineOf(text.toStdString())), line);
}

void TestJsonObject::text_mustBeAnObject_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("line");
  QTest::newRow("empty") << QByteArray() << "f.json: is empty, expected a JSON object";
  QTest::newRow("array") << QByteArray("[1]") << "f.json: expected a JSON object";
  QTest::newRow("broken") << QByteArray("{\n\n\"a\": ]") << "f.json, line 3: is not valid JSON";
  QTest::newRow("bytes") << QByteArray("{\"\xff\xfe\": 1}") << "f.json, line 1: is not valid JSON";
  QTest::newRow("beyond range") << QByteArray("{\"a\": 1e999}")
                                << "f.json: holds a number that is beyond all that can be computed with";
  QTest::newRow("deep") << QByteArray(100000, '[') << "f.json: nests deeper than 100 levels, which is not read";
  QTest::newRow("twice") << QByteArray(R"({"a": {"b": 1, "b": 2}})") << "f.json: has the field b twice in one object";
}

void TestJsonObject::text_mustBeAnObject() {
  QFETCH(QByteArray, text);
  QFETCH(QString, line);
  QCOMPARE(QString::fromStdString(lineOf(text.toStdString())), line);
}

void TestJsonObject::comment_isAllowedEverywhere() {
  QCOMPARE(lineOf(R"({"comment": "a", "inner": {"comment": ["b"]}})"), std::string());
}

void TestJsonObject::nearestName_forgivesOneSlip_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("nearest");
  QTest::newRow("swapped") << "angel"
                           << "angle";
  QTest::newRow("missing") << "inertia_kgm2"
                           << "inertia_kg_m2";
  QTest::newRow("changed") << "scald"
                           << "scale";
  QTest::newRow("nothing near") << "zzz"
                                << "";
  QTest::newRow("empty") << ""
                         << "";
}

void TestJsonObject::nearestName_forgivesOneSlip() {
  QFETCH(QString, name);
  QFETCH(QString, nearest);
  const std::vector<std::string> candidates{"angle", "scale", "inertia_kg_m2"};
  QCOMPARE(QString::fromStdString(nearestName(name.toStdString(), candidates).value_or("")), nearest);
}

void TestJsonObject::nameThatIsNoUtf8_isReplaced() {
  QCOMPARE(asUtf8("Pr\xfc"
                  "fstand"),
           std::string("Pr\xef\xbf\xbd"
                       "fstand"));
  QCOMPARE(asUtf8("Pr\xc3\xbc"
                  "fstand \"3\""),
           std::string("Pr\xc3\xbc"
                       "fstand \"3\""));
}

QTEST_APPLESS_MAIN(TestJsonObject)
#include "tst_json_object.moc"
