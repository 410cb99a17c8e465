#include <QTest>

#include "diagnose/diagnosis.h"
#include "support/foreign_rig.h"
#include "support/sanitized.h"

using namespace breakaway;

/// Rigs of a plant that shares nothing with ours, each of a kind that was misjudged once.
class TestForeignRigs : public QObject {
  Q_OBJECT
 private slots:
  void rig_getsItsAnswer_data();
  void rig_getsItsAnswer();
  void whatIsThereAllTheTime_isNoPush();
};

void TestForeignRigs::rig_getsItsAnswer_data() {
  QTest::addColumn<QString>("family");
  QTest::addColumn<int>("seed");
  QTest::addColumn<bool>("quick");  // for every change; the others by ./dev test thorough
  QTest::newRow("a current loop that lags") << "sound" << 7 << true;
  QTest::newRow("sines too quick for filters of torque") << "sound" << 9 << false;
  QTest::newRow("a winding while the rotor speeds up") << "sound" << 28 << true;
  QTest::newRow("a small pull beside a stiff drive") << "sound" << 24 << false;
  QTest::newRow("a measured current, late by most of a row") << "sound" << 53 << true;
  QTest::newRow("a winding that rows are too long to show") << "sound" << 40 << false;
  QTest::newRow("places too small to matter") << "sound" << 37 << false;
  QTest::newRow("winding and rotor ring faster than rows, some of which are missing") << "sound" << 131 << true;
  QTest::newRow("a place by friction that wanders slowly") << "sound" << 68 << false;
  QTest::newRow("an inertia that rows are too long to show, and friction that seems to settle")
      << "sound" << 293 << true;
  QTest::newRow("friction that wanders, and a controller that answers") << "sound" << 302 << false;
  QTest::newRow("a current loop that lags, beside a small pull") << "sound" << 305 << false;
  QTest::newRow("torque that seems to change from row to row") << "sound" << 26 << true;
  QTest::newRow("a stop, far from what the base foresees") << "end_stop" << 1 << true;
  QTest::newRow("an arm over less than a turn") << "imbalance" << 2 << false;
  QTest::newRow("friction near standstill, of any exponent") << "stribeck" << 47 << true;
  QTest::newRow("a delay that inertia could stand in for, but for no more than half of it")
      << "transport_delay" << 46 << false;
  QTest::newRow("a push that stands out, though all other stretches err, too") << "external_disturbance" << 54 << true;
  QTest::newRow("a load on a soft spring, which makes inertia seem to run away") << "compliance" << 61 << true;
  QTest::newRow("contacts that yield, which only simulation finds") << "presliding" << 47 << true;
}

void TestForeignRigs::rig_getsItsAnswer() {
  QFETCH(QString, family);
  QFETCH(int, seed);
  QFETCH(bool, quick);
  if (test::sanitized && seed != 7) QSKIP("takes too long under sanitizers: diagnoses like others");
  if (!quick && !test::thorough()) QSKIP(test::onlyThorough);
  const test::ForeignRig rig = test::foreignRig(family.toStdString(), static_cast<std::uint64_t>(seed));
  const auto diagnosis = diagnose(rig.bench, rig.recordings, {}, {});
  QVERIFY2(diagnosis, rig.words.c_str());
  std::string said = rig.words + ": " + nameOf(diagnosis->verdict);
  for (const Finding& finding : diagnosis->findings) said += " " + finding.effect;
  if (family == "sound") {
    QVERIFY2(diagnosis->verdict == Verdict::nothingMissing, said.c_str());
  } else {
    QVERIFY2(diagnosis->findings.size() == 1 && diagnosis->findings[0].effect == family.toStdString(), said.c_str());
  }
}

void TestForeignRigs::whatIsThereAllTheTime_isNoPush() {
  if (test::sanitized) QSKIP(test::likeOthers);
  // A command that acts late, where an axis goes from place to place: a push in one stretch would take up what it does
  // there, and nothing of what it does in all others.
  const test::ForeignRig rig = test::foreignRig("transport_delay", 43);
  const auto diagnosis = diagnose(rig.bench, rig.recordings, {}, {});
  QVERIFY2(diagnosis, rig.words.c_str());
  for (const Finding& finding : diagnosis->findings) QVERIFY(finding.effect != "external_disturbance");
}

QTEST_APPLESS_MAIN(TestForeignRigs)
#include "tst_foreign_rigs.moc"
