#include <QTest>
#include <cmath>
#include <complex>

#include "base/random.h"
#include "observer/disturbance_observer.h"
#include "observer/edge_timed_velocity.h"
#include "observer/kalman_velocity.h"
#include "observer/riccati.h"
#include "observer/velocity_observer.h"

using namespace breakaway;

class TestObservers : public QObject {
  Q_OBJECT
 private slots:
  void exponential_agreesWithTheLibrary();
  void constantLoad_isApproachedWithTheExactPole();
  void changedCutoff_givesNoJump();
  void floatObserver_followsTheDoubleOne();
  void constantAcceleration_leavesNoVelocityError();
  void quantisedRamp_isQuieterThanTheBackwardDifference();
  void sampledObserver_isTheContinuousOne_data();
  void sampledObserver_isTheContinuousOne();
  void sampledObserver_nearsTheContinuousOneWithTheTick();
  void sampledObserver_answersSpeedAsTheContinuousOne();
  void loadStep_isFollowedWithTheCutoff();
  void edgeTimes_giveTheExactSpeed();
  void reversalAtAnEdge_givesNoSpeed();
  void standstill_bringsTheEdgeTimedSpeedDown();
  void covariance_solvesItsRiccatiEquation();
  void kalmanGain_isTheSameInSinglePrecision();
  void kalmanFilter_findsAConstantLoad();
};

void TestObservers::exponential_agreesWithTheLibrary() {
  for (double x = 0.0; x > -40.0; x -= 0.37) QVERIFY(std::abs(exponential(x) / std::exp(x) - 1.0) < 1e-12);
}

void TestObservers::constantLoad_isApproachedWithTheExactPole() {
  // Standing at zero speed with current i held: τ̂ after n ticks is Kt·i·(1 − e^(−g·n·T)).
  DisturbanceObserver<double> observer;
  observer.configure({200.0, 6e-5, 0.07}, 2e-4);
  observer.reset(0.0);
  double estimate = 0.0;
  for (int k = 0; k < 50; ++k) estimate = observer.step(0.3, 0.0);
  QVERIFY(std::abs(estimate / (0.021 * (1.0 - std::exp(-200.0 * 50 * 2e-4))) - 1.0) < 1e-10);
}

void TestObservers::changedCutoff_givesNoJump() {
  DisturbanceObserver<double> observer;
  observer.configure({200.0, 6e-5, 0.07}, 2e-4);
  double before = 0.0;
  for (int k = 0; k < 500; ++k) before = observer.step(0.3, 20.0);
  observer.configure({50.0, 6e-5, 0.07}, 2e-4);
  QVERIFY(std::abs(observer.step(0.3, 20.0) - before) < 1e-6);
}

void TestObservers::floatObserver_followsTheDoubleOne() {
  DisturbanceObserver<double> fine;
  DisturbanceObserver<float> board;
  fine.configure({200.0, 6e-5, 0.07}, 2e-4);
  board.configure({200.0f, 6e-5f, 0.07f}, 2e-4f);
  Noise noise(3);
  double worst = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const double current = 0.3 + 0.1 * noise.normal(), speed = 20.0 * std::sin(k * 1e-3);
    worst = std::max(worst,
                     std::abs(fine.step(current, speed) -
                              static_cast<double>(board.step(static_cast<float>(current), static_cast<float>(speed)))));
  }
  QVERIFY2(worst < 1e-5 && worst > 0.0, qPrintable(QString::number(worst)));
}

void TestObservers::constantAcceleration_leavesNoVelocityError() {
  VelocityObserver<double> observer;
  observer.configure(400.0, 0.0, 2e-4);
  double velocity = 0.0, time = 0.0;
  for (int k = 0; k < 5000; ++k) {
    time = k * 2e-4;
    velocity = observer.step(0.5 * 100.0 * time * time, 0.0);
  }
  QVERIFY(std::abs(velocity - 100.0 * time) < 1e-6);
}

void TestObservers::quantisedRamp_isQuieterThanTheBackwardDifference() {
  VelocityObserver<double> observer;
  const double T = 2e-4, count = 2.0 * M_PI / 14400.0, speed = 7.3;
  observer.configure(400.0, 0.0, T);
  double last = 0.0, squares = 0.0, raw = 0.0;
  int n = 0;
  for (int k = 0; k < 20000; ++k) {
    const double angle = std::floor(speed * k * T / count) * count;
    const double velocity = observer.step(angle + 0.5 * count, 0.0);
    if (k > 2000)
      squares += (velocity - speed) * (velocity - speed), raw += std::pow((angle - last) / T - speed, 2), ++n;
    last = angle;
  }
  const double ratio = std::sqrt(squares / raw);
  QVERIFY2(ratio < 0.05 && ratio > 0.0001, qPrintable(QString::number(ratio)));
}

