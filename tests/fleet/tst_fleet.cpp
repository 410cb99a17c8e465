#include <QRegularExpression>
#include <QTest>
#include <random>

#include "fleet/fleet_figures.h"
#include "fleet/fleet_lines.h"
#include "fleet/fleet_map.h"
#include "fleet/fleet_table.h"
#include "fleet/spread.h"
#include "fleet/summary_csv.h"
#include "fleet/summary_page.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

/// A fleet's results, read, told apart, and as table and page.
class TestFleet : public QObject {
  Q_OBJECT
 private slots:
  void lineThatIsNoResult_isNamed_data();
  void lineThatIsNoResult_isNamed();
  void lastLineWithoutEnd_isLeftOut();
  void entryApart_isFoundByItsInterval_data();
  void entryApart_isFoundByItsInterval();
  void equalFleet_hasOneApart();
  void fewEntries_tellNothing();
  void normalFleet_hasItsScatterAndFewApart();
  void csv_holdsEveryEntryWithAllItSays();
  void textsInCsv_areQuoted();
  void fieldThatIsCalledAsAColumn_isTheManifests();
  void dates_areRead_data();
  void dates_areRead();
  void trend_needsTwoDays();
  void histogram_countsEveryEntry();
  void page_needsNothingElse();
  void pageData_holdsAllRows();
  void texts_breakOutOfNothing();
  void largeFleet_staysLean();
  void maps_lieOverTheFleet();
  void emptyFleet_isAPage();
};

static FleetText read(const std::string& text) {
  auto fleet = readFleet(text, "r.jsonl");
  if (!fleet) qFatal("%s", fleet.error().message().c_str());
  return std::move(*fleet);
}

void TestFleet::lineThatIsNoResult_isNamed_data() {
  QTest::addColumn<QString>("line");
  QTest::addColumn<QString>("error");
  const auto row = [](const char* name, const QJsonObject& result, const char* error) {
    QTest::newRow(name) << QString::fromStdString(lineOf(result)) << QString("r.jsonl, line 2") + error;
  };
  QTest::newRow("no JSON") << "{]\n"
                           << "r.jsonl, line 2: is not valid JSON";
  QTest::newRow("a list") << "[]\n"
                          << "r.jsonl, line 2: expected a JSON object";
  QTest::newRow("empty") << "\n"
                         << "r.jsonl, line 2: is not valid JSON";
  row("neither", {{"id", "a"}}, ": is no result: it has neither diagnosis nor error");
  row("no id", {{"error", "x"}}, ", field id: is missing");
  row("id that is none", {{"id", true}, {"error", "x"}}, ", field id: expected a text or a number");
  row("error that is none", {{"id", 1}, {"error", 3}}, ", field error: expected a text");
  const auto changed = [&](const char* name, const QString& field, const QJsonValue& value, const char* error) {
    QJsonObject diagnosis = diagnosisOf(0.02, 1e-3);
    if (value.isUndefined())
      diagnosis.remove(field);
    else
      diagnosis[field] = value;
    row(name, resultOf("a", diagnosis), error);
  };
  changed("no verdict", "verdict", QJsonValue::Undefined, ", field diagnosis.verdict: is missing");
  changed("verdict unheard of", "verdict", "good", ", field diagnosis.verdict: expected nothing_missing, named,");
  changed("of a later version", "schema", "breakaway.diagnosis/2",
          ", field diagnosis.schema: is \"breakaway.diagnosis/2\", expected \"breakaway.diagnosis/1\"");
  changed("no base", "base", QJsonValue::Undefined, ", field diagnosis.base: is missing");
  changed("base without interval", "base", QJsonObject{{"coulomb_Nm", QJsonObject{{"value", 1.0}}}},
          ", field diagnosis.base.coulomb_Nm.ci95: is missing");
  changed("interval of three", "base",
          QJsonObject{{"coulomb_Nm", QJsonObject{{"value", 1.0}, {"ci95", QJsonArray{1, 2, 3}}}}},
          ", field diagnosis.base.coulomb_Nm.ci95: expected two numbers");
  changed("findings no list", "findings", "none", ", field diagnosis.findings: expected a list");
  changed("finding without a name", "findings", QJsonArray{QJsonObject()},
          ", field diagnosis.findings[0].effect: is missing");
  changed("no fit", "fit", QJsonValue::Undefined, ", field diagnosis.fit: is missing");
}

