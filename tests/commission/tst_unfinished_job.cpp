// What sweeps have measured lies on disk until it is a map, one folder per job, and each is one process' own.
#include <QDateTime>
#include <QTest>
#include <filesystem>
#include <memory>
#include <vector>

#include "commission/commission_progress.h"
#include "commission/progress_writer.h"
#include "commission/unfinished_job.h"
#include "support/temporary.h"

using namespace breakaway;

class TestUnfinishedJob : public QObject {
  Q_OBJECT
 private slots:
  void whatIsKept_isFoundAgain();
  void anotherBoardOfTheModel_findsNone();
  void whatGrows_staysInItsFolder();
  void otherSweeps_replaceWhatWasThere();
  void whatIsHeld_isNotFound();
  void damagedOne_isPassedOver();
  void whatIsComplete_isGone();
  void brokenOffSpeed_growsInItsFolder();
  void allOfThem_areListed();
  void writer_hasTheLastInTheEnd();
  void writer_saysWhatFailed();
};

namespace {

Commission swept(size_t breakaways, size_t bins = 36) {
  Commission known;
  known.identity.device = "board";
  known.sweeps.bins = bins;
  for (size_t k = 0; k < breakaways; ++k) {
    BreakawayEvent event;
    event.bin = k % bins;
    event.angle_rad = 0.1 + 0.001 * static_cast<double>(k);
    known.breakaways.push_back(event);
  }
  return known;
}

std::vector<std::string> jobsIn(const std::string& place) {
  std::vector<std::string> jobs;
  std::error_code code;
  for (const auto& one : std::filesystem::directory_iterator(place, code)) jobs.push_back(one.path().string());
  return jobs;
}

}  // namespace

void TestUnfinishedJob::whatIsKept_isFoundAgain() {
  const test::TemporaryFolder folder;
  const std::string place = folder.path("unfinished");
  QVERIFY(!UnfinishedJob::find(place, {"board"}));
  VERIFY_OK(UnfinishedJob(place).keep(swept(7)));
  QVERIFY(!UnfinishedJob::find(place, {"another board"}));
  const auto found = UnfinishedJob::find(place, {"board"});
  QVERIFY(found && found->known().breakaways.size() == 7);
  QVERIFY(found->known().sweeps == swept(7).sweeps);
  QVERIFY(std::abs(found->since_s() - static_cast<double>(QDateTime::currentSecsSinceEpoch())) < 60.0);
}

void TestUnfinishedJob::anotherBoardOfTheModel_findsNone() {
  const test::TemporaryFolder folder;
  const std::string place = folder.path("unfinished");
  Commission known = swept(7);
  known.identity.serialNumber = "0042";
  VERIFY_OK(UnfinishedJob(place).keep(known));
  const auto boardOf = [](const char* serial) {
    Identity board;
    board.device = "board";
    board.serialNumber = serial;
    return board;
  };
  QVERIFY(!UnfinishedJob::find(place, boardOf("0043")));
  QVERIFY(UnfinishedJob::find(place, boardOf("0042")));
  const auto found = UnfinishedJob::find(place, boardOf(""));  // one that says none may be it
  QVERIFY(found);
  QCOMPARE(found->known().identity.serialNumber, std::string("0042"));
}

void TestUnfinishedJob::whatGrows_staysInItsFolder() {
  const test::TemporaryFolder folder;
  const std::string place = folder.path("unfinished");
  UnfinishedJob job(place);
  VERIFY_OK(job.keep(swept(3)));
  const auto before = jobsIn(place);
  VERIFY_OK(job.keep(swept(5)));
  QCOMPARE(jobsIn(place), before);
}

void TestUnfinishedJob::otherSweeps_replaceWhatWasThere() {
  const test::TemporaryFolder folder;
  const std::string place = folder.path("unfinished");
  {
    UnfinishedJob job(place);
    VERIFY_OK(job.keep(swept(30)));
    const auto before = jobsIn(place);
    VERIFY_OK(job.keep(swept(4, 18)));
    QCOMPARE(jobsIn(place).size(), size_t{1});
    QVERIFY(jobsIn(place) != before);
  }
  const auto found = UnfinishedJob::find(place, {"board"});
  QVERIFY(found && found->known().breakaways.size() == 4 && found->known().sweeps.bins == 18);
}

void TestUnfinishedJob::whatIsHeld_isNotFound() {
  const test::TemporaryFolder folder;
  const std::string place = folder.path("unfinished");
  auto first = std::make_unique<UnfinishedJob>(place);
  VERIFY_OK(first->keep(swept(3)));
  QVERIFY(!UnfinishedJob::find(place, {"board"}));
  first.reset();
  const auto taken = UnfinishedJob::find(place, {"board"});
  QVERIFY(taken && !UnfinishedJob::find(place, {"board"}));
}

