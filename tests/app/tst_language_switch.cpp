// A language chosen in the window is spoken at once: all texts are as in a window that was started in it, and nothing
// else is otherwise than before.
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <algorithm>

#include "app/desk.h"
#include "app/rendered_tree.h"
#include "app/visible_texts.h"
#include "session/language.h"
#include "support/temporary.h"
#include "widgets/fields.h"
#include "widgets/live_plots.h"

using namespace breakaway;
using namespace breakaway::test;

class TestLanguageSwitch : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void cleanup();
  void german_isSpokenAtOnceAndNothingIsLost();
  void edits_stay();
  void findings_haveTheirRoom();
  void results_areShownInTheOtherLanguage();
  void openLog_isUnderstoodInTheOtherLanguage();
  void everyField_staysAsItWas();
  void turningMotor_isLeftAlone();
  void openQuestion_isWaitedFor();
  void openCell_isWaitedFor();
  void pausedPicture_stays();
  void effects_areNamedInWords();
};

namespace {

/// Chooses in the menu.
void choose(MainWindow& window, const QString& name) {
  for (QAction* action : named<QPushButton>(window, "themeButton")->menu()->actions()) {
    if (action->text() == name) return action->trigger();
  }
  qFatal("no language %s", qPrintable(name));
}

/// The report's preview is made beside the window.
bool previewed(MainWindow& window) {
  window.showPage("reportPage");
  return QTest::qWaitFor([&] { return named<QListWidget>(window, "reportChapters")->count() > 0; }, patience_ms);
}

bool spoken(Language language) {
  return QTest::qWaitFor([&] { return spokenLanguage() == language; }, patience_ms);
}

}  // namespace

void TestLanguageSwitch::initTestCase() {
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestLanguageSwitch::cleanup() {
  speak(Language::english);
  keepLanguage(Language::english);
}

void TestLanguageSwitch::german_isSpokenAtOnceAndNothingIsLost() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showLive(true);
  desk.window.showParameters(true);
  const PageTexts english = textsByPage(desk.window);
  desk.window.showPage("tunePage");
  QTest::qWait(100);
  const uint64_t samples = desk.session.live.history().end();
  const ControllerSettings settings = desk.session.connection.settings();
  const size_t said = desk.session.messages.lines().size();

  choose(desk.window, "Deutsch");
  QVERIFY(spoken(Language::german));
  QCOMPARE(keptLanguage(), Language::german);
  QCOMPARE(shownPage(desk.window), QString("tunePage"));
  QVERIFY(desk.session.connection.connected() && !desk.session.connection.powered());
  QVERIFY(desk.session.connection.settings() == settings);
  QCOMPARE(desk.session.messages.lines().size(), said);
  QVERIFY(QTest::qWaitFor([&] { return desk.session.live.history().end() > samples; }, patience_ms));
  QVERIFY(named<QWidget>(desk.window, "livePlots")->isVisible());
  QVERIFY(named<QWidget>(desk.window, "parametersDock")->isVisible());

  // As in a window that was begun in German.
  const PageTexts german = textsByPage(desk.window);
  {
    Desk other;
    QVERIFY(other.connected());
    other.window.showLive(true);
    other.window.showParameters(true);
    compareTexts(german, textsByPage(other.window));
  }
  QVERIFY(german != english);
  QVERIFY(named<QPushButton>(desk.window, "connectButton")->text() == "Neu verbinden");
  QVERIFY(desk.session.connection.connected());

  choose(desk.window, "English");
  QVERIFY(spoken(Language::english));
  compareTexts(textsByPage(desk.window), english);
  press(desk.window, "stopButton");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.messages.lines().back().text.startsWith("STOP"); }, patience_ms));
}