void TestFleet::lineThatIsNoResult_isNamed() {
  QFETCH(QString, line);
  QFETCH(QString, error);
  const std::string good = lineOf(resultOf("good", diagnosisOf(0.02, 1e-3)));
  const auto fleet = readFleet(good + line.toStdString() + good, "r.jsonl");
  QVERIFY(!fleet);
  const QString said = QString::fromStdString(fleet.error().message());
  QVERIFY2(said.startsWith(error), qPrintable(said));
}

void TestFleet::lastLineWithoutEnd_isLeftOut() {
  const std::string whole = fleetWithOne(0.02, 1e-3);
  const FleetText all = read(whole), cut = read(whole.substr(0, whole.size() - 100));
  QVERIFY(!all.cutShort && cut.cutShort);
  QCOMPARE(cut.entries.size(), all.entries.size() - 1);
}

void TestFleet::entryApart_isFoundByItsInterval_data() {
  QTest::addColumn<double>("coulomb_Nm");
  QTest::addColumn<double>("half_Nm");
  QTest::addColumn<bool>("apart");
  QTest::newRow("twice the others") << 0.04 << 1e-3 << true;
  QTest::newRow("twice the others, uncertain") << 0.04 << 0.0195 << false;
  QTest::newRow("half the others") << 0.01 << 1e-3 << true;
  QTest::newRow("as the others") << 0.0203 << 1e-4 << false;
}

void TestFleet::entryApart_isFoundByItsInterval() {
  QFETCH(double, coulomb_Nm);
  QFETCH(double, half_Nm);
  QFETCH(bool, apart);
  const auto entries = read(fleetWithOne(coulomb_Nm, half_Nm)).entries;
  const auto order = outliersFirst(entries, baseColumns(entries));
  QCOMPARE(order.size(), entries.size());
  QCOMPARE(std::abs(order[0].distance) >= standsOutFrom, apart);
  QVERIFY(std::abs(order[1].distance) < standsOutFrom);
  if (!apart) return;
  QCOMPARE(entries[order[0].entry].id, std::string("odd"));
  QCOMPARE(order[0].parameter, std::string("coulomb_Nm"));
  QCOMPARE(order[0].distance > 0.0, coulomb_Nm > 0.02);
}

void TestFleet::equalFleet_hasOneApart() {
  std::string text;
  for (int k = 0; k < 30; ++k) text += lineOf(resultOf(QString::number(k), diagnosisOf(k == 7 ? 0.03 : 0.02, 0.0)));
  const auto entries = read(text).entries;
  const auto order = outliersFirst(entries, baseColumns(entries));
  QCOMPARE(entries[order[0].entry].id, std::string("7"));
  QVERIFY(order[0].distance > standsOutFrom);
  QCOMPARE(order[1].distance, 0.0);
  QCOMPARE(order[1].entry, size_t{0});
}

void TestFleet::fewEntries_tellNothing() {
  const auto entries = read(fleetWithOne(0.2, 1e-4, 3)).entries;
  for (const StandsOut& one : outliersFirst(entries, baseColumns(entries))) QCOMPARE(one.distance, 0.0);
}

void TestFleet::normalFleet_hasItsScatterAndFewApart() {
  std::mt19937 random(5);
  std::normal_distribution<double> scatter(0.02, 0.001);
  std::string text;
  for (int k = 0; k < 2000; ++k) text += lineOf(resultOf(QString::number(k), diagnosisOf(scatter(random), 1e-5)));
  const auto entries = read(text).entries;
  const auto columns = baseColumns(entries);
  QVERIFY2(columns[0].median > 0.0199 && columns[0].median < 0.0201, qPrintable(QString::number(columns[0].median)));
  QVERIFY(columns[0].deviation > 0.00093 && columns[0].deviation < 0.00107);
  const auto order = outliersFirst(entries, columns);
  const auto apart = std::count_if(order.begin(), order.end(),
                                   [](const StandsOut& one) { return std::abs(one.distance) >= standsOutFrom; });
  QVERIFY2(apart <= 5, qPrintable(QString::number(apart)));  // of 2000 normal ones 0.9 lie beyond 3.5
}

