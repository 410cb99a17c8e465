// A recording's picture of any stretch: few points, and no extreme lost.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "session/overview.h"

using namespace breakaway;

class TestOverview : public QObject {
  Q_OBJECT
 private slots:
  void longStretch_keepsEveryExtremeInFewPoints();
  void shortStretch_hasItsRows();
  void missingValues_areNoExtremes();
  void channelThatIsNotThere_isEmpty();
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

QTEST_APPLESS_MAIN(TestOverview)
#include "tst_overview.moc"
