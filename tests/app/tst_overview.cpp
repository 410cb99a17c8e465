// A recording's picture of any stretch: few points, no extreme lost, and soon drawn; and what is drawn again and again
// rests while nothing is new.
#include <qcustomplot.h>

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "session/comparison.h"
#include "session/overview.h"
#include "support/processor_time.h"
#include "support/sanitized.h"
#include "widgets/residual_plots.h"
#include "widgets/while_shown.h"

using namespace breakaway;
using namespace breakaway::test;

class TestOverview : public QObject {
  Q_OBJECT
 private slots:
  void longStretch_keepsEveryExtremeInFewPoints();
  void shortStretch_hasItsRows();
  void missingValues_areNoExtremes();
  void channelThatIsNotThere_isEmpty();
  void begin_isWhereItLeavesItsFirstValue();
  void noisyRecording_isDrawnAtOnce();
  void calmRecording_isDrawnSmoothly();
  void nothingNew_isLookedForSeldom();
};

namespace {

constexpr size_t rows = 1'000'000;
constexpr double step_s = 1e-4;

Recording noisy(std::vector<double>& values) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  std::vector<double> time;
  for (size_t k = 0; k < rows; ++k) {
    time.push_back(step_s * static_cast<double>(k));
    values.push_back(noise(random));
  }
  values[777'777] = 50.0;  // one row that stands out
  return Recording::seal("r", {{"time_s", time}, {"angle_rad", values}}).value();
}

}  // namespace

void TestOverview::longStretch_keepsEveryExtremeInFewPoints() {
  std::vector<double> values;
  const Overview overview(noisy(values), "angle_rad");
  QCOMPARE(overview.range().second, 50.0);
  QCOMPARE(overview.range().first, *std::min_element(values.begin(), values.end()));
  for (const auto& [from, to] : {std::pair{0.0, 100.0}, {10.0, 90.0}, {77.0, 78.5}, {0.0, 30.0}}) {
    const auto points = overview.between(from, to, 800);
    QVERIFY2(points.size() > 1600 && points.size() < 25600, qPrintable(QString::number(points.size())));
    double least = 0.0, most = 0.0, last = -1.0;
    for (const auto& point : points) {
      QVERIFY(point.time_s > last);
      last = point.time_s;
      least = std::min(least, point.value);
      most = std::max(most, point.value);
    }
    const auto first = values.begin() + static_cast<ptrdiff_t>(from / step_s);
    const auto end = values.begin() + static_cast<ptrdiff_t>(to / step_s);
    QVERIFY(least <= *std::min_element(first, end) && most >= *std::max_element(first, end));
  }
}