void TestFleet::csv_holdsEveryEntryWithAllItSays() {
  QJsonObject named = diagnosisOf(0.75, 0.25);
  named["verdict"] = "named";
  named["findings"] = QJsonArray{
      QJsonObject{{"effect", "stribeck"}, {"parameters", QJsonObject{{"excess_Nm", withInterval(0.5, 0.25)}}}},
      QJsonObject{{"effect", "cogging"}, {"parameters", QJsonObject()}}};
  QJsonObject fit = named["fit"].toObject();
  fit["heldout"] = QJsonObject{{"before", 0.02}, {"after", 0.005}, {"improvement_ci95", QJsonArray{0.5, 0.875}}};
  named["fit"] = fit;
  QJsonObject first = resultOf("a", named);
  first["site"] = "Graz";
  first["report"] = "reports/a/report.html";
  const std::string text =
      lineOf(first) + lineOf({{"id", 3}, {"error", "b.json: cannot be read"}, {"date", "2026-01-02"}});
  const QStringList lines = QString::fromStdString(summaryCsv(read(text).entries)).split('\n');
  QCOMPARE(lines.size(), 4);
  QCOMPARE(lines[0],
           QString("id,verdict,names,gain,gain_low95,gain_high95,heldout_before,heldout_after,floor,channel,coulomb_Nm,"
                   "coulomb_Nm_low95,coulomb_Nm_high95,wander_rms_Nm,stribeck.excess_Nm,stribeck.excess_Nm_low95,"
                   "stribeck.excess_Nm_high95,stands_out,stands_out_by,at,report,error,site,date"));
  QCOMPARE(lines[1], QString("a,named,stribeck cogging,0.75,0.5,0.875,0.02,0.005,0.001,angle_rad,0.75,0.5,1,1e-04,"
                             "0.5,0.25,0.75,0,,2026-03-02T09:14:07Z,reports/a/report.html,,Graz,"));
  QCOMPARE(lines[2], QString("3,error,,,,,,,,,,,,,,,,,,2026-01-02,,b.json: cannot be read,,2026-01-02"));
}

void TestFleet::textsInCsv_areQuoted() {
  const std::string text = lineOf({{"id", "a, \"b\""}, {"error", "x"}});
  QVERIFY(summaryCsv(read(text).entries).find("\n\"a, \"\"b\"\"\",error,") != std::string::npos);
}

void TestFleet::fieldThatIsCalledAsAColumn_isTheManifests() {
  const std::string text = lineOf({{"id", 1}, {"error", "x"}, {"verdict", "mine"}});
  const QString csv = QString::fromStdString(summaryCsv(read(text).entries));
  QVERIFY(csv.section('\n', 0, 0).endsWith(",manifest_verdict") && csv.section('\n', 1, 1).endsWith(",mine"));
}

void TestFleet::dates_areRead_data() {
  QTest::addColumn<QString>("at");
  QTest::addColumn<double>("days");  // −1: none
  QTest::newRow("day") << "1970-01-02" << 1.0;
  QTest::newRow("noon") << "2026-03-02T12:00:00Z" << 20514.5;
  QTest::newRow("to the minute") << "1970-01-01 06:00" << 0.25;
  QTest::newRow("no such day") << "2026-02-30" << -1.0;
  QTest::newRow("no date") << "March" << -1.0;
  QTest::newRow("empty") << "" << -1.0;
  QTest::newRow("more behind") << "2026-03-02x" << -1.0;
}

void TestFleet::dates_areRead() {
  QFETCH(QString, at);
  QFETCH(double, days);
  QCOMPARE(daysOf(at.toStdString()).value_or(-1.0), days);
}

void TestFleet::trend_needsTwoDays() {
  std::string text = lineOf(resultOf("a", diagnosisOf(0.02, 1e-3, "2026-03-02T09:00:00Z"))) +
                     lineOf(resultOf("b", diagnosisOf(0.03, 1e-3, "2026-03-02T12:00:00Z"))) +
                     lineOf(resultOf("c", diagnosisOf(0.01, 1e-3, "2026-03-02T15:00:00Z")));
  auto entries = read(text).entries;
  QVERIFY(!trendFigure(baseColumns(entries)[0], entries));
  text += lineOf(resultOf("d", diagnosisOf(0.04, 1e-3, "2026-03-12T09:00:00Z")));
  entries = read(text).entries;
  const auto figure = trendFigure(baseColumns(entries)[0], entries);
  QVERIFY(figure);
  QCOMPARE(figure->curves[0].y, (std::vector<double>{0.02, 0.04}));
  QCOMPARE(figure->curves[0].low, (std::vector<double>{0.02, 0.04}));
  QCOMPARE(figure->curves[0].x, (std::vector<double>{0.5, 10.375}));
}

