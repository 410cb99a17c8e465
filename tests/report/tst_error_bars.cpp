#include <QTest>

#include "report/error_bars.h"

using namespace breakaway;

/// What is said of a finding's rivals, and in which order they stand.
class TestErrorBars : public QObject {
  Q_OBJECT
 private slots:
  void rivals_inOneSentence_data();
  void rivals_inOneSentence();
  void bars_areOfAllThatWasFitted();
};

namespace {

RivalScore rivalOf(const std::string& effect, double ratio, double low, double high) {
  return {effect, 2e-3 * ratio, 2e-3 * low, 2e-3 * high, ratio, low, high};
}

}  // namespace

void TestErrorBars::rivals_inOneSentence_data() {
  QTest::addColumn<QStringList>("ambiguousWith");
  QTest::addColumn<std::vector<RivalScore>>("rivals");
  QTest::addColumn<QString>("says");
  QTest::addColumn<QString>("saysNot");
  const std::vector<RivalScore> none;
  QTest::newRow("none came near") << QStringList() << none << "No other effect came near"
                                  << "can't be told";
  QTest::newRow("the twin, which nothing tells from it, needn't be fitted")
      << QStringList{"coulomb_asymmetry"} << none << "errs as it does"
      << "came near";
  QTest::newRow("those that weren't tried in time err as nobody knows")
      << QStringList{"stribeck", "cogging"} << none << "wasn't fitted in its place"
      << "errs as it does";
  QTest::newRow("one that errs alike") << QStringList{"cogging"}
                                       << std::vector{rivalOf("cogging", 1.02, 0.97, 1.08),
                                                      rivalOf("stribeck", 1.5, 1.2, 1.9)}
                                       << "can't tell it from"
                                       << "The nearest";
  QTest::newRow("all err more: the nearest")
      << QStringList() << std::vector{rivalOf("stribeck", 1.5, 1.2, 1.9), rivalOf("cogging", 3.0, 2.0, 4.0)}
      << "errs 1.5 times as much on held-out data (95 % interval 1.2 to 1.9)"
      << "can't tell";
}

void TestErrorBars::rivals_inOneSentence() {
  QFETCH(QStringList, ambiguousWith);
  QFETCH(std::vector<RivalScore>, rivals);
  QFETCH(QString, says);
  QFETCH(QString, saysNot);
  Finding finding;
  finding.effect = "constant_load";
  for (const QString& one : ambiguousWith) finding.ambiguousWith.push_back(one.toStdString());
  finding.rivals = rivals;
  const QString text = QString::fromStdString(std::string(rivalSentence(finding)));
  QVERIFY2(text.contains(says), qPrintable(text));
  QVERIFY2(!text.contains(saysNot), qPrintable(text));
}

void TestErrorBars::bars_areOfAllThatWasFitted() {
  Diagnosis diagnosis;
  diagnosis.fit.heldoutBefore = 5e-3;
  diagnosis.fit.heldoutAfter = 2e-3;
  diagnosis.fit.floor = 1e-3;
  Finding finding;
  finding.effect = "cogging";
  finding.rivals = {rivalOf("stribeck", 1.5, 1.2, 1.9), rivalOf("imbalance", 2.0, 1.6, 2.4)};
  const auto bars = rivalBars(diagnosis, finding);
  using Of = ErrorBar::Of;
  QCOMPARE(bars.size(), size_t{5});
  const Of order[] = {Of::found, Of::rival, Of::rival, Of::base, Of::floor};
  const double errors[] = {2e-3, 3e-3, 4e-3, 5e-3, 1e-3};
  for (size_t k = 0; k < bars.size(); ++k) {
    QVERIFY(bars[k].of == order[k]);
    QCOMPARE(bars[k].error, errors[k]);
  }
  QVERIFY(bars[1].rival != nullptr && bars[1].rival->effect == "stribeck");
}

QTEST_APPLESS_MAIN(TestErrorBars)
#include "tst_error_bars.moc"
