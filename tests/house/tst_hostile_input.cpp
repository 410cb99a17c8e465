#include <sys/inotify.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zip.h>
#include <zlib.h>

#include <QElapsedTimer>
#include <QProcess>
#include <QTest>
#include <array>
#include <cstring>
#include <functional>
#include <vector>

#include "house/program.h"
#include "house/pushed_mass.h"
#include "support/temporary.h"

using namespace breakaway::test;

/// Input that is made to break a reader, or only absurd: one line and status 2, within bounds of time and memory, and
/// nothing is left. What is well-formed however odd is read.
class TestHostileInput : public QObject {
  Q_OBJECT
 private slots:
  void input_isRefusedInOneLine_data();
  void input_isRefusedInOneLine();
  void endlessInput_isRefused_data();
  void endlessInput_isRefused();
  void pipe_isOpenedOnce_data();
  void pipe_isOpenedOnce();
  void fullDevice_isSaid_data();
  void fullDevice_isSaid();
  void oddInput_isRead_data();
  void oddInput_isRead();
};

using Files = QMap<QByteArray, QByteArray>;

namespace {

constexpr qsizetype mega = 1 << 20;
constexpr int patience_ms = 120'000;

QByteArray packed(const QByteArray& block, int members) {
  QByteArray out(static_cast<qsizetype>(deflateBound(nullptr, static_cast<uLong>(block.size()))) + 64, '\0');
  z_stream stream{};
  deflateInit2(&stream, 1, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(block.data()));
  stream.avail_in = static_cast<uInt>(block.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.truncate(static_cast<qsizetype>(stream.total_out));
  deflateEnd(&stream);
  return out.repeated(members);
}

QByteArray zipped(const std::vector<std::pair<const char*, QByteArray>>& members) {
  zip_source_t* content = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  zip_source_keep(content);
  zip_t* archive = zip_open_from_source(content, ZIP_TRUNCATE, nullptr);
  for (const auto& [name, bytes] : members) {
    zip_source_t* part = zip_source_buffer(archive, bytes.data(), static_cast<zip_uint64_t>(bytes.size()), 0);
    const auto index = zip_file_add(archive, name, part, 0);
    zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), ZIP_CM_DEFLATE, 1);
  }
  if (zip_close(archive) != 0) qFatal("the archive can't be packed");
  zip_source_open(content);
  zip_stat_t status;
  zip_source_stat(content, &status);
  QByteArray whole(static_cast<qsizetype>(status.size), '\0');
  zip_source_read(content, whole.data(), status.size);
  zip_source_close(content);
  zip_source_free(content);
  return whole;
}

QByteArray workbook(const QByteArray& rows, const QByteArray& texts = {}) {
  return zipped({{"xl/workbook.xml", "<workbook/>"},
                 {"xl/sharedStrings.xml", "<sst><si>" + texts + "</si></sst>"},
                 {"xl/worksheets/sheet1.xml", "<worksheet><sheetData>" + rows + "</sheetData></worksheet>"}});
}

QByteArray npy(const QByteArray& shape) {
  const QByteArray head = "{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + ", }\n";
  return QByteArray("\x93NUMPY\x01\x00", 8) + char(head.size()) + '\0' + head + QByteArray(48, '\0');
}

