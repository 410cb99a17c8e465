#include <QTest>
#include <algorithm>
#include <set>

#include "diagnose/diagnosed.h"
#include "diagnose/diagnosis.h"
#include "diagnose/effects/catalogue.h"
#include "recording/csv.h"
#include "support/real_recordings.h"
#include "support/sanitized.h"

using namespace breakaway;

/// M. Duclusaud, G. Passault et al., arXiv 2410.08650: a hobby servo that lifts a pendulum, by voltage. What they found
/// to matter most is friction that grows with the load.
class TestXl330Real : public QObject {
  Q_OBJECT
 private slots:
  void gearAndIron_areBothNamed();
  void rival_isListedOnce();

 private:
  static std::string folder() { return test::realRecordings() + "/bam_xl330/"; }
  static Bench bench() { return *readBench(folder() + "xl330.bench.json"); }
  static Recording read(const std::string& name) { return *readCsv(folder() + name + ".csv"); }
};

void TestXl330Real::gearAndIron_areBothNamed() {
  NEEDS_REAL_RECORDINGS();
  if (test::sanitized) QSKIP(test::likeOthers);
  std::vector<Recording> recordings;
  for (const char* motion : {"lift_and_drop", "sin_time_square", "up_and_down"}) {
    for (const char* gain : {"100", "400", "800"}) recordings.push_back(read(std::string(motion) + "_kp" + gain));
  }
  const auto diagnosis = diagnose(bench(), recordings, {}, {});
  QVERIFY(diagnosis);
  qInfo("%s", inWords(*diagnosis).c_str());
  const auto names = [&](const char* effect) {
    return std::any_of(diagnosis->findings.begin(), diagnosis->findings.end(),
                       [effect](const Finding& one) { return one.effect == effect; });
  };
  // Either alone stands for much of the other, and leaves three times the squared error of both.
  QVERIFY(names("load_dependent_friction"));
  QVERIFY(names("torque_saturation"));
  QVERIFY(diagnosis->fit.heldoutAfter < 0.5 * diagnosis->fit.heldoutBefore);
}

/// Friction that grows with the load is tried in the place of others in two shapes. What held-out data say of each
/// rival comes with it.
void TestXl330Real::rival_isListedOnce() {
  NEEDS_REAL_RECORDINGS();
  if (test::sanitized) QSKIP(test::likeOthers);
  const auto diagnosis = diagnose(bench(),
                                  {read("lift_and_drop_kp400"), read("up_and_down_kp400"),
                                   read("sin_time_square_kp400"), read("up_and_down_kp100")},
                                  {read("sin_time_square_kp100")}, {});
  QVERIFY(diagnosis && !diagnosis->findings.empty());
  for (const Finding& finding : diagnosis->findings) {
    const std::set<std::string> each(finding.ambiguousWith.begin(), finding.ambiguousWith.end());
    QCOMPARE(each.size(), finding.ambiguousWith.size());
    for (const std::string& name : finding.ambiguousWith) {
      const auto scored = std::count_if(finding.rivals.begin(), finding.rivals.end(),
                                        [&name](const RivalScore& one) { return one.effect == name; });
      QVERIFY2(scored == (name == findEffect(finding.effect)->twin() ? 0 : 1), name.c_str());
    }
  }
}

QTEST_APPLESS_MAIN(TestXl330Real)
#include "tst_xl330_real.moc"