void TestFleet::histogram_countsEveryEntry() {
  for (const double odd : {0.0201, 10.0}) {
    const auto entries = read(fleetWithOne(odd, 0.0, 200)).entries;
    const FleetColumn column = baseColumns(entries)[0];
    const Figure figure = spreadFigure(column);
    const Curve& bars = figure.curves[0];
    double sum = 0.0;
    for (size_t k = 0; k < bars.y.size(); k += 5) {
      sum += bars.y[k + 1];
      // Each bar stands by itself: what is filled between two of different heights isn't slanted.
      QVERIFY(bars.x[k] == bars.x[k + 1] && bars.y[k] == 0.0 && bars.y[k + 2] == bars.y[k + 1]);
      QVERIFY(bars.x[k + 2] > bars.x[k + 1] && std::isnan(bars.x[k + 4]));
    }
    QCOMPARE(sum + static_cast<double>(beyondSpread(column)), 201.0);
    QCOMPARE(beyondSpread(column), size_t{odd > 1.0 ? 1U : 0U});
  }
}

static QJsonObject dataIn(const QString& page) {
  const QString json = page.section("id=\"fleet-data\">", 1).section("</script>", 0, 0);
  return QJsonDocument::fromJson(json.toUtf8()).object();
}

static QJsonObject columnNamed(const QJsonObject& data, const QString& name) {
  for (const auto& one : data["columns"].toArray()) {
    if (one.toObject()["n"] == name) return one.toObject();
  }
  return {};
}

void TestFleet::page_needsNothingElse() {
  QString page = QString::fromStdString(summaryPage(read(fleetWithOne(0.04, 1e-4)).entries));
  QVERIFY(page.startsWith("<!DOCTYPE html>") && page.endsWith("</html>\n"));
  page.remove("http://www.w3.org/2000/svg");
  for (const char* outside : {"src=", "href=\"", "url(", "@import", "http://", "https://", "fetch(", "XMLHttp"}) {
    if (QString(outside).startsWith("http")) page.remove("'" + QString(outside) + "'");
    QVERIFY2(!page.contains(outside), outside);
  }
  QVERIFY(page.contains("21 entries: 21 nothing missing.\n1 stands out"));
  QVERIFY(page.contains("<svg") && page.contains("id=\"made\""));
  QVERIFY(page.indexOf("<tr class=\"apart\"><td>odd</td>") > 0);
}

void TestFleet::pageData_holdsAllRows() {
  const auto entries = read(fleetWithOne(0.04, 1e-4, 400) + lineOf({{"id", "broken"}, {"error", "no bench"}})).entries;
  const QString page = QString::fromStdString(summaryPage(entries));
  const QJsonObject data = dataIn(page);
  QCOMPARE(data["rows"].toInt(), 402);
  QCOMPARE(data["apart"].toInt(), 1);
  const QJsonObject ids = columnNamed(data, "id"), coulomb = columnNamed(data, "coulomb_Nm");
  QCOMPARE(ids["w"].toArray().size(), 402);
  QCOMPARE(ids["w"].toArray().at(ids["i"].toArray().at(0).toInt()).toString(), QString("odd"));
  QCOMPARE(ids["w"].toArray().at(ids["i"].toArray().at(401).toInt()).toString(), QString("broken"));
  QCOMPARE(coulomb["v"].toArray().size(), 402);
  QCOMPARE(coulomb["v"].toArray().at(0).toDouble(), 0.04);
  QCOMPARE(coulomb["h"].toArray().at(0).toDouble(), 0.0401);
  QVERIFY(coulomb["v"].toArray().at(401).isNull());
  QCOMPARE(page.section("<tbody>", 2, 2).section("</tbody>", 0, 0).count("<tr"), static_cast<int>(plainRows));
  QVERIFY(page.contains("<noscript><p>The first 200 of 402 rows"));
}

void TestFleet::texts_breakOutOfNothing() {
  const QString evil = "</script><img src=x onerror=alert(1)>";
  QJsonObject result = resultOf(evil, diagnosisOf(0.02, 1e-3));
  result["report"] = "javascript:alert(1)";
  result["note"] = evil;
  const QString page =
      QString::fromStdString(summaryPage(read(lineOf(result) + lineOf({{"id", "e"}, {"error", evil}})).entries));
  QVERIFY(!page.contains("<img"));
  QVERIFY(!page.contains("javascript:"));
  const QJsonObject data = dataIn(page);
  QVERIFY(columnNamed(data, "id")["w"].toArray().contains(evil));
  QCOMPARE(data["reports"].toArray().at(0).toString(), QString("javascript%3Aalert%281%29"));
}

