// Both languages are complete: every text of the window and every message of core has its German, with the same places.
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <filesystem>
#include <map>
#include <set>

#include "base/catalogue.h"
#include "base/message.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/effects/wording.h"
#include "motor/bench.h"

using namespace breakaway;

class TestLanguages : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void message_isEnglishUnlessACatalogueHasIt();
  void message_keepsItsFormatsAndMayTurnItsValuesRound();
  void joinedMessages_areEachInTheirLanguage();
  void errors_sayTheirFactInTheLanguage();
  void catalogue_refusesOtherPlaces();
  void everyMessage_hasItsGerman();
  void everyName_hasItsGerman();
  void noGerman_isLeftOver();
  void everyTextOfTheWindow_hasItsGerman();
  void windowTexts_areSeenByLupdate();

 private:
  QString root_ = qEnvironmentVariable("BREAKAWAY_SOURCE_DIR");
  Catalogue german_;
};

namespace {

QString textOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList sourcesIn(const QString& folder) {
  QStringList found;
  for (const auto& one : std::filesystem::recursive_directory_iterator(folder.toStdString())) {
    const QString path = QString::fromStdString(one.path().string());
    if (path.endsWith(".cpp") || path.endsWith(".h")) found << path;
  }
  return found;
}

/// Literals beside each other, as the compiler joins them.
QString joinedLiterals(const QString& source) {
  static const QRegularExpression literal(R"re("((?:[^"\\]|\\.)*)")re");
  QString text;
  for (auto all = literal.globalMatch(source); all.hasNext();) text += all.next().captured(1);
  return text.replace("\\\"", "\"").replace("\\n", "\n").replace("\\\\", "\\");
}

/// What stands as a literal in message(), marked() and the constructor of a Step; where.
std::map<std::string, QString> messagesIn(const QString& source, const QString& where) {
  static const QRegularExpression comment("^ *//.*$", QRegularExpression::MultilineOption);
  static const QRegularExpression made(R"re(\b(?:message|marked|Step)\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)[,)])re");
  std::map<std::string, QString> found;
  for (auto all = made.globalMatch(QString(source).remove(comment)); all.hasNext();)
    found.emplace(joinedLiterals(all.next().captured(1)).toStdString(), where);
  return found;
}

std::map<std::string, QString> allMessages(const QString& root) {
  std::map<std::string, QString> found;
  for (const char* folder : {"/core", "/firmware_link", "/app"}) {
    for (const QString& path : sourcesIn(root + folder)) found.merge(messagesIn(textOf(path), path.section('/', -2)));
  }
  return found;
}

/// Whether there is a word outside of the places.
bool hasWords(const std::string& text) {
  static const QRegularExpression places("\\{[^}]*\\}"), letters("[A-Za-z]{2}");
  return QString::fromStdString(text).remove(places).contains(letters);
}

/// A parameter's name without its unit, as the window takes it apart; the window's own list of units is longest first.
QString withoutUnit(const QString& name) {
  static const QRegularExpression unit(
      "_(Nm_s2_per_rad2|N_s2_per_m2|Nm_s_per_rad|N_s_per_m|V_s_per_rad|V_s_per_m|Nm_per_rad|N_per_m|Nm_per_A|N_per_A|"
      "Nm_per_s|rad_per_s|m_per_s|ohm_per_A2|per_Nm|per_A2|per_rad|per_m|per_A|per_N|per_s|kg_m2|ohm|degC|rad|Nm|kg|Hz|"
      "ms|N|m|s|A|V|H|J|K|W)$");
  return QString(name).remove(unit);
}

QStringList placesOf(const QString& text) {
  static const QRegularExpression place("%[0-9n]");
  QStringList found;
  for (auto all = place.globalMatch(text); all.hasNext();) found << all.next().captured();
  found.sort();
  return found;
}

struct Translation {
  QString text;
  bool finished = false;
};

/// By context and source.
std::map<std::pair<QString, QString>, Translation> translationsIn(const QString& path) {
  std::map<std::pair<QString, QString>, Translation> found;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return found;
  QXmlStreamReader xml(&file);
  QString context, source;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == u"name") context = xml.readElementText();
    if (xml.name() == u"source") source = xml.readElementText();
    if (xml.name() == u"translation") {
      const bool unfinished = xml.attributes().hasAttribute("type");
      found[{context, source}] = {xml.readElementText(), !unfinished};
    }
  }
  return found;
}

/// Translated texts that are only looked up when shown are marked where they stand.
QStringList unseenIn(const QString& source, const QString& where) {
  static const QRegularExpression unmarked(
      R"re((?:QString (\w+)\(const char\* text\) \{\s*return|const auto (\w+) = \[[^\]]*\]\(const char\* text\) \{\s*return) QCoreApplication::translate)re");
  QStringList found;
  for (auto all = unmarked.globalMatch(source); all.hasNext();) {
    const auto one = all.next();
    const QString name = one.captured(1).isEmpty() ? one.captured(2) : one.captured(1);
    if (source.contains(QRegularExpression("\\b" + name + "\\(\""))) found << where + ": " + name + "(\"…\")";
  }
  return found;
}

}  // namespace

void TestLanguages::initTestCase() {
  const auto read = Catalogue::read(textOf(root_ + "/resources/lang/core_de.json").toStdString());
  QVERIFY2(read.ok(), read ? "" : read.error().message().c_str());
  german_ = *read;
  QVERIFY(german_.all().size() > 300);
}

void TestLanguages::message_isEnglishUnlessACatalogueHasIt() {
  const Message rows = message("{} rows of {}", 12, "a.csv");
  QCOMPARE(rows.english(), std::string("12 rows of a.csv"));
  QCOMPARE(rows.in(Catalogue()), rows.english());
  const auto other = Catalogue::read(R"({"{} rows of {}": "{} Zeilen von {}"})");
  QVERIFY(other.ok());
  QCOMPARE(rows.in(*other), std::string("12 Zeilen von a.csv"));
  QCOMPARE(Message(std::string("{} rows of {}")).in(*other), std::string("{} rows of {}"));  // as it is
}

void TestLanguages::message_keepsItsFormatsAndMayTurnItsValuesRound() {
  const Message moved = message("moved by {:.3f} A within {:.1f} s", 0.12345, 2.0);
  QCOMPARE(moved.english(), std::string("moved by 0.123 A within 2.0 s"));
  const auto other = Catalogue::read(R"({"moved by {:.3f} A within {:.1f} s": "in {1} s um {0} A"})");
  QVERIFY(other.ok());
  QCOMPARE(moved.in(*other), std::string("in 2.0 s um 0.123 A"));
}

void TestLanguages::joinedMessages_areEachInTheirLanguage() {
  const auto other = Catalogue::read(R"({"torque": "Drehmoment", "{} less": "{} weniger", " and ": " und "})");
  QVERIFY(other.ok());
  const Message both =
      message("{} less", message("torque")) + ". " + listed({Message("a"), Message("b")}, message(" and "));
  QCOMPARE(both.english(), std::string("torque less. a and b"));
  QCOMPARE(both.in(*other), std::string("Drehmoment weniger. a und b"));
  QCOMPARE(listed({Message("a"), Message("b"), Message("c")}, message(" and ")).english(), std::string("a, b and c"));
}

void TestLanguages::errors_sayTheirFactInTheLanguage() {
  const auto other = Catalogue::read(R"({"has {} rows": "hat {} Zeilen"})");
  QVERIFY(other.ok());
  const Error error{"a.csv", message("has {} rows", 3)};
  QCOMPARE(error.message(), std::string("a.csv: has 3 rows"));
  QCOMPARE(error.said().in(*other), std::string("a.csv: hat 3 Zeilen"));
  const Error plain{"a.csv", "is empty"};
  QCOMPARE(plain.said().in(*other), std::string("a.csv: is empty"));
  QCOMPARE((Error{"a\nb", message("has {} rows", 3)}.said().in(*other)), std::string("a\\x0ab: has 3 rows"));
}

void TestLanguages::catalogue_refusesOtherPlaces() {
  QVERIFY(Catalogue::read(R"({"{} of {}": "{1} aus {0}"})").ok());
  for (const char* bad : {R"({"{} of {}": "{} aus"})", R"({"{} of {}": "{} {} {}"})", R"({"{:.3g} A": "{1} A"})", "[]",
                          "{", R"({"a": 1})"})
    QVERIFY2(!Catalogue::read(bad).ok(), bad);
}

void TestLanguages::everyMessage_hasItsGerman() {
  QCOMPARE(messagesIn("x = message(\"a {} \"\n  \"b\", 1); Step(\"c\", {})", "").size(), size_t(2));
  QVERIFY(messagesIn("message(\"a {} \"\n  \"b\", 1)", "").contains("a {} b"));
  const auto messages = allMessages(root_);
  QVERIFY(messages.size() > 300);
  QStringList missing;
  for (const auto& [text, where] : messages) {
    if (hasWords(text) && german_.find(text) == nullptr) missing << where + ": " + QString::fromStdString(text);
  }
  QVERIFY2(missing.isEmpty(), qPrintable("no German in resources/lang/core_de.json:\n" + missing.join('\n')));
}

/// What files name with underscores, the window shows as words.
void TestLanguages::everyName_hasItsGerman() {
  std::set<QString> names;
  for (const Axis axis : {Axis::rotary, Axis::linear}) {
    const MotorNames& motor = motorNames(axis);
    for (const char* name : {motor.torqueConstant, motor.backEmfConstant, motor.resistance, motor.inductance,
                             motor.inertia, motor.viscous, motor.coulomb, driveLateName, biasName(axis)})
      names.insert(withoutUnit(name));
    for (const Effect* effect : catalogue()) {
      names.insert(QString::fromStdString(effectName(*effect).english()));
      for (const ParameterSpec& one : effect->parameters(axis))
        names.insert(withoutUnit(QString::fromStdString(one.name)));
    }
  }
  QStringList missing;
  for (const QString& name : names) {
    if (german_.find(name.toStdString()) == nullptr) missing << name;
  }
  QVERIFY2(missing.isEmpty(), qPrintable("no German name: " + missing.join(", ")));
}

void TestLanguages::noGerman_isLeftOver() {
  const auto messages = allMessages(root_);
  QStringList stale;
  for (const auto& [english, other] : german_.all()) {
    const bool isName = QRegularExpression("^[a-z0-9_]+$").match(QString::fromStdString(english)).hasMatch();
    if (!isName && !messages.contains(english)) stale << QString::fromStdString(english);
  }
  QVERIFY2(stale.isEmpty(), qPrintable("nothing says these any more:\n" + stale.join('\n')));
}

void TestLanguages::everyTextOfTheWindow_hasItsGerman() {
  QString lupdate;
  for (const char* place : {"/usr/lib/qt6/bin/lupdate", "/usr/bin/lupdate6", "/usr/bin/lupdate-qt6"}) {
    if (lupdate.isEmpty() && QFile::exists(place)) lupdate = place;
  }
  QVERIFY2(!lupdate.isEmpty(), "lupdate (package qt6-l10n-tools) is missing");
  const QTemporaryDir folder;
  const QString fresh = folder.filePath("window.ts");
  QProcess process;
  process.start(lupdate, {"-silent", "-locations", "none", "-source-language", "en", "-target-language", "de_DE",
                          root_ + "/app", "-ts", fresh});
  QVERIFY(process.waitForFinished(60'000) && process.exitCode() == 0);
  const auto asked = translationsIn(fresh), kept = translationsIn(root_ + "/resources/lang/window_de.ts");
  QVERIFY(asked.size() > 900);
  QStringList wrong;
  for (const auto& [key, unused] : asked) {
    const auto& [context, source] = key;
    const auto found = kept.find(key);
    const QString name = context + ": " + source;
    if (found == kept.end() || !found->second.finished || found->second.text.isEmpty())
      wrong << name + " has no German";
    else if (placesOf(source) != placesOf(found->second.text))
      wrong << name + " has other places";
  }
  for (const auto& [key, unused] : kept) {
    if (!asked.contains(key)) wrong << key.first + ": " + key.second + " isn't said any more";
  }
  QVERIFY2(wrong.isEmpty(), qPrintable("resources/lang/window_de.ts:\n" + wrong.join('\n')));
}

void TestLanguages::windowTexts_areSeenByLupdate() {
  QVERIFY(!unseenIn("QString words(const char* text) {\n  return QCoreApplication::translate(\"A\", text);\n}\n"
                    "auto x = words(\"time\");",
                    "")
               .isEmpty());
  QStringList unseen;
  for (const QString& path : sourcesIn(root_ + "/app")) unseen += unseenIn(textOf(path), path.section('/', -2));
  QVERIFY2(unseen.isEmpty(), qPrintable("mark them by QT_TRANSLATE_NOOP: " + unseen.join(", ")));
}

QTEST_GUILESS_MAIN(TestLanguages)
#include "tst_languages.moc"