/// The sampled observer's response at frequency w to a torque Kt·i that is a complex sine, at the rotor's standstill.
static std::complex<double> sampledResponse(double g, double T, double w) {
  DisturbanceObserver<double> cosine, sine;
  cosine.configure({g, 6e-5, 1.0}, T);
  sine.configure({g, 6e-5, 1.0}, T);
  std::complex<double> response = 0.0;
  const int settled = static_cast<int>(30.0 / (g * T));
  for (int k = 0; k <= settled; ++k) {
    const std::complex<double> input = std::polar(1.0, w * k * T);
    response = std::complex<double>(cosine.step(input.real(), 0.0), sine.step(input.imag(), 0.0)) / input;
  }
  return response;
}

void TestObservers::sampledObserver_isTheContinuousOne_data() {
  QTest::addColumn<double>("cutoff");
  QTest::addColumn<double>("part");
  for (const double g : {50.0, 200.0, 500.0}) {
    for (const double part : {0.1, 0.5, 1.0, 3.0}) QTest::addRow("g %g, w %g g", g, part) << g << part;
  }
}

void TestObservers::sampledObserver_isTheContinuousOne() {
  QFETCH(double, cutoff);
  QFETCH(double, part);
  // A sampled value stands for the middle of the tick that it is held over: it leads by half a tick.
  const double T = 2e-4, w = part * cutoff;
  const std::complex<double> continuous = cutoff / std::complex<double>(cutoff, w);
  const std::complex<double> sampled = sampledResponse(cutoff, T, w) * std::polar(1.0, -0.5 * w * T);
  const double off = std::abs(sampled / continuous - 1.0);
  QVERIFY2(off < 0.1 * w * w * T * T + 0.1 * cutoff * cutoff * T * T && off > 1e-12, qPrintable(QString::number(off)));
}

void TestObservers::sampledObserver_nearsTheContinuousOneWithTheTick() {
  const std::complex<double> continuous = 200.0 / std::complex<double>(200.0, 200.0);
  const double coarse = std::abs(sampledResponse(200.0, 4e-4, 200.0) - continuous);
  const double fine = std::abs(sampledResponse(200.0, 2e-4, 200.0) - continuous);
  QVERIFY2(coarse / fine > 1.9 && coarse / fine < 2.1, qPrintable(QString::number(coarse / fine)));
}

void TestObservers::sampledObserver_answersSpeedAsTheContinuousOne() {
  // From speed to estimate: −gJ·s/(s+g).
  const double T = 2e-4, g = 200.0, J = 6e-5;
  for (const double w : {20.0, 100.0, 200.0, 600.0}) {
    DisturbanceObserver<double> cosine, sine;
    cosine.configure({g, J, 1.0}, T);
    sine.configure({g, J, 1.0}, T);
    std::complex<double> response = 0.0;
    for (int k = 0; k <= 1000; ++k) {
      const std::complex<double> input = std::polar(1.0, w * k * T);
      response = std::complex<double>(cosine.step(0.0, input.real()), sine.step(0.0, input.imag())) / input;
    }
    const std::complex<double> s(0.0, w), continuous = -g * J * s / (s + g);
    const double off = std::abs(response / continuous - 1.0);
    QVERIFY2(off < 0.6 * g * T && off > 1e-9, qPrintable(QString::number(off)));
  }
}

void TestObservers::loadStep_isFollowedWithTheCutoff() {
  // A motor at 0.3 A on which a load of 5 mNm comes at t = 0, its speed exact at each tick.
  const double T = 2e-4, g = 200.0, J = 6e-5, Kt = 0.07, load = 0.005;
  DisturbanceObserver<double> observer;
  observer.configure({g, J, Kt}, T);
  observer.reset(0.0);
  double worst = 0.0;
  for (int k = 1; k < 200; ++k) {
    const double expected = load * (1.0 - std::exp(-g * k * T));
    worst = std::max(worst, std::abs(observer.step(0.3, (Kt * 0.3 - load) / J * k * T) - expected));
  }
  // Within the half tick by which a speed that is held for a tick is behind.
  const double held = 0.6 * g * T * (Kt * 0.3 - load);
  QVERIFY2(worst < held && worst > 0.01 * held, qPrintable(QString::number(worst / held)));
}

