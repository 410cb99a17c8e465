// The command's project: what --project puts in, what project lists, shows, compares and mends.
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "commission/unfinished_job.h"
#include "house/program.h"
#include "house/pushed_mass.h"

using namespace breakaway;
using namespace breakaway::test;

class TestProjectCommand : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void tune_goesIntoTheProject();
  void diagnose_isARunOfItsMotor();
  void itsDate_namesARun();
  void batch_putsEachDiagnosisInOnce();
  void twoTunings_areCompared();
  void note_namesARun();
  void wrongWords_areOneLine();
  void noProject_isRefusedBeforeTheWork();
  void unfinishedSweeps_areNamed();

 private:
  Outcome breakaway(const QStringList& words) const { return run(builtProgram("breakaway"), words, place_.path()); }
  QJsonObject json(const QStringList& words) const {
    return QJsonDocument::fromJson(breakaway(words + QStringList{"--json"}).out.toUtf8()).object();
  }
  void write(const QString& name, const QByteArray& content) const {
    QFile file(place_.filePath(name));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
  }
  QTemporaryDir place_;
};

void TestProjectCommand::initTestCase() {
  QByteArray bench = pushedMassBench();
  bench.replace(bench.indexOf('{'), 1, "{\"motor_serial\": \"0117\", ");
  write("b.json", bench);
  // Too short to search in, so that a diagnosis is soon done.
  write("r.csv", pushedMassRecording(100, {}, "time_s,position_m,force_N", 4e-2));
  write("s.csv", pushedMassRecording(110, {}, "time_s,position_m,force_N", 4e-2));
  write("l.jsonl",
        "{\"id\": \"a\", \"bench\": \"b.json\", \"recordings\": [\"r.csv\"]}\n"
        "{\"id\": \"b\", \"bench\": \"b.json\", \"recordings\": [\"s.csv\"]}\n"
        "{\"id\": \"c\", \"bench\": \"none.json\", \"recordings\": [\"r.csv\"]}\n");
}

void TestProjectCommand::tune_goesIntoTheProject() {
  const QString preset = qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/resources/presets/servo.bench.json";
  const Outcome tuned = breakaway({"tune", "--bench", preset, "--out", "t", "--project", "p"});
  QVERIFY2(tuned.status == 0, qPrintable(tuned.err));
  QVERIFY2(tuned.out.contains("Project: p, run "), qPrintable(tuned.out));
  const QJsonArray runs = json({"project", "list", "p"})["runs"].toArray();
  QCOMPARE(runs.size(), 1);
  QCOMPARE(runs[0].toObject()["kind"].toString(), "tuning");
  const QString folder = runs[0].toObject()["folder"].toString();
  for (const QString& name : QDir(place_.filePath("t")).entryList(QDir::Files)) {
    QFile out(place_.filePath("t/" + name)), kept(place_.filePath(folder + "/" + name));
    QVERIFY2(out.open(QIODevice::ReadOnly) && kept.open(QIODevice::ReadOnly), qPrintable(name));
    QCOMPARE(kept.readAll(), out.readAll());
  }
  const Outcome checked = breakaway({"project", "check", "p"});
  QVERIFY2(checked.out.contains("all as they should be"), qPrintable(checked.out));
}

void TestProjectCommand::diagnose_isARunOfItsMotor() {
  const Outcome done =
      breakaway({"diagnose", "--bench", "b.json", "--recording", "r.csv", "--out", "d", "--project", "p", "--json"});
  QVERIFY2(done.status == 0, qPrintable(done.err));
  const QString id = QJsonDocument::fromJson(done.out.toUtf8())["project"]["run"].toString();
  QCOMPARE(id.size(), 8);
  const QJsonObject run = json({"project", "show", "p", id.first(6)});
  QCOMPARE(run["motor"].toString(), "0117");
  QCOMPARE(run["kind"].toString(), "diagnosis");
  QVERIFY(run["values"].toArray().size() >= 2);
  const QJsonArray values = json({"project", "list", "p", "--motor", "0117", "--history"})["values"].toArray();
  QCOMPARE(values.size(), run["values"].toArray().size());
  const QJsonArray findings = json({"project", "list", "p", "--motor", "0117", "--history"})["findings"].toArray();
  QCOMPARE(findings.size(), 1);
  QCOMPARE(findings[0]["run"].toString(), id);
  QCOMPARE(findings[0]["verdict"], run["verdict"]);
  QVERIFY(json({"project", "list", "p", "--motor", "9"})["runs"].toArray().isEmpty());
}

