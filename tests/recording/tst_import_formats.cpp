#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include "base/catalogue.h"
#include "recording/csv.h"
#include "recording/import/import.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

namespace {

/// Whether the window says it otherwise in German.
bool hasGerman(const Message& message) {
  static const auto german = [] {
    QFile file(qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/resources/lang/core_de.json");
    return file.open(QIODevice::ReadOnly) ? *Catalogue::read(file.readAll().toStdString()) : Catalogue();
  }();
  return message.in(german) != message.english();
}

}  // namespace

/// The manual's table of forms, import.md, each row with a file in tests/data/import.
class TestImportFormats : public QObject {
  Q_OBJECT
 private slots:
  void everyRowOfTheManual_isTrue_data();
  void everyRowOfTheManual_isTrue();
  void everyFile_hasItsRow();
  void everyColumn_isTold_data() { everyRowOfTheManual_isTrue_data(); }
  void everyColumn_isTold();
  void whatNoFileSays_isAskedFor_data();
  void whatNoFileSays_isAskedFor();
  void currentsAndVoltages_areNeverAnAngle();
  void wrappedAngle_goesOnWithinEachStretch();
  void whatCannotBe_isCalledImplausible_data();
  void whatCannotBe_isCalledImplausible();
  void filesThatAreNotRead_areNamed_data();
  void filesThatAreNotRead_areNamed();

