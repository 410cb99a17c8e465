#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>
#include <cmath>
#include <numbers>

#include "draw/svg_path.h"
#include "draw/svg_plot.h"
#include "draw/svg_ticks.h"

using namespace breakaway;

class TestSvgPlot : public QObject {
  Q_OBJECT
 private slots:
  void ticks_areRoundAndInside_data();
  void ticks_areRoundAndInside();
  void tickLabels_tellTicksApart_data();
  void tickLabels_tellTicksApart();
  void everyFigure_isWellFormed_data();
  void everyFigure_isWellFormed();
  void longCurve_isThinnedButKeepsItsExtremes();
  void gap_splitsTheCurve();
  void curve_staysInsideItsFrame();
  void polarAngle_growsCounterClockwise_data();
  void polarAngle_growsCounterClockwise();
  void text_isEscaped();
  void words_areThoseOfTheLanguage();
};

static Curve wave(size_t points) {
  Curve curve{.label = "wave", .x = {}, .y = {}};
  for (size_t k = 0; k < points; ++k) {
    curve.x.push_back(static_cast<double>(k) * 1e-3);
    curve.y.push_back(std::sin(0.01 * static_cast<double>(k)));
  }
  return curve;
}

/// The numbers after the path letters of the first curve: x, y, x, y, …
static std::vector<Pixel> pointsOfCurve(const std::string& svg) {
  static const QRegularExpression path("<path d=\"([^\"]*)\" fill=\"none\" class=\"bw-sc0\"");
  auto all = path.globalMatch(QString::fromStdString(svg));
  QString data;
  while (all.hasNext()) data = all.next().captured(1);  // the last one; the first is the legend's
  std::vector<Pixel> points;
  static const QRegularExpression number("[ML](-?[0-9.]+) (-?[0-9.]+)");
  auto numbers = number.globalMatch(data);
  while (numbers.hasNext()) {
    const auto one = numbers.next();
    points.push_back({one.captured(1).toDouble(), one.captured(2).toDouble()});
  }
  return points;
}

void TestSvgPlot::ticks_areRoundAndInside_data() {
  QTest::addColumn<double>("low");
  QTest::addColumn<double>("high");
  QTest::newRow("unit") << 0.0 << 1.0;
  QTest::newRow("across zero") << -0.034 << 0.021;
  QTest::newRow("far from zero") << 1e6 << 1e6 + 3.0;
  QTest::newRow("tiny") << 1e-9 << 7e-9;
  QTest::newRow("huge") << -4e12 << 9e12;
}

void TestSvgPlot::ticks_areRoundAndInside() {
  QFETCH(double, low);
  QFETCH(double, high);
  const auto ticks = niceTicks(low, high, 6);
  QVERIFY2(ticks.size() >= 3 && ticks.size() <= 12, qPrintable(QString::number(ticks.size())));
  const double step = ticks[1] - ticks[0];
  for (const double tick : ticks) {
    QVERIFY(tick >= low - 1e-6 * step && tick <= high + 1e-6 * step);
    QVERIFY(std::abs(tick / step - std::round(tick / step)) < 1e-6);
  }
  const double leading = step / std::pow(10.0, std::floor(std::log10(step) + 1e-6));
  QVERIFY(std::abs(leading - 1) < 1e-6 || std::abs(leading - 2) < 1e-6 || std::abs(leading - 5) < 1e-6);
}

void TestSvgPlot::tickLabels_tellTicksApart_data() {
  QTest::addColumn<QList<double>>("ticks");
  QTest::addColumn<QString>("labels");
  QTest::newRow("whole") << QList<double>{0, 10, 20} << "0 10 20";
  QTest::newRow("decimals") << QList<double>{-0.5, 0, 0.5} << "−0.5 0.0 0.5";
  QTest::newRow("small") << QList<double>{0, 2e-5, 4e-5} << "0 20 40 (× 10⁻⁶)";
  QTest::newRow("large") << QList<double>{1e6, 1.5e6, 2e6} << "1.0 1.5 2.0 (× 10⁶)";
}

void TestSvgPlot::tickLabels_tellTicksApart() {
  QFETCH(QList<double>, ticks);
  QFETCH(QString, labels);
  const TickLabels got = tickLabels({ticks.begin(), ticks.end()});
  QStringList texts;
  for (const auto& text : got.texts) texts << QString::fromStdString(text);
  QCOMPARE(texts.join(' ') + QString::fromStdString(exponentText(got.exponent)), labels);
}

void TestSvgPlot::everyFigure_isWellFormed_data() {
  QTest::addColumn<int>("kind");
  for (int kind = 0; kind < 12; ++kind) QTest::newRow(qPrintable(QString::number(kind))) << kind;
}

void TestSvgPlot::everyFigure_isWellFormed() {
  QFETCH(int, kind);
  Figure figure{.title = "T", .xLabel = "x / s", .yLabel = "y / <rad>", .curves = {wave(500)}};
  Curve& curve = figure.curves[0];
  if (kind == 1) figure.curves.clear();
  if (kind == 2) curve.y.assign(curve.y.size(), NAN);
  if (kind == 3) curve.y.assign(curve.y.size(), 5e-324);
  if (kind == 4) curve = {.label = "one", .x = {1}, .y = {2}};
  if (kind == 5) figure.logX = figure.logY = true;
  if (kind == 6) figure.polar = true;
  if (kind == 7) curve.low = curve.high = curve.y, figure.highlights = {{0.1, 0.2, "a & b"}, {9.0, 8.0, "outside"}};
  if (kind == 8) curve.y[3] = 1e300, curve.style = Curve::Style::points, figure.equalScale = true;
  if (kind == 9) figure.xRange = figure.yRange = {{1.0, 1.0}};
  if (kind == 10) curve.y.assign(curve.y.size(), 5e-324), figure.polar = true;
  if (kind == 11) curve.y[3] = 1.7e308, curve.y[4] = -1.7e308;
  const std::string svg = toSvg(figure);
  QXmlStreamReader xml(QString::fromStdString(svg));
  while (!xml.atEnd()) xml.readNext();
  QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
  QVERIFY(svg.find("nan") == std::string::npos && svg.find("inf") == std::string::npos);
  QCOMPARE(svg.find("no data") != std::string::npos, kind == 1 || kind == 2);
  QVERIFY(svg.find(" id=") == std::string::npos);
}

