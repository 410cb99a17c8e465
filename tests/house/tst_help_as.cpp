#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTest>

#include "house/program.h"
#include "support/temporary.h"

using namespace breakaway::test;

/// Man pages and completions say what the help says, and shells understand them.
class TestHelpAs : public QObject {
  Q_OBJECT
 private slots:
  void everyOptionOfTheHelp_isInEveryForm();
  void bash_completes_data();
  void bash_completes();
  void board_completesItsOptions();
  void zshAndFish_readTheirs_data();
  void zshAndFish_readTheirs();
  void fish_completes();
  void manPage_isFormattedWithoutComplaint();
  void otherForm_isRefused();

 private:
  QStringList completed(const QString& program, const QStringList& words) const;

  TemporaryFolder folder_;
};

namespace {

QString tells(const QString& program, const char* form) {
  return run(builtProgram(program), {"--help-as", form}).out;
}

/// "--bench" and the like, from the first columns of a help.
QStringList optionsOf(const QString& command) {
  static const QRegularExpression option("^ {2,}(?:-[a-z],)?(--[A-Za-z0-9-]+)", QRegularExpression::MultilineOption);
  QStringList names;
  for (auto it = option.globalMatch(run(builtProgram("breakaway"), {"help", command}).out); it.hasNext();)
    names << it.next().captured(1);
  return names;
}

/// The part of a text from `start` to the next `end`.
QString part(const QString& text, const QString& start, const QString& end) {
  return text.section(start, 1, 1).section(end, 0, 0);
}

}  // namespace

void TestHelpAs::everyOptionOfTheHelp_isInEveryForm() {
  const QString man = tells("breakaway", "man"), bash = tells("breakaway", "bash"), zsh = tells("breakaway", "zsh"),
                fish = tells("breakaway", "fish");
  int found = 0;
  QVERIFY(commands().size() >= 15);
  for (const QString& command : commands()) {
    const QString page = part(man, "\n.SS " + command + "\n", "\n.SS ");
    const QString words =
        part(bash, "        " + command + ")\n", ";;") + part(bash, "        " + command + ") ", ";;");
    const QString arguments = part(zsh, "\n    " + command + ")\n", "\n      ;;");
    QVERIFY2(!page.isEmpty() && !words.isEmpty() && !arguments.isEmpty(), qPrintable(command));
    for (const QString& option : optionsOf(command)) {
      ++found;
      const QString what = command + " " + option;
      QVERIFY2(page.contains("\\fB" + QString(option).replace("-", "\\-") + "\\fR"), qPrintable("man: " + what));
      QVERIFY2(words.contains(option), qPrintable("bash: " + what));
      QVERIFY2(arguments.contains(option + "["), qPrintable("zsh: " + what));
      const QRegularExpression line("__fish_seen_subcommand_from " + command + "'.* -l " + option.mid(2) + " ");
      QVERIFY2(fish.contains(line), qPrintable("fish: " + what));
    }
  }
  QVERIFY(found > 100);
}

/// What bash offers after `words`, the last of which is being typed.
QStringList TestHelpAs::completed(const QString& program, const QStringList& words) const {
  const std::string script = folder_.write("completion", tells(program, "bash").toStdString());
  const QString line = "source " + QString::fromStdString(script) +
                       "; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); $(complete -p \"$1\" | sed -E 's/.*-F "
                       "([^ ]+).*/\\1/'); printf '%s\\n' \"${COMPREPLY[@]}\"";
  const Outcome bash = run("bash", QStringList{"-c", line, "bash", program} + words);
  QStringList offered = bash.out.split('\n', Qt::SkipEmptyParts);
  if (bash.status != 0 || !bash.err.isEmpty()) offered << bash.err;
  return offered;
}