 private:
  static QString folder() { return qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/tests/data/import/"; }
  static QList<QStringList> table();
  TemporaryFolder temporary_;
};

QList<QStringList> TestImportFormats::table() {
  QFile manual(qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/resources/help/import.md");
  if (!manual.open(QIODevice::ReadOnly)) return {};
  QList<QStringList> rows;
  for (const QString& line : QString::fromUtf8(manual.readAll()).split('\n')) {
    QStringList cells = line.split(" | ");
    if (cells.size() != 7 || !line.startsWith("| ") || !cells[1].startsWith('`')) continue;
    cells[0] = cells[0].mid(2);
    cells[1] = cells[1].mid(1, cells[1].size() - 2);
    cells[4] = cells[4].startsWith('`') ? cells[4].mid(1, cells[4].size() - 2) : QString();
    rows.append(cells);
  }
  return rows;
}

void TestImportFormats::everyRowOfTheManual_isTrue_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("map");
  QTest::addColumn<int>("rows");
  QTest::addColumn<QString>("last");
  const auto all = table();
  QVERIFY(all.size() > 40);
  for (const QStringList& row : all) QTest::newRow(qPrintable(row[1])) << row[1] << row[4] << row[5].toInt() << row[6];
}

void TestImportFormats::everyRowOfTheManual_isTrue() {
  QFETCH(QString, file);
  QFETCH(QString, map);
  QFETCH(int, rows);
  QFETCH(QString, last);
  ImportMap said;
  if (!map.isEmpty()) {
    const auto read = readImportMapText(map.toStdString(), "map");
    VERIFY_OK(read);
    said = *read;
  }
  const auto imported = importRecording((folder() + file).toStdString(), said);
  VERIFY_OK(imported);
  const Recording& recording = imported->recording;
  QCOMPARE(recording.rows(), size_t(rows));
  static const QRegularExpression check("`(\\w+)` (\\S+) ± ([0-9.e+-]+)");
  int checks = 0;
  for (auto it = check.globalMatch(last); it.hasNext(); ++checks) {
    const auto match = it.next();
    const std::string name = match.captured(1).toStdString();
    QVERIFY2(recording.has(name), name.c_str());
    const double got = recording.channel(name).back(), wanted = match.captured(2).toDouble();
    QVERIFY2(std::abs(got - wanted) <= 1.01 * match.captured(3).toDouble(),
             qPrintable(QString("%1: %2, expected %3").arg(name.c_str()).arg(got, 0, 'g', 12).arg(wanted, 0, 'g', 12)));
  }
  QVERIFY(checks > 0);
  VERIFY_OK(writeCsv(recording, temporary_.path("r.csv")));
  VERIFY_OK(readCsv(temporary_.path("r.csv")));
}

void TestImportFormats::everyFile_hasItsRow() {
  QStringList named;
  for (const QStringList& row : table()) named.append(row[1]);
  for (const QString& file : QDir(folder()).entryList(QDir::Files)) QVERIFY2(named.contains(file), qPrintable(file));
}

void TestImportFormats::everyColumn_isTold() {
  QFETCH(QString, file);
  QFETCH(QString, map);
  ImportMap said;
  if (!map.isEmpty()) said = *readImportMapText(map.toStdString(), "map");
  const auto imported = importRecording((folder() + file).toStdString(), said);
  VERIFY_OK(imported);
  QVERIFY(!imported->columns.empty());
  for (const ColumnFate& column : imported->columns) {
    QVERIFY(!column.from.empty());
    QVERIFY2(!column.why.empty(), column.from.c_str());
    const bool there = column.kind != ColumnFate::Kind::leftOut;
    QVERIFY2(imported->recording.has(column.to) == there || !there, column.to.c_str());
    QVERIFY2(hasGerman(column.why), column.why.c_str());
  }
  for (const Message& remark : imported->remarks) QVERIFY2(hasGerman(remark), remark.c_str());
}

void TestImportFormats::whatNoFileSays_isAskedFor_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("asked");
  QTest::newRow("pole pairs") << "vesc_tool_log.csv"
                              << R"({"pole_pairs": 7})";
  QTest::newRow("pole pairs of a speed alone") << "betaflight.csv"
                                               << R"({"pole_pairs": 7})";
  QTest::newRow("counts") << "comma_and_blanks.csv"
                          << R"({"counts_per_rev": 4096})";
  QTest::newRow("counts by their unit") << "kgf_cm.csv"
                                        << R"({"counts_per_rev": 4096})";
  QTest::newRow("rate") << "no_time_column.csv"
                        << R"({"sample_time_s": 0.01})";
  QTest::newRow("rate of a monitor") << "simplefoc.txt"
                                     << R"({"sample_time_s": 0.01})";
  QTest::newRow("channels") << "oscilloscope_numbered_channels.csv"
                            << R"("to": "angle_rad")";
}

void TestImportFormats::whatNoFileSays_isAskedFor() {
  QFETCH(QString, file);
  QFETCH(QString, asked);
  const auto imported = importRecording((folder() + file).toStdString());
  QVERIFY(!imported.ok());
  const QString message = QString::fromStdString(imported.error().message());
  QVERIFY2(message.contains(asked) && message.contains("--map"), qPrintable(message));
  QVERIFY2(hasGerman(imported.error().fact), qPrintable(message));
}

void TestImportFormats::currentsAndVoltages_areNeverAnAngle() {
  ImportMap map;
  map.columns["ms_today"] = {"time_s", 1e-3, 0.0};
  const auto imported = importRecording((folder() + "vesc_tool_log.csv").toStdString(), map);
  QVERIFY(!imported.ok());
  for (const char* name :
       {"q_axis_current", "q voltage", "voltage_q", "current.q", "q_A", "servo_stats.q_A", "iq_pos"}) {
    const auto alone =
        importRecording(temporary_.write("log.csv", std::string("time_s,") + name + "\n0,1\n1,2\n2,3\n"));
    QVERIFY2(!alone.ok() || !alone->recording.has("angle_rad") || std::string(name) == "iq_pos", name);
  }
}

void TestImportFormats::wrappedAngle_goesOnWithinEachStretch() {
  const auto imported = importRecording((folder() + "wrapped_angle_with_pause.csv").toStdString());
  VERIFY_OK(imported);
  const auto angle = imported->recording.channel("angle_rad");
  const auto time = imported->recording.time();
  size_t pause = 0;
  for (size_t k = 1; k < time.size(); ++k) {
    if (time[k] - time[k - 1] > 0.1) {
      pause = k;
    } else {
      QVERIFY2(std::abs(angle[k] - angle[k - 1]) < 3.1416, qPrintable(QString::number(k)));
    }
  }
  QVERIFY(pause > 0);
  size_t said = 0;
  for (const std::string& remark : imported->remarks) said += remark.find("pause") != std::string::npos ? 1 : 0;
  QVERIFY(said >= 1);
}

void TestImportFormats::whatCannotBe_isCalledImplausible_data() {
  QTest::addColumn<QString>("head");
  QTest::addColumn<double>("angle");
  QTest::addColumn<double>("speed");
  QTest::addColumn<double>("drive");
  QTest::addColumn<bool>("lost");
  QTest::addColumn<QString>("said");
  const auto row = [](const char* name, const char* head, double angle, double speed, double drive, bool lost,
                      const char* said) { QTest::newRow(name) << head << angle << speed << drive << lost << said; };
  row("all is well", "time_s,angle_rad,velocity_rad_per_s,current_A", 1, 1, 1, false, "");
  row("a drive of the other sign", "time_s,angle_rad,velocity_rad_per_s,current_A", 1, 1, -1, false,
      "moves against current_A");
  row("a speed of the other sign", "time_s,angle_rad,velocity_rad_per_s,current_A", 1, -1, 1, false, "the other sign");
  row("a speed of another unit", "time_s,angle_rad,velocity_rad_per_s,current_A", 1, 9.55, 1, false,
      "as the speed says");
  row("signs that are lost", "time_s,angle_rad,velocity_rad_per_s,current_A", 1, 1, 1, true, "never changes its sign");
  row("a converter's counts", "time_s,angle_rad,velocity_rad_per_s,current", 1, 1, 800, false, "thousandths");
  row("degrees that are called rad", "time_ms,angle_rad,speed,current_A", 1e5, 1e5, 1, false, "would turn");
}

/// To and fro; what drives has friction's and inertia's share.
void TestImportFormats::whatCannotBe_isCalledImplausible() {
  QFETCH(QString, head);
  QFETCH(double, angle);
  QFETCH(double, speed);
  QFETCH(double, drive);
  QFETCH(bool, lost);
  QFETCH(QString, said);
  QString text = head + "\n";
  for (int k = 0; k < 400; ++k) {
    const double phase = 0.03 * k, rate = 20.0 * std::cos(phase);
    double current = drive * ((rate > 0 ? 0.2 : -0.2) + 0.01 * rate - 0.05 * std::sin(phase));
    if (lost) current = std::abs(current);
    if (drive > 100) current = std::round(current);
    text += QString("%1,%2,%3,%4\n")
                .arg(head.contains("ms") ? 10.0 * k : 0.01 * k)
                .arg(angle * 20.0 * std::sin(phase) / 3.0, 0, 'g', 12)
                .arg(speed * rate, 0, 'g', 12)
                .arg(current, 0, 'g', 12);
  }
  const auto imported = importRecording(temporary_.write("log.csv", text.toStdString()));
  VERIFY_OK(imported);
  QString implausible;
  for (const Message& remark : imported->remarks) {
    QVERIFY2(hasGerman(remark), remark.c_str());
    if (remark.starts_with("implausible")) implausible += QString::fromStdString(remark) + "\n";
  }
  if (said.isEmpty()) QCOMPARE(implausible, QString());
  QVERIFY2(implausible.contains(said), qPrintable(implausible));
}

void TestImportFormats::filesThatAreNotRead_areNamed_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("said");
  const auto row = [](const char* name, const QByteArray& bytes, const char* said) {
    QTest::newRow(name) << bytes + QByteArray(64, '\0') << QString(said);
  };
  row("xls", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1", "before 2007");
  row("MCAP", "\x89MCAP0\r\n", "MCAP");
  row("Parquet", "PAR1", "Parquet");
  row("ROS bag", "#ROSBAG V2.0\n", "ROS bag");
  row("ROS 2 bag", QByteArray("SQLite format 3\0", 16), "ROS 2 bag");
  row("TDMS", "TDSm", "TDMS");
  row("blackbox", "H Product:Blackbox flight data recorder", "blackbox_decode");
  row("MDF", "MDF     4.10", "MDF");
  row("zip cut short", "PK\x03\x04", "zip archive");
  row("something binary", QByteArray("\x01\x02\x03\x00\x07\x05\x00\x02", 8), "binary file");
}

void TestImportFormats::filesThatAreNotRead_areNamed() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, said);
  const auto imported = importRecording(temporary_.write("log.dat", bytes.toStdString()));
  QVERIFY(!imported.ok());
  QVERIFY2(QString::fromStdString(imported.error().message()).contains(said), imported.error().message().c_str());
  QVERIFY2(hasGerman(imported.error().fact), imported.error().message().c_str());
}

QTEST_APPLESS_MAIN(TestImportFormats)
#include "tst_import_formats.moc"
