// A report for somebody: its chapters, what is said below the title, and what always stays.
#include <QTest>

#include "draw/html_chapters.h"
#include "draw/html_report.h"

using namespace breakaway;

class TestHtmlChapters : public QObject {
  Q_OBJECT
 private slots:
  void chapters_areTheHeadingsInOrder();
  void chapterLeftOut_goesWithAllBelowIt();
  void customerAndRemarks_standBelowTheTitle();
  void words_areEscapedAndKeepTheirLines();
  void nothingToChange_leavesTheReportAsItWas();
};

namespace {

std::string report() {
  HtmlReport made("Friction of axis 7", "servo");
  made.verdict("It sticks.");
  made.heading("Friction < 3 mNm & more");
  made.paragraph("the map");
  made.heading("Detail", 3);
  made.paragraph("of the map");
  made.heading("Motor");
  made.paragraph("its constants");
  return made.html();
}

size_t at(const std::string& text, const std::string& part) {
  return text.find(part);
}

}  // namespace

void TestHtmlChapters::chapters_areTheHeadingsInOrder() {
  QCOMPARE(chaptersOf(report()), (std::vector<std::string>{"Friction < 3 mNm & more", "Motor"}));
}

void TestHtmlChapters::chapterLeftOut_goesWithAllBelowIt() {
  const std::string edited = editedReport(report(), {{}, {}, {"Friction < 3 mNm & more"}});
  for (const char* gone : {"the map", "Detail", "of the map"}) QVERIFY2(at(edited, gone) == std::string::npos, gone);
  for (const char* stays : {"It sticks.", "Motor", "its constants", "id=\"made\"", "</html>"})
    QVERIFY2(at(edited, stays) != std::string::npos, stays);
  const std::string last = editedReport(report(), {{}, {}, {"Motor"}});
  QVERIFY(at(last, "its constants") == std::string::npos && at(last, "id=\"made\"") != std::string::npos);
}

void TestHtmlChapters::customerAndRemarks_standBelowTheTitle() {
  const std::string edited = editedReport(report(), {"Example Ltd", "Measured cold.", {}});
  QVERIFY(at(edited, "servo</p>") < at(edited, "Example Ltd"));
  QVERIFY(at(edited, "Example Ltd") < at(edited, "Measured cold.") &&
          at(edited, "Measured cold.") < at(edited, "It sticks."));
}

void TestHtmlChapters::words_areEscapedAndKeepTheirLines() {
  const std::string edited = editedReport(report(), {"A <b> & Co", "one\ntwo", {}});
  QVERIFY(at(edited, "A &lt;b&gt; &amp; Co") != std::string::npos);
  QVERIFY(at(edited, "one<br>\ntwo") != std::string::npos);
}

void TestHtmlChapters::nothingToChange_leavesTheReportAsItWas() {
  const std::string was = report();
  QCOMPARE(editedReport(was, {}), was);
  QCOMPARE(editedReport(was, {{}, {}, {"a chapter that isn't there"}}), was);
}

QTEST_APPLESS_MAIN(TestHtmlChapters)
#include "tst_html_chapters.moc"
