#include <QTest>
#include <cmath>
#include <numbers>

#include "diagnose/fit/inverse_fit.h"
#include "diagnose/fit/inverse_rows.h"
#include "support/temporary.h"
#include "support/within.h"

using namespace breakaway;
using breakaway::test::within;

class TestInverse : public QObject {
  Q_OBJECT
 private slots:
  void lowPass_hasNoPhase();
  void lowPass_halvesThePowerTwiceAtItsCutoff();
  void impulse_staysSymmetric();
  void bothSides_areFilteredAlike();
  void linearSystem_isRecovered();
  void standingStill_isRefused();
};

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// Amplitude and phase of a filtered sine in the middle of its length.
struct Response {
  double gain, phase_rad;
};

Response responseAt(double frequency_Hz, double cutoff_Hz) {
  const double step = 1e-3;
  std::vector<double> values;
  values.reserve(8000);
  for (int k = 0; k < 8000; ++k) values.push_back(std::sin(turn * frequency_Hz * step * k));
  lowPass(values, step, cutoff_Hz);
  double in = 0.0, quadrature = 0.0;
  for (int k = 2000; k < 6000; ++k) {
    in += values[static_cast<size_t>(k)] * std::sin(turn * frequency_Hz * step * k) / 2000.0;
    quadrature += values[static_cast<size_t>(k)] * std::cos(turn * frequency_Hz * step * k) / 2000.0;
  }
  return {std::hypot(in, quadrature), std::atan2(quadrature, in)};
}

constexpr double mass_kg = 95.0, viscous = 200.0, coulomb = 20.0, load = -3.2;

/// A slide whose position is a sum of sines, and the force that its equation asks for at each row.
Track slide() {
  Track track;
  track.name = "slide";
  for (int k = 0; k < 20000; ++k) {
    const double t = 1e-3 * k;
    double x = 0.0, v = 0.0, a = 0.0;
    for (const auto& [amplitude, frequency] : {std::pair{0.05, 0.4}, {0.01, 1.7}, {0.002, 4.3}}) {
      const double w = turn * frequency;
      x += amplitude * std::sin(w * t);
      v += amplitude * w * std::cos(w * t);
      a -= amplitude * w * w * std::sin(w * t);
    }
    track.time.push_back(t);
    track.position.push_back(x);
    track.input.push_back(mass_kg * a + viscous * v + coulomb * (v > 0.0 ? 1.0 : -1.0) + load);
  }
  track.seen.assign(track.rows(), 1);
  track.connected.assign(track.rows(), 1);
  track.noise = 1e-9;
  return track;
}

Model slideModel() {
  Model model;
  model.axis = Axis::linear;
  for (const char* name : {"mass_kg", "viscous_N_s_per_m", "coulomb_N"}) model.base.push_back({name, 1.0, 1.0, 1.0});
  return model;
}

}  // namespace

void TestInverse::lowPass_hasNoPhase() {
  for (const double frequency : {2.0, 10.0, 25.0, 40.0}) {
    const Response response = responseAt(frequency, 30.0);
    QVERIFY2(std::abs(response.phase_rad) < 1e-6, qPrintable(QString::number(response.phase_rad)));
  }
}

void TestInverse::lowPass_halvesThePowerTwiceAtItsCutoff() {
  QVERIFY(within(responseAt(30.0, 30.0).gain, 0.5, 1e-3));
  QVERIFY(within(responseAt(5.0, 30.0).gain, 1.0, 1e-4));
  const double far = responseAt(120.0, 30.0).gain;
  QVERIFY(far > 1e-6 && far < 1e-4);  // 4⁻⁸ and the bilinear transform's share
}

void TestInverse::impulse_staysSymmetric() {
  std::vector<double> values(2001, 0.0);
  values[1000] = 1.0;
  lowPass(values, 1e-3, 20.0);
  double sum = 0.0;
  for (size_t k = 0; k <= 1000; ++k) QVERIFY(std::abs(values[1000 - k] - values[1000 + k]) < 1e-12);
  for (const double value : values) sum += value;
  QVERIFY(std::abs(sum - 1.0) < 1e-9);
  QVERIFY(values[1000] > 0.02 && values[1000] < 0.06);
}

void TestInverse::bothSides_areFilteredAlike() {
  Eigen::MatrixXd columns(4000, 2);
  Eigen::VectorXd response(4000);
  for (Eigen::Index k = 0; k < 4000; ++k) {
    const double t = 1e-3 * static_cast<double>(k);
    columns(k, 0) = std::sin(9.0 * t) + 0.3 * std::sin(900.0 * t);
    columns(k, 1) = std::sin(31.0 * t) > 0.0 ? 1.0 : -1.0;
    response[k] = 3.0 * columns(k, 0) - 0.7 * columns(k, 1);
  }
  std::vector<char> use(4000, 1);
  std::fill(use.begin() + 1000, use.begin() + 2000, 0);
  filterAlike(columns, response, use, 1e-3, 20.0);
  QCOMPARE(columns.rows(), response.size());
  QCOMPARE(response.size(), Eigen::Index(300));  // every tenth row of 3000
  QVERIFY((response - 3.0 * columns.col(0) + 0.7 * columns.col(1)).norm() < 1e-9);
}

void TestInverse::linearSystem_isRecovered() {
  Model model = slideModel();
  model.effects = {{"constant_load", {}}};
  const auto fit = fitInverse(model, {slide()});
  VERIFY_OK(fit);
  QVERIFY2(within(*fit->model.baseValue("mass_kg"), mass_kg, 2e-3),
           qPrintable(QString::number(*fit->model.baseValue("mass_kg"))));
  QVERIFY2(within(*fit->model.baseValue("viscous_N_s_per_m"), viscous, 2e-3),
           qPrintable(QString::number(*fit->model.baseValue("viscous_N_s_per_m"))));
  QVERIFY2(within(*fit->model.baseValue("coulomb_N"), coulomb, 5e-3),
           qPrintable(QString::number(*fit->model.baseValue("coulomb_N"))));
  const Parameter& found = fit->model.effects.front().parameters.front();
  QCOMPARE(found.name, std::string("load_N"));
  QVERIFY2(within(found.value, load, 0.01), qPrintable(QString::number(found.value)));
  QVERIFY(found.low95 < found.value && found.value < found.high95);
  QVERIFY2(fit->relativeError < 0.01, qPrintable(QString::number(fit->relativeError)));

  const auto without = fitInverse(slideModel(), {slide()});
  VERIFY_OK(without);
  QVERIFY(without->relativeError > 3.0 * fit->relativeError);
}

void TestInverse::standingStill_isRefused() {
  Track track = slide();
  std::fill(track.position.begin(), track.position.end(), 0.2);
  VERIFY_ERROR(fitInverse(slideModel(), {track}), "slide: holds too little motion for the inverse model");
}

QTEST_APPLESS_MAIN(TestInverse)
#include "tst_inverse.moc"