/// What was found is said in more words than anything else, and in German in more still.
void TestLanguageSwitch::findings_haveTheirRoom() {
  if (sanitized) QSKIP("a diagnosis takes minutes under sanitizers; it is tested by the journey of Compare");
  Desk desk;
  desk.window.resize(1280, 720);
  desk.window.showPage("comparePage");
  press(desk.window, "openExampleButton");
  const auto* diagnose = named<QPushButton>(desk.window, "diagnoseButton");
  QVERIFY(QTest::qWaitFor([&] { return diagnose->isEnabled(); }, patience_ms));
  press(desk.window, "diagnoseButton");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.comparison.diagnosis().has_value(); }, patience_ms));
  for (const char* language : {"Deutsch", "English"}) {
    choose(desk.window, language);
    QVERIFY(spoken(QString(language) == "Deutsch" ? Language::german : Language::english));
    QTest::qWait(100);
    const QStringList cut = clipped(desk.window);
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join("; ")));
  }
}

/// And what was typed, ticked and chosen for it.
void TestLanguageSwitch::edits_stay() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showParameters(true);
  auto* table = named<QTableWidget>(desk.window, "parametersTable");
  table->item(1, 3)->setText("0.5");
  table->item(9, 3)->setText("2.5");
  table->item(9, 0)->setCheckState(Qt::Unchecked);
  table->setCurrentCell(9, 3);
  QCOMPARE(desk.session.edits.count(), size_t{2});
  const ControllerSettings edited = desk.session.edits.edited(), accepted = desk.session.connection.settings();
  choose(desk.window, "Deutsch");
  QVERIFY(spoken(Language::german));
  QVERIFY(desk.session.edits.edited() == edited);
  QVERIFY(desk.session.connection.settings() == accepted);  // nothing was sent
  table = named<QTableWidget>(desk.window, "parametersTable");
  QCOMPARE(table->item(1, 3)->text(), QString("0.5"));
  QCOMPARE(table->item(9, 0)->checkState(), Qt::Unchecked);
  QCOMPARE(table->currentRow(), 9);
  desk.session.edits.undo();
  QCOMPARE(desk.session.edits.count(), size_t{1});
}

/// A bench job's results, and what the pages say of it.
void TestLanguageSwitch::results_areShownInTheOtherLanguage() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.quickSpeeds();
  desk.sweep(36, 1);
  QVERIFY(desk.mapComes());
  QVERIFY(QTest::qWaitFor([&] { return !desk.session.connection.run().running(); }, patience_ms));
  press(desk.window, "viewStatic");
  QVERIFY(previewed(desk.window));
  named<QListWidget>(desk.window, "reportChapters")->item(0)->setCheckState(Qt::Unchecked);
  const PageTexts english = textsByPage(desk.window);
  desk.window.showPage("frictionPage");

  choose(desk.window, "Deutsch");
  QVERIFY(spoken(Language::german));
  QCOMPARE(shownPage(desk.window), QString("frictionPage"));
  QVERIFY(named<QPushButton>(desk.window, "viewStatic")->isChecked());
  QVERIFY(desk.session.bench.known().knows(Known::map));
  QCOMPARE(named<QSpinBox>(desk.window, "bins")->value(), 36);
  const QStringList left = englishIn(textsByPage(desk.window), english);
  QVERIFY2(left.isEmpty(), qPrintable(left.join("\n")));
  choose(desk.window, "English");
  QVERIFY(spoken(Language::english));
  QVERIFY(previewed(desk.window));
  QCOMPARE(named<QListWidget>(desk.window, "reportChapters")->item(0)->checkState(), Qt::Unchecked);
  compareTexts(textsByPage(desk.window), english);
  const TemporaryFolder folder;
  desk.window.showPage("frictionPage");
  QVERIFY(desk.exported("csv", QString::fromStdString(folder.path("map.csv"))));
}

