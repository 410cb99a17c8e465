#include <QTest>
#include <cmath>

#include "base/statistics.h"
#include "figures/observer_figures.h"
#include "observer/kalman_velocity.h"

using namespace breakaway;

class TestObserverFigures : public QObject {
  Q_OBJECT
 private slots:
  void disturbanceObserver_isNearlyTheKalmanFilterAtItsBest_data();
  void disturbanceObserver_isNearlyTheKalmanFilterAtItsBest();
  void everyCurve_hasItsBestWithin();
  void kalmanFilter_errsAsItExpects_data();
  void kalmanFilter_errsAsItExpects();
  void velocityEstimators_areInTheirOrder();
  void observedRotor_isTheSameForTheSameSeed();
};

namespace {

double number(const BenchFigure& figure, const std::string& name) {
  for (const auto& [known, value] : figure.keyNumbers) {
    if (known == name) return value;
  }
  qFatal("no number %s", name.c_str());
}

/// Rigs by name: what differs from the servo.
void addRotors() {
  QTest::addColumn<double>("walk");
  QTest::addColumn<double>("counts");
  QTest::addColumn<double>("noise_A");
  QTest::addColumn<double>("tick_s");
  QTest::addColumn<int>("seed");
  QTest::newRow("servo") << 0.01 << 14400.0 << 0.017 << 2e-4 << 1;
  QTest::newRow("calm load") << 0.001 << 14400.0 << 0.017 << 2e-4 << 2;
  QTest::newRow("wild load") << 0.1 << 14400.0 << 0.017 << 2e-4 << 3;
  QTest::newRow("coarse encoder") << 0.01 << 2000.0 << 0.017 << 2e-4 << 4;
  QTest::newRow("noisy current") << 0.01 << 14400.0 << 0.08 << 2e-4 << 5;
  QTest::newRow("slow board") << 0.01 << 14400.0 << 0.017 << 1e-3 << 6;
}

ObserverFigureOptions fetched() {
  QFETCH(double, walk);
  QFETCH(double, counts);
  QFETCH(double, noise_A);
  QFETCH(double, tick_s);
  QFETCH(int, seed);
  ObserverFigureOptions options;
  options.rotor.loadWalk_Nm_per_sqrt_s = walk;
  options.rotor.count_rad = 2.0 * M_PI / counts;
  options.rotor.currentNoise_A = noise_A;
  options.rotor.tick_s = tick_s;
  options.rotor.seed = static_cast<uint64_t>(seed);
  return options;
}

}  // namespace

void TestObserverFigures::disturbanceObserver_isNearlyTheKalmanFilterAtItsBest_data() {
  addRotors();
}

void TestObserverFigures::disturbanceObserver_isNearlyTheKalmanFilterAtItsBest() {
  const BenchFigure figure = disturbanceCutoffFigure(fetched());
  const double fedByKalman = number(figure, "best_kalman_speed_over_kalman");
  QVERIFY2(fedByKalman < 1.2 && fedByKalman > 0.9, qPrintable(QString::number(fedByKalman)));
  const double fixed = number(figure, "best_luenberger_over_kalman");
  QVERIFY2(fixed < 1.2 && fixed > 0.9, qPrintable(QString::number(fixed)));
  const double matched = number(figure, "best_luenberger_3g_over_kalman");
  QVERIFY2(matched < 1.2 && matched > 0.9, qPrintable(QString::number(matched)));
}

void TestObserverFigures::everyCurve_hasItsBestWithin() {
  const BenchFigure figure = disturbanceCutoffFigure({});
  const auto& cutoffs = columnOf(figure, "cutoff_rad_per_s");
  for (const char* name : {"luenberger", "luenberger_3g", "kalman_speed"}) {
    const double best = number(figure, std::string("best_cutoff_") + name + "_rad_per_s");
    QVERIFY2(best > cutoffs.front() && best < cutoffs.back(), name);
  }
  QVERIFY(number(figure, "best_backward_difference_over_kalman") > 1.5);
}

void TestObserverFigures::kalmanFilter_errsAsItExpects_data() {
  addRotors();
}

void TestObserverFigures::kalmanFilter_errsAsItExpects() {
  ObservedRotorOptions rotor = fetched().rotor;
  rotor.duration_s = 10.0;
  const auto ticks = observeRotor(rotor);
  KalmanVelocity<double> filter;
  filter.configure({rotor.inertia_kg_m2, rotor.torqueConstant_Nm_per_A, rotor.count_rad, rotor.loadWalk_Nm_per_sqrt_s,
                    rotor.currentNoise_A},
                   rotor.tick_s);
  filter.reset(ticks.front().angle_rad);
  std::vector<double> velocity, load;
  for (size_t k = 0; k < ticks.size(); ++k) {
    filter.step(ticks[k].angle_rad, ticks[k].current_A);
    if (k < ticks.size() / 10) continue;
    velocity.push_back(filter.velocity_rad_per_s() - ticks[k].velocity_rad_per_s);
    load.push_back(filter.load_Nm() - ticks[k].nextLoad_Nm);
  }
  const double inVelocity = rms(velocity) / std::sqrt(filter.velocityVariance());
  const double walked = rotor.loadWalk_Nm_per_sqrt_s * rotor.loadWalk_Nm_per_sqrt_s * rotor.tick_s;
  const double inLoad = rms(load) / std::sqrt(filter.loadVariance() + walked);
  // Where the rotor passes a coarse encoder's counts slowly, their rounding is no white noise: the filter does better.
  QVERIFY2(inVelocity > 0.7 && inVelocity < 1.15, qPrintable(QString::number(inVelocity)));
  QVERIFY2(inLoad > 0.85 && inLoad < 1.15, qPrintable(QString::number(inLoad)));
}

void TestObserverFigures::velocityEstimators_areInTheirOrder() {
  const BenchFigure figure = velocityEstimatorFigure({});
  const auto& raw = columnOf(figure, "backward_difference_rad_per_s");
  const auto& timed = columnOf(figure, "edge_timed_rad_per_s");
  const auto& observed = columnOf(figure, "luenberger_rad_per_s");
  const auto& filtered = columnOf(figure, "kalman_rad_per_s");
  QCOMPARE(filtered.size(), size_t{5});
  for (size_t k = 0; k < raw.size(); ++k) {
    QVERIFY(filtered[k] < 0.1 * raw[k] && filtered[k] > 0.005 * raw[k]);
    QVERIFY(filtered[k] < 1.05 * observed[k]);
  }
  QVERIFY(timed.front() < filtered.front() && timed.back() > filtered.back());
}

void TestObserverFigures::observedRotor_isTheSameForTheSameSeed() {
  ObservedRotorOptions rotor;
  rotor.duration_s = 0.1;
  const auto first = observeRotor(rotor), second = observeRotor(rotor);
  rotor.seed = 2;
  const auto third = observeRotor(rotor);
  QCOMPARE(first.back().current_A, second.back().current_A);
  QVERIFY(first.back().current_A != third.back().current_A);
}

QTEST_APPLESS_MAIN(TestObserverFigures)
#include "tst_observer_figures.moc"