void TestProjectCommand::itsDate_namesARun() {
  const Outcome put = breakaway({"project", "add", "dated", "d"});
  QVERIFY2(put.status == 0, qPrintable(put.err));
  const QJsonObject run = json({"project", "show", "dated", "last"});
  QCOMPARE(json({"project", "show", "dated", run["at"].toString()})["id"], run["id"]);
}

void TestProjectCommand::batch_putsEachDiagnosisInOnce() {
  const Outcome first = breakaway({"batch", "l.jsonl", "--out", "r.jsonl"});
  QVERIFY2(first.status == 0, qPrintable(first.err));  // killed before the project had them, say
  const Outcome second = breakaway({"batch", "l.jsonl", "--out", "r.jsonl", "--project", "q"});
  QVERIFY2(second.out.contains("q: 2 diagnoses put in"), qPrintable(second.out + second.err));
  const Outcome third = breakaway({"batch", "l.jsonl", "--out", "r.jsonl", "--project", "q"});
  QVERIFY2(third.out.contains("q: 0 diagnoses put in"), qPrintable(third.out));
  QStringList names;
  const QJsonArray ofMotor = json({"project", "list", "q", "--motor", "0117"})["runs"].toArray();
  for (const auto& one : ofMotor) names << one.toObject()["name"].toString();
  names.sort();
  QCOMPARE(names, QStringList({"a", "b"}));
}

void TestProjectCommand::twoTunings_areCompared() {
  const QString preset = qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/resources/presets/servo.bench.json";
  for (const char* share : {"1", "30"}) {
    const Outcome tuned = breakaway(
        {"tune", "--bench", preset, "--inertia-error", share, "--out", QString("t") + share, "--project", "c"});
    if (tuned.status != 0) QSKIP(qPrintable("tune takes no such option: " + tuned.err));
  }
  const QJsonArray runs = json({"project", "list", "c"})["runs"].toArray();
  const Outcome compared =
      breakaway({"project", "compare", "c", runs[0]["id"].toString(), runs[1]["id"].toString(), "--out", "cmp"});
  QVERIFY2(compared.status == 0, qPrintable(compared.err));
  QVERIFY2(compared.out.contains("Nothing has changed beyond the 95 % intervals."), qPrintable(compared.out));
  QVERIFY(QFile::exists(place_.filePath("cmp/report.html")) && QFile::exists(place_.filePath("cmp/comparison.json")));
}

void TestProjectCommand::note_namesARun() {
  QCOMPARE(breakaway({"project", "add", "n", "r.csv", "--remark", "cold"}).status, 0);
  QCOMPARE(breakaway({"project", "note", "n", "last", "--name", "first", "--motor", "7"}).status, 0);
  const QJsonObject run = json({"project", "show", "n", "first"});
  QCOMPARE(run["motor"].toString(), "7");
  QCOMPARE(run["remark"].toString(), "cold");
  QCOMPARE(run["kind"].toString(), "recording");
  QVERIFY(QFile::remove(place_.filePath("n/index.sqlite")));
  const Outcome listed = breakaway({"project", "list", "n"});
  QVERIFY2(listed.out.contains("was missing: made anew from 1 runs") && listed.out.contains("first"),
           qPrintable(listed.out));
  QVERIFY(breakaway({"project", "rebuild", "n"}).out.contains("index made from 1 runs"));
}