/// What is understood of another tool's log, what was found in it, and what is wrong with it.
void TestLanguageSwitch::openLog_isUnderstoodInTheOtherLanguage() {
  const TemporaryFolder folder;
  std::string text = "t;Winkel [deg];omega;Winkel 2 [deg];foo\n";
  for (int k = 0; k < 50; ++k)
    text += std::to_string(10 * k) + ";" + std::to_string(k * k) + ";" + std::to_string(200 * k) + ";1;2\n";
  Desk desk;
  desk.window.showPage("comparePage");
  LogOpening& log = desk.session.comparison.log();
  desk.session.comparison.open(QString::fromStdString(folder.write("log.csv", text)));
  const auto settled = [&log] { return log.isOpen() && !log.settling(); };
  QVERIFY(QTest::qWaitFor(settled, patience_ms));
  const auto why = [&desk](int row) { return named<QTableWidget>(desk.window, "logColumns")->item(row, 4)->text(); };
  const auto state = [&desk] { return named<QLabel>(desk.window, "logState")->text(); };
  QCOMPARE(why(1), QString("by its name"));
  QCOMPARE(why(2), QString("a guess: so it agrees with the angle"));
  QCOMPARE(why(4), QString("its name says nothing that is known"));
  QCOMPARE(state(), QString("the time has no unit; steps of 10 were taken for ms"));

  choose(desk.window, "Deutsch");
  QVERIFY(spoken(Language::german));
  QVERIFY(settled());
  QCOMPARE(why(1), QString("nach ihrem Namen"));
  QCOMPARE(why(2), QString("geraten: so stimmt sie mit dem Winkel überein"));
  QCOMPARE(why(4), QString("ihr Name sagt nichts Bekanntes"));
  QCOMPARE(state(), QString("die Zeit hat keine Einheit; Schritte von 10 wurden als ms genommen"));
  log.take("t", {}, {});
  QVERIFY(QTest::qWaitFor([&] { return settled() && !log.fault().empty(); }, patience_ms));
  QVERIFY2(state().contains("keine Spalte war als Zeit zu verstehen"), qPrintable(state()));
  desk.session.comparison.open(QString::fromStdString(folder.write("log.xls", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1")));
  const auto refused = [&] {
    const auto& lines = desk.session.messages.lines();
    return std::any_of(lines.begin(), lines.end(),
                       [](const auto& line) { return line.text.contains("ist eine Office-Datei"); });
  };
  QVERIFY(QTest::qWaitFor(refused, patience_ms));
}

/// Each one that can be changed is changed, also where pages hold more than their fields.
void TestLanguageSwitch::everyField_staysAsItWas() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showLive(true);
  named<QLineEdit>(desk.window, "reportCustomer")->setText("Kunde & Co.");
  named<QPlainTextEdit>(desk.window, "reportRemarks")->setPlainText("one\ntwo");
  named<QLineEdit>(desk.window, "addressEdit")->setText("tcp:10.0.0.1:2000");
  named<QComboBox>(desk.window, "residualAxis")->setCurrentIndex(2);
  named<QSpinBox>(desk.window, "turns")->setValue(3);
  named<QDoubleSpinBox>(desk.window, "stepHeight")->setValue(12.0);
  desk.window.showPage("handPage");
  press(desk.window, "handVoltage");
  named<QDoubleSpinBox>(desk.window, "handTarget")->setValue(2.5);
  press(desk.window, "handCurrent");
  named<QDoubleSpinBox>(desk.window, "handTarget")->setValue(0.4);
  named<QComboBox>(desk.window, "spanBox")->setCurrentIndex(1);
  named<QComboBox>(desk.window, "triggerMode")->setCurrentIndex(1);
  named<QComboBox>(desk.window, "triggerChannel")->setCurrentIndex(2);
  press(desk.window, "spectrumButton");
  press(desk.window, "cursorsButton");
  named<QComboBox>(desk.window, "spectrumWindow")->setCurrentIndex(2);
  press(desk.window, "logButton");
  press(desk.window, "logTroubleOnly");
  desk.session.messages.warn("what failed");
  Fields before = fieldsIn(desk.window);
  choose(desk.window, "Deutsch");
  QVERIFY(spoken(Language::german));
  Fields after = fieldsIn(desk.window);
  for (const char* moves : {"livePlots"}) {
    before.remove(moves);
    after.remove(moves);
  }
  QCOMPARE(after.keys(), before.keys());
  for (auto field = before.cbegin(); field != before.cend(); ++field) {
    if (field.value().metaType().isEqualityComparable())
      QVERIFY2(after[field.key()] == field.value(), qPrintable(field.key()));
  }
  QCOMPARE(shownPage(desk.window), QString("handPage"));
  QCOMPARE(named<QTableWidget>(desk.window, "logTable")->item(0, 1)->text(), QString("what failed"));
  press(desk.window, "handVoltage");
  QCOMPARE(named<QDoubleSpinBox>(desk.window, "handTarget")->value(), 2.5);
}

void TestLanguageSwitch::turningMotor_isLeftAlone() {
  Desk desk(unhurried);
  QVERIFY(desk.connected());
  press(desk.window, "turnButton");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.connection.run().running(); }, patience_ms));
  choose(desk.window, "Deutsch");
  const auto& lines = desk.session.messages.lines();
  QVERIFY(QTest::qWaitFor([&] { return lines.back().text.contains("once the motor stands"); }, patience_ms));
  const size_t said = lines.size();
  QTest::qWait(300);
  QCOMPARE(lines.size(), said);  // once
  QCOMPARE(spokenLanguage(), Language::english);
  QVERIFY(desk.session.connection.run().running() && desk.session.connection.powered());
  press(desk.window, "stopButton");
  QVERIFY(spoken(Language::german));
  QVERIFY(!desk.session.connection.powered());
  QCOMPARE(named<QPushButton>(desk.window, "connectButton")->text(), QString("Neu verbinden"));
}