void TestUnfinishedJob::damagedOne_isPassedOver() {
  const test::TemporaryFolder folder;
  const std::string place = folder.path("unfinished");
  VERIFY_OK(UnfinishedJob(place).keep(swept(3)));
  const std::string damaged = jobsIn(place)[0];
  std::filesystem::resize_file(damaged + "/progress/breakaways.json", 20);
  QVERIFY(!UnfinishedJob::find(place, {"board"}));
  QVERIFY(std::filesystem::exists(damaged));  // a person may still want it
}

void TestUnfinishedJob::whatIsComplete_isGone() {
  const test::TemporaryFolder folder;
  const std::string place = folder.path("unfinished");
  UnfinishedJob job(place);
  VERIFY_OK(job.keep(swept(3)));
  job.remove();
  QVERIFY(jobsIn(place).empty());
  VERIFY_OK(job.keep(swept(1)));
  QCOMPARE(jobsIn(place).size(), size_t{1});
  Commission complete = swept(3);
  QVERIFY(isUnfinished(complete));
  complete.facts.add({Known::map});
  QVERIFY(!isUnfinished(complete) && !isUnfinished({}));
}

void TestUnfinishedJob::brokenOffSpeed_growsInItsFolder() {
  const test::TemporaryFolder folder;
  const std::string place = folder.path("unfinished");
  Commission known = swept(0);
  VelocityRun run{10.0, 2, 1.5, 0.75, 0.0, 0.01, 0.0, {{3, 0.1, 0.2, -3.0, 9.1}}, {}, true};
  std::vector<std::string> before;
  {
    UnfinishedJob job(place);
    for (const double duration_s : {1.5, 2.5, 25.0}) {
      run.duration_s = duration_s;
      run.middle_s = 0.5 * duration_s;
      run.brokenOff = duration_s < 25.0;
      known.runs = {run};
      VERIFY_OK(job.keep(known));
      if (before.empty()) before = jobsIn(place);
      QCOMPARE(jobsIn(place), before);
      const auto kept = unfinishedIn(place);
      QVERIFY(kept.size() == 1 && kept[0].known.ok() && kept[0].known->runs.size() == 1);
      QCOMPARE(kept[0].known->runs[0].duration_s, duration_s);
    }
  }
  const auto found = UnfinishedJob::find(place, {"board"});
  QVERIFY(found && found->known().runs.size() == 1 && !found->known().runs[0].brokenOff);
}

void TestUnfinishedJob::allOfThem_areListed() {
  const test::TemporaryFolder folder;
  const std::string place = folder.path("unfinished");
  QVERIFY(unfinishedIn(place).empty());
  Commission other = swept(1);
  other.identity.device = "another board";
  VERIFY_OK(UnfinishedJob(place).keep(other));
  UnfinishedJob job(place);
  VERIFY_OK(job.keep(swept(7)));
  const auto all = unfinishedIn(place);
  QCOMPARE(all.size(), size_t{2});
  for (const UnfinishedEntry& one : all) {
    VERIFY_OK(one.known);
    QCOMPARE(one.held, one.known->identity.device == "board");
    QVERIFY(QDateTime::fromString(QString::fromStdString(one.at), Qt::ISODate).isValid());
  }
  QCOMPARE(howFar(swept(7)), std::string("0 speeds and 7 of 144 breakaways"));
  other.runs.resize(1);
  QCOMPARE(howFar(other), std::string("1 speed and 1 of 144 breakaways"));
}

void TestUnfinishedJob::writer_hasTheLastInTheEnd() {
  const test::TemporaryFolder folder;
  ProgressWriter writer(folder.path("out"));
  QVERIFY(!writer.wrote());
  for (size_t k = 1; k <= 40; ++k) VERIFY_OK(writer.keep(swept(100 * k)));
  VERIFY_OK(writer.finish());
  const auto kept = readProgress(folder.path("out"));
  VERIFY_OK(kept);
  QVERIFY(writer.wrote() && kept->breakaways.size() == 4000);
}

void TestUnfinishedJob::writer_saysWhatFailed() {
  const test::TemporaryFolder folder;
  folder.write("out", "a file, where a folder is to be made");
  ProgressWriter writer(folder.path("out"));
  VERIFY_OK(writer.keep(swept(3)));
  QVERIFY(!writer.finish());
  bool failed = false;
  for (int k = 0; k < 2000 && !failed; ++k) {
    failed = !writer.keep(swept(3));
    QTest::qSleep(1);
  }
  QVERIFY(failed);
}

QTEST_APPLESS_MAIN(TestUnfinishedJob)
#include "tst_unfinished_job.moc"
