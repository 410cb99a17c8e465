#include <QFile>
#include <QStandardPaths>
#include <QTest>

#include "base/numbers.h"
#include "fleet/fleet_lines.h"
#include "friction/map_export.h"
#include "house/program.h"
#include "support/temporary.h"

using namespace breakaway::test;

/// `breakaway summary` with the real program, and its page in a real browser.
class TestSummary : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void form_followsTheName();
  void reports_leadFromThePage();
  void whatStandsOutAndErrors_leadToTheirReports();
  void severalResults_areOneFleet();
  void resultThatStandsThereTwice_countsOnce();
  void maps_areReadFromTheResultsFolder();
  void cutLastLine_isSaid();
  void wrongInput_leavesNothing_data();
  void wrongInput_leavesNothing();
  void answer_namesWhatStandsOut();
  void browser_sortsFiltersAndLinks();

 private:
  Outcome summary(const QString& words) const {
    return run(builtProgram("breakaway"), QString("summary " + words).split(' '),
               QString::fromStdString(folder_->path()));
  }
  QString content(const std::string& name) const {
    const auto text = breakaway::readFile(folder_->path(name));
    return text ? QString::fromStdString(*text) : QString();
  }
  std::unique_ptr<TemporaryFolder> folder_;
};

void TestSummary::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  folder_->write("r.jsonl", fleetWithOne(0.04, 1e-4));
}

void TestSummary::form_followsTheName() {
  const Outcome csv = summary("r.jsonl --out f.csv");
  QVERIFY2(csv.status == 0 && csv.err.isEmpty(), qPrintable(csv.err));
  QCOMPARE(csv.out.split('\n').at(1), QString("f.csv: 21 entries, 1 stand out, 0 ended in an error"));
  QCOMPARE(content("f.csv").count('\n'), 22);
  QCOMPARE(summary("r.jsonl --out f.html").status, 0);
  QVERIFY(content("f.html").startsWith("<!DOCTYPE html>"));
  QCOMPARE(summary("r.jsonl --out f --as html").status, 0);
  QVERIFY(content("f").startsWith("<!DOCTYPE html>"));
  const Outcome piped = summary("r.jsonl --out -");
  QCOMPARE(piped.out, content("f.csv"));
}

void TestSummary::reports_leadFromThePage() {
  QVERIFY(breakaway::makeFolder(folder_->path("results")));
  QVERIFY(breakaway::makeFolder(folder_->path("pages/new")));
  QJsonObject result = resultOf("a", diagnosisOf(0.02, 1e-3));
  result["report"] = "reports/a b/report.html";
  folder_->write("results/r.jsonl", lineOf(result));
  QCOMPARE(summary("results/r.jsonl --out pages/new/f.html").status, 0);
  QVERIFY(content("pages/new/f.html").contains("<a href=\"../../results/reports/a%20b/report.html\">a</a>"));
  QCOMPARE(summary("results/r.jsonl --out results/f.html").status, 0);
  QVERIFY(content("results/f.html").contains("<a href=\"reports/a%20b/report.html\">a</a>"));
}

void TestSummary::whatStandsOutAndErrors_leadToTheirReports() {
  QJsonObject odd = resultOf("far off", diagnosisOf(0.05, 1e-4));
  odd["report"] = "reports/far off/report.html";
  const QJsonObject failed{{"id", "failed"}, {"error", "no bench"}, {"report", "reports/failed.html"}};
  folder_->write("r.jsonl", fleetWithOne(0.02, 1e-4) + lineOf(odd) + lineOf(failed));
  QCOMPARE(summary("r.jsonl --out f.html").status, 0);
  const QString page = content("f.html");
  const QString stands = page.section("What stands out</h2>", 1).section("<h2", 0, 0);
  QVERIFY2(stands.contains("<td><a href=\"reports/far%20off/report.html\">far off</a></td>"), qPrintable(stands));
  const QString errors = page.section("What ended in an error</h2>", 1);
  QVERIFY2(errors.contains("<td><a href=\"reports/failed.html\">failed</a></td>"), qPrintable(errors));
}

void TestSummary::severalResults_areOneFleet() {
  folder_->write("s.jsonl", lineOf(resultOf("last", diagnosisOf(0.02, 1e-3))));
  QCOMPARE(summary("r.jsonl s.jsonl --out f.csv").status, 0);
  QCOMPARE(content("f.csv").count('\n'), 23);
  QVERIFY(content("f.csv").contains("\nlast,"));
}

