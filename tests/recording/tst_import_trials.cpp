#include <QTest>
#include <algorithm>
#include <cmath>

#include "recording/import/import.h"
#include "support/imported_log.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::meaning;
using breakaway::test::TemporaryFolder;

/// Tables of several trials, and what may be the clock where no name says so.
class TestImportTrials : public QObject {
  Q_OBJECT
 private slots:
  void clocksOfTrials_followOneAnother_data();
  void clocksOfTrials_followOneAnother();
  void clockThatGoesOnThroughTrials_staysAsItIs();
  void trials_arePartedByTheirColumn();
  void trialOfASingleRow_isLeftOut();
  void stepsThatCountRows_areNoTime();
  void firstColumn_isTheTimeOnlyIfItsNameAllowsIt_data();
  void firstColumn_isTheTimeOnlyIfItsNameAllowsIt();
  void whatSomethingTook_isNoTime();
  void rowsSentAndReceived_areAskedAbout_data();
  void rowsSentAndReceived_areAskedAbout();

 private:
  /// Trials of an angle, each beginning at 0 s.
  static std::string trialsOf(const QString& names, int rows, const QStringList& values) {
    QString text = names + "\n";
    for (const QString& value : values) {
      for (int k = 0; k < rows; ++k)
        text += QString("%1,%2,%3,%4\n").arg(value).arg(k).arg(0.005 * k).arg(0.3 * std::sin(0.1 * k));
    }
    return text.toStdString();
  }
  TemporaryFolder folder_;
};

void TestImportTrials::clocksOfTrials_followOneAnother_data() {
  QTest::addColumn<QString>("names");
  QTest::addColumn<int>("rows");
  QTest::addColumn<QStringList>("values");
  QTest::newRow("a time by its steps") << "trajectory_id,row,time_step,angle_rad" << 60 << QStringList{"0", "1", "2"};
  QTest::newRow("a time by its name") << "episode_index,frame_index,timestamp,angle_rad" << 60
                                      << QStringList{"0", "1", "2"};
  QTest::newRow("trials of few rows") << "trial,k,t_s,angle_rad" << 6 << QStringList{"1", "2", "3"};
  QTest::newRow("trials with names") << "run_name,k,time,angle_rad" << 30 << QStringList{"slow", "fast", "stop"};
}

void TestImportTrials::clocksOfTrials_followOneAnother() {
  QFETCH(QString, names);
  QFETCH(int, rows);
  QFETCH(QStringList, values);
  const auto log = importRecording(folder_.write("log.csv", trialsOf(names, rows, values)));
  VERIFY_OK(log);
  const auto time_s = log->recording.channel("time_s");
  QCOMPARE(time_s.size(), static_cast<size_t>(3 * rows));
  const auto at = static_cast<size_t>(rows);
  QVERIFY(std::abs(time_s[at] - time_s[at - 1] - 1.0) < 1e-9);
  QVERIFY(std::abs(time_s[2 * at + 1] - time_s[2 * at] - 0.005) < 1e-9);
  const std::string column = names.split(',')[0].toStdString();
  QVERIFY(std::any_of(log->remarks.begin(), log->remarks.end(), [&](const std::string& one) {
    return one.starts_with(column) && one.find("{\"split\": \"" + column + "\"}") != std::string::npos;
  }));
}

void TestImportTrials::clockThatGoesOnThroughTrials_staysAsItIs() {
  QString text = "trial,time_s,angle_rad\n";
  for (int k = 0; k < 90; ++k) text += QString("%1,%2,%3\n").arg(k / 30).arg(0.01 * k).arg(std::sin(0.1 * k));
  const auto log = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("time_s").back() - 0.89) < 1e-9);
  QVERIFY(log->remarks.empty());
}

void TestImportTrials::trials_arePartedByTheirColumn() {
  ImportMap map;
  map.split = "trajectory_id";
  const auto logs = importRecordings(
      folder_.write("log.csv", trialsOf("trajectory_id,row,time_step,angle_rad", 60, {"4", "7"})), map);
  VERIFY_OK(logs);
  QCOMPARE(logs->size(), 2U);
  for (const Imported& one : *logs) {
    const auto time_s = one.recording.channel("time_s");
    QCOMPARE(time_s.front(), 0.0);
    QVERIFY(std::abs(time_s.back() - 0.295) < 1e-9);
  }
}

