#include <QTest>
#include <cmath>

#include "control/duty_table.h"
#include "motor/bench.h"
#include "motor/duty_curve.h"
#include "support/temporary.h"

using namespace breakaway;

class TestDutyCurve : public QObject {
  Q_OBJECT
 private slots:
  void inverse_undoesTheCurve();
  void unknownCurve_givesWhatIsAsked();
  void deadZone_givesNothing();
  void beyondTheLastPoint_itGrowsAsTheDuty();
  void fallingCurve_doesNotRise();
  void board_invertsAsTheHostDoes();
  void benchFile_keepsTheCurve();
  void benchFile_refusesAFallingCurve();
};

namespace {

DutyCurve bent() {
  return {{{0.01, {}}, {0.02, {0.004, 1e-4}}, {0.05, {0.028, 1e-4}}, {0.2, {0.174, 1e-4}}}};
}

std::string benchText(const std::string& curve) {
  return R"({"schema": "breakaway.bench/1", "axis": "rotary", "drive": {"input": "current_A", "duty_curve": )" + curve +
         "}}";
}

}  // namespace

void TestDutyCurve::inverse_undoesTheCurve() {
  const DutyCurve curve = bent();
  for (int k = -100; k <= 100; ++k) {
    const double wanted = 0.0097 * k;
    QVERIFY(std::abs(curve.output(curve.input(wanted)) - wanted) < 1e-12);
  }
}

void TestDutyCurve::unknownCurve_givesWhatIsAsked() {
  QVERIFY(!DutyCurve{}.known() && DutyCurve{}.rises());
  QCOMPARE(DutyCurve{}.output(0.3), 0.3);
  QCOMPARE(DutyCurve{}.input(-0.3), -0.3);
}

void TestDutyCurve::deadZone_givesNothing() {
  QCOMPARE(bent().output(0.0099), 0.0);
  QCOMPARE(bent().output(-0.01), 0.0);
  QCOMPARE(bent().input(0.0), 0.0);
  QVERIFY(bent().input(1e-9) > 0.01 && bent().input(-1e-9) < -0.01);
}

void TestDutyCurve::beyondTheLastPoint_itGrowsAsTheDuty() {
  QVERIFY(std::abs(bent().output(0.7) - 0.674) < 1e-12);
  QVERIFY(std::abs(bent().output(-0.7) + 0.674) < 1e-12);
}

void TestDutyCurve::fallingCurve_doesNotRise() {
  QVERIFY(bent().rises());
  DutyCurve falls = bent();
  falls.points[2].output.value = 0.003;
  QVERIFY(!falls.rises());
  DutyCurve begins = bent();
  begins.points[0].output.value = 0.001;
  QVERIFY(!begins.rises());
}

void TestDutyCurve::board_invertsAsTheHostDoes() {
  const DutyCurve curve = bent();
  DutyTable<double> table;
  for (const DutyPoint& point : curve.points) {
    table.input[table.points] = point.input;
    table.output[table.points++] = point.output.value;
  }
  DutyInverse<double> inverse;
  QCOMPARE(inverse.inputFor(0.4), 0.4);
  inverse.take(table);
  for (int k = -100; k <= 100; ++k) QVERIFY(std::abs(inverse.inputFor(0.009 * k) - curve.input(0.009 * k)) < 1e-12);
}

void TestDutyCurve::benchFile_keepsTheCurve() {
  test::TemporaryFolder folder;
  const auto bench = readBenchText(benchText("[[0.01, 0, 0], [0.03, 0.015, 0.0001]]"), "b");
  QVERIFY2(bench.ok(), bench.ok() ? "" : bench.error().message().c_str());
  QVERIFY(writeBench(*bench, folder.path("b.json")).ok());
  const auto back = readBench(folder.path("b.json"));
  QVERIFY(back.ok() && back->dutyCurve.points.size() == 2);
  QCOMPARE(back->dutyCurve.points[1].output, (Estimate{0.015, 0.0001}));
}

void TestDutyCurve::benchFile_refusesAFallingCurve() {
  const auto bench = readBenchText(benchText("[[0.01, 0, 0], [0.03, -0.015, 0.0001]]"), "b.bench.json");
  QVERIFY(!bench.ok());
  QVERIFY2(bench.error().message().find("duty_curve") != std::string::npos, bench.error().message().c_str());
}

QTEST_APPLESS_MAIN(TestDutyCurve)
#include "tst_duty_curve.moc"