void TestSvgPlot::longCurve_isThinnedButKeepsItsExtremes() {
  Figure figure{.title = "", .xLabel = "", .yLabel = "", .curves = {wave(300000)}};
  const std::string plain = toSvg(figure);
  QVERIFY2(plain.size() > 5000 && plain.size() < 80000, qPrintable(QString::number(plain.size())));
  figure.yRange = {{-2.0, 10.0}};
  const auto before = pointsOfCurve(toSvg(figure));
  figure.curves[0].y[123456] = 9.0;  // one sample of 300,000
  const auto after = pointsOfCurve(toSvg(figure));
  const auto highest = [](const std::vector<Pixel>& points) {
    double y = 1e9;
    for (const Pixel& p : points) y = std::min(y, p.y);
    return y;
  };
  QVERIFY2(highest(after) < highest(before) - 150.0,
           qPrintable(QString("%1 %2").arg(highest(after)).arg(highest(before))));
}

void TestSvgPlot::gap_splitsTheCurve() {
  const Frame frame{0, 0, 10, 10};
  QCOMPARE(linePath({{0, 1}, {1, 1}, {NAN, NAN}, {3, 1}, {4, 2}}, frame), std::string("M0 1L1 1M3 1L4 2"));
  QCOMPARE(linePath({{NAN, 1}, {1, 1}, {2, NAN}}, frame), std::string("M1 1h.1"));
}

void TestSvgPlot::curve_staysInsideItsFrame() {
  const Frame frame{0, 0, 10, 10};
  QCOMPARE(linePath({{-10, 5}, {20, 5}}, frame), std::string("M0 5L10 5"));
  QCOMPARE(linePath({{5, 5}, {5, 100}, {6, 100}, {6, 5}}, frame), std::string("M5 5L5 10M6 10L6 5"));
  QCOMPARE(linePath({{-5, -5}, {-6, 20}}, frame), std::string());
  QCOMPARE(dotPath({{1, 1}, {11, 1}, {1, 1}}, frame), std::string("M1 1h.1"));
}

void TestSvgPlot::polarAngle_growsCounterClockwise_data() {
  QTest::addColumn<bool>("zeroAtTop");
  QTest::addColumn<double>("angle");
  QTest::addColumn<int>("right");
  QTest::addColumn<int>("up");
  QTest::newRow("0° right") << false << 0.0 << 1 << 0;
  QTest::newRow("90° up") << false << 0.5 * std::numbers::pi << 0 << 1;
  QTest::newRow("0° up") << true << 0.0 << 0 << 1;
  QTest::newRow("90° left") << true << 0.5 * std::numbers::pi << -1 << 0;
}

void TestSvgPlot::polarAngle_growsCounterClockwise() {
  QFETCH(bool, zeroAtTop);
  QFETCH(double, angle);
  QFETCH(int, right);
  QFETCH(int, up);
  Figure figure{.title = "",
                .xLabel = "",
                .yLabel = "",
                .curves = {{.label = "", .x = {angle}, .y = {1.0}}},
                .polar = true,
                .zeroAtTop = zeroAtTop,
                .yRange = {{0.0, 2.0}}};
  figure.curves[0].style = Curve::Style::points;
  const auto points = pointsOfCurve(toSvg(figure, 600, 600));
  QCOMPARE(points.size(), size_t(1));
  figure.curves[0].y = {0.0};
  const auto centre = pointsOfCurve(toSvg(figure, 600, 600));
  const double dx = points[0].x - centre[0].x, dy = centre[0].y - points[0].y;
  QVERIFY(std::hypot(dx, dy) > 80.0);
  QVERIFY(std::abs(dx / std::hypot(dx, dy) - right) < 0.01 && std::abs(dy / std::hypot(dx, dy) - up) < 0.01);
}

void TestSvgPlot::text_isEscaped() {
  QCOMPARE(escaped("a<b> & \"c\" 'd'\x01"), std::string("a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39; "));
}

void TestSvgPlot::words_areThoseOfTheLanguage() {
  const auto german = Catalogue::read(R"({"time / s": "Zeit / s", "run {}": "Lauf {}", "most here": "hier"})");
  QVERIFY(german.ok());
  Figure figure{message("run {}", 3), message("time / s"), "mNm"};
  figure.curves.push_back(wave(10));
  figure.curves.front().label = message("run {}", 7);
  figure.highlights.push_back({0.0, 0.01, message("most here")});
  const std::string here = toSvg(figure), there = toSvg(inLanguage(figure, *german));
  for (const char* word : {"run 3", "run 7", "time / s", "most here", "mNm"})
    QVERIFY2(here.find(word) != std::string::npos, word);
  for (const char* word : {"Lauf 3", "Lauf 7", "Zeit / s", "hier", "mNm"})
    QVERIFY2(there.find(word) != std::string::npos, word);
  QVERIFY(there.find("run") == std::string::npos && there.find("time") == std::string::npos);
}

QTEST_APPLESS_MAIN(TestSvgPlot)
#include "tst_svg_plot.moc"