void TestSummary::resultThatStandsThereTwice_countsOnce() {
  const auto of = [](const char* run) {
    QJsonObject diagnosis = diagnosisOf(0.02, 1e-3);
    diagnosis["made"] = QJsonObject{{"at", "2026-03-02T09:14:07Z"}, {"run", run}};
    return lineOf(resultOf("a", diagnosis));
  };
  folder_->write("s.jsonl", of("one"));
  folder_->write("t.jsonl", of("one") + of("two"));
  const Outcome outcome = summary("s.jsonl t.jsonl --out f.csv");
  QVERIFY2(outcome.status == 0, qPrintable(outcome.err));
  QCOMPARE(content("f.csv").count("\na,"), 2);
  QVERIFY2(
      outcome.out.startsWith("Results that stand there more than once, and count once: 1\nIds with several results"),
      qPrintable(outcome.out));
  QVERIFY(!summary("s.jsonl --out f.csv").out.contains("more than once"));
}

void TestSummary::maps_areReadFromTheResultsFolder() {
  QVERIFY(breakaway::makeFolder(folder_->path("there/maps")));
  breakaway::FrictionMap map;
  map.bins.resize(12);
  for (size_t k = 0; k < 12; ++k) {
    map.bins[k].angle_rad = breakaway::turn_rad * (static_cast<double>(k) + 0.5) / 12.0;
    for (auto& way : map.bins[k].way) way.static_Nm.value = 0.0125;
  }
  VERIFY_OK(breakaway::exportMap(map, "json", folder_->path("there/maps/a.json")));
  QJsonObject with = resultOf("a", diagnosisOf(0.02, 1e-3)), gone = with;
  with["map"] = "maps/a.json";
  gone["map"] = "maps/b.json";
  folder_->write("there/r.jsonl", lineOf(with) + lineOf(resultOf("none", diagnosisOf(0.02, 1e-3))));
  const Outcome outcome = summary("there/r.jsonl --maps map --out f.csv");
  QVERIFY2(outcome.status == 0, qPrintable(outcome.err));
  const QStringList lines = content("f.csv").split('\n');
  const auto at = lines[0].split(',').indexOf("map_static_friction_Nm");
  QVERIFY(at > 0);
  QVERIFY(std::abs(lines[1].split(',')[at].toDouble() - 0.0125) < 1e-12 && lines[2].split(',')[at].isEmpty());
  folder_->write("there/r.jsonl", lineOf(gone));
  const Outcome lost = summary("there/r.jsonl --maps map --out g.csv");
  QVERIFY2(
      lost.status == 2 && lost.err.startsWith("breakaway: there/r.jsonl, entry a: there/maps/b.json: cannot be read"),
      qPrintable(lost.err));
}

void TestSummary::cutLastLine_isSaid() {
  folder_->write("r.jsonl", fleetWithOne(0.04, 1e-4) + "{\"id\": \"half");
  const Outcome outcome = summary("r.jsonl --out f.csv");
  QCOMPARE(outcome.status, 0);
  QVERIFY2(outcome.out.startsWith("r.jsonl: its last line has no end"), qPrintable(outcome.out));
  QCOMPARE(content("f.csv").count('\n'), 22);
}

void TestSummary::wrongInput_leavesNothing_data() {
  QTest::addColumn<QString>("words");
  QTest::addColumn<QString>("line");
  QTest::newRow("no file") << "none.jsonl --out f.csv"
                           << "none.jsonl: cannot be read";
  QTest::newRow("no form") << "r.jsonl --out f.pdf"
                           << "f.pdf: expected a name that ends in .html or .csv";
  QTest::newRow("a list in place of results") << "list.jsonl --out f.html"
                                              << "list.jsonl, line 1: is no result";
  QTest::newRow("onto its input") << "r.jsonl --as csv --out r.jsonl"
                                  << "r.jsonl: is an input as well";
}

void TestSummary::wrongInput_leavesNothing() {
  QFETCH(QString, words);
  QFETCH(QString, line);
  folder_->write("list.jsonl", "{\"id\": 1, \"bench\": \"b.json\", \"recordings\": [\"r.csv\"]}\n");
  const QStringList before = folder_->names();
  const Outcome outcome = summary(words);
  QCOMPARE(outcome.status, 2);
  QVERIFY2(outcome.err.startsWith("breakaway: " + line) && outcome.err.count('\n') == 1, qPrintable(outcome.err));
  QCOMPARE(folder_->names(), before);
}

