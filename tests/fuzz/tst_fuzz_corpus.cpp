#include <QDirIterator>
#include <QTest>

#include "base/atomic_file.h"
#include "fuzz/fuzzed.h"
#include "support/sanitized.h"

using namespace breakaway;
using namespace breakaway::test;

/// Replays the corpus of every fuzzed reader, each file also cut short and with bytes changed; a reader that breaks
/// aborts.
class TestFuzzCorpus : public QObject {
  Q_OBJECT
 private slots:
  void everyInput_isReadOrRefused_data();
  void everyInput_isReadOrRefused();
};

void TestFuzzCorpus::everyInput_isReadOrRefused_data() {
  QTest::addColumn<QString>("reader");
  const QString corpus = qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/tests/fuzz/corpus/";
  for (const auto& [name, reader] : fuzzedReaders()) {
    const QString reading = QString::fromStdString(name);
    QVERIFY2(!QDir(corpus + reading).isEmpty(), qPrintable("no corpus for " + reading));
    QTest::newRow(qPrintable(reading)) << reading;
  }
}

void TestFuzzCorpus::everyInput_isReadOrRefused() {
  QFETCH(QString, reader);
  const FuzzedReader read = fuzzedReaders().at(reader.toStdString());
  const bool slow = reader == "mat" || reader == "hdf5" || reader == "board_host";  // a process, or waiting, each
  const int quickRuns = sanitized ? 200 : 20;  // what is read beside its place, only a sanitizer sees
  unsigned state = 1;
  const auto random = [&state] { return (state = state * 1664525U + 1013904223U) >> 8; };
  QDirIterator files(qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/tests/fuzz/corpus/" + reader, QDir::Files);
  size_t count = 0;
  while (files.hasNext()) {
    const auto bytes = readFile(files.next().toStdString());
    QVERIFY(bytes.ok());
    read(*bytes);
    ++count;
    for (int run = 0; run < (slow ? 10 : quickRuns) && !bytes->empty(); ++run) {
      std::string changed = bytes->substr(0, run % 2 == 0 ? bytes->size() : random() % bytes->size());
      for (unsigned k = 0; k < 1 + random() % 4 && !changed.empty(); ++k) {
        static const std::string telling = "0123456789.,;:-+eE \t\n\r\"{}[]#nai\xff";
        changed[random() % changed.size()] = telling[random() % telling.size()];
      }
      read(changed);
    }
  }
  QVERIFY(count > 0);
}

QTEST_APPLESS_MAIN(TestFuzzCorpus)
#include "tst_fuzz_corpus.moc"
