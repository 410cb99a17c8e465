// The window's skeleton: STOP is never cut off, nothing moves when a label changes, nothing is cut off at any size, all
// that takes the focus has a name, and the wheel changes nothing by hovering.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <QWheelEvent>

#include "app/desk.h"
#include "app/rendered_tree.h"
#include "app/spoken.h"
#include "app/visible_texts.h"
#include "session/settings_edits.h"
#include "support/temporary.h"
#include "widgets/rail.h"

using namespace breakaway;
using namespace breakaway::test;

class TestSkeleton : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void stop_isWholeFromTheFirstFrame();
  void window_fitsASmallScreen();
  void nothing_turnsAtTheStart();
  void nothing_movesWhenTheStateChanges();
  void nothing_isCutOffOrOverlaps_data();
  void nothing_isCutOffOrOverlaps();
  void tableOfALog_leavesStopInPlace_data();
  void tableOfALog_leavesStopInPlace();
  void focusable_hasNameAndTooltip();
  void tab_goesDownThePage();
  void disabledButton_keepsTheFocusInItsPlace();
  void wheel_changesNothingWithoutFocus();
  void rail_saysHowFarAStepIs();
  void log_keepsEveryLineWithItsTime();
  void german_leavesNothingInEnglish();
  void live_hasRoomForTriggerAndSpectrum_data();
  void live_hasRoomForTriggerAndSpectrum();
};

