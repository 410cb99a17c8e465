// A recording that goes to disk in blocks: what is read back, after whatever ended the writing.
#include <sys/wait.h>
#include <unistd.h>

#include <QFile>
#include <QRandomGenerator>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <csignal>

#include "base/atomic_file.h"
#include "recording/block_file.h"
#include "recording/csv.h"
#include "recording/sample_recording.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestBlockFile : public QObject {
  Q_OBJECT
 private slots:
  void rows_comeBackExactly_withGapsNoted();
  void csv_readsBackAsTheSameRecording();
  void fileCutAnywhere_givesTheBlocksBeforeTheCut();
  void damagedBlock_losesItsOwnRowsOnly();
  void damagedBeginning_isReadByALaterHead();
  void mendingADamagedFile_losesNothingMore();
  void fileOfMarks_isGivenUpSoon();
  void killedWriter_leavesAllThatItAppended();
  void fileBeingWritten_isNotMended();
  void timesThatDontGrow_areLeftOut();
  void otherFiles_areNamedAsSuch();
};

namespace {

const BlockHead head{{"time_s", "angle_rad"}, {{"device", "a board"}}};

std::vector<double> rowsFrom(size_t first, size_t count) {
  std::vector<double> rows;
  for (size_t k = first; k < first + count; ++k) {
    rows.push_back(0.001 * static_cast<double>(k));
    rows.push_back(std::sin(0.1 * static_cast<double>(k)));
  }
  return rows;
}

/// Ten blocks of a hundred rows, with a gap after the third.
void write(const std::string& path, bool ended) {
  auto writer = BlockWriter::create(path, head);
  if (!writer) qFatal("%s", writer.error().message().c_str());
  for (size_t k = 0; k < 10; ++k) {
    if (!writer->append(rowsFrom(100 * k, 100))) qFatal("append");
    if (k == 2 && !writer->appendGap({0.299, 7})) qFatal("gap");
  }
  if (ended && !writer->end("")) qFatal("end");
}

}  // namespace

void TestBlockFile::rows_comeBackExactly_withGapsNoted() {
  const TemporaryFolder folder;
  write(folder.path("r.blocks"), true);
  QVERIFY(isBlockFile(folder.path("r.blocks")));
  const auto survey = surveyBlocks(folder.path("r.blocks"));
  VERIFY_OK(survey);
  QVERIFY(survey->ended && survey->why.empty() && survey->damaged == 0);
  QCOMPARE(survey->lost(), uint64_t{7});
  const auto recording = readBlocks(folder.path("r.blocks"));
  VERIFY_OK(recording);
  QCOMPARE(recording->rows(), size_t{1000});
  const auto expected = rowsFrom(0, 1000);
  for (size_t k = 0; k < 1000; ++k) {
    QCOMPARE(recording->time()[k], expected[2 * k]);
    QCOMPARE(recording->channel("angle_rad")[k], expected[2 * k + 1]);
  }
  const std::pair<std::string, std::string> gap{"gap", "7 samples lost after 0.299 s"}, device{"device", "a board"};
  QVERIFY(std::count(recording->notes().begin(), recording->notes().end(), gap) == 1);
  QVERIFY(std::count(recording->notes().begin(), recording->notes().end(), device) == 1);
}

void TestBlockFile::csv_readsBackAsTheSameRecording() {
  const TemporaryFolder folder;
  write(folder.path("r.blocks"), true);
  VERIFY_OK(writeBlocksAsCsv(folder.path("r.blocks"), folder.path("r.csv")));
  const auto blocks = readRecording(folder.path("r.blocks")), csv = readRecording(folder.path("r.csv"));
  VERIFY_OK(csv);
  QVERIFY(blocks->channels() == csv->channels());
  QVERIFY(blocks->notes() == csv->notes());
}

void TestBlockFile::fileCutAnywhere_givesTheBlocksBeforeTheCut() {
  const TemporaryFolder folder;
  write(folder.path("r.blocks"), true);
  QFile file(QString::fromStdString(folder.path("r.blocks")));
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QByteArray whole = file.readAll();
  QRandomGenerator random(7);
  for (int k = 0; k < 60; ++k) {
    const auto cut = static_cast<qsizetype>(random.bounded(200, static_cast<int>(whole.size())));
    const std::string path = folder.write("cut.blocks", whole.first(cut).toStdString());
    const auto mended = mendBlocks(path, "a kill");
    VERIFY_OK(mended);
    QVERIFY(mended->rows % 100 == 0);
    // Whatever was whole before the cut is there: a block is 1616 bytes.
    QVERIFY2(static_cast<qsizetype>(mended->rows) * 16 > cut - qsizetype{3400}, qPrintable(QString::number(cut)));
    const auto again = surveyBlocks(path);
    VERIFY_OK(again);
    QVERIFY(again->ended && again->damaged == 0 && again->rows == mended->rows);
    QCOMPARE(again->why, std::string("a kill"));
  }
}