QByteArray words(std::initializer_list<quint32> values) {
  QByteArray bytes;
  for (const quint32 value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  return bytes;
}

/// One variable t of `rows` rows, of which two are there.
QByteArray mat(quint32 rows) {
  const QByteArray body =
      words({6, 8, 6, 0, 5, 8, rows, 1, 1, 1}) + "t" + QByteArray(7, '\0') + words({9, 16}) + QByteArray(16, '\0');
  return QByteArray("MATLAB 5.0 MAT-file").leftJustified(124, ' ') + QByteArray("\x00\x01IM", 4) +
         words({14, static_cast<quint32>(body.size())}) + body;
}

/// Rows whose times are what `time` says.
QByteArray recording(const std::function<double(int)>& time) {
  QByteArray text = "time_s,position_m,force_N\n";
  for (int k = 0; k < 1000; ++k)
    text +=
        QByteArray::number(time(k), 'g', 17) + "," + QByteArray::number(k % 7) + "," + QByteArray::number(k % 5) + "\n";
  return text;
}

Outcome bounded(const QStringList& words, const QString& folder, const QString& input = {},
                const QString& output = {}) {
  QProcess process;
  process.setWorkingDirectory(folder);
  if (!input.isEmpty()) process.setStandardInputFile(input);
  if (!output.isEmpty()) process.setStandardOutputFile(output);
#ifndef __SANITIZE_ADDRESS__  // whose shadow alone needs more
  process.setChildProcessModifier([] {
    const rlimit memory{size_t{3} << 30, size_t{3} << 30}, computing{60, 60};
    ::setrlimit(RLIMIT_AS, &memory);
    ::setrlimit(RLIMIT_CPU, &computing);
  });
#endif
  process.start(builtProgram("breakaway"), words);
  if (!process.waitForFinished(patience_ms)) {
    process.kill();
    process.waitForFinished();
    return {};
  }
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
          QString::fromUtf8(process.readAllStandardOutput()), QString::fromUtf8(process.readAllStandardError())};
}

void checkRefused(const Outcome& outcome, const QString& line) {
  QVERIFY2(outcome.status == 2, qPrintable(QString("status %1, said: %2").arg(outcome.status).arg(outcome.err)));
  QVERIFY2(outcome.err.count('\n') == 1 && outcome.err.contains(line), qPrintable(outcome.err));
}

}  // namespace

