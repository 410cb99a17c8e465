#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDirIterator>
#include <QTest>

#include "base/atomic_file.h"
#include "base/line_log.h"
#include "base/output_folder.h"
#include "base/shard.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

class TestFiles : public QObject {
  Q_OBJECT
 private slots:
  void writtenFile_replacesTheOldOneWhole();
  void partOfAKilledWriter_goes_andOfALivingOneStays();
  void linkIsFollowed_andModeIsKept();
  void devicesAndFifos_areWrittenToAsSuch();
  void outputThatWouldDestroy_isRefusedBeforehand();
  void folder_isPutInPlaceWhole_andStaleFilesGo();
  void foldersOtherFiles_stay();
  void folderThatFails_changesNothing();
  void folderInUse_isRefused();
  void folderOfAnotherCommandOrWithAnInput_isRefused();
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

void TestFiles::partOfAKilledWriter_goes_andOfALivingOneStays() {
  const TemporaryFolder folder;
  const std::string left = folder.write(".breakaway-1-0.part", "killed"), of = folder.write(".breakaway-2-0.part", "l");
  const int living = ::open(of.c_str(), O_WRONLY | O_CLOEXEC);
  QCOMPARE(::flock(living, LOCK_EX | LOCK_NB), 0);
  VERIFY_OK(writeFile(folder.path("a"), "first"));
  VERIFY_OK(writeFile(folder.path("a"), "second"));
  ::close(living);
  QVERIFY(::access(left.c_str(), F_OK) != 0 && ::access(of.c_str(), F_OK) == 0);
  QCOMPARE(*readFile(folder.path("a")), std::string("second"));
}

void TestFiles::linkIsFollowed_andModeIsKept() {
  const TemporaryFolder folder;
  QVERIFY(QFile::link("target", QString::fromStdString(folder.path("link"))));
  VERIFY_OK(writeFile(folder.path("link"), "through a link to nothing"));
  QVERIFY(QFileInfo(QString::fromStdString(folder.path("link"))).isSymLink());
  QVERIFY(::chmod(folder.path("target").c_str(), 0600) == 0);
  VERIFY_OK(writeFile(folder.path("link"), "again"));
  QCOMPARE(*readFile(folder.path("target")), std::string("again"));
  struct stat status {};
  QVERIFY(::stat(folder.path("target").c_str(), &status) == 0);
  QCOMPARE(status.st_mode & 07777, mode_t(0600));
}

void TestFiles::devicesAndFifos_areWrittenToAsSuch() {
  const TemporaryFolder folder;
  VERIFY_OK(writeFile("/dev/null", "gone"));
  VERIFY_ERROR(writeFile("/dev/full", "text"), "/dev/full: cannot be written: No space left on device");
  VERIFY_ERROR(appendLine("/dev/full", "text"), "/dev/full: cannot be written: No space left on device");
  QVERIFY(!QFileInfo("/dev/null").isFile() && !QFileInfo("/dev/full").isFile());
  QVERIFY(::mkfifo(folder.path("fifo").c_str(), 0600) == 0);
  const int end = ::open(folder.path("fifo").c_str(), O_RDONLY | O_NONBLOCK);
  VERIFY_OK(writeFile(folder.path("fifo"), "flows"));
  char text[16] = {};
  QCOMPARE(::read(end, text, sizeof text), ssize_t(5));
  ::close(end);
  QCOMPARE(folder.names(), QStringList());  // the FIFO is a system file
}

void TestFiles::outputThatWouldDestroy_isRefusedBeforehand() {
  const TemporaryFolder folder;
  const std::string in = folder.write("in", "precious"), link = folder.path("link");
  QVERIFY(::link(in.c_str(), link.c_str()) == 0);
  VERIFY_ERROR(checkOutput(link, {in}), link + ": is an input as well, expected another file to write");
  VERIFY_ERROR(checkOutput(""), "output: has an empty name, expected a file");
  VERIFY_ERROR(checkOutput(folder.path()), folder.path() + ": is a folder, expected a file");
  QVERIFY(!checkOutput(folder.path("none/file")));
  QVERIFY(::chmod(in.c_str(), 0400) == 0);
  QVERIFY(!checkOutput(in) && !writeFile(in, "other"));
  QCOMPARE(*readFile(in), std::string("precious"));
  VERIFY_OK(checkOutput(folder.path("new"), {in}));
  VERIFY_OK(checkOutput("-"));
}

namespace {

/// Fills `out` with files of these names.
Result<void> fillFolder(const std::string& out, const std::vector<std::string>& names, const std::string& text,
                        const std::string& command = "test") {
  auto folder = OutputFolder::open({out, command, {"figures", "main"}, {}});
  if (!folder) return folder.error();
  return folder->fill([&](const std::string& stage) -> Result<void> {
    if (auto made = makeFolder(stage + "/figures"); !made) return made;
    for (const std::string& name : names) {
      if (auto written = writeFile(stage + "/" + name, text); !written) return written;
    }
    return {};
  });
}

QStringList filesBelow(const std::string& folder) {
  QStringList names;
  QDirIterator one(QString::fromStdString(folder), QDir::Files, QDirIterator::Subdirectories);
  while (one.hasNext()) names << QDir(QString::fromStdString(folder)).relativeFilePath(one.next());
  names.sort();
  return names;
}

}  // namespace

void TestFiles::folder_isPutInPlaceWhole_andStaleFilesGo() {
  const TemporaryFolder folder;
  const std::string out = folder.path("deep/out");
  VERIFY_OK(fillFolder(out, {"main", "figures/a", "figures/b"}, "1"));
  VERIFY_OK(fillFolder(out, {"main", "figures/b", "figures/c"}, "2"));
  QCOMPARE(filesBelow(out), (QStringList{"figures/b", "figures/c", "main"}));
  QCOMPARE(*readFile(out + "/figures/b"), std::string("2"));
  QCOMPARE(QDir(QString::fromStdString(folder.path("deep")))
               .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
           QStringList{"out"});
}

void TestFiles::foldersOtherFiles_stay() {
  const TemporaryFolder folder;
  const std::string out = folder.path("out");
  VERIFY_OK(fillFolder(out, {"main", "figures/a"}, "1"));
  folder.write("out/mine", "mine");
  folder.write("out/figures/mine", "mine");
  VERIFY_OK(fillFolder(out, {"main", "figures/b"}, "2"));
  QCOMPARE(filesBelow(out), (QStringList{"figures/b", "figures/mine", "main", "mine"}));
  QCOMPARE(*readFile(out + "/main"), std::string("2"));
}

void TestFiles::folderThatFails_changesNothing() {
  const TemporaryFolder folder;
  const std::string out = folder.path("deep/out");
  {
    auto fresh = OutputFolder::open({out, "test", {"main"}, {}});
    VERIFY_OK(fresh);
    VERIFY_ERROR(fresh->fill([](const std::string& stage) { return writeFile(stage + "/no/main", ""); }),
                 out + "/no/main: cannot be written: No such file or directory");
  }
  QCOMPARE(folder.names(), QStringList());
}

void TestFiles::folderInUse_isRefused() {
  const TemporaryFolder folder;
  const std::string out = folder.path("out");
  const auto first = OutputFolder::open({out, "test", {"main"}, {}});
  VERIFY_OK(first);
  VERIFY_ERROR(OutputFolder::open({out, "test", {"main"}, {}}), out + ": another process writes into it");
}

void TestFiles::folderOfAnotherCommandOrWithAnInput_isRefused() {
  const TemporaryFolder folder;
  const std::string out = folder.path("out");
  VERIFY_OK(fillFolder(out, {"main"}, "1"));
  VERIFY_ERROR(fillFolder(out, {"main"}, "2", "other"), out + ": holds main of test, expected another folder");
  VERIFY_ERROR(OutputFolder::open({out, "test", {"main"}, {out + "/main"}}),
               out + ": main in it is an input and would be replaced, expected another folder");
  QVERIFY(!OutputFolder::open({"", "test", {"main"}, {}}));
  QCOMPARE(*readFile(out + "/main"), std::string("1"));
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
