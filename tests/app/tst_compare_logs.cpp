// Compare through the window: a log of any kind is shown as it is understood, corrected, and opened.
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <cmath>

#include "app/compare_desk.h"
#include "app/technician.h"
#include "app/window_support.h"
#include "session/language.h"
#include "widgets/log_panel.h"

using namespace breakaway;
using namespace breakaway::test;

class TestCompareLogs : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void log_isShownAsUnderstoodAndCorrectedByAClick();
  void whatNoLogSays_isAskedForAndRemembered();
  void logOfSeveralMotors_isPartedByAClick();
  void advice_isTheWindows();
  void benchBesideARecording_isOpenedWithIt();

 private:
  const QTemporaryDir settings_;
};

void TestCompareLogs::initTestCase() {
  qputenv("XDG_CONFIG_HOME", settings_.path().toUtf8());
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

/// Chooses as a person does who types the first letters.
static void choose(QWidget& window, const QString& objectName, const QString& item) {
  auto* box = named<QComboBox>(window, qPrintable(objectName));
  const int index = box->findText(item);
  if (index < 0) qFatal("%s doesn't offer %s", qPrintable(objectName), qPrintable(item));
  box->setFocus();
  while (box->currentIndex() != index) QTest::keyClick(box, box->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
}

static QString written(const QTemporaryDir& folder, const QByteArray& text) {
  QFile file(folder.filePath("log.csv"));
  if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0) qFatal("no log");
  return file.fileName();
}

void TestCompareLogs::log_isShownAsUnderstoodAndCorrectedByAClick() {
  const QTemporaryDir folder;
  QByteArray text = "t [ms];Winkel [deg];u;x\n";
  for (int k = 0; k < 50; ++k)
    text += QByteArray::number(10 * k) + ";" + QByteArray::number(k * k) + ";" + QByteArray::number(k % 5) + ";" +
            QByteArray::number(0.5 * k) + "\n";
  Desk desk;
  desk.answers.byTitle["Open a recording"] = written(folder, text);
  press(desk.window, "openRecordingButton");
  LogOpening& log = desk.session.comparison.log();
  const auto settled = [&log] { return log.isOpen() && !log.settling(); };
  QVERIFY(QTest::qWaitFor(settled, patience_ms));
  QVERIFY(named<LogPanel>(desk.window, "logPanel")->isVisible());
  QVERIFY(!named<QWidget>(desk.window, "residualPlots")->isVisible());
  const auto* table = named<QTableWidget>(desk.window, "logColumns");
  QCOMPARE(table->rowCount(), 4);
  QCOMPARE(table->item(1, 0)->text(), QString("Winkel [deg]"));
  const auto* taken = named<QComboBox>(desk.window, "logTakenAs1");
  QCOMPARE(taken->currentText(), QString("angle"));
  QVERIFY2(taken->toolTip().contains("angle_rad"), qPrintable(taken->toolTip()));
  QCOMPARE(named<QComboBox>(desk.window, "logUnit1")->currentText(), QString("deg"));
  QCOMPARE(table->item(1, 3)->text(), QString("0  1  4"));
  QCOMPARE(table->item(1, 3)->toolTip(), QString("0  1  4  9"));
  choose(desk.window, "logUnit1", "rev");
  QVERIFY(QTest::qWaitFor([&] { return settled() && log.columns()[1].unit == "rev"; }, patience_ms));
  choose(desk.window, "logTakenAs3", "current");
  QVERIFY(QTest::qWaitFor([&] { return settled() && log.columns()[3].to == "current_A"; }, patience_ms));
  choose(desk.window, "logUnit3", "mA");
  QVERIFY(QTest::qWaitFor([&] { return settled() && log.columns()[3].unit == "mA"; }, patience_ms));
  press(desk.window, "logOpenButton");
  const auto& recording = desk.session.comparison.recording();
  QVERIFY(recording.has_value());
  QVERIFY(std::abs(recording->channel("angle_rad")[3] - 9.0 * 2.0 * M_PI) < 1e-9);
  QVERIFY(std::abs(recording->channel("current_A")[10] - 5e-3) < 1e-12);
  QVERIFY(!named<LogPanel>(desk.window, "logPanel")->isVisible());
}

/// What only the command can do isn't advised in the window.
void TestCompareLogs::advice_isTheWindows() {
  const QTemporaryDir folder;
  QByteArray text = "ms_today;erpm;current_motor;duty_cycle;pos\n";
  for (int k = 0; k < 50; ++k)
    text += QByteArray::number(5 * k) + ";" + QByteArray::number(80.2 * k) + ";0.3;0.01;" +
            QByteArray::number(0.31 + 1.77 * k) + "\n";
  for (const Language language : {Language::english, Language::german}) {
    speak(language);
    Desk desk;
    desk.session.comparison.openRecording(written(folder, text));
    const LogOpening& log = desk.session.comparison.log();
    QVERIFY(QTest::qWaitFor([&log] { return log.isOpen() && !log.settling(); }, patience_ms));
    const auto* table = named<QTableWidget>(desk.window, "logColumns");
    QStringList said{named<QLabel>(desk.window, "logState")->text()};
    for (int row = 0; row < table->rowCount(); ++row) said << table->item(row, 4)->text();
    const QString all = said.join(" | ");
    speak(Language::english);
    QVERIFY2(!all.contains("--map"), qPrintable(all));
    QVERIFY2(all.contains(language == Language::english ? "pole pairs; say it here" : "Polpaar"), qPrintable(all));
  }
}

void TestCompareLogs::benchBesideARecording_isOpenedWithIt() {
  const QTemporaryDir folder;
  const QString example = qEnvironmentVariable("BREAKAWAY_RESOURCES") + "/examples/example";
  const QString recording = folder.filePath("r.csv"), bench = folder.filePath("r.bench.json");
  QVERIFY(QFile::copy(example + ".csv", recording) && QFile::copy(example + ".bench.json", bench));
  {
    Desk desk;
    desk.session.comparison.openRecording(recording);
    QVERIFY(QTest::qWaitFor([&] { return desk.session.comparison.bench().has_value(); }, patience_ms));
    QCOMPARE(desk.session.comparison.bench()->name, std::string("example"));
    QVERIFY(named<QPushButton>(desk.window, "diagnoseButton")->isEnabled());
  }
  // Of two none is meant.
  QVERIFY(QFile::copy(bench, folder.filePath("other.bench.json")));
  Desk desk;
  desk.session.comparison.openRecording(recording);
  QVERIFY(QTest::qWaitFor([&] { return desk.session.comparison.recording().has_value(); }, patience_ms));
  QVERIFY(!desk.session.comparison.bench());
}

void TestCompareLogs::logOfSeveralMotors_isPartedByAClick() {
  const QTemporaryDir folder;
  QByteArray text = "t_ms,motor,angle_deg\n";
  for (int k = 0; k < 50; ++k) {
    for (const char* motor : {"left", "right"})
      text += QByteArray::number(10 * k) + "," + motor + "," + QByteArray::number(*motor == 'l' ? k * k : 7 * k) + "\n";
  }
  Desk desk;
  desk.answers.byTitle["Open a recording"] = written(folder, text);
  press(desk.window, "openRecordingButton");
  LogOpening& log = desk.session.comparison.log();
  const auto settled = [&log] { return log.isOpen() && !log.settling(); };
  QVERIFY(QTest::qWaitFor(settled, patience_ms));
  QVERIFY2(log.fault().find("split") != std::string::npos, log.fault().c_str());
  QVERIFY(!named<QComboBox>(desk.window, "logPart")->isEnabled());
  choose(desk.window, "logSplit", "motor");
  QVERIFY(QTest::qWaitFor([&] { return settled() && log.fault().empty(); }, patience_ms));
  QCOMPARE(log.parts(), QStringList({"left", "right"}));
  choose(desk.window, "logPart", "right");
  QVERIFY(QTest::qWaitFor([&] { return settled() && log.part() == 1; }, patience_ms));
  QCOMPARE(named<QComboBox>(desk.window, "logPart")->currentText(), QString("right"));
  press(desk.window, "logOpenButton");
  const auto& recording = desk.session.comparison.recording();
  QVERIFY(recording.has_value());
  QCOMPARE(recording->rows(), size_t{50});
  QVERIFY(std::abs(recording->channel("angle_rad")[10] - 70.0 * M_PI / 180.0) < 1e-9);
}

void TestCompareLogs::whatNoLogSays_isAskedForAndRemembered() {
  const QTemporaryDir folder;
  QByteArray text = "voltage,angle_deg\n";
  for (int k = 0; k < 50; ++k) text += QByteArray::number(k % 3) + "," + QByteArray::number(k * k) + "\n";
  const QString path = written(folder, text);
  for (const bool again : {false, true}) {
    Desk desk;
    desk.answers.byTitle["Open a recording"] = path;
    press(desk.window, "openRecordingButton");
    LogOpening& log = desk.session.comparison.log();
    const auto settled = [&log] { return log.isOpen() && !log.settling(); };
    QVERIFY(QTest::qWaitFor(settled, patience_ms));
    QCOMPARE(log.fault().find("sample_time_s") != std::string::npos, !again);
    QCOMPARE(named<QWidget>(desk.window, "logOpenButton")->isEnabled(), again);
    auto* apart = named<QLineEdit>(desk.window, "logSampleTime");
    if (!again) {
      QTest::keyClicks(apart, "0.02");
      QTest::keyClick(apart, Qt::Key_Return);
      QVERIFY(QTest::qWaitFor([&] { return settled() && log.fault().empty(); }, patience_ms));
    }
    QCOMPARE(apart->text(), QString("0.02"));
    press(desk.window, "logOpenButton");
    QVERIFY(desk.session.comparison.recording().has_value());
    QVERIFY(std::abs(desk.session.comparison.recording()->time().back() - 0.98) < 1e-12);
  }
  QCOMPARE(QDir(LogOpening::memory()).entryList({"*.map.json"}).size(), 2);
}

JOURNEY_MAIN(TestCompareLogs)
#include "tst_compare_logs.moc"
