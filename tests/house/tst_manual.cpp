// The manual keeps up with the program: every effect and command is in it, and every link leads somewhere.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMap>
#include <QRegularExpression>
#include <QTest>
#include <algorithm>

#include "diagnose/effects/catalogue.h"
#include "diagnose/model/criteria.h"
#include "house/program.h"

using namespace breakaway;
using namespace breakaway::test;

class TestManual : public QObject {
  Q_OBJECT
 private slots:
  void everyEffect_hasItsWholeEntry();
  void everyEntry_isAnEffect();
  void poorEntry_isFound();
  void everyCommand_isInTheManual();
  void everyCriterion_isInTheAppendix();
  void criteria_areAFewAndWhole();
  void everyPlaceInTheArchitecture_isThere();
  void plantedPlace_isMissed();
  void everyLink_leadsSomewhere();
  void plantedLink_isFollowed_data();
  void plantedLink_isFollowed();
};

static QString helpFolder() {
  return qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/resources/help";
}

static QString contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

static QString textOf(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// The headings of the given level and what stands below each, up to the next heading of that level or above.
static QMap<QString, QString> sectionsOf(const QString& markdown, int level) {
  QMap<QString, QString> sections;
  const QRegularExpression heading("^(#{1," + QString::number(level) + "}) (.*)$");
  QString name;
  for (const QString& line : markdown.split('\n')) {
    const auto match = heading.match(line);
    if (match.hasMatch()) {
      name = match.capturedLength(1) == level ? match.captured(2) : QString();
      if (!name.isEmpty()) sections[name];
    } else if (!name.isEmpty()) {
      sections[name] += line + '\n';
    }
  }
  return sections;
}

/// What an entry has to say of an effect and doesn't.
static QStringList missingFrom(const QString& entry, const Effect& effect) {
  QStringList needed{"**Formula**: `" + textOf(effect.formula()) + "`", "**Source**: " + textOf(effect.source())};
  for (const ParameterSpec& one : effect.parameters(Axis::rotary))
    needed << "`" + QString::fromStdString(one.name) + "` (";
  for (const std::string_view one : effect.lookAlikes()) needed << "(#" + textOf(one) + ")";
  QStringList missing;
  for (const QString& words : needed) {
    if (!entry.simplified().contains(words.simplified())) missing << words;
  }
  return missing;
}

void TestManual::everyEffect_hasItsWholeEntry() {
  const auto entries = sectionsOf(contentOf(helpFolder() + "/effects.md"), 3);
  for (const Effect* effect : catalogue()) {
    const QString name = textOf(effect->name());
    QVERIFY2(entries.contains(name), qPrintable("no heading " + name));
    const QStringList missing = missingFrom(entries[name], *effect);
    QVERIFY2(missing.isEmpty(), qPrintable(name + " lacks " + missing.join("; ")));
  }
}

void TestManual::everyEntry_isAnEffect() {
  const QStringList names = sectionsOf(contentOf(helpFolder() + "/effects.md"), 3).keys();
  QCOMPARE(names.size(), static_cast<qsizetype>(catalogue().size()));
  for (const QString& name : names) QVERIFY2(findEffect(name.toStdString()) != nullptr, qPrintable(name));
}

void TestManual::poorEntry_isFound() {
  const auto entries = sectionsOf(contentOf(helpFolder() + "/effects.md"), 3);
  const Effect& effect = *findEffect("stribeck");
  QString entry = entries["stribeck"];
  QVERIFY(missingFrom(entry, effect).isEmpty());
  QCOMPARE(missingFrom(entry.remove("`exponent`"), effect), QStringList{"`exponent` ("});
  QVERIFY(missingFrom(entries["cogging"], effect).size() > 3);
}

void TestManual::everyCommand_isInTheManual() {
  const Outcome help = run(builtProgram("breakaway"), {"--help"});
  QCOMPARE(help.status, 0);
  const QString manual = contentOf(helpFolder() + "/commands.md");
  const QStringList lines = help.out.section("Subcommands:", 1).section("\n\n", 0, 0).split('\n', Qt::SkipEmptyParts);
  QVERIFY(lines.size() >= 8);
  for (const QString& line : lines) {
    const QString command = line.trimmed().section(' ', 0, 0);
    QVERIFY2(manual.contains("\n| `" + command + " "), qPrintable(command));
  }
  QVERIFY(!manual.contains("\n| `unheard-of "));
}

/// `./dev bench diagnosis --criteria` prints the table that belongs there.
void TestManual::everyCriterion_isInTheAppendix() {
  const QString appendix = contentOf(helpFolder() + "/criteria.md");
  const QString table = textOf(criteriaMarkdown());
  QVERIFY(table.count('\n') > 20);
  QVERIFY2(appendix.endsWith("\n\n" + table), qPrintable(table));
  const QString method = contentOf(helpFolder() + "/method.md");
  for (const Criterion& one : criteriaTable()) {
    // A word of several parts is written as one, or as the words it is made of.
    QString spaced = textOf(one.name);
    spaced.replace(QRegularExpression("([A-Z])"), " \\1");
    QVERIFY2(method.contains('*' + textOf(one.name) + '*') || method.contains('*' + spaced.toLower() + '*') ||
                 method.contains('*' + spaced.toLower().replace(" floor", " the floor") + '*'),
             qPrintable("the method doesn't ask for " + textOf(one.name)));
  }
}

void TestManual::criteria_areAFewAndWhole() {
  QVERIFY(criteriaTable().size() <= 40);
  QCOMPARE(criteriaTable().size() * sizeof(double), sizeof(Criteria));  // each is in the table
  for (const Criterion& one : criteriaTable()) {
    const std::string name(one.name);
    QVERIFY2(Criteria{}.*one.value > 0.0 && !one.asks.empty() && !one.setBy.empty(), name.c_str());
    const auto larger = varied({}, one.name, 1.3);
    QVERIFY(larger);
    QCOMPARE((*larger).*one.value, 1.3 * Criteria{}.*one.value);
    QVERIFY(*larger != Criteria{});
  }
  const auto unknown = varied({}, "guesswork", 1.3);
  QVERIFY(!unknown);
  QVERIFY(unknown.error().message().find("guesswork: is no criterion; there are: negligible, ") == 0);
}

/// The anchors that headings make: small letters, blanks as dashes, no punctuation.
static QStringList anchorsIn(const QString& markdown) {
  QStringList anchors;
  for (const QString& line : markdown.split('\n')) {
    if (!line.startsWith('#')) continue;
    QString anchor = line.section(' ', 1).toLower();
    anchors << anchor.remove(QRegularExpression("[^\\w -]")).replace(' ', '-');
  }
  return anchors;
}

/// The relative links of a text in `folder` that lead to no file, or to no heading of one. `self` is the text's file.
static QStringList deadLinks(const QString& markdown, const QString& self) {
  QStringList dead;
  const QRegularExpression link("\\]\\(([^)\\s]+)\\)");
  for (auto it = link.globalMatch(markdown); it.hasNext();) {
    const QString target = it.next().captured(1);
    if (target.contains("://")) continue;
    const QString file = target.section('#', 0, 0), anchor = target.section('#', 1);
    const QString path = file.isEmpty() ? self : QFileInfo(self).absolutePath() + "/" + file;
    const bool leads = QFileInfo(path).isFile() && (anchor.isEmpty() || anchorsIn(contentOf(path)).contains(anchor));
    if (!leads) dead << target;
  }
  return dead;
}

/// Files and folders that a text names between backticks, as long as they have a slash, and that aren't there: from the
/// repository's root, or from one of the folders that the text speaks of. What a build makes is no place of the
/// repository.
static QStringList missingPlaces(const QString& text) {
  const QDir root(qEnvironmentVariable("BREAKAWAY_SOURCE_DIR"));
  const QStringList from{".", "core", "core/diagnose", "core/commission", "firmware_link"};
  QStringList missing;
  const QRegularExpression place("`([a-z_0-9]+(?:/(?:[a-z_0-9.]*|CMakeLists[.]txt))+)`");
  for (auto it = place.globalMatch(text); it.hasNext();) {
    const QString path = it.next().captured(1);
    if (path.startsWith("build/")) continue;
    const auto isThere = [&](const QString& folder) { return QFileInfo::exists(root.filePath(folder + "/" + path)); };
    if (std::none_of(from.begin(), from.end(), isThere)) missing << path;
  }
  return missing;
}

void TestManual::everyPlaceInTheArchitecture_isThere() {
  const QString root = qEnvironmentVariable("BREAKAWAY_SOURCE_DIR");
  for (const char* file : {"/ARCHITECTURE.md", "/CONTRIBUTING.md"}) {
    const QString text = contentOf(root + file);
    QVERIFY2(!text.isEmpty(), file);
    const QStringList missing = missingPlaces(text);
    QVERIFY2(missing.isEmpty(), qPrintable(QString(file) + " names what isn't there: " + missing.join(", ")));
  }
}

void TestManual::plantedPlace_isMissed() {
  QCOMPARE(
      missingPlaces("see `core/base/result.h`, `verdict/judge.cpp`, `build/elsewhere/bin` and `core/cellar/wine.h`"),
      QStringList{"core/cellar/wine.h"});
}

void TestManual::everyLink_leadsSomewhere() {
  QStringList files{qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/README.md"};
  for (const QString& name : QDir(helpFolder()).entryList({"*.md"})) files << helpFolder() + "/" + name;
  QVERIFY(files.size() > 7);
  for (const QString& file : files) {
    const QStringList dead = deadLinks(contentOf(file), file);
    QVERIFY2(dead.isEmpty(), qPrintable(file + ": " + dead.join(", ")));
  }
}

void TestManual::plantedLink_isFollowed_data() {
  QTest::addColumn<QString>("link");
  QTest::addColumn<bool>("leads");
  QTest::newRow("file") << "files.md" << true;
  QTest::newRow("heading") << "files.md#bench-file" << true;
  QTest::newRow("heading of its own") << "#the-manual" << true;
  QTest::newRow("elsewhere") << "https://example.org/nothing" << true;
  QTest::newRow("no file") << "nowhere.md" << false;
  QTest::newRow("a folder") << "pictures" << false;
  QTest::newRow("no heading") << "files.md#nothing" << false;
  QTest::newRow("no heading of its own") << "#nothing" << false;
}

void TestManual::plantedLink_isFollowed() {
  QFETCH(QString, link);
  QFETCH(bool, leads);
  const QString text = "See [it](" + link + ") or ![a picture](pictures/friction-done-light.png).";
  QCOMPARE(deadLinks(text, helpFolder() + "/index.md"), leads ? QStringList() : QStringList{link});
}

QTEST_APPLESS_MAIN(TestManual)
#include "tst_manual.moc"
