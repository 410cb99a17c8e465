#include <QDir>
#include <QDirIterator>
#include <QProcess>
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

QTEST_APPLESS_MAIN(TestInstall)
#include "tst_install.moc"