void TestHelpAs::bash_completes_data() {
  QTest::addColumn<QStringList>("words");
  QTest::addColumn<QString>("offered");
  const auto row = [](const QStringList& words, const char* offered) {
    QTest::newRow(qPrintable(words.join(' '))) << words << QString(offered);
  };
  row({"li"}, "list");
  row({"co"}, "commission");
  row({"--ver"}, "--version");
  row({"list", ""}, "effects criteria presets columns");
  row({"list", "p"}, "presets");
  row({"diagnose", "--rec"}, "--recording");
  row({"tune", "--stiffness", "s"}, "soft stiff");
  row({"tune", "--bench", "b.json", "--stif"}, "--stiffness");
  row({"export", "--model", "m.json", "--as", "mo"}, "modelica");
  row({"help", "dia"}, "diagnose");
  row({"commission", "--turns", "1"}, "");
  row({"diagnose", "--bench", "zz"}, "");
  row({"nonsense", "--b"}, "");
}

void TestHelpAs::bash_completes() {
  QFETCH(QStringList, words);
  QFETCH(QString, offered);
  QCOMPARE(completed("breakaway", words).join(' '), offered);
}

void TestHelpAs::board_completesItsOptions() {
  QCOMPARE(completed("breakaway-board", {"--pa"}), QStringList{"--pace"});
  QCOMPARE(completed("breakaway-board", {"--pace", "g"}), QStringList{"granted"});
}

void TestHelpAs::zshAndFish_readTheirs_data() {
  QTest::addColumn<QString>("program");
  QTest::newRow("breakaway") << "breakaway";
  QTest::newRow("breakaway-board") << "breakaway-board";
}

void TestHelpAs::zshAndFish_readTheirs() {
  QFETCH(QString, program);
  bool read = false;
  for (const char* shell : {"zsh", "fish"}) {
    if (QStandardPaths::findExecutable(shell).isEmpty()) continue;
    const QString script = QString::fromStdString(folder_.write("script", tells(program, shell).toStdString()));
    const Outcome outcome = run(shell, {"-n", script});
    QVERIFY2(outcome.status == 0 && outcome.err.isEmpty(), qPrintable(shell + (": " + outcome.err)));
    read = true;
  }
  if (!read) QSKIP("neither zsh nor fish is here");
}

void TestHelpAs::fish_completes() {
  if (QStandardPaths::findExecutable("fish").isEmpty()) QSKIP("fish isn't here");
  const QString script = QString::fromStdString(folder_.write("b.fish", tells("breakaway", "fish").toStdString()));
  const auto offered = [&](const QString& line) {
    return run("fish", {"--no-config", "-c", "source " + script + "; complete -C '" + line + "'"}).out;
  };
  QVERIFY(offered("breakaway comm").startsWith("commission\t"));
  QVERIFY(offered("breakaway diagnose --rec").startsWith("--recording\t"));
  QCOMPARE(offered("breakaway list p").section('\t', 0, 0).trimmed(), QString("presets"));
  QVERIFY(!offered("breakaway diagnose --stiff").contains("--stiffness"));
}

void TestHelpAs::manPage_isFormattedWithoutComplaint() {
  if (QStandardPaths::findExecutable("groff").isEmpty()) QSKIP("groff isn't here");
  for (const char* program : {"breakaway", "breakaway-board"}) {
    const QString page = QString::fromStdString(folder_.write("page.1", tells(program, "man").toStdString()));
    const Outcome outcome = run("groff", {"-K", "utf8", "-man", "-Tutf8", "-ww", "-P-cbou", page});
    QVERIFY2(outcome.status == 0 && outcome.err.isEmpty(), qPrintable(outcome.err));
    QVERIFY(outcome.out.contains(QString(program) + " - "));
    QVERIFY(outcome.out.contains("--version"));
  }
}

void TestHelpAs::otherForm_isRefused() {
  const Outcome outcome = run(builtProgram("breakaway"), {"--help-as", "tcsh"});
  QCOMPARE(outcome.status, 2);
  QCOMPARE(outcome.err, QString("breakaway: --help-as: expected one of: man, bash, zsh, fish\n"));
  QVERIFY(outcome.out.isEmpty());
}

QTEST_APPLESS_MAIN(TestHelpAs)
#include "tst_help_as.moc"
