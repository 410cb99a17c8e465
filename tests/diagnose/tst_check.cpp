// What a check promises of a recording, a diagnosis keeps; what is poor in its channels is said.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>
#include <cmath>

#include "base/numbers.h"
#include "base/random.h"
#include "diagnose/check/check.h"
#include "diagnose/diagnosis.h"
#include "diagnose/effects/catalogue.h"
#include "support/driven_recording.h"
#include "support/known_servo.h"
#include "support/recorded_rig.h"
#include "support/sanitized.h"

using namespace breakaway;
using namespace breakaway::test;

class TestCheck : public QObject {
  Q_OBJECT
 private slots:
  void smallestSize_isWhereADiagnosisBegins_data();
  void smallestSize_isWhereADiagnosisBegins();
  void wander_raisesTheLimit();
  void whatTheMotionLacks_isSaidWithItsExperiment();
  void soundChannels_getNoComplaint();
  void poorChannels_areSaid_data();
  void poorChannels_areSaid();
  void wrongScale_comesFirst();
  void json_holdsEveryEffect();
};

namespace {

constexpr double count = turn_rad / 14400.0;

/// The servo with `effects`, driven this way and that over whole turns, through an encoder of 14400 counts.
Recording recorded(DriveInput input, const std::vector<EffectTerm>& effects, double seconds = 20.0) {
  Model model = servoModel(input);
  model.effects = effects;
  const Recording exact = drivenRecording(model, {.seconds = secondsToFit(seconds), .hold_s = 0.02, .size = 1.5});
  std::vector<Channel> channels = exact.channels();
  for (Channel& one : channels) {
    if (one.name != "angle_rad") continue;
    for (double& value : one.values) value = count * std::floor(value / count);
  }
  return *Recording::seal("r.csv", channels);
}

Bench benchOf(DriveInput input) {
  Bench bench;
  bench.input = input;
  bench.countsPerUnit = 14400.0;
  bench.motor = {0.07, 0.07, 1.2, 0.0011, 7e-5, {}, 0.01};
  if (input == DriveInput::torque) bench.motor = {{}, {}, {}, {}, 7e-5, {}, 0.01};
  if (input != DriveInput::torque) bench.trusted = {"torque_constant_Nm_per_A"};
  return bench;
}

Check checked(const Bench& bench, const Recording& recording) {
  auto found = check(bench, {recording});
  if (!found) qFatal("%s", found.error().message().c_str());
  return std::move(*found);
}

const Sight& sightOf(const Check& check, const std::string& effect) {
  for (const Sight& one : check.effects) {
    if (one.effect->name() == effect) return one;
  }
  qFatal("%s is no effect", effect.c_str());
}

bool finds(const Bench& bench, const Recording& recording, const std::string& effect) {
  const auto diagnosis = diagnose(bench, {recording}, {}, {});
  if (!diagnosis) qFatal("%s", diagnosis.error().message().c_str());
  const std::string twin(findEffect(effect)->twin());
  return std::any_of(diagnosis->findings.begin(), diagnosis->findings.end(),
                     [&](const Finding& one) { return one.effect == effect || one.effect == twin; });
}

/// The effect at its smallest size times `factor`.
EffectTerm sized(const Sight& sight, double factor) {
  EffectTerm term{std::string(sight.effect->name()), sight.smallest};
  Parameter& first = term.parameters.front();
  first.value = first.low95 = first.high95 = first.value * factor;
  return term;
}

bool complains(const Check& check, const char* words) {
  return std::any_of(check.channelWords.begin(), check.channelWords.end(),
                     [words](const std::string& one) { return one.find(words) != std::string::npos; });
}

}  // namespace

void TestCheck::smallestSize_isWhereADiagnosisBegins_data() {
  QTest::addColumn<int>("input");
  QTest::addColumn<QString>("effect");
  const auto add = [](const char* drive, DriveInput input, const char* effect) {
    QTest::addRow("%s, %s", drive, effect) << static_cast<int>(input) << effect;
  };
  for (const char* effect : {"stribeck", "transport_delay"}) add("torque", DriveInput::torque, effect);
  add("voltage", DriveInput::voltage, "dead_time");
  if (!thorough()) return;
  for (const char* effect : {"constant_load", "cogging", "quadratic_drag"}) add("torque", DriveInput::torque, effect);
  add("voltage", DriveInput::voltage, "viscous_asymmetry");
}

void TestCheck::smallestSize_isWhereADiagnosisBegins() {
  if (sanitized) QSKIP("numbers of short recordings say nothing");
  QFETCH(int, input);
  QFETCH(QString, effect);
  const auto drive = static_cast<DriveInput>(input);
  const Bench bench = benchOf(drive);
  const Check check = checked(bench, recorded(drive, {}));
  const Sight& sight = sightOf(check, effect.toStdString());
  QVERIFY2(sight.shown(), sight.why.c_str());
  qInfo("from %g (%s)", sight.smallest.front().value, nameOf(sight.limit));
  QVERIFY(finds(bench, recorded(drive, {sized(sight, 8.0)}), effect.toStdString()));
  QVERIFY(!finds(bench, recorded(drive, {sized(sight, 0.25)}), effect.toStdString()));
}

void TestCheck::wander_raisesTheLimit() {
  if (sanitized) QSKIP("numbers of short recordings say nothing");
  const auto still = recordRig({.seconds = 20.0}), wanders = recordRig({.seconds = 20.0, .wander_Nm = 4e-4});
  const Check quiet = checked(still.bench, still.recording), restless = checked(wanders.bench, wanders.recording);
  const Sight &before = sightOf(quiet, "cogging"), &after = sightOf(restless, "cogging");
  QVERIFY(before.shown() && after.shown());
  QVERIFY2(*after.torque > 1.5 * *before.torque,
           qPrintable(QString("%1 after %2").arg(*after.torque).arg(*before.torque)));
}

