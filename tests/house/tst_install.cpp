#include <QDir>
#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include "house/program.h"
#include "support/temporary.h"

using namespace breakaway::test;

/// What is installed works from wherever it is put.
class TestInstall : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void presets_areThoseOfThePrefix();
  void namedFolder_goesFirst();
  void example_isDiagnosed();
  void simulatedBoard_isChecked();
  void board_startsOnItsOwnPreset();
  void everyResource_isThere();
  void vcpkg_namesTheLibrariesThatCmakeFinds();

 private:
  QString program(const QString& name) const { return prefix_ + "/bin/" + name; }

  TemporaryFolder folder_;
  QString prefix_;
};

void TestInstall::initTestCase() {
  qunsetenv("BREAKAWAY_RESOURCES");
  const QString installed = QString::fromStdString(folder_.path("installed"));
  const Outcome done =
      run("cmake", {"--install", builtProgram(".."), "--prefix", installed, "--component", "breakaway"});
  QVERIFY2(done.status == 0, qPrintable(done.err));
  prefix_ = QString::fromStdString(folder_.path("moved to another place"));
  QVERIFY(QDir().rename(installed, prefix_));
}

void TestInstall::presets_areThoseOfThePrefix() {
  const Outcome list = run(program("breakaway"), {"list", "presets"}, "/");
  QCOMPARE(list.status, 0);
  const QStringList lines = list.out.split('\n', Qt::SkipEmptyParts);
  QVERIFY(lines.size() >= 3);
  for (const QString& line : lines)
    QVERIFY2(line.contains(" " + prefix_ + "/share/breakaway/presets/"), qPrintable(line));
}

void TestInstall::namedFolder_goesFirst() {
  QVERIFY(QDir().mkpath(QString::fromStdString(folder_.path("own/presets"))));
  folder_.write("own/presets/mine.rig.json", "{}");
  qputenv("BREAKAWAY_RESOURCES", QByteArray::fromStdString(folder_.path("own")));
  const Outcome list = run(program("breakaway"), {"list", "presets"});
  qunsetenv("BREAKAWAY_RESOURCES");
  QCOMPARE(list.out.simplified(),
           QString::fromStdString("simulated:mine " + folder_.path("own/presets/mine.rig.json")));
}

void TestInstall::example_isDiagnosed() {
  const QString examples = prefix_ + "/share/breakaway/examples/example";
  const QString out = QString::fromStdString(folder_.path("d"));
  const Outcome done = run(program("breakaway"), {"diagnose", "--bench", examples + ".bench.json", "--recording",
                                                  examples + ".csv", "--out", out});
  QVERIFY2(done.status == 0, qPrintable(done.err));
  QVERIFY(QFile::exists(out + "/diagnosis.json"));
}

void TestInstall::simulatedBoard_isChecked() {
  const QString out = QString::fromStdString(folder_.path("c"));
  const Outcome done =
      run(program("breakaway"), {"commission", "--board", "simulated", "--bench",
                                 prefix_ + "/share/breakaway/presets/servo.bench.json", "--wiring-only", "--out", out});
  QVERIFY2(done.status == 0, qPrintable(done.err));
}

void TestInstall::board_startsOnItsOwnPreset() {
  QProcess board;
  board.start(program("breakaway-board"), {"--rig", "geared"});
  QVERIFY(board.waitForReadyRead(10000));
  const QString uri = QString::fromUtf8(board.readLine());
  board.terminate();
  QVERIFY(board.waitForFinished(10000));
  QVERIFY2(uri.startsWith("serial:/dev/pts/"), qPrintable(uri));
}

/// All that the checkout has for people goes along; the icons are in the window itself.
void TestInstall::everyResource_isThere() {
  const QDir resources(qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/resources");
  int found = 0;
  for (const char* kind : {"examples", "help", "presets", "schemas"}) {
    for (QDirIterator it(resources.filePath(kind), QDir::Files, QDirIterator::Subdirectories); it.hasNext(); ++found) {
      const QString file = resources.relativeFilePath(it.next());
      QVERIFY2(QFile::exists(prefix_ + "/share/breakaway/" + file), qPrintable(file));
    }
  }
  QVERIFY(found > 40);
}

static QByteArray sourceFile(const QString& name) {
  QFile file(qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/" + name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// As vcpkg calls them. Threads are the compiler's own.
static QSet<QString> librariesOfCmake() {
  const QMap<QString, QString> otherwise{{"boost", "boost-math"},
                                         {"pkgconfig", "pkgconf"},
                                         {"qt6", "qtbase"},
                                         {"qcustomplotqt6", "qcustomplot"},
                                         {"threads", ""}};
  const QString text = sourceFile("CMakeLists.txt");
  const QRegularExpression call(R"((?:find_package|pkg_check_modules)\((\w+)([^)]*)\))");
  QSet<QString> found;
  for (auto it = call.globalMatch(text); it.hasNext();) {
    const auto match = it.next();
    const QString name = match.captured(1).toLower().replace('_', '-');
    found << otherwise.value(name, name);
    if (name == "qt6" && match.captured(2).contains(" Svg ")) found << "qtsvg";
  }
  found.remove("");
  return found;
}

static QSet<QString> namesIn(const QJsonValue& dependencies) {
  QSet<QString> names;
  for (const auto& one : dependencies.toArray())
    names << (one.isObject() ? one.toObject()["name"].toString() : one.toString());
  return names;
}

/// No library in one and not in the other; Qt's are those of the window.
void TestInstall::vcpkg_namesTheLibrariesThatCmakeFinds() {
  const QJsonObject manifest = QJsonDocument::fromJson(sourceFile("vcpkg.json")).object();
  const QSet<QString> always = namesIn(manifest["dependencies"]);
  const QSet<QString> window = namesIn(manifest["features"].toObject()["window"].toObject()["dependencies"]);
  const QSet<QString> found = librariesOfCmake();
  QVERIFY(found.size() > 10);
  QCOMPARE(QStringList((always + window - found).values()), QStringList());
  QCOMPARE(QStringList((found - always - window).values()), QStringList());
  QCOMPARE(window, (QSet<QString>{"qcustomplot", "qtbase", "qtsvg"}));
}

QTEST_APPLESS_MAIN(TestInstall)
#include "tst_install.moc"