void TestProjectCommand::wrongWords_areOneLine() {
  QCOMPARE(breakaway({"project", "add", "w", "r.csv"}).status, 0);
  const QList<QStringList> wrong{{"project", "list", "none"},
                                 {"project", "show", "w"},
                                 {"project", "show", "w", "nobody"},
                                 {"project", "compare", "w", "last"},
                                 {"project", "add", "w"},
                                 {"project", "add", "w", "none.csv"},
                                 {"project", "ponder", "w"},
                                 {"project", "compare", "w", "last", "last"}};
  for (const QStringList& words : wrong) {
    const Outcome outcome = breakaway(words);
    QVERIFY2(outcome.status == 2 && outcome.err.count('\n') == 1 && outcome.out.isEmpty(),
             qPrintable(words.join(' ') + ": " + outcome.err));
  }
  QVERIFY(!QDir(place_.filePath("none")).exists());
}

void TestProjectCommand::noProject_isRefusedBeforeTheWork() {
  const QString preset = qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/resources/presets/servo.bench.json";
  const Outcome tuned = breakaway({"tune", "--bench", preset, "--out", "never", "--project", "r.csv"});
  QCOMPARE(tuned.status, 2);
  QVERIFY2(tuned.err.contains("r.csv: is a file"), qPrintable(tuned.err));
  QVERIFY(!QDir(place_.filePath("never")).exists());
}

void TestProjectCommand::unfinishedSweeps_areNamed() {
  QVERIFY(breakaway({"project", "add", "u", "r.csv"}).status == 0);
  QVERIFY(!breakaway({"project", "list", "u"}).out.contains("unfinished"));
  QVERIFY(json({"project", "list", "u"})["unfinished"].isArray());
  Commission known;
  known.identity.device = "a board";
  known.sweeps.bins = 90;
  known.runs.resize(3, VelocityRun{10.0, 2, 1.5, 0.75, 0.0, 0.01, 0.0, {{3, 0.1, 0.2, -3.0, 9.1}}, {}, false});
  known.runs.back().brokenOff = true;
  known.breakaways.resize(12);
  UnfinishedJob job(unfinishedPlace(place_.filePath("u").toStdString()));
  QVERIFY(job.keep(known).ok());
  const QString words =
      "commission      a board: 3 speeds, 1 of them broken off, and 12 of 360 breakaways; under way\n";
  for (const char* action : {"list", "check"}) {
    const QString said = breakaway({"project", action, "u"}).out;
    QVERIFY2(said.contains(QRegularExpression("^unfinished  20\\d\\d-\\d\\d-\\d\\dT[\\d:]{8}Z  " + words,
                                              QRegularExpression::MultilineOption)),
             qPrintable(said));
    const QJsonArray all = json({"project", action, "u"})["unfinished"].toArray();
    QCOMPARE(all.size(), 1);
    QCOMPARE(all[0]["speeds_broken_off"].toInt(), 1);
    QCOMPARE(all[0]["breakaways_asked"].toInt(), 360);
    QVERIFY(all[0]["under_way"].toBool() && all[0]["device"] == "a board");
  }
  QVERIFY(json({"project", "list", "u", "--device", "another"})["unfinished"].toArray().isEmpty());
  QVERIFY(json({"project", "show", "u", "last"})["unfinished"].toArray().isEmpty());  // no board's
  QVERIFY(breakaway({"project", "check", "u"}).out.contains("all as they should be"));
  const QString folder = json({"project", "list", "u"})["unfinished"][0]["folder"].toString();
  QVERIFY(QFile::resize(place_.filePath(folder) + "/progress/breakaways.json", 20));
  const Outcome damaged = breakaway({"project", "check", "u"});
  QVERIFY2(damaged.out.contains("breakaways.json") && damaged.out.contains("1 faults"), qPrintable(damaged.out));
  job.remove();
  QVERIFY(!breakaway({"project", "list", "u"}).out.contains("unfinished"));
}

QTEST_GUILESS_MAIN(TestProjectCommand)
#include "tst_project_command.moc"