/// Runs the M/T estimate over the motion `angleAt(t)` up to `end_s`, the edges found by bisection.
template <typename AngleAt>
static double edgeTimedSpeed(AngleAt angleAt, double end_s) {
  const double T = 2e-4, q = 2.0 * M_PI / 14400.0;
  EdgeTimedVelocity<double> timed;
  timed.configure(q, 1e-3);
  double edge = 0.0, edge_s = -1.0, velocity = 0.0;
  for (double now = T; now < end_s; now += T) {
    const double before = std::floor(angleAt(now - T) / q), after = std::floor(angleAt(now) / q);
    if (after != before) {
      edge = (after > before ? after : after + 1.0) * q;
      double low = now - T, high = now;
      for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (low + high);
        ((angleAt(middle) < edge) == (after > before) ? low : high) = middle;
      }
      edge_s = high;
    }
    velocity = timed.step(edge, edge_s < 0.0 ? 1.0 : now - edge_s, T);
  }
  return velocity;
}

void TestObservers::edgeTimes_giveTheExactSpeed() {
  for (const double speed : {0.3, 7.3, -60.0}) {
    const double found = edgeTimedSpeed([speed](double t) { return 0.1 + speed * t; }, 0.5);
    QVERIFY2(std::abs(found / speed - 1.0) < 1e-6, qPrintable(QString::number(found)));
  }
}

void TestObservers::reversalAtAnEdge_givesNoSpeed() {
  // Swinging across one edge: the edges that are passed all lie in the same place.
  const double q = 2.0 * M_PI / 14400.0;
  const double found = edgeTimedSpeed([q](double t) { return 10.0 * q + 0.3 * q * std::sin(300.0 * t); }, 0.5);
  QVERIFY2(std::abs(found) < 1e-9, qPrintable(QString::number(found)));
}

void TestObservers::standstill_bringsTheEdgeTimedSpeedDown() {
  const auto stopped = [](double t) { return 7.0 * std::min(t, 0.1); };
  QVERIFY(std::abs(edgeTimedSpeed(stopped, 0.1) / 7.0 - 1.0) < 0.01);
  const double after_s = 0.4, most = 2.0 * M_PI / 14400.0 / (after_s - 2e-3);
  const double found = edgeTimedSpeed(stopped, 0.1 + after_s);
  QVERIFY2(found <= most && found > 0.5 * most, qPrintable(QString::number(found)));
}

void TestObservers::covariance_solvesItsRiccatiEquation() {
  using Matrix = Matrix3<double>;
  const Matrix F{{{1.0, 1.0, -0.5}, {0.0, 1.0, -1.0}, {0.0, 0.0, 1.0}}};
  for (const double walk : {1e-12, 1e-8, 1e-4, 1.0}) {
    Matrix Q;
    Q.at[0][0] = 0.25e-6, Q.at[0][1] = Q.at[1][0] = 0.5e-6, Q.at[1][1] = 1e-6, Q.at[2][2] = walk;
    const Matrix P = stationaryCovariance(F, Q, 1.0 / 12.0);
    Matrix corrected = P;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) corrected.at[i][j] -= P.at[i][0] * P.at[0][j] / (P.at[0][0] + 1.0 / 12.0);
    }
    const Matrix next = F * corrected * F.transposed() + Q;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        QVERIFY(std::abs(next.at[i][j] - P.at[i][j]) < 1e-7 * std::sqrt(P.at[i][i] * P.at[j][j]));
    }
  }
}

void TestObservers::kalmanGain_isTheSameInSinglePrecision() {
  KalmanVelocity<double> fine;
  KalmanVelocity<float> board;
  fine.configure({6e-5, 0.07, 4.36e-4, 0.01, 0.017}, 2e-4);
  board.configure({6e-5f, 0.07f, 4.36e-4f, 0.01f, 0.017f}, 2e-4f);
  for (int k = 0; k < 3; ++k) {
    const double ratio = static_cast<double>(board.gain(k)) / fine.gain(k);
    QVERIFY2(std::abs(ratio - 1.0) < 1e-3, qPrintable(QString::number(ratio)));
  }
}

void TestObservers::kalmanFilter_findsAConstantLoad() {
  KalmanVelocity<double> filter;
  const double T = 2e-4, q = 2.0 * M_PI / 14400.0, J = 6e-5, load = 0.02, current = 0.3;
  filter.configure({J, 0.07, q, 0.01, 0.0}, T);
  double angle = 0.0, velocity = 5.0, sum = 0.0;
  filter.reset(0.0);
  const double acceleration = (0.07 * current - load) / J;
  for (int k = 0; k < 3000; ++k) {
    angle += T * (velocity + 0.5 * T * acceleration);
    velocity += T * acceleration;
    filter.step((std::floor(angle / q) + 0.5) * q, current);
    if (k >= 2000) sum += filter.load_Nm();
  }
  QVERIFY2(std::abs(sum / 1000.0 - load) < 2e-4, qPrintable(QString::number(sum / 1000.0)));
  QVERIFY(std::abs(filter.velocity_rad_per_s() - velocity) < 5.0 * std::sqrt(filter.velocityVariance()));
}

QTEST_APPLESS_MAIN(TestObservers)
#include "tst_observers.moc"
