#include <QFileInfo>
#include <QRegularExpression>
#include <QTest>
#include <QWidget>

#include "house/program.h"

using namespace breakaway::test;

class TestHeadless : public QObject {
  Q_OBJECT
 private slots:
  void headlessProgram_linksNoGuiLibrary();
  void guiLibrary_wouldBeFound();
  void everyCommand_hasCompleteHelp();
};

static const QRegularExpression gui(
    "^lib(Qt[0-9]*(Gui|Widgets|PrintSupport|Svg|OpenGL)|qcustomplot|X11|xcb|wayland|GL\\.|EGL)");

/// The libraries that a program needs, and those that these need, by name.
static QStringList neededBy(const QString& program) {
  const Outcome ldd = run("ldd", {program});
  QStringList names;
  for (const QString& line : ldd.out.split('\n')) {
    const QString name = line.trimmed().section(' ', 0, 0).section('/', -1);
    if (!name.isEmpty()) names << name;
  }
  return ldd.status == 0 ? names : QStringList();
}

void TestHeadless::headlessProgram_linksNoGuiLibrary() {
  const QStringList needed = neededBy(builtProgram("breakaway"));
  QVERIFY2(needed.filter("libc.so").size() == 1, "ldd said nothing");
  QVERIFY2(needed.filter(gui).isEmpty(), qPrintable(needed.filter(gui).join(' ')));
}

void TestHeadless::guiLibrary_wouldBeFound() {
  QCOMPARE(QWidget::staticMetaObject.className(), "QWidget");  // this test itself needs a GUI library
  QVERIFY(neededBy(QFileInfo("/proc/self/exe").canonicalFilePath()).filter(gui).size() >= 2);
}

void TestHeadless::everyCommand_hasCompleteHelp() {
  const QString program = builtProgram("breakaway");
  const Outcome help = run(program, {"--help"});
  QCOMPARE(help.status, 0);
  const QStringList lines = help.out.section("Subcommands:", 1).section("\n\n", 0, 0).split('\n', Qt::SkipEmptyParts);
  QVERIFY(lines.size() >= 4);
  for (const QString& line : lines) {
    const QString command = line.trimmed().section(' ', 0, 0);
    const Outcome one = run(program, {command, "--help"});
    QVERIFY2(one.status == 0 && one.err.isEmpty(), qPrintable(command));
    const bool writes = !QStringList{"ports", "profile", "list", "help", "check"}.contains(command);
    QVERIFY2(one.out.contains(writes ? "--out" : command), qPrintable(one.out));
    QVERIFY2(line.trimmed().section(' ', 1).trimmed().size() > 10, qPrintable(command + " has no description"));
  }
}

QTEST_APPLESS_MAIN(TestHeadless)
#include "tst_headless.moc"
