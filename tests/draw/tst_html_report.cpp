#include <QTest>

#include "draw/html_report.h"
#include "support/temporary.h"

using namespace breakaway;

class TestHtmlReport : public QObject {
  Q_OBJECT
 private slots:
  void report_needsNothingElse();
  void texts_areEscaped();
  void numberColumns_areSetToTheRight();
  void numbers_areShort_data();
  void numbers_areShort();
};

static HtmlReport sample() {
  HtmlReport report("Bench <3>", "a & b");
  report.heading("Proof");
  report.paragraph("x < y");
  report.verdict("named");
  report.list({"one & two"});
  report.facts({{"rows", "10"}});
  report.table({"effect", "share"}, {{"stribeck", "0.71"}, {"cogging", "\u22120.1"}}, "Found");
  report.figure({.title = "F", .xLabel = "t / s", .yLabel = "y", .curves = {{.label = "c", .x = {0, 1}, .y = {0, 1}}}},
                "What it shows");
  report.details("How", {"so"});
  return report;
}

void TestHtmlReport::report_needsNothingElse() {
  const test::TemporaryFolder folder;
  VERIFY_OK(sample().write(folder.path("report.html")));
  const std::string html = *readFile(folder.path("report.html"));
  QVERIFY(html.starts_with("<!DOCTYPE html>") && html.ends_with("</html>\n"));
  for (const char* outside : {"src=", "href=", "url(", "@import", "<script", "http://", "https://"}) {
    std::string rest = html;
    const std::string nameSpace = "http://www.w3.org/2000/svg";
    if (const size_t at = rest.find(nameSpace); at != std::string::npos) rest.erase(at, nameSpace.size());
    QVERIFY2(rest.find(outside) == std::string::npos, outside);
  }
  QVERIFY(html.find("prefers-color-scheme") != std::string::npos && html.find("@media print") != std::string::npos);
  QVERIFY(html.find("<svg") != std::string::npos && html.find("What it shows") != std::string::npos);
}

void TestHtmlReport::texts_areEscaped() {
  const std::string html = sample().html();
  QVERIFY(html.find("<title>Bench &lt;3&gt;</title>") != std::string::npos);
  QVERIFY(html.find("<p>x &lt; y</p>") != std::string::npos);
  QVERIFY(html.find("<li>one &amp; two</li>") != std::string::npos);
}

void TestHtmlReport::numberColumns_areSetToTheRight() {
  const std::string html = sample().html();
  QVERIFY(html.find("<td>stribeck</td><td class=\"number\">0.71</td>") != std::string::npos);
}

void TestHtmlReport::numbers_areShort_data() {
  QTest::addColumn<double>("value");
  QTest::addColumn<QString>("text");
  QTest::newRow("0") << 0.0 << "0";
  QTest::newRow("4 digits") << 0.0123456 << "0.01235";
  QTest::newRow("whole") << 95.1089 << "95.11";
  QTest::newRow("thousands") << 24841.0 << "24\u202f841";
  QTest::newRow("a whole number of thousands") << -2000.0 << "\u22122000";
  QTest::newRow("small") << -3.1e-5 << "\u22123.1·10⁻⁵";
  QTest::newRow("small, whole") << 2e-6 << "2·10⁻⁶";
  QTest::newRow("large") << 1.25e7 << "1.25·10⁷";
}

void TestHtmlReport::numbers_areShort() {
  QFETCH(double, value);
  QFETCH(QString, text);
  QCOMPARE(QString::fromStdString(numberText(value)), text);
}

QTEST_APPLESS_MAIN(TestHtmlReport)
#include "tst_html_report.moc"
