#include <QTest>
#include <cmath>
#include <deque>
#include <random>

#include "experiment/square_response.h"
#include "experiment/winding_test.h"
#include "firmware_link/board_drive.h"
#include "support/firmware_stream.h"

using namespace breakaway;
using namespace breakaway::test;

class TestSquareResponse : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void commandsThatComeLate_leaveTheTimeConstantAsItIs_data();
  void commandsThatComeLate_leaveTheTimeConstantAsItIs();
  void windingOverTheWire_hasItsTimeConstant_data();
  void windingOverTheWire_hasItsTimeConstant();
};

namespace {

constexpr double tick_s = 2e-4, tau_s = 9e-4;

/// A winding whose commands take `delay` ticks, or up to that many, from sample to bridge.
class LateWinding {
 public:
  LateWinding(int delay, bool jitters, double lost) : delay_(delay), jitters_(jitters), lost_(lost) {}

  /// Of a square wave of 40 ticks each way.
  SquareResponse measured() {
    SquareResponse response(40, tick_s);
    for (int tick = 0; tick < 40000; ++tick) {
      const double wanted_V = (seen_ / 40) % 2 == 0 ? 0.5 : -0.5;
      while (!under_.empty() && under_.front().first <= tick) {
        voltage_V_ = under_.front().second;
        under_.pop_front();
      }
      Sample sample;
      sample.time_s = tick * tick_s;
      sample.voltage_V = voltage_V_;
      sample.current_A = current_A_ + std::normal_distribution<double>(0.0, 0.017)(random_);
      current_A_ += (1.0 - std::exp(-tick_s / tau_s)) * (voltage_V_ / 1.2 - current_A_);
      if (std::uniform_real_distribution<double>()(random_) < lost_) continue;
      ++seen_;
      response.take(sample);
      const int takes = jitters_ ? 1 + static_cast<int>(random_() % static_cast<unsigned>(delay_)) : delay_;
      if (under_.empty() || under_.back().second != wanted_V) under_.emplace_back(tick + takes, wanted_V);
    }
    return response;
  }

 private:
  int delay_;
  bool jitters_;
  double lost_;
  std::mt19937 random_{7};
  std::deque<std::pair<int, double>> under_;
  int seen_ = 0;
  double voltage_V_ = 0.0, current_A_ = 0.0;
};

}  // namespace

void TestSquareResponse::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestSquareResponse::commandsThatComeLate_leaveTheTimeConstantAsItIs_data() {
  QTest::addColumn<int>("delay");
  QTest::addColumn<bool>("jitters");
  QTest::addColumn<double>("lost");
  QTest::newRow("next tick") << 1 << false << 0.0;
  QTest::newRow("a slice later") << 6 << false << 0.0;
  QTest::newRow("now sooner, now later") << 20 << true << 0.0;
  QTest::newRow("0.1 % lost") << 1 << false << 0.001;
  QTest::newRow("late and 1 % lost") << 20 << true << 0.01;
}

void TestSquareResponse::commandsThatComeLate_leaveTheTimeConstantAsItIs() {
  QFETCH(int, delay);
  QFETCH(bool, jitters);
  QFETCH(double, lost);
  const auto found = fitTimeConstant(LateWinding(delay, jitters, lost).measured());
  QVERIFY2(found.ok(), found.ok() ? "" : found.error().message().c_str());
  const double error = found->value / tau_s - 1.0;
  QVERIFY2(std::abs(error) < 0.03, qPrintable(QString::number(error)));
  QVERIFY(std::abs(found->value - tau_s) < 3.0 * found->standardError);
}

void TestSquareResponse::windingOverTheWire_hasItsTimeConstant_data() {
  QTest::addColumn<QString>("preset");
  QTest::addColumn<double>("spoiled");
  for (const char* preset : {"servo", "published-0134"}) QTest::addRow("%s", preset) << preset << 0.0;
  QTest::newRow("servo, pieces lost") << "servo" << 0.01;
}

void TestSquareResponse::windingOverTheWire_hasItsTimeConstant() {
  QFETCH(QString, preset);
  QFETCH(double, spoiled);
  const Rig rig = presetRig(preset.toStdString());
  const auto far = std::make_shared<FirmwareStream::Far>(rig, 1);
  const auto spoiling = std::make_shared<Spoiling>();
  auto stream = std::make_unique<SpoiledStream>(std::make_unique<FirmwareStream>(far), spoiling, 3);
  auto board = openBoardDrive(std::move(stream), {});
  QVERIFY(board.ok());
  spoiling->truncated = spoiled;
  WindingTestOptions options;
  options.ramps = 2;
  const auto test = std::make_shared<WindingTest>(options);
  (*board)->start(test);
  std::vector<Sample> samples;
  size_t lost = 0;
  while (test->state() == Procedure::State::running) {
    samples.clear();
    const auto missing = (*board)->advance(0.1, samples);
    QVERIFY2(missing.ok(), missing.ok() ? "" : missing.error().message().c_str());
    lost += *missing;
  }
  QVERIFY2(test->state() == Procedure::State::finished, test->status().failure.c_str());
  QCOMPARE(lost > 0, spoiled > 0.0);
  const auto found = fitTimeConstant(test->squareResponse());
  QVERIFY2(found.ok(), found.ok() ? "" : found.error().message().c_str());
  const double true_s = rig.inductance_H / rig.resistance_ohm;
  QVERIFY2(std::abs(found->value - true_s) < std::max(0.05 * true_s, 2.0 * found->standardError),
           qPrintable(QString("%1 s for %2 s").arg(found->value).arg(true_s)));
}

QTEST_GUILESS_MAIN(TestSquareResponse)
#include "tst_square_response.moc"