void TestBlockFile::damagedBlock_losesItsOwnRowsOnly() {
  const TemporaryFolder folder;
  write(folder.path("r.blocks"), true);
  const std::string whole = readFile(folder.path("r.blocks")).value();
  // In its content, in its mark, in its length; of the third of ten blocks of rows, each 1616 bytes.
  const size_t third = whole.size() - 16 - 32 - size_t{8} * 1616;
  for (const size_t at : {third + 900, third, third + 9}) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    const std::string path = folder.write("flipped.blocks", damaged);
    const auto survey = surveyBlocks(path);
    VERIFY_OK(survey);
    QVERIFY(survey->ended && survey->damaged == 0 && survey->lost() == 7);
    QCOMPARE(survey->rows, uint64_t{900});
    QCOMPARE(survey->holes.size(), size_t{1});
    QCOMPARE(survey->holes[0].after_s, 0.199);
    QCOMPARE(survey->unreadable(), uint64_t{1616});
    const auto recording = readBlocks(path);
    VERIFY_OK(recording);
    QCOMPARE(recording->time()[199], 0.199);
    QCOMPARE(recording->time()[200], 0.3);
    const std::pair<std::string, std::string> note{"damaged", "1616 bytes of the file after 0.199 s"};
    QVERIFY(std::count(recording->notes().begin(), recording->notes().end(), note) == 1);
  }
}

void TestBlockFile::damagedBeginning_isReadByALaterHead() {
  const TemporaryFolder folder;
  const std::string path = folder.path("r.blocks");
  {
    auto writer = BlockWriter::create(path, head);
    VERIFY_OK(writer);
    for (size_t k = 0; k < 150; ++k) VERIFY_OK(writer->append(rowsFrom(1000 * k, 1000)));
    VERIFY_OK(writer->end(""));
  }
  QCOMPARE(surveyBlocks(path)->rows, uint64_t{150'000});
  std::string damaged = readFile(path).value();
  damaged.replace(0, 4096, 4096, '\0');
  folder.write("r.blocks", damaged);
  QVERIFY(isBlockFile(path));
  const auto recording = readRecording(path);
  VERIFY_OK(recording);
  QCOMPARE(recording->rows(), size_t{149'000});
  QCOMPARE(recording->channel("angle_rad")[0], std::sin(100.0));
}

void TestBlockFile::mendingADamagedFile_losesNothingMore() {
  const TemporaryFolder folder;
  write(folder.path("r.blocks"), false);
  std::string damaged = readFile(folder.path("r.blocks")).value();
  damaged[5000] = static_cast<char>(damaged[5000] ^ 4);
  const std::string path = folder.write("killed.blocks", damaged + std::string(700, 'x'));
  const auto mended = mendBlocks(path, "a kill");
  VERIFY_OK(mended);
  QCOMPARE(mended->rows, uint64_t{900});
  const auto again = surveyBlocks(path);
  VERIFY_OK(again);
  QVERIFY(again->ended && again->rows == 900 && again->holes.size() == 1);
}

void TestBlockFile::fileOfMarks_isGivenUpSoon() {
  const TemporaryFolder folder;
  std::string marks;
  for (int k = 0; k < 1 << 20; ++k) marks += "BRKB";
  QVERIFY(!readBlocks(folder.write("marks.blocks", marks)).ok());
}

void TestBlockFile::killedWriter_leavesAllThatItAppended() {
  const TemporaryFolder folder;
  const std::string path = folder.path("r.blocks");
  int told[2];
  QVERIFY(::pipe(told) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    auto writer = BlockWriter::create(path, head);
    for (size_t k = 0; k < 5; ++k) static_cast<void>(writer->append(rowsFrom(100 * k, 100)));
    if (::write(told[1], "x", 1) == 1) ::pause();
    ::_exit(1);
  }
  char byte = 0;
  QVERIFY(::read(told[0], &byte, 1) == 1);
  QVERIFY(isBeingWritten(path));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  QVERIFY(!isBeingWritten(path));
  const auto recording = readBlocks(path);
  VERIFY_OK(recording);
  QCOMPARE(recording->rows(), size_t{500});
  QVERIFY(recording->notes().back().second.find("kill") != std::string::npos);
}

void TestBlockFile::fileBeingWritten_isNotMended() {
  const TemporaryFolder folder;
  auto writer = BlockWriter::create(folder.path("r.blocks"), head);
  VERIFY_OK(writer);
  VERIFY_OK(writer->append(rowsFrom(0, 10)));
  VERIFY_ERROR(mendBlocks(folder.path("r.blocks"), "x"), folder.path("r.blocks") + ": is being written");
  QCOMPARE(surveyBlocks(folder.path("r.blocks"))->rows, uint64_t{10});
  QVERIFY(!BlockWriter::create(folder.path("r.blocks"), head).ok());
}

void TestBlockFile::timesThatDontGrow_areLeftOut() {
  const TemporaryFolder folder;
  {
    auto writer = BlockWriter::create(folder.path("r.blocks"), head);
    VERIFY_OK(writer);
    VERIFY_OK(writer->append(rowsFrom(0, 10)));
    VERIFY_OK(writer->append(rowsFrom(5, 10)));
    VERIFY_OK(writer->end(""));
  }
  const auto recording = readBlocks(folder.path("r.blocks"));
  VERIFY_OK(recording);
  QCOMPARE(recording->rows(), size_t{15});
}

void TestBlockFile::otherFiles_areNamedAsSuch() {
  const TemporaryFolder folder;
  const std::string path = folder.write("x.blocks", "time_s,angle_rad\n0,1\n");
  QVERIFY(!isBlockFile(path));
  VERIFY_ERROR(readBlocks(path), path + ": doesn't begin as a recording of blocks");
  QVERIFY(!isBlockFile(folder.path("none")));
}

QTEST_APPLESS_MAIN(TestBlockFile)
#include "tst_block_file.moc"
