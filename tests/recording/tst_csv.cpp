#include <QTest>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "recording/csv.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

class TestCsv : public QObject {
  Q_OBJECT
 private slots:
  void whatIsWritten_readsBackToTheSameDoubles();
  void missingCells_stayMissing();
  void markCrLfSpacesAndLastLineWithoutBreak_areRead();
  void otherColumns_mayHoldAnything();
  void quotedNames_comeBack();
  void notes_areKept();
  void numbers_areReadAsStrtodReadsThem();
  void timeText_isCopiedAsItStands();
  void badText_getsOneLine_data();
  void badText_getsOneLine();
  void missingFileAndFolder_areTold();
  void failedWrite_leavesNothingBehind();
};

static bool same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
}

void TestCsv::whatIsWritten_readsBackToTheSameDoubles() {
  const unsigned seed = std::random_device{}();
  qInfo("seed %u", seed);
  std::mt19937_64 random(seed);
  std::vector<Channel> channels{{"time_s", {}}, {"angle_rad", {}}, {"current_A", {}}};
  for (int k = 0; k < 5000; ++k) {
    channels[0].values.push_back(k * 1e-3);
    for (size_t c = 1; c < 3; ++c) {
      double value = 0.0;
      do {
        const uint64_t bits = random();
        std::memcpy(&value, &bits, sizeof value);
      } while (std::isinf(value));
      channels[c].values.push_back(std::isnan(value) ? NAN : value);
    }
  }
  for (const double special : {0.0, -0.0, 5e-324, std::numeric_limits<double>::max(), -2.2250738585072014e-308}) {
    channels[0].values.push_back(channels[0].values.back() + 1.0);
    channels[1].values.push_back(special);
    channels[2].values.push_back(-special);
  }
  const TemporaryFolder folder;
  const auto recording = Recording::seal("r", channels);
  VERIFY_OK(recording);
  VERIFY_OK(writeCsv(*recording, folder.path("r.csv")));
  const auto read = readCsv(folder.path("r.csv"));
  VERIFY_OK(read);
  QCOMPARE(read->rows(), channels[0].values.size());
  for (const Channel& channel : channels) {
    for (size_t k = 0; k < read->rows(); ++k) {
      QVERIFY2(same(read->channel(channel.name)[k], channel.values[k]),
               qPrintable(QString("%1 row %2").arg(channel.name.c_str()).arg(k)));
    }
  }
}

void TestCsv::missingCells_stayMissing() {
  const auto read = readCsvText("time_s,angle_rad,current_A\n0,,1\n1,2,\n2,nan,NaN\n", "r");
  VERIFY_OK(read);
  QVERIFY(std::isnan(read->channel("angle_rad")[0]));
  QCOMPARE(read->channel("current_A")[0], 1.0);
  QVERIFY(std::isnan(read->channel("current_A")[1]));
  QVERIFY(std::isnan(read->channel("angle_rad")[2]) && std::isnan(read->channel("current_A")[2]));
  const TemporaryFolder folder;
  VERIFY_OK(writeCsv(*read, folder.path("r.csv")));
  QCOMPARE(*readFile(folder.path("r.csv")), std::string("time_s,angle_rad,current_A\n0,,1\n1,2,\n2,,\n"));
}

void TestCsv::markCrLfSpacesAndLastLineWithoutBreak_areRead() {
  const auto read = readCsvText("\xEF\xBB\xBF time_s , angle_rad\r\n0, 1.5 \r\n\r\n1,+2.5e1", "r");
  VERIFY_OK(read);
  QCOMPARE(read->rows(), size_t(2));
  QCOMPARE(read->channel("angle_rad")[0], 1.5);
  QCOMPARE(read->channel("angle_rad")[1], 25.0);
}

void TestCsv::otherColumns_mayHoldAnything() {
  const std::string text =
      "\"time_s\",state,\"note, by hand\",angle_rad,gain\n"
      "0,idle,\"3, then 4\",1.5,inf\n"
      "1,12,,2.5,7\n";
  const auto read = readCsvText(text, "r");
  VERIFY_OK(read);
  QCOMPARE(read->channel("angle_rad")[0], 1.5);
  QCOMPARE(read->channel("angle_rad")[1], 2.5);
  QVERIFY(std::isnan(read->channel("state")[0]) && std::isnan(read->channel("note, by hand")[0]));
  QVERIFY(std::isnan(read->channel("gain")[0]));
  QCOMPARE(read->channel("state")[1], 12.0);
  QCOMPARE(read->channel("gain")[1], 7.0);
  const TemporaryFolder folder;
  const auto texts = timeTextIn("note,time_s\n\"a, b\",0.0\n,0.10\n", "r.csv");
  VERIFY_OK(texts);
  QCOMPARE(texts->at(0), std::string("0.0"));
  QCOMPARE(texts->at(1), std::string("0.10"));
  VERIFY_OK(writeCsv(*read, folder.path("w.csv")));
  VERIFY_OK(readCsv(folder.path("w.csv")));
}

void TestCsv::quotedNames_comeBack() {
  for (const char* header : {"a\"b,c", "\"a, \"\"b\"\"\",c", "\"a,c", "\"\"\"a\",c", "\" a , b \",c", "\"#a, b\",c"}) {
    const auto read = readCsvText(std::string("time_s,") + header + "\n0,1\n1,2\n", "r");
    const auto wider = readCsvText(std::string("time_s,") + header + "\n0,1,5\n1,2,6\n", "r");
    QVERIFY2(read.ok() != wider.ok(), header);
    const Recording& one = read ? *read : *wider;
    const TemporaryFolder folder;
    VERIFY_OK(writeCsv(one, folder.path("w.csv")));
    const auto again = readCsv(folder.path("w.csv"));
    VERIFY_OK(again);
    QVERIFY2(again->channels() == one.channels(), header);
  }
  const TemporaryFolder folder;
  const auto first = readCsvText("\"#a\",time_s\n1,0\n2,1\n", "r");
  VERIFY_OK(first);
  VERIFY_OK(writeCsv(*first, folder.path("w.csv")));
  const auto again = readCsv(folder.path("w.csv"));
  VERIFY_OK(again);
  QVERIFY(again->channels() == first->channels());
}