void TestHostileInput::input_isRefusedInOneLine_data() {
  QTest::addColumn<QString>("command");
  QTest::addColumn<Files>("files");
  QTest::addColumn<QString>("line");
  const auto log = [](const char* name, const QByteArray& bytes, const char* line) {
    QTest::newRow(name) << "import f --out o.csv" << Files{{"f", bytes}} << line;
  };
  log("a line of digits", QByteArray("1,").repeated(4 * mega), "f: holds no table");
  log("a line of letters", QByteArray(8 * mega, 'a'), "f: holds no table");
  log("line feeds", QByteArray(8 * mega, '\n'), "f: is empty");
  log("quotes", QByteArray(8 * mega, '"'), "f: holds no table");
  log(".gz beyond all bounds", packed(QByteArray(64 * mega, '\0'), 17), "f: unpacks to more than 1 GB");
  log("a workbook of blanks", workbook(QByteArray(260 * mega, ' ')), "is more than 256 MB of XML");
  log("a workbook of far cells", workbook(QByteArray("<row><c r=\"XFD1\"><v>1</v></c></row>").repeated(100'000)),
      "f: has a sheet of more than 100 million cells");
  const QByteArray deepText = QByteArray("<r>").repeated(300'000) + "<t>a</t>" + QByteArray("</r>").repeated(300'000);
  log("a workbook of texts in texts", workbook("<row><c t=\"s\"><v>0</v></c></row>", deepText),
      "f: is an Excel workbook without a table");
  log("an archive in an archive", zipped({{"a", packed("time_s,angle_rad\n0,1\n1,2\n", 1)}}),
      "f: is a packed file within a zip archive");
  log("an array of 10^9 rows", npy("(1000000000, 3)"), "f: is a NumPy array that is cut short");
  log("an array beyond all numbers", npy("(99999999999999999999, 3)"), "f: ");
  log("a MATLAB variable of 10^9 rows", mat(1'000'000'000), "f: is damaged");
  log("a MATLAB variable of -1 rows", mat(0xffffffff), "f: is damaged");
  log("lists in lists", QByteArray(1'000'000, '['), "f: nests deeper");
  log("objects in objects", QByteArray("{\"a\":").repeated(1'000'000), "f: nests deeper");
  QByteArray fields = "{\"k\":1";
  for (int k = 0; k < 300'000; ++k) fields += ",\"k" + QByteArray::number(k) + "\":1";
  log("an object of many fields", fields + "}", "f: holds no log");
  log("a message of lists in lists", "a: 1\n---\na: 2\n---\na: " + QByteArray(1'000'000, '[') + "\n---\n",
      "f: no column could be taken for the time");
  QByteArray messages = "a: 1\n---\na: 2\n---\n";
  for (int k = 0; k < 20'000; ++k) messages += "k" + QByteArray::number(k) + ": 1\n---\n";
  log("messages of many kinds", messages, "f: holds messages of too many kinds");
  const auto diagnosed = [](const char* name, const QByteArray& text, const char* line) {
    QTest::newRow(name) << "diagnose --bench b.json --recording r.csv --out d"
                        << Files{{"b.json", pushedMassBench()}, {"r.csv", text}} << line;
  };
  diagnosed("times beyond digits", recording([](int k) { return 1e295 * k; }), "r.csv: ");
  diagnosed("a pause of an age", recording([](int k) { return 1e-2 * k + (k > 500 ? 1e12 : 0.0); }), "r.csv: ");
  diagnosed("times within a moment", recording([](int k) { return 1e-300 * k; }), "r.csv: is too short");
  QTest::newRow("an absurd job")
      << "commission --resume --out c"
      << Files{{"c/progress/state.json",
                R"({"schema": "breakaway.progress/1", "device": "a", "bins": 1000000000000, "turns": -1})"}}
      << "state.json";
}

void TestHostileInput::input_isRefusedInOneLine() {
  QFETCH(QString, command);
  QFETCH(Files, files);
  QFETCH(QString, line);
  const TemporaryFolder folder;
  for (auto it = files.begin(); it != files.end(); ++it) {
    const QFileInfo file(QString::fromStdString(folder.path(it.key().toStdString())));
    QVERIFY(QDir().mkpath(file.path()));
    folder.write(it.key().toStdString(), it.value().toStdString());
  }
  const QStringList before = folder.names();
  checkRefused(bounded(command.split(' '), QString::fromStdString(folder.path())), line);
  QCOMPARE(folder.names(), before);
}

void TestHostileInput::endlessInput_isRefused_data() {
  QTest::addColumn<QString>("input");
  QTest::newRow("a device") << "/dev/zero";
  QTest::newRow("standard input") << "-";
  QTest::newRow("a pipe") << "pipe";
}

void TestHostileInput::endlessInput_isRefused() {
  QFETCH(QString, input);
  const TemporaryFolder folder;
  const QString place = QString::fromStdString(folder.path());
  QProcess writer;
  if (input == "pipe") {
    QVERIFY(::mkfifo(folder.path("pipe").c_str(), 0600) == 0);
    writer.setStandardOutputFile(QProcess::nullDevice());
    writer.setWorkingDirectory(place);
    writer.start("sh", {"-c", "yes 1,2 > pipe"});
    QVERIFY(writer.waitForStarted());
  }
  const QString standard = input == "-" ? "/dev/zero" : QString();
  checkRefused(bounded({"import", input, "--out", "o.csv"}, place, standard), "gives more than 256 MB without an end");
  QVERIFY(!folder.names().contains("o.csv"));
  writer.kill();
  writer.waitForFinished();
}

void TestHostileInput::pipe_isOpenedOnce_data() {
  QTest::addColumn<QString>("command");
  QTest::newRow("import") << "import pipe --out o.csv";
  QTest::newRow("check") << "check --bench b.json --recording pipe";
}

/// Who writes into a pipe ends when a first reader closes it, and a second one waits without end.
void TestHostileInput::pipe_isOpenedOnce() {
  QFETCH(QString, command);
  const TemporaryFolder folder;
  folder.write("l.csv", pushedMassRecording().toStdString());
  folder.write("b.json", pushedMassBench().toStdString());
  QVERIFY(::mkfifo(folder.path("pipe").c_str(), 0600) == 0);
  const int watch = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  QVERIFY(watch >= 0 && ::inotify_add_watch(watch, folder.path("pipe").c_str(), IN_OPEN | IN_CLOSE_NOWRITE) >= 0);
  QProcess writer;
  writer.setWorkingDirectory(QString::fromStdString(folder.path()));
  writer.start("sh", {"-c", "cat l.csv > pipe"});
  const Outcome outcome = bounded(command.split(' '), QString::fromStdString(folder.path()));
  QVERIFY(writer.waitForFinished(patience_ms));
  alignas(inotify_event) std::array<char, 4096> events{};
  const ssize_t bytes = ::read(watch, events.data(), events.size());
  ::close(watch);
  QVERIFY2(outcome.status == 0, qPrintable(outcome.err));
  int closedByReaders = 0;
  for (ssize_t at = 0; at < bytes; at += ssize_t{sizeof(inotify_event)}) {
    inotify_event event{};
    std::memcpy(&event, &events.at(static_cast<size_t>(at)), sizeof event);
    closedByReaders += (event.mask & IN_CLOSE_NOWRITE) != 0 ? 1 : 0;
  }
  QCOMPARE(closedByReaders, 1);
}

void TestHostileInput::fullDevice_isSaid_data() {
  QTest::addColumn<QString>("command");
  QTest::addColumn<QString>("output");
  QTest::newRow("a file") << "import l.csv --out /dev/full"
                          << "";
  QTest::newRow("results") << "batch l.jsonl --out /dev/full"
                           << "";
  QTest::newRow("standard output") << "import l.csv --out -"
                                   << "/dev/full";
  QTest::newRow("an answer") << "list effects"
                             << "/dev/full";
  QTest::newRow("help") << "--help"
                        << "/dev/full";
}

void TestHostileInput::fullDevice_isSaid() {
  QFETCH(QString, command);
  QFETCH(QString, output);
  const TemporaryFolder folder;
  folder.write("l.csv", "t,angle_rad\n0,1\n1,2\n2,3\n");
  folder.write("l.jsonl", R"({"id": 1, "bench": "b", "recordings": ["r"]})");
  checkRefused(bounded(command.split(' '), QString::fromStdString(folder.path()), {}, output), "written");
  QCOMPARE(folder.names(), QStringList({"l.csv", "l.jsonl"}));
}

void TestHostileInput::oddInput_isRead_data() {
  QTest::addColumn<QByteArray>("name");
  QTest::addColumn<QByteArray>("bytes");
  const QByteArray table = "t,angle_rad\n0,1\n1,2\n2,4\n";
  QTest::newRow("a name that isn't UTF-8") << QByteArray("\xff\xfe.csv") << table;
  QTest::newRow("a column that isn't UTF-8") << QByteArray("l.csv") << QByteArray(table).replace("t,", "t,\xff\xfe_");
  QByteArray byIndex = "{\"time_s\":{", angles = "\"angle_rad\":{";
  for (int k = 0; k < 100'000; ++k) {
    const QByteArray head = (k == 0 ? "\"" : ",\"") + QByteArray::number(k) + "\":";
    byIndex += head + QByteArray::number(1e-3 * k);
    angles += head + QByteArray::number(k % 9);
  }
  QTest::newRow("a field per row") << QByteArray("l.json") << byIndex + "}," + angles + "}}";
  QByteArray pause = "time_ms,angle_deg\n";
  for (qint64 k = 0; k < 1000; ++k)
    pause += QByteArray::number(k + (k > 500 ? 100'000'000'000'000 : 0)) + "," + QByteArray::number(k) + "\n";
  QTest::newRow("a pause of ages") << QByteArray("l.csv") << pause;
}

void TestHostileInput::oddInput_isRead() {
  QFETCH(QByteArray, name);
  QFETCH(QByteArray, bytes);
  const TemporaryFolder folder;
  folder.write(name.toStdString(), bytes.toStdString());
  QProcess process;  // whose words would be UTF-8 only
  process.setWorkingDirectory(QString::fromStdString(folder.path()));
  process.start("sh", {"-c", "exec \"$0\" import * --out o", builtProgram("breakaway")});
  QVERIFY(process.waitForFinished(patience_ms));
  QVERIFY2(process.exitCode() == 0, process.readAllStandardError().constData());
  QVERIFY(folder.names().contains("o"));
}

QTEST_APPLESS_MAIN(TestHostileInput)
#include "tst_hostile_input.moc"