void TestOverview::shortStretch_hasItsRows() {
  std::vector<double> values;
  const Overview overview(noisy(values), "angle_rad");
  const auto points = overview.between(50.00005, 50.01005, 800);
  QCOMPARE(points.size(), size_t{102});  // a hundred, and one on either side
  for (size_t k = 0; k < points.size(); ++k) QCOMPARE(points[k].value, values[500'000 + k]);
}

void TestOverview::missingValues_areNoExtremes() {
  std::vector<double> time, values;
  for (int k = 0; k < 10'000; ++k) {
    time.push_back(k);
    values.push_back(k % 100 < 70 ? std::numeric_limits<double>::quiet_NaN() : 0.001 * k);
  }
  const Overview overview(Recording::seal("r", {{"time_s", time}, {"angle_rad", values}}).value(), "angle_rad");
  QCOMPARE(overview.range(), (std::pair{0.07, 9.999}));
}

void TestOverview::channelThatIsNotThere_isEmpty() {
  std::vector<double> values;
  const Overview overview(noisy(values), "position_m");
  QVERIFY(overview.between(0.0, 100.0, 800).empty());
}

/// Two seconds at rest with a count to and fro, then a ramp of one a second: a hundredth of eight is 0.08 s later.
void TestOverview::begin_isWhereItLeavesItsFirstValue() {
  std::vector<double> time, values;
  for (int k = 0; k <= 1000; ++k) {
    time.push_back(5.0 + 0.01 * k);
    values.push_back(3.0 + (k <= 200 ? 0.001 * (k % 2) : 0.01 * (k - 200)));
  }
  const Overview overview(Recording::seal("r", {{"time_s", time}, {"angle_rad", values}}).value(), "angle_rad");
  QCOMPARE(overview.begin().value, 3.0);
  QVERIFY2(std::abs(overview.begin().time_s - 7.09) < 0.011, qPrintable(QString::number(overview.begin().time_s)));
  const std::vector<double> still(time.size(), 1.5);
  const Overview resting(Recording::seal("r", {{"time_s", time}, {"angle_rad", still}}).value(), "angle_rad");
  QCOMPARE(resting.begin().time_s, 5.0);
  QCOMPARE(resting.begin().value, 1.5);
}

/// The picture is as many up and down strokes as are seen apart: of a thick line, each crosses all others.
void TestOverview::noisyRecording_isDrawnAtOnce() {
  Messages messages;
  Comparison comparison(messages);
  ResidualPlots plots(comparison);
  plots.resize(1400, 500);
  plots.show();
  std::vector<double> values;
  comparison.takeRecording(noisy(values));
  auto* plot = plots.findChild<QCustomPlot*>("residualPlot");
  QTRY_VERIFY_WITH_TIMEOUT(plot->graph(0)->dataCount() > 800, 20000);
  double least_s = 1.0;  // of three, for processor time has pauses of the machine in it, too
  for (int k = 0; k < 3; ++k) {
    const ProcessorTime time(ProcessorTime::Of::thread);
    plot->replot();
    least_s = std::min(least_s, time.elapsed_s());
  }
  if (!sanitized) QVERIFY2(least_s < 0.05, qPrintable(QString::number(least_s)));
  QVERIFY2(!plot->graph(0)->antialiased(), "what fills its pixels has no steps to smooth");
}

void TestOverview::calmRecording_isDrawnSmoothly() {
  Messages messages;
  Comparison comparison(messages);
  ResidualPlots plots(comparison);
  plots.resize(1400, 500);
  plots.show();
  std::vector<double> time, values;
  for (size_t k = 0; k < 100'000; ++k) {
    time.push_back(1e-3 * static_cast<double>(k));
    values.push_back(std::sin(0.5 * time.back()));
  }
  comparison.takeRecording(Recording::seal("r", {{"time_s", time}, {"angle_rad", values}}).value());
  auto* plot = plots.findChild<QCustomPlot*>("residualPlot");
  QTRY_VERIFY_WITH_TIMEOUT(plot->graph(0)->dataCount() > 400, 20000);
  QVERIFY(plot->graph(0)->antialiased());
}

void TestOverview::nothingNew_isLookedForSeldom() {
  using namespace std::chrono_literals;
  QWidget widget;
  int looked = 0;
  bool isNew = true;
  new WhileShown(&widget, 10ms, [&] {
    ++looked;
    return isNew;
  });
  widget.show();
  QTRY_VERIFY_WITH_TIMEOUT(looked > 40, 20000);
  isNew = false;
  QTest::qWait(600);  // until it rests
  const int before = looked;
  QTest::qWait(1000);
  QVERIFY2(looked - before <= 5, qPrintable(QString::number(looked - before)));
  QTRY_VERIFY_WITH_TIMEOUT(looked > before, 5000);
  isNew = true;
  const int again = looked;
  QTRY_VERIFY_WITH_TIMEOUT(looked > again + 20, 20000);
  widget.hide();
  const int hidden = looked;
  QTest::qWait(50);
  QCOMPARE(looked, hidden);
}

QTEST_MAIN(TestOverview)
#include "tst_overview.moc"