void TestSkeleton::initTestCase() {
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestSkeleton::stop_isWholeFromTheFirstFrame() {
  Answers answers;
  Session session;
  MainWindow window(session, answers);
  window.resize(1280, 720);
  window.show();
  const auto* stop = named<QPushButton>(window, "stopButton");
  QCOMPARE(stop->size(), QSize(160, 36));
  QVERIFY(window.rect().contains(placeIn(stop, window)));
  const QImage drawn = window.grab(placeIn(stop, window)).toImage();
  int red = 0;
  for (int x = 0; x < drawn.width(); ++x) red += drawn.pixelColor(x, 6) == Look::light().stop ? 1 : 0;
  QVERIFY(red > 150);
}

void TestSkeleton::window_fitsASmallScreen() {
  Desk desk;
  for (const auto& [live, trigger] : {std::pair{false, 0}, std::pair{true, 0}, std::pair{true, 1}}) {
    desk.window.showLive(live);
    named<QComboBox>(desk.window, "triggerMode")->setCurrentIndex(trigger);
    for (const QString& page : pages) {
      desk.window.showPage(page);
      QTest::qWait(1);
      const QSize least = desk.window.minimumSizeHint();
      QVERIFY2(least.width() <= 1280 && least.height() <= 720,
               qPrintable(QString("%1: %2×%3").arg(page).arg(least.width()).arg(least.height())));
    }
  }
}

void TestSkeleton::nothing_turnsAtTheStart() {
  Desk desk;
  QVERIFY(desk.connected());
  QTest::qWait(300);
  QVERIFY(!desk.session.connection.powered());
  QVERIFY(!desk.session.connection.run().running());
}

void TestSkeleton::nothing_movesWhenTheStateChanges() {
  Desk desk(4.0);
  QMap<QString, QMap<QString, QRect>> first;
  const auto look = [&](const char* state) {
    for (const QString& page : pages) {
      desk.window.showPage(page);
      QTest::qWait(1);
      const auto now = places(desk.window);
      if (!first.contains(page)) first[page] = now;
      for (auto one = now.cbegin(); one != now.cend(); ++one) {
        const QRect before = first[page].value(one.key(), one.value());
        if (before != one.value())
          qFatal("%s on %s: %s went from %d,%d to %d,%d (%d×%d to %d×%d)", state, qPrintable(page),
                 qPrintable(one.key()), before.x(), before.y(), one.value().x(), one.value().y(), before.width(),
                 before.height(), one.value().width(), one.value().height());
      }
    }
  };
  look("not connected");
  desk.session.connection.open("simulated:servo");
  look("connected");
  desk.session.bench.turnSlowly();
  QVERIFY(QTest::qWaitFor([&] { return desk.session.connection.run().running(); }, 5000));
  look("turning");
  desk.session.bench.make(RunKind::homing);
  QVERIFY(QTest::qWaitFor([&] { return desk.session.connection.runs(RunKind::homing); }, 5000));
  look("homing");
  desk.session.connection.stop();
  QVERIFY(QTest::qWaitFor([&] { return !desk.session.connection.run().running(); }, 5000));
  look("stopped");
  desk.session.messages.warn("Something failed, and it takes a long sentence to say what it was and where to look");
  look("failed");
  desk.session.connection.close();
  look("disconnected");
}

void TestSkeleton::nothing_isCutOffOrOverlaps_data() {
  QTest::addColumn<QSize>("size");
  QTest::addColumn<bool>("live");
  QTest::addColumn<bool>("parameters");
  QTest::addColumn<bool>("german");
  size_t rows = 0;
  const auto add = [&rows](const QSize& size, const char* shown, bool live, bool parameters, bool german) {
    if (alsoRun(rows++, 7))
      QTest::addRow("%d×%d%s", size.width(), size.height(), shown) << size << live << parameters << german;
  };
  // The last one is 3840 × 2160 at 200 %.
  for (const QSize size : {QSize(1280, 720), QSize(1366, 768), QSize(1920, 1080)}) {
    add(size, "", false, false, false);
    add(size, ", live", true, false, false);
    add(size, ", parameters", false, true, false);
    add(size, ", live, parameters", true, true, false);
    add(size, ", live, parameters, in German", true, true, true);
    add(size, ", in German", false, false, true);
  }
}

void TestSkeleton::nothing_isCutOffOrOverlaps() {
  QFETCH(QSize, size);
  QFETCH(bool, live);
  QFETCH(bool, parameters);
  QFETCH(bool, german);
  const Spoken language(german ? Language::german : Language::english);
  Desk desk;
  desk.window.resize(size);
  desk.window.showLive(live);
  if (parameters) desk.window.showParameters(true);
  for (const char* board : {"", "simulated:servo", "simulated:linear"}) {
    if (*board != 0) desk.session.connection.open(board);
    QVERIFY(desk.session.connection.connected() || *board == 0);
    for (const QString& page : pages) {
      desk.window.showPage(page);
      QTest::qWait(1);
      QVERIFY2(desk.window.size() == size,
               qPrintable(QString("%1 %2: %3×%4").arg(board, page).arg(desk.window.width()).arg(desk.window.height())));
      const QStringList cut = clipped(desk.window), on = overlapping(desk.window);
      QVERIFY2(cut.isEmpty(), qPrintable(board + page + ": " + cut.join("; ")));
      QVERIFY2(on.isEmpty(), qPrintable(board + page + ": " + on.join("; ")));
      QVERIFY(desk.window.rect().contains(placeIn(named<QWidget>(desk.window, "stopButton"), desk.window)));
      desk.window.showPage("connectPage");
    }
  }
}

void TestSkeleton::live_hasRoomForTriggerAndSpectrum_data() {
  QTest::addColumn<QSize>("size");
  QTest::addColumn<bool>("german");
  QTest::addColumn<QString>("board");
  size_t rows = 0;
  for (const QSize size : {QSize(1280, 720), QSize(1366, 768)}) {
    for (const bool german : {false, true}) {
      for (const char* board : {"servo", "linear"})
        if (alsoRun(rows++, 3))
          QTest::addRow("%d×%d, %s, in %s", size.width(), size.height(), board, german ? "German" : "English")
              << size << german << "simulated:" + QString(board);
    }
  }
}

/// Both at once, with the longest of what each can say.
void TestSkeleton::live_hasRoomForTriggerAndSpectrum() {
  QFETCH(QSize, size);
  QFETCH(bool, german);
  QFETCH(QString, board);
  const Spoken language(german ? Language::german : Language::english);
  Desk desk;
  desk.window.resize(size);
  desk.session.connection.open(board);
  desk.window.showPage("handPage");
  desk.window.showLive(true);
  press(desk.window, "spectrumButton");
  press(desk.window, "cursorsButton");
  for (const char* box : {"triggerChannel", "triggerEdge", "spectrumChannel", "spectrumWindow"}) {
    auto* choices = named<QComboBox>(desk.window, box);
    int longest = 0;
    for (int k = 1; k < choices->count(); ++k)
      longest = choices->itemText(k).size() > choices->itemText(longest).size() ? k : longest;
    choices->setCurrentIndex(longest);
  }
  named<QDoubleSpinBox>(desk.window, "triggerLevel")->setValue(-1234.56);
  for (const int mode : {1, 2}) {
    named<QComboBox>(desk.window, "triggerMode")->setCurrentIndex(mode);
    for (const bool large : {false, true}) {
      desk.window.showLiveLarge(large);
      QTest::qWait(50);
      QCOMPARE(desk.window.size(), size);
      for (const char* part : {"triggerChannel", "triggerLevel", "triggerState", "spectrumChannel", "spectrumPlot"})
        QVERIFY2(named<QWidget>(desk.window, part)->isVisible(), part);
      const QStringList cut = clipped(desk.window), on = overlapping(desk.window);
      QVERIFY2(cut.isEmpty(), qPrintable(cut.join("; ")));
      QVERIFY2(on.isEmpty(), qPrintable(on.join("; ")));
    }
  }
}

void TestSkeleton::tableOfALog_leavesStopInPlace_data() {
  QTest::addColumn<bool>("german");
  QTest::newRow("in English") << false;
  QTest::newRow("in German") << true;
}

void TestSkeleton::tableOfALog_leavesStopInPlace() {
  QFETCH(bool, german);
  const TemporaryFolder folder;
  const std::string log = folder.write("log.csv",
                                       "t_ms,motor,a_long_name_of_an_angle_deg,board temp\n0,left,1,31\n"
                                       "10,left,2,31\n20,right,3,31\n30,right,4,31\n");
  const Spoken language(german ? Language::german : Language::english);
  Desk desk;
  desk.window.resize(1280, 720);
  desk.window.showPage("comparePage");
  desk.session.comparison.open(QString::fromStdString(log));
  const LogOpening& opening = desk.session.comparison.log();
  QVERIFY(QTest::qWaitFor([&] { return opening.isOpen() && !opening.settling(); }, 20000));
  QTest::qWait(20);
  QCOMPARE(desk.window.size(), QSize(1280, 720));
  QVERIFY(named<QWidget>(desk.window, "logPanel")->isVisible());
  QVERIFY2(!named<QLabel>(desk.window, "compareReading")->text().isEmpty(), "what is next isn't said");
  for (const char* whole : {"stopButton", "logOpenButton", "logSplit", "logPart", "logGear"})
    QVERIFY2(desk.window.rect().contains(placeIn(named<QWidget>(desk.window, whole), desk.window)), whole);
  // What it is taken as, its values and the reason are seen without scrolling, and the boxes don't touch.
  const auto* table = named<QTableWidget>(desk.window, "logColumns");
  QCOMPARE(table->horizontalScrollBar()->maximum(), 0);
  constexpr int values = 3, reasons = 4;
  const QStringList cut = shortenedIn(*table, reasons) + shortenedIn(*table, values);
  QVERIFY2(
      cut.isEmpty(),
      qPrintable(
          QString("%1 in %2 by %3").arg(cut.join("; ")).arg(table->columnWidth(reasons)).arg(table->rowHeight(3))));
}

void TestSkeleton::focusable_hasNameAndTooltip() {
  Desk desk;
  desk.window.showLive(true);
  desk.window.showParameters(true);
  named<QWidget>(desk.window, "logDrawer")->show();
  QStringList silent;
  for (const QString& page : pages) {
    desk.window.showPage(page);
    for (const QWidget* widget : desk.window.findChildren<QWidget*>()) {
      if (!widget->isVisible() || !(widget->focusPolicy() & Qt::TabFocus)) continue;
      if (widget->objectName().startsWith("qt_") || qobject_cast<const QAbstractSpinBox*>(widget->parentWidget()))
        continue;
      const auto* button = qobject_cast<const QAbstractButton*>(widget);
      const bool spoken = !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
      const QString name = QString("%1 (%2)").arg(widget->objectName(), widget->metaObject()->className());
      if (!spoken) silent << name + " has no name";
      if (widget->toolTip().isEmpty()) silent << name + " has no tooltip";
    }
  }
  silent.removeDuplicates();
  QVERIFY2(silent.isEmpty(), qPrintable(silent.join(", ")));
}

void TestSkeleton::tab_goesDownThePage() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&desk.window));
  for (const QString& page : pages) {
    desk.window.showPage(page);
    auto* content = named<QWidget>(desk.window, page.toLatin1().constData());
    QSet<const QWidget*> reached;
    QWidget* focused = named<QWidget>(desk.window, "steps");
    focused->setFocus();
    for (int k = 0; k < 200; ++k) {
      QTest::keyClick(focused, Qt::Key_Tab);
      focused = QApplication::focusWidget();
      QVERIFY(focused != nullptr);
      if (reached.contains(focused)) break;
      reached << focused;
    }
    for (const QWidget* control : visibleControls(*content)) {
      if (control->isEnabled())
        QVERIFY2(reached.contains(control), qPrintable(page + ": Tab doesn't reach " + control->objectName()));
    }
  }
}

