// F1 and "?": the manual on what is under the cursor. Every page has its place, and every place is in the manual.
#include <QAction>
#include <QFile>
#include <QLineEdit>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBrowser>

#include "app/desk.h"
#include "widgets/manual.h"

using namespace breakaway;
using namespace breakaway::test;

class TestHelpInPlace : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void everyTopic_isInTheManual();
  void f1_opensThePageOfWhatHasTheFocus();
  void questionMark_isALetterInAText();
  void links_areFollowedWithinTheManual();
};

void TestHelpInPlace::initTestCase() {
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestHelpInPlace::everyTopic_isInTheManual() {
  Desk desk;
  QSet<QString> topics;
  for (const QWidget* widget : desk.window.findChildren<QWidget*>()) topics << Manual::topicOf(widget);
  QVERIFY(topics.size() >= 10);
  for (const QString& topic : topics) {
    QFile file(qEnvironmentVariable("BREAKAWAY_RESOURCES") + "/help/" + topic.section('#', 0, 0));
    QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(topic));
    const QString anchor = topic.section('#', 1);
    bool found = anchor.isEmpty();
    for (const QString& line : QString::fromUtf8(file.readAll()).split('\n'))
      found = found || (line.startsWith('#') && anchorOf(line.mid(line.indexOf(' ')).remove('`')) == anchor);
    QVERIFY2(found, qPrintable(topic));
  }
}

void TestHelpInPlace::f1_opensThePageOfWhatHasTheFocus() {
  Desk desk;
  desk.window.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&desk.window));
  desk.window.showPage("tunePage");
  QVERIFY(desk.window.findChild<QWidget*>("manual") == nullptr);
  press(desk.window, "helpButton");
  auto* text = named<QTextBrowser>(desk.window, "manualText");
  QVERIFY(text->isVisible());
  QVERIFY(text->toPlainText().startsWith("The window"));
  QCOMPARE(text->textCursor().block().text(), QString("Tune"));
  QVERIFY(text->verticalScrollBar()->value() > 0);
  desk.window.showPage("comparePage");
  named<QAction>(desk.window, "helpAction")->trigger();
  QTRY_VERIFY2(text->toPlainText().startsWith("Diagnosis") || text->toPlainText().startsWith("The window"),
               qPrintable(text->toPlainText().left(40)));
}

void TestHelpInPlace::questionMark_isALetterInAText() {
  Desk desk;
  desk.window.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&desk.window));
  desk.window.showPage("runsPage");
  auto* line = named<QLineEdit>(desk.window, "runsText");
  line->setFocus();
  QTest::keyClicks(line, "why?");
  QCOMPARE(line->text(), QString("why?"));
  QVERIFY(desk.window.findChild<QWidget*>("manual") == nullptr);
  named<QWidget>(desk.window, "steps")->setFocus();
  QTest::keyClick(named<QWidget>(desk.window, "steps"), Qt::Key_F1);
  QTRY_VERIFY(desk.window.findChild<QWidget*>("manual") != nullptr);
}

void TestHelpInPlace::links_areFollowedWithinTheManual() {
  Desk desk;
  press(desk.window, "helpButton");
  auto* text = named<QTextBrowser>(desk.window, "manualText");
  const QString before = text->toPlainText();
  emit text->anchorClicked(QUrl("window.md#runs"));
  QVERIFY(text->toPlainText() != before);
  QCOMPARE(text->textCursor().block().text(), QString("Runs"));
}

JOURNEY_MAIN(TestHelpInPlace)
#include "tst_help_in_place.moc"