void TestImportTrials::trialOfASingleRow_isLeftOut() {
  const std::string text = trialsOf("trial,row,time_s,angle_rad", 60, {"1", "2"}) + "3,0,0,0.1\n";
  ImportMap map;
  map.split = "trial";
  const auto logs = importRecordings(folder_.write("log.csv", text), map);
  VERIFY_OK(logs);
  QCOMPARE(logs->size(), 2U);
  const auto& remarks = logs->front().remarks;
  QVERIFY(std::any_of(remarks.begin(), remarks.end(), [](const std::string& one) {
    return one == "1 part of the log is a single row and was left out";
  }));
  map.split = "row";  // each row another one
  QVERIFY(!importRecordings(folder_.write("rows.csv", "row,time_s,angle_rad\n1,0,1\n2,1,2\n3,2,2\n"), map).ok());
}

void TestImportTrials::stepsThatCountRows_areNoTime() {
  QString text = "trial,time_step,angle_rad\n";
  for (int k = 0; k < 90; ++k) text += QString("%1,%2,%3\n").arg(k / 30).arg(k % 30).arg(std::sin(0.1 * k));
  const auto log = importRecording(folder_.write("log.csv", text.toStdString()));
  QVERIFY(!log.ok());
  QVERIFY2(log.error().message().find("sample_time_s") != std::string::npos, log.error().message().c_str());
}

void TestImportTrials::firstColumn_isTheTimeOnlyIfItsNameAllowsIt_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("time");
  QTest::newRow("a word that isn't known") << "waktunya" << true;
  QTest::newRow("a value") << "x_value" << false;
  QTest::newRow("a distance") << "distance" << false;
  QTest::newRow("a frequency") << "freq" << false;
  QTest::newRow("a depth") << "depth_of_cut" << false;
}

void TestImportTrials::firstColumn_isTheTimeOnlyIfItsNameAllowsIt() {
  QFETCH(QString, name);
  QFETCH(bool, time);
  QString text = name + ",angle_rad\n";
  for (int k = 0; k < 90; ++k) text += QString("%1,%2\n").arg(0.2 * k).arg(std::sin(0.1 * k));
  const auto log = importRecording(folder_.write("log.csv", text.toStdString()));
  QCOMPARE(log.ok(), time);
  if (time) {
    QVERIFY(log->columns[0].guessed);
  } else {
    QVERIFY2(log.error().message().find("sample_time_s") != std::string::npos, log.error().message().c_str());
  }
}

void TestImportTrials::whatSomethingTook_isNoTime() {
  QString text = "angle_deg,total_us\n";
  for (int k = 0; k < 300; ++k) text += QString("%1,%2\n").arg(20.0 * std::sin(0.1 * k)).arg(900 + k % 30);
  const auto log = importRecording(folder_.write("log.csv", text.toStdString()));
  QVERIFY(!log.ok());
  QVERIFY2(log.error().message().find("sample_time_s") != std::string::npos, log.error().message().c_str());
}

void TestImportTrials::rowsSentAndReceived_areAskedAbout_data() {
  QTest::addColumn<QString>("sent");
  QTest::addColumn<QString>("received");
  QTest::addColumn<bool>("asked");
  QTest::newRow("letters") << "T"
                           << "R" << true;
  QTest::newRow("words") << "cmd"
                         << "fb" << true;
  QTest::newRow("states") << "run"
                          << "hold" << false;
}

/// A command and what follows it closely differ little from row to row.
void TestImportTrials::rowsSentAndReceived_areAskedAbout() {
  QFETCH(QString, sent);
  QFETCH(QString, received);
  QFETCH(bool, asked);
  QString text = "time_ms,dir,pos_rad,vel_rad_s\n";
  for (int k = 0; k < 200; ++k) {
    const double angle = std::sin(0.05 * k), speed = 0.5 * std::cos(0.05 * k);
    text += QString("%1,%2,%3,%4\n").arg(10 * k).arg(sent).arg(angle + 1e-3).arg(speed);
    text += QString("%1,%2,%3,%4\n").arg(10 * k + 4).arg(received).arg(angle).arg(speed);
  }
  const std::string path = folder_.write("log.csv", text.toStdString());
  const auto log = importRecording(path);
  QCOMPARE(!log.ok(), asked);
  if (!asked) return;
  QVERIFY2(log.error().message().find("{\"split\": \"dir\"}") != std::string::npos, log.error().message().c_str());
  ImportMap map;
  map.split = "dir";
  const auto parts = importRecordings(path, map);
  VERIFY_OK(parts);
  QCOMPARE(parts->size(), 2U);
}

QTEST_APPLESS_MAIN(TestImportTrials)
#include "tst_import_trials.moc"