void TestFleet::largeFleet_staysLean() {
  std::mt19937 random(5);
  std::normal_distribution<double> scatter(0.02, 0.001);
  std::string text;
  for (int k = 0; k < 10000; ++k)
    text += lineOf(resultOf("axis " + QString::number(k), diagnosisOf(scatter(random), 1e-3)));
  const std::string page = summaryPage(read(text).entries);
  QVERIFY2(page.size() > 300'000 && page.size() < 1'000'000, qPrintable(QString::number(page.size())));
}

/// A rotor's map of `bins` bins whose static friction is `level_Nm`, with position torque of one wave a turn.
static FrictionMap mapOf(double level_Nm, size_t bins) {
  FrictionMap map;
  map.coulombAverage_Nm = {0.8 * level_Nm, 1e-4};
  map.viscousAverage_Nm_s_per_rad = {2e-5, 1e-6};
  for (size_t k = 0; k < bins; ++k) {
    MapBin bin;
    bin.angle_rad = turn_rad * (static_cast<double>(k) + 0.5) / static_cast<double>(bins);
    const double wave_Nm = 1e-3 * std::cos(bin.angle_rad);
    bin.way[0].static_Nm.value = level_Nm + wave_Nm;
    bin.way[1].static_Nm.value = level_Nm - wave_Nm;
    map.bins.push_back(bin);
  }
  return map;
}

void TestFleet::maps_lieOverTheFleet() {
  auto entries = read(fleetWithOne(0.02, 1e-3, 10)).entries;
  for (size_t k = 0; k < 6; ++k)
    addMap(entries[k], mapOf(k == 2 ? 0.03 : 0.02 + 1e-5 * static_cast<double>(k), 60 + 30 * k));
  const auto columns = baseColumns(entries);
  const auto column = [&columns](const char* name) {
    const auto it = std::find_if(columns.begin(), columns.end(), [name](const auto& one) { return one.name == name; });
    if (it == columns.end()) qFatal("no column %s", name);
    return *it;
  };
  QCOMPARE(column("map_static_friction_Nm").values.size(), size_t{6});
  QVERIFY(std::abs(column("map_static_friction_Nm").values[0].value - 0.02) < 1e-9);
  QVERIFY(std::abs(column("map_position_torque_Nm").values[0].value - 1e-3) < 2e-6);
  QVERIFY(column("map_coulomb_Nm").intervals && !column("map_position_torque_Nm").intervals);
  const StandsOut first = outliersFirst(entries, columns).front();
  QVERIFY(first.entry == 2 && QString::fromStdString(first.parameter).startsWith("map_"));

  const auto figures = mapFigures(entries);
  QCOMPARE(figures.size(), size_t{3});
  const Curve& position = figures[2].curves[0];
  for (size_t k = 0; k < position.x.size(); ++k) {
    QVERIFY(std::abs(position.y[k] - 1e-3 * std::cos(position.x[k] / 360.0 * turn_rad)) < 5e-6);
    QVERIFY(position.low[k] <= position.y[k] && position.y[k] <= position.high[k]);
  }
  QCOMPARE(position.x.back(), 360.0);
  QVERIFY(summaryPage(entries).find("Friction maps") != std::string::npos);
  QVERIFY(mapFigures({entries[0], entries[7]}).empty());

  // What ended in an error stands out by nothing, whatever its map says.
  entries[2].error = "none";
  for (const StandsOut& one : outliersFirst(entries, columns)) QVERIFY(one.entry != 2 || one.parameter.empty());

  FrictionMap linear = mapOf(3.0, 20);
  linear.axis = Axis::linear;
  FleetEntry slide;
  addMap(slide, linear);
  QVERIFY(!slide.map && slide.parameters[0].first == "map_static_friction_N");
  QCOMPARE(slide.parameters[3].first, std::string("map_viscous_N_s_per_m"));
}

void TestFleet::emptyFleet_isAPage() {
  const QString page = QString::fromStdString(summaryPage({}));
  QVERIFY(page.contains("0 entries"));
  QCOMPARE(dataIn(page)["rows"].toInt(-1), 0);
  QVERIFY(QString::fromStdString(summaryCsv({})).startsWith("id,verdict,names,gain"));
}

QTEST_APPLESS_MAIN(TestFleet)
#include "tst_fleet.moc"