void TestCsv::notes_areKept() {
  const auto read = readCsvText("# rig: bench 3: left\n#plain\n\ntime_s\n0\n1\n", "r");
  VERIFY_OK(read);
  QCOMPARE(read->notes().size(), size_t(2));
  QCOMPARE(read->notes()[0].first, std::string("rig"));
  QCOMPARE(read->notes()[0].second, std::string("bench 3: left"));
  QCOMPARE(read->notes()[1].first, std::string("plain"));
}

void TestCsv::numbers_areReadAsStrtodReadsThem() {
  for (const char* text : {"1e-400", "-1e-320", "4.9e-324", "0.1", "123456789012345678901234567890", "9007199254740993",
                           ".5", "5.", "1E5", "2.2250738585072011e-308"}) {
    const auto read = readCsvText(std::string("time_s,x\n0,") + text + "\n", "r");
    VERIFY_OK(read);
    QVERIFY2(same(read->channel("x")[0], std::strtod(text, nullptr)), text);
  }
}

void TestCsv::timeText_isCopiedAsItStands() {
  const auto texts = timeTextIn("# a: b\nangle_rad,time_s\n1,0.000\n\n2, 1e-3\n", "r.csv");
  VERIFY_OK(texts);
  QCOMPARE(texts->size(), size_t(2));
  QCOMPARE(texts->at(0), std::string("0.000"));
  QCOMPARE(texts->at(1), std::string("1e-3"));
}

void TestCsv::badText_getsOneLine_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* name, const QByteArray& text, const char* line) {
    QTest::newRow(name) << text << QString::fromUtf8(line);
  };
  row("empty", "", "r.csv: is empty, expected a header line with time_s");
  row("notes only", "# a: b\n", "r.csv: is empty, expected a header line with time_s");
  row("header only", "time_s,x\n", "r.csv: has a header and no rows");
  row("no time", "t,x\n0,1\n", "r.csv: has no column time_s, found: t, x");
  row("semicolons", "time_s;x\n0;1\n",
      "r.csv, header: is separated by semicolons or tabs, expected commas; breakaway import converts such files");
  row("nameless column", "time_s,,x\n0,1,2\n", "r.csv, header: column 2 has no name");
  row("column twice", "time_s,x,x\n0,1,2\n", "r.csv: has the column x twice");
  row("text", "time_s,duty\n0,1\n1,abc\n", "r.csv, row 2, column duty: expected a finite number, found \"abc\"");
  row("number and text", "time_s,duty\n0,1V\n", "r.csv, row 1, column duty: expected a finite number, found \"1V\"");
  row("two signs", "time_s,duty\n0,+-1\n", "r.csv, row 1, column duty: expected a finite number, found \"+-1\"");
  row("PWM in counts", "time_s,duty\n0,1\n1,64\n",
      "r.csv, row 2, column duty: expected a duty from -1 to 1, found \"64\"");
  row("infinity", "time_s,duty\n0,inf\n", "r.csv, row 1, column duty: expected a finite number, found \"inf\"");
  row("beyond range", "time_s,duty\n0,1e999\n", "r.csv, row 1, column duty: expected a finite number, found \"1e999\"");
  row("too few cells", "time_s,x\n0,1\n1\n", "r.csv, row 2: has too few cells: 1, expected 2");
  row("too many cells", "time_s,x\n0,1,2\n", "r.csv, row 1: has more cells than the header's 2");
  row("time missing", "time_s,x\n0,1\n,2\n",
      "r.csv, row 2, column time_s: is missing or not finite, expected a time in s");
  row("time stands still", "time_s,x\n0,1\n0.25,2\n\n0.25,3\n",
      "r.csv, row 3, column time_s: 0.25 does not increase after 0.25, expected strictly increasing times");
  row("time falls by a hair", "time_s,x\n1.0000000001,1\n1,2\n",
      "r.csv, row 2, column time_s: 1 does not increase after 1.0000000001, expected strictly increasing times");
  row("bytes", QByteArray("\x00\xff\x01,\n\x02", 6), "r.csv, header: column 2 has no name");
}

void TestCsv::badText_getsOneLine() {
  QFETCH(QByteArray, text);
  QFETCH(QString, line);
  const auto read = readCsvText(text.toStdString(), "r.csv");
  VERIFY_ERROR(read, line.toStdString());
}

void TestCsv::missingFileAndFolder_areTold() {
  const TemporaryFolder folder;
  VERIFY_ERROR(readCsv(folder.path("none.csv")),
               folder.path("none.csv") + ": cannot be read: No such file or directory");
  VERIFY_ERROR(readCsv(folder.path()), folder.path() + ": is a folder, expected a file");
}

void TestCsv::failedWrite_leavesNothingBehind() {
  const TemporaryFolder folder;
  const auto recording = readCsvText("time_s\n0\n1\n", "r");
  QVERIFY(!writeCsv(*recording, folder.path("no/such/folder.csv")).ok());
  VERIFY_OK(makeFolder(folder.path("taken")));
  QVERIFY(!writeCsv(*recording, folder.path("taken")).ok());
  QCOMPARE(folder.names(), QStringList{"taken"});
}

QTEST_APPLESS_MAIN(TestCsv)
#include "tst_csv.moc"