void TestSummary::answer_namesWhatStandsOut() {
  const Outcome outcome = summary("r.jsonl --out f.html --json");
  const QJsonObject answer = QJsonDocument::fromJson(outcome.out.toUtf8()).object();
  QCOMPARE(answer["entries"].toInt(), 21);
  QCOMPARE(answer["verdicts"].toObject()["nothing_missing"].toInt(), 21);
  const QJsonArray apart = answer["stand_out"].toArray();
  QCOMPARE(apart.size(), 1);
  QCOMPARE(apart.at(0).toObject()["id"].toString(), QString("odd"));
  QVERIFY(apart.at(0).toObject()["deviations"].toDouble() > 3.5);
}

/// What a visitor does, one thing after the other; what is seen then goes into an element that is found in the page.
static const char* const visit = R"js(<script>
addEventListener('load', () => {
  const seen = {}, one = name => document.querySelector(name);
  const ids = () => [...document.querySelectorAll('.fleet tbody tr:not(.room)')].map(row => row.cells[0].textContent);
  const head = name => [...document.querySelectorAll('.fleet thead th button')].find(each => each.textContent === name);
  const set = (name, value) => { one(name).value = value; one(name).dispatchEvent(new Event('input')); };
  seen.loaded_ms = performance.now();
  seen.first = ids()[0];
  seen.count = one('#fleet-count').textContent;
  seen.drawn = ids().length;
  head('coulomb_Nm').click();
  seen.largest = ids()[0];
  head('coulomb_Nm').click();
  seen.smallest = ids()[0];
  set('#fleet-search', 'AXIS 77 ');
  seen.found = one('#fleet-count').textContent;
  set('#fleet-search', '');
  set('#fleet-verdict', 'error');
  seen.errors = ids();
  set('#fleet-verdict', '');
  one('#fleet-apart').click();
  seen.apart = ids();
  seen.report = one('.fleet tbody a').getAttribute('href');
  one('#fleet-apart').click();
  const box = one('.fleet');
  box.scrollTop = box.scrollHeight;
  setTimeout(() => {
    seen.last = ids().at(-1);
    const mark = document.createElement('pre');
    mark.id = 'seen';
    mark.textContent = JSON.stringify(seen);
    document.body.append(mark);
  }, 200);
});
</script>)js";

void TestSummary::browser_sortsFiltersAndLinks() {
  const QString browser = QStandardPaths::findExecutable("chromium");
  if (browser.isEmpty()) QSKIP("chromium isn't installed: the page is not opened in a browser");
  std::string text;
  for (int k = 0; k < 10000; ++k) {
    QJsonObject result =
        resultOf("axis " + QString::number(k), diagnosisOf(k == 4321 ? 0.05 : 0.02 + 1e-7 * ((k * 37) % 10007), 1e-5));
    if (k == 4321) result["report"] = "reports/4321/report.html";
    text += k == 5000 ? lineOf({{"id", "broken"}, {"error", "no bench"}}) : lineOf(result);
  }
  folder_->write("r.jsonl", text);
  QCOMPARE(summary("r.jsonl --out f.html").status, 0);
  folder_->write("visited.html", content("f.html").toStdString() + visit);
  const Outcome outcome = run(
      browser, {"--headless", "--no-sandbox", "--disable-gpu", "--window-size=1366,768",
                "--user-data-dir=" + QString::fromStdString(folder_->path("profile")), "--virtual-time-budget=10000",
                "--dump-dom", QString::fromStdString("file://" + folder_->path("visited.html"))});
  QCOMPARE(outcome.status, 0);
  const QString json = outcome.out.section("<pre id=\"seen\">", 1).section("</pre>", 0, 0);
  const QJsonObject seen = QJsonDocument::fromJson(json.toUtf8()).object();
  qInfo("10000 entries are there after %.0f ms", seen["loaded_ms"].toDouble());
  QCOMPARE(seen["count"].toString(), QString("10,000 of 10,000"));
  QVERIFY2(seen["drawn"].toInt() > 20 && seen["drawn"].toInt() < 100, qPrintable(json));
  QCOMPARE(seen["first"].toString(), QString("axis 4321"));
  QCOMPARE(seen["largest"].toString(), QString("axis 4321"));
  QCOMPARE(seen["smallest"].toString(), QString("axis 0"));
  QCOMPARE(seen["found"].toString(), QString("280 of 10,000"));  // of all numbers of four digits
  QCOMPARE(seen["errors"].toArray(), QJsonArray{"broken"});
  QCOMPARE(seen["apart"].toArray(), QJsonArray{"axis 4321"});
  QCOMPARE(seen["report"].toString(), QString("reports/4321/report.html"));
  QCOMPARE(seen["last"].toString(), QString("broken"));
  QVERIFY2(seen["loaded_ms"].toDouble() < 5000.0, qPrintable(json));
}

QTEST_GUILESS_MAIN(TestSummary)
#include "tst_summary.moc"