/// Return, pressed once too often, must not start what comes next on the page.
void TestSkeleton::disabledButton_keepsTheFocusInItsPlace() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showPage("tunePage");
  desk.window.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&desk.window));
  auto* apply = named<QPushButton>(desk.window, "applyButton");
  const auto edit = [&desk](double factor) {
    ControllerSettings wanted = desk.session.edits.accepted();
    wanted.velocity_kp_A_s_per_rad *= factor;
    desk.session.edits.edit(wanted);
  };
  edit(0.9);
  apply->setFocus();
  QTest::keyClick(apply, Qt::Key_Return);
  QTRY_VERIFY(!apply->isEnabled());
  auto* contents = named<QWidget>(desk.window, "windowContents");
  QCOMPARE(QApplication::focusWidget(), contents);
  QTest::keyClick(contents, Qt::Key_Return);
  QTest::qWait(20);
  QVERIFY(!desk.session.connection.run().running());
  edit(0.8);
  QCOMPARE(QApplication::focusWidget(), apply);
  edit(1.0);
  QCOMPARE(QApplication::focusWidget(), contents);
  QTest::keyClick(contents, Qt::Key_Tab);
  QWidget* next = QApplication::focusWidget();
  QVERIFY(next != contents && next->isEnabled());
  QTest::keyClick(next, Qt::Key_Tab, Qt::ShiftModifier);
  QVERIFY(QApplication::focusWidget() != next);
  edit(0.7);
  QVERIFY2(QApplication::focusWidget() != apply, "it was left by hand");
}