void TestCheck::whatTheMotionLacks_isSaidWithItsExperiment() {
  // To and fro over a fifth of a turn, without the current: neither a turn's waves nor the current sensor show.
  Model model = servoModel(DriveInput::voltage);
  const Recording recording =
      drivenRecording(model, {.seconds = secondsToFit(12.0), .hold_s = 0.004, .size = 0.6, .current = false});
  const Check check = checked(benchOf(DriveInput::voltage), recording);
  const std::string words = inWords(check);
  for (const char* effect : {"current_sensor_offset", "channel_skew"}) {
    const Sight& sight = sightOf(check, effect);
    QVERIFY2(!sight.shown(), effect);
    QVERIFY(!sight.why.empty() && !sight.experiment.empty());
    QVERIFY2(words.find(std::string("Can't show ") + effect) != std::string::npos, words.c_str());
    QVERIFY(words.find(sight.experiment) != std::string::npos);
  }
}

void TestCheck::soundChannels_getNoComplaint() {
  const Check check = checked(benchOf(DriveInput::torque), recorded(DriveInput::torque, {}));
  for (const std::string& one : check.channelWords) qInfo("%s", one.c_str());
  QCOMPARE(check.channelWords.size(), size_t(2));
  const ChannelQuality& channels = check.channels.front();
  QVERIFY(std::abs(channels.rate_Hz - 1000.0) < 1e-6);
  QVERIFY(std::abs(channels.readingStep / count - 1.0) < 1e-6);
  QVERIFY(channels.driveReverses && static_cast<double>(channels.reversals) > 0.5 * channels.duration_s &&
          channels.missingRows == 0);
}

void TestCheck::poorChannels_areSaid_data() {
  QTest::addColumn<QString>("what");
  QTest::addColumn<QString>("words");
  QTest::newRow("missing") << "missing"
                           << "rows are missing";
  QTest::newRow("clipped") << "clipped"
                           << "stand at the largest or smallest torque_Nm";
  QTest::newRow("repeated") << "repeated"
                            << "of the rows repeat the one before";
  QTest::newRow("coarse") << "coarse"
                          << "of the counts that the bench declares";
  QTest::newRow("slow") << "slow"
                        << "50 Hz is slow";
}

void TestCheck::poorChannels_areSaid() {
  QFETCH(QString, what);
  QFETCH(QString, words);
  std::vector<Channel> channels = recorded(DriveInput::torque, {}, 40.0).channels();
  const auto column = [&channels](const char* name) -> std::vector<double>& {
    return std::find_if(channels.begin(), channels.end(), [name](const Channel& one) { return one.name == name; })
        ->values;
  };
  const auto keep = [&channels](auto holds) {
    for (Channel& one : channels) {
      std::vector<double> kept;
      for (size_t k = 0; k < one.values.size(); ++k) {
        if (holds(k)) kept.push_back(one.values[k]);
      }
      one.values = kept;
    }
  };
  const size_t quarter = channels[0].values.size() / 4;
  if (what == "missing") keep([=](size_t k) { return k < 3 * quarter || k % (quarter / 5) > 20; });
  if (what == "clipped")
    for (double& one : column("torque_Nm")) one = std::clamp(one, -0.02, 0.02);
  if (what == "repeated")
    for (size_t k = 0; k < column("angle_rad").size(); ++k) column("angle_rad")[k] = column("angle_rad")[k - k % 4];
  if (what == "coarse")
    for (double& one : column("angle_rad")) one = 8.0 * count * std::floor(one / (8.0 * count));
  if (what == "slow") keep([](size_t k) { return k % 20 == 0; });
  const Check check = checked(benchOf(DriveInput::torque), *Recording::seal("r.csv", channels));
  for (const std::string& one : check.channelWords) qInfo("%s", one.c_str());
  QVERIFY(complains(check, words.toUtf8().constData()));
}

void TestCheck::wrongScale_comesFirst() {
  auto rig = recordRig({.seconds = 10.0, .currentDrive = true, .voltageToo = true});
  std::vector<Channel> channels = rig.recording.channels();
  for (double& one : channels[1].values) one *= 57.29578;
  const Check check = checked(rig.bench, *Recording::seal("r.csv", channels));
  QVERIFY(check.misread);
  QVERIFY(inWords(check).starts_with("Misread: r.csv: angle_rad is 57.3 times too large, as in degrees"));
}

void TestCheck::json_holdsEveryEffect() {
  const Check check = checked(benchOf(DriveInput::torque), recorded(DriveInput::torque, {}));
  const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(checkJson(check))).object();
  QCOMPARE(json["schema"].toString(), QString("breakaway.check/1"));
  QVERIFY(json["misread"].isNull());
  const QJsonArray effects = json["effects"].toArray();
  QCOMPARE(static_cast<size_t>(effects.size()), catalogue().size());
  for (const auto& one : effects) {
    const QJsonObject effect = one.toObject();
    const bool shown = effect["shown"].toBool();
    QCOMPARE(shown, !effect["smallest"].toObject().isEmpty());
    QCOMPARE(shown, effect["why_not"].toString().isEmpty());
    QVERIFY(!shown || !effect["experiment"].toString().isEmpty());
  }
  QCOMPARE(json["channels"].toArray().size(), 1);
  QVERIFY(json["floor"].toDouble() > 0.0 && json["error"].toDouble() > 0.0);
}

QTEST_GUILESS_MAIN(TestCheck)
#include "tst_check.moc"