void TestLanguageSwitch::openQuestion_isWaitedFor() {
  Desk desk;
  auto* question = new QDialog(named<QWidget>(desk.window, "connectPage"));
  question->show();
  choose(desk.window, "Deutsch");
  const auto& lines = desk.session.messages.lines();
  QVERIFY(QTest::qWaitFor([&] { return !lines.empty() && lines.back().text.contains("question"); }, patience_ms));
  QCOMPARE(spokenLanguage(), Language::english);
  question->close();
  QVERIFY(spoken(Language::german));
}

void TestLanguageSwitch::openCell_isWaitedFor() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showParameters(true);
  auto* table = named<QTableWidget>(desk.window, "parametersTable");
  desk.window.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&desk.window));
  table->setFocus();
  table->setCurrentCell(1, 3);
  table->editItem(table->item(1, 3));
  QTRY_VERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()) != nullptr);
  QTest::keyClicks(QApplication::focusWidget(), "0.5");
  choose(desk.window, "Deutsch");
  QTest::qWait(200);
  QCOMPARE(spokenLanguage(), Language::english);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  QVERIFY(spoken(Language::german));
  QCOMPARE(desk.session.edits.count(), size_t{1});
}

void TestLanguageSwitch::effects_areNamedInWords() {
  speak(Language::english);
  QCOMPARE(inLanguage(Message("This recording could not show rising_stiction, backlash.")),
           QString("This recording could not show rising stiction, backlash."));
  QCOMPARE(inLanguage(Message("there is no column angle_rad")), QString("there is no column angle_rad"));
}

void TestLanguageSwitch::pausedPicture_stays() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showPage("handPage");
  desk.window.showLive(true);
  QTest::qWait(300);
  press(desk.window, "pauseButton");
  press(desk.window, "cursorsButton");
  const auto* before = named<LivePlots>(desk.window, "livePlots");
  const double from_s = before->from_s(), to_s = before->to_s();
  const QString cursors = named<QLabel>(desk.window, "cursorDifference")->text();
  QVERIFY(!cursors.isEmpty());
  choose(desk.window, "Deutsch");
  QVERIFY(spoken(Language::german));
  QTest::qWait(100);
  const auto* after = named<LivePlots>(desk.window, "livePlots");
  QVERIFY(after->paused());
  QCOMPARE(after->from_s(), from_s);
  QCOMPARE(after->to_s(), to_s);
  QCOMPARE(named<QLabel>(desk.window, "cursorDifference")->text(), cursors);
}

JOURNEY_MAIN(TestLanguageSwitch)
#include "tst_language_switch.moc"
