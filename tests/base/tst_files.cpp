#include <QTest>

#include "base/atomic_file.h"
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

QTEST_APPLESS_MAIN(TestFiles)
#include "tst_files.moc"
