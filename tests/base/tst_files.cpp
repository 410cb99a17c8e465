#include <QTest>

#include "base/atomic_file.h"
#include "base/line_log.h"
#include "base/shard.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

class TestFiles : public QObject {
  Q_OBJECT
 private slots:
  void writtenFile_replacesTheOldOneWhole();
  void bytes_surviveUnchanged();
  void folder_isMadeWithItsParentsAndMayExist();
  void fileInPlaceOfAFolder_isTold();
  void fileThatBreaksOff_isTold();
  void lineCutShort_isLeftOutAndCutAway();
  void logThatCannotBeWritten_isTold();
  void shards_holdEveryJobOnce();
  void wrongShard_isOneClearLine();
};

void TestFiles::writtenFile_replacesTheOldOneWhole() {
  const TemporaryFolder folder;
  VERIFY_OK(writeFile(folder.path("a"), "a long first content"));
  VERIFY_OK(writeFile(folder.path("a"), "short"));
  QCOMPARE(*readFile(folder.path("a")), std::string("short"));
  QCOMPARE(folder.names(), QStringList{"a"});
}

void TestFiles::bytes_surviveUnchanged() {
  const TemporaryFolder folder;
  std::string bytes;
  for (int k = 0; k < 200000; ++k) bytes += static_cast<char>(k * 7);
  VERIFY_OK(writeFile(folder.path("a"), bytes));
  QVERIFY(*readFile(folder.path("a")) == bytes);
}

void TestFiles::folder_isMadeWithItsParentsAndMayExist() {
  const TemporaryFolder folder;
  VERIFY_OK(makeFolder(folder.path("a/b/c")));
  VERIFY_OK(makeFolder(folder.path("a/b/c")));
  VERIFY_OK(writeFile(folder.path("a/b/c/d"), ""));
}

void TestFiles::fileInPlaceOfAFolder_isTold() {
  const TemporaryFolder folder;
  folder.write("a", "");
  QVERIFY(!makeFolder(folder.path("a")).ok());
  QVERIFY(!makeFolder(folder.path("a/b")).ok());
}

void TestFiles::fileThatBreaksOff_isTold() {
  const auto read = readFile("/proc/self/mem");  // readable by name, not at its beginning
  QVERIFY(!read.ok());
  QCOMPARE(read.error().message(), std::string("/proc/self/mem: cannot be read to its end"));
}

void TestFiles::lineCutShort_isLeftOutAndCutAway() {
  const TemporaryFolder folder;
  const std::string log = folder.path("log");
  QCOMPARE(readWholeLines(log)->size(), size_t(0));
  QVERIFY(appendLine(log, "first").ok());
  folder.write("log", "first\nsec");
  QCOMPARE(*readWholeLines(log), std::vector<std::string>{"first"});
  QCOMPARE(*readFile(log), std::string("first\nsec"));  // reading changes nothing
  QVERIFY(appendLine(log, "second").ok());
  QCOMPARE(*readFile(log), std::string("first\nsecond\n"));
  folder.write("log", "cut");
  QVERIFY(appendLine(log, "first").ok());
  QCOMPARE(*readFile(log), std::string("first\n"));
}

void TestFiles::logThatCannotBeWritten_isTold() {
  const TemporaryFolder folder;
  const auto done = appendLine(folder.path("none/log"), "line");
  QVERIFY(!done.ok());
  QVERIFY(done.error().message().find("none/log: cannot be written") != std::string::npos);
}

void TestFiles::shards_holdEveryJobOnce() {
  for (size_t job = 0; job < 10; ++job) {
    int holders = 0;
    for (const char* part : {"1/3", "2/3", "3/3"}) holders += parseShard(part)->holds(job) ? 1 : 0;
    QCOMPARE(holders, 1);
  }
}

void TestFiles::wrongShard_isOneClearLine() {
  for (const char* wrong : {"0/2", "3/2", "1", "1/2x", "", "-1/2", "1/0"}) {
    const auto shard = parseShard(wrong);
    VERIFY_ERROR(shard, "--shard: expected I/N with I from 1 to N, found \"" + std::string(wrong) + "\"");
  }
}

QTEST_APPLESS_MAIN(TestFiles)
#include "tst_files.moc"
