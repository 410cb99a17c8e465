// Beliefs that contradict what is measured are found with their factor; honest ones are let be.
#include <QTest>
#include <cmath>

#include "motor/beliefs.h"

using namespace breakaway;

class TestBeliefs : public QObject {
  Q_OBJECT
 private slots:
  void honestBelief_isLetBe_data();
  void honestBelief_isLetBe();
  void wrongUnit_isNamed_data();
  void wrongUnit_isNamed();
  void doubtfulMeasurement_contradictsNobody();
  void doubtfulRatio_suggestsWhatItMayBe();
  void wrongSign_isNoFactor();
  void fileAgainstItself_isNamedByField();
};

namespace {

Belief belief(BeliefOf of, double ratio, bool trusted, double error = 0.01) {
  return {of, message("the bench's"), "field", 0.07 * ratio, trusted, {0.07, 0.07 * error}};
}

struct Named {
  const char* name;
  BeliefOf of;
};
constexpr Named all[] = {{"supply", BeliefOf::supply},
                         {"torque constant", BeliefOf::torqueConstant},
                         {"back-EMF constant", BeliefOf::backEmfConstant},
                         {"resistance", BeliefOf::resistance},
                         {"inductance", BeliefOf::inductance},
                         {"inertia", BeliefOf::inertia}};

}  // namespace

void TestBeliefs::honestBelief_isLetBe_data() {
  QTest::addColumn<int>("of");
  for (const Named& one : all) QTest::newRow(one.name) << static_cast<int>(one.of);
}

void TestBeliefs::honestBelief_isLetBe() {
  QFETCH(int, of);
  for (const bool trusted : {false, true}) {
    for (const double ratio : {0.75, 1.0, 1.3})
      QVERIFY(!contradictionOf(belief(static_cast<BeliefOf>(of), ratio, trusted), Axis::rotary));
  }
}

void TestBeliefs::wrongUnit_isNamed_data() {
  QTest::addColumn<int>("of");
  QTest::addColumn<double>("ratio");
  QTest::addColumn<QString>("words");
  const auto row = [](const char* name, BeliefOf of, double ratio, const char* words) {
    QTest::newRow(name) << static_cast<int>(of) << ratio << words;
  };
  row("Kt in mNm/A", BeliefOf::torqueConstant, 1030.0, "1030 times as much, as in mNm/A");
  row("Kt in kg cm/A", BeliefOf::torqueConstant, 10.2, "kg cm");
  row("Kt with rpm", BeliefOf::torqueConstant, 9.5493, "rpm");
  row("Kt with degrees", BeliefOf::torqueConstant, 57.296, "57.3 times as much, as with degrees");
  row("Kt by four", BeliefOf::torqueConstant, 4.0, "4 times as much");
  row("Kt twice", BeliefOf::torqueConstant, 2.0, "2 times as much");
  row("Kt half", BeliefOf::torqueConstant, 0.5, "0.5 times as much");
  row("Ke per rpm", BeliefOf::backEmfConstant, 1.0 / 9.5493, "V/rpm");
  row("Ke per 1000 rpm", BeliefOf::backEmfConstant, 104.72, "1000 rpm");
  row("R in milliohms", BeliefOf::resistance, 1e3, "milliohms");
  row("L in mH", BeliefOf::inductance, 1e3, "mH");
  row("J in g cm2", BeliefOf::inertia, 1.02e7, "g cm2");
  row("J in kg cm2", BeliefOf::inertia, 1e4, "kg cm2");
  row("another supply", BeliefOf::supply, 2.0, "supply");
  row("lines for edges", BeliefOf::counts, 0.25, "lines for edges");
  row("4000 for 4096", BeliefOf::counts, 4000.0 / 4096.0, "0.9766 times as much");
}

void TestBeliefs::wrongUnit_isNamed() {
  QFETCH(int, of);
  QFETCH(double, ratio);
  QFETCH(QString, words);
  const auto said = contradictionOf(belief(static_cast<BeliefOf>(of), ratio, false, 1e-4), Axis::rotary);
  QVERIFY(said);
  QVERIFY2(QString::fromStdString(*said).contains(words), said->c_str());
}

void TestBeliefs::doubtfulMeasurement_contradictsNobody() {
  QVERIFY(contradictionOf(belief(BeliefOf::torqueConstant, 2.0, false, 0.05), Axis::rotary));
  QVERIFY(!contradictionOf(belief(BeliefOf::torqueConstant, 2.0, false, 0.3), Axis::rotary));
}

/// Beyond its doubt, but not as near to a usual factor as a sure one would have to be.
void TestBeliefs::doubtfulRatio_suggestsWhatItMayBe() {
  const auto doubtful = contradictionOf(belief(BeliefOf::backEmfConstant, 2.9, false, 0.2), Axis::rotary);
  QVERIFY(doubtful && doubtful->find("four edges") != std::string::npos);
  const auto sure = contradictionOf(belief(BeliefOf::backEmfConstant, 2.9, false, 1e-3), Axis::rotary);
  QVERIFY(sure && sure->find("four edges") == std::string::npos);
}

void TestBeliefs::wrongSign_isNoFactor() {
  const auto said = contradictionOf(belief(BeliefOf::torqueConstant, -1.0, false), Axis::linear);
  QVERIFY(said && said->find("the sign is wrong") != std::string::npos);
}

void TestBeliefs::fileAgainstItself_isNamedByField() {
  Bench bench;
  bench.motor = {0.07, 0.07, 1.2, 0.0011, 6e-5, {}, {}};
  QVERIFY(!selfContradictionOf(bench));
  bench.motor.torqueConstant = 70.0;
  QCOMPARE(selfContradictionOf(bench)->place, std::string("torque_constant_Nm_per_A"));
  bench.motor.torqueConstant = 0.07;
  bench.motor.inertia = 600.0;
  QCOMPARE(selfContradictionOf(bench)->place, std::string("inertia_kg_m2"));
  bench.motor.resistance_ohm.reset();
  QVERIFY(!selfContradictionOf(bench));
}

QTEST_APPLESS_MAIN(TestBeliefs)
#include "tst_beliefs.moc"