void TestSkeleton::wheel_changesNothingWithoutFocus() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showPage("tunePage");
  auto* slider = named<QSlider>(desk.window, "kpSlider");
  auto* box = named<QDoubleSpinBox>(desk.window, "kpBox");
  const auto turn = [](QWidget* widget) {
    QWheelEvent event(QPointF(5, 5), widget->mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
  };
  named<QWidget>(desk.window, "steps")->setFocus();
  const int before = slider->value();
  const double value = box->value();
  turn(slider);
  turn(box);
  QCOMPARE(slider->value(), before);
  QCOMPARE(box->value(), value);
  desk.window.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&desk.window));
  slider->setFocus();
  turn(slider);
  QVERIFY(slider->value() != before);
}

void TestSkeleton::rail_saysHowFarAStepIs() {
  Desk desk;
  const auto* rail = named<Rail>(desk.window, "steps");
  const auto words = [rail](int row) { return rail->item(row)->data(Qt::AccessibleDescriptionRole).toString(); };
  QCOMPARE(words(0), QString("no board"));
  QCOMPARE(words(3), QString("needs a board"));
  QVERIFY(desk.connected());
  QVERIFY2(words(0).contains("kHz"), qPrintable(words(0)));
  QCOMPARE(words(1), QString("next"));
  QCOMPARE(words(2), QString());
  QVERIFY(desk.homed());
  QVERIFY2(words(3).startsWith("index ± ") && words(3).endsWith("°"), qPrintable(words(3)));
  QVERIFY2(words(1).contains("passed"), qPrintable(words(1)));
  QCOMPARE(words(2), QString("next"));
}

void TestSkeleton::log_keepsEveryLineWithItsTime() {
  Desk desk;
  const Messages& log = desk.session.messages;
  const size_t before = log.lines().size();
  desk.session.messages.say("first");
  desk.session.messages.warn("second");
  QCOMPARE(log.lines().size(), before + 2);
  QVERIFY(log.unreadTrouble() != nullptr);
  QVERIFY(named<QPushButton>(desk.window, "logButton")->text().contains("new"));
  press(desk.window, "logButton");
  QCOMPARE(log.unread(), size_t{0});
  const auto* table = named<QTableWidget>(desk.window, "logTable");
  QCOMPARE(table->item(0, 1)->text(), QString("second"));
  QVERIFY(QTime::fromString(table->item(0, 0)->text(), "HH:mm:ss").isValid());
  press(desk.window, "logTroubleOnly");
  QCOMPARE(table->rowCount(), 1);
}

/// Every text that can be read on the pages of a window with this board, with its tooltips and names.
static Texts textsIn(Desk& desk, const char* board) {
  Texts texts;
  if (*board != 0) desk.session.connection.open(board);
  desk.window.showLive(true);
  desk.window.showParameters(true);
  for (const QString& page : pages) {
    desk.window.showPage(page);
    QTest::qWait(1);
    for (QWidget* widget : desk.window.findChildren<QWidget*>()) texts += textsOf(*widget);
  }
  return texts;
}

/// What both languages have in common holds no English word.
void TestSkeleton::german_leavesNothingInEnglish() {
  for (const char* board : {"", "simulated:servo", "simulated:linear"}) {
    Texts here, there;
    {
      Desk desk;
      here = textsIn(desk, board);
    }
    {
      const Spoken german(Language::german);
      Desk desk;
      there = textsIn(desk, board);
    }
    QVERIFY(here.size() > 100 && there.size() > 100);
    const QStringList left = englishIn(there, here);
    QVERIFY2(left.isEmpty(), qPrintable(QString(board) + ": " + left.join("\n")));
  }
}

JOURNEY_MAIN(TestSkeleton)
#include "tst_skeleton.moc"
