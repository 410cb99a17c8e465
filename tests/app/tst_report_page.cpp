// The report: seen before it is written, with a customer's name, remarks and the chapters that are wanted, as HTML and
// as PDF.
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextBrowser>

#include "app/desk.h"
#include "app/rendered_tree.h"
#include "base/atomic_file.h"

using namespace breakaway;
using namespace breakaway::test;

class TestReportPage : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void nothingMeasured_saysHowToComeToAReport();
  void report_isSeenAsItIsWritten();
};

void TestReportPage::initTestCase() {
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestReportPage::nothingMeasured_saysHowToComeToAReport() {
  Desk desk;
  desk.window.showPage("reportPage");
  auto* preview = named<QTextBrowser>(desk.window, "reportPreview");
  QTRY_VERIFY(preview->toPlainText().startsWith("Nothing was measured yet"));
  QVERIFY(!named<QPushButton>(desk.window, "writePaperButton")->isEnabled());
  press(desk.window, "reportOfComparison");
  QTRY_VERIFY(preview->toPlainText().startsWith("Nothing was diagnosed yet"));
}

void TestReportPage::report_isSeenAsItIsWritten() {
  const QTemporaryDir folder;
  Desk desk;
  QVERIFY(desk.connected());
  QVERIFY(desk.homed());
  QVERIFY(desk.session.bench.known().knows(Known::motor));
  desk.window.showPage("reportPage");
  auto* preview = named<QTextBrowser>(desk.window, "reportPreview");
  QTRY_VERIFY(preview->toPlainText().startsWith("Friction of"));
  auto* customer = named<QLineEdit>(desk.window, "reportCustomer");
  customer->setFocus();
  QTest::keyClicks(customer, "Example Ltd, line 4");
  auto* remarks = named<QPlainTextEdit>(desk.window, "reportRemarks");
  remarks->setPlainText("Measured cold.");
  QTRY_VERIFY(preview->toPlainText().contains("Example Ltd, line 4"));
  QVERIFY(preview->toPlainText().contains("Measured cold."));
  auto* chapters = named<QListWidget>(desk.window, "reportChapters");
  QVERIFY(chapters->count() >= 2);
  const QString left = "How it was measured";
  const auto found = chapters->findItems(left, Qt::MatchExactly);
  QCOMPARE(found.size(), 1);
  QVERIFY(preview->toPlainText().contains(left));
  found.front()->setCheckState(Qt::Unchecked);
  QTRY_VERIFY(!preview->toPlainText().contains(left));
  QVERIFY(preview->toPlainText().contains("Made "));
  const QString html = folder.filePath("r.html"), pdf = folder.filePath("r.pdf");
  desk.answers.byTitle["Write the friction report"] = html;
  desk.answers.byTitle["Write the report as PDF"] = pdf;
  press(desk.window, "writeFrictionReportButton");
  QTRY_VERIFY(QFile::exists(html));
  const auto written = readFile(html.toStdString());
  QVERIFY(written->find("Example Ltd, line 4") != std::string::npos);
  QVERIFY(written->find(left.toStdString()) == std::string::npos);
  press(desk.window, "writePaperButton");
  QTRY_VERIFY(QFile::exists(pdf));
  const auto paper = readFile(pdf.toStdString());
  QVERIFY(paper->starts_with("%PDF-") && paper->size() > 5000);
  // A report is for people: in their language, whatever the window's is.
  remarks->clear();
  auto* language = named<QComboBox>(desk.window, "reportLanguage");
  language->setCurrentIndex(language->findData("de"));
  QTRY_VERIFY(preview->toPlainText().startsWith("Reibung von"));
  // What was left out is left out in the other language.
  const auto same = chapters->findItems("Wie gemessen wurde", Qt::MatchExactly);
  QVERIFY(same.size() == 1 && same.front()->checkState() == Qt::Unchecked);
  QTRY_VERIFY_WITH_TIMEOUT(!preview->toPlainText().contains("Wie gemessen wurde"), patience_ms);
  same.front()->setCheckState(Qt::Checked);
  QTRY_VERIFY(preview->toPlainText().contains("Wie gemessen wurde"));
  const QString german = preview->toPlainText().section("Made ", 0, 0);
  QVERIFY2(german.contains("Drehmomentkonstante") && german.contains("Wie gemessen wurde"), qPrintable(german));
  QCOMPARE(chapters->item(0)->text(), QString("Reibung, Motor und Encoder"));
  static const QRegularExpression english("\\b(the|of|and|is|to|from|with|by|each|way|clockwise|inductance)\\b");
  const auto left_over = english.match(german);
  QVERIFY2(!left_over.hasMatch(), qPrintable(german.mid(std::max(0, int(left_over.capturedStart()) - 40), 80)));
  QFile::remove(html);
  press(desk.window, "writeFrictionReportButton");
  QTRY_VERIFY(QFile::exists(html));
  const auto inGerman = readFile(html.toStdString());
  QVERIFY(inGerman->find("<html lang=\"de\">") != std::string::npos);
  QVERIFY(inGerman->find("<h2>Der Motor</h2>") != std::string::npos);
  for (const QSize size : {QSize(1280, 720), QSize(1366, 768)}) {
    desk.window.resize(size);
    QTest::qWait(20);
    const QStringList cut = clipped(desk.window), on = overlapping(desk.window);
    QVERIFY2(cut.isEmpty() && on.isEmpty(), qPrintable((cut + on).join("; ")));
    if (qEnvironmentVariableIsSet("BREAKAWAY_LOOK"))
      desk.window.grab().save(QString("/tmp/report-%1.png").arg(size.width()));
  }
}

JOURNEY_MAIN(TestReportPage)
#include "tst_report_page.moc"
