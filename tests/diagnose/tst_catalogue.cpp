#include <QRegularExpression>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <string>

#include "diagnose/effects/catalogue.h"
#include "diagnose/verdict/worth_saying.h"
#include "support/known_servo.h"
#include "support/rich_excitation.h"
#include "support/within.h"

using namespace breakaway;
using namespace breakaway::test;

Q_DECLARE_METATYPE(const breakaway::Effect*)
Q_DECLARE_METATYPE(breakaway::Excitation)

/// What every entry of the catalogue must hold, whichever physics it stands for.
class TestCatalogue : public QObject {
  Q_OBJECT
 private slots:
  void names_areThoseOfTheContract();
  void entry_saysFormulaAndSource_data() { effects(); }
  void entry_saysFormulaAndSource();
  void parameters_endInTheirUnit_data() { effects(); }
  void parameters_endInTheirUnit();
  void lookAlikes_areOtherEntries_data() { effects(); }
  void lookAlikes_areOtherEntries();
  void tells_haveBothSides_data() { effects(); }
  void tells_haveBothSides();
  void parts_belongTogether_data() { effects(); }
  void parts_belongTogether();
  void twins_areMutual_data() { effects(); }
  void twins_areMutual();
  void richData_givesShapes_data() { effects(); }
  void richData_givesShapes();
  void poorData_givesNoShapeOutOfBounds_data() { effects(); }
  void poorData_givesNoShapeOutOfBounds();
  void shapes_areWithinBounds_data() { effectsOnAllDrives(); }
  void shapes_areWithinBounds();
  void amplitude_scalesWhatTheEffectDoes_data() { effectsOnAllDrives(); }
  void amplitude_scalesWhatTheEffectDoes();
  void words_areWholeAndFinite_data() { effectsOnAllDrives(); }
  void words_areWholeAndFinite();
  void wrongSign_isNotPlausible();
  void whatTheTravelDoesNotShow_isNotPlausible();
  void waveOverATravel_hasOvertones();
  void aReadingWithinItsRow_isNoSkew();
  void heatOfTheUsualCurrent_isWhatCounts();
  void pushThatMayBeginAfterItsEnd_saysNothing();

 private:
  static void effects();
  static void effectsOnAllDrives();
};

namespace {

constexpr std::array contractNames{"coulomb_asymmetry",
                                   "viscous_asymmetry",
                                   "stribeck",
                                   "presliding",
                                   "quadratic_drag",
                                   "position_dependent_friction",
                                   "position_dependent_viscous",
                                   "load_dependent_friction",
                                   "friction_warmup",
                                   "rising_stiction",
                                   "constant_load",
                                   "imbalance",
                                   "cogging",
                                   "torque_ripple",
                                   "torque_saturation",
                                   "dead_time",
                                   "current_sensor_offset",
                                   "winding_heating",
                                   "supply_sag",
                                   "encoder_eccentricity",
                                   "command_saturation",
                                   "backlash",
                                   "compliance",
                                   "end_stop",
                                   "transport_delay",
                                   "channel_skew",
                                   "external_disturbance"};

/// Without a unit of their own; the limit and the slew are in the drive input's.
const std::set<std::string> pureNumbers{"known_load_part", "order", "exponent", "damping_ratio", "side",
                                        "coefficient",     "limit"};

/// The first parameter out of its bounds or not finite, in words; empty: none.
QString outOfBounds(const Effect& effect, const std::vector<double>& p, Axis axis) {
  const auto specs = effect.parameters(axis);
  if (specs.size() != p.size()) return QString("%1 values").arg(p.size());
  for (size_t k = 0; k < p.size(); ++k) {
    if (!std::isfinite(p[k]) || p[k] < specs[k].lower || p[k] > specs[k].upper)
      return QString("%1 = %2").arg(specs[k].name.c_str()).arg(p[k]);
  }
  return {};
}

/// Everything an effect does at one instant: load, friction, lost voltage, and what encoder and current sensor add.
std::array<double, 5> deedsOf(const Effect& effect, const std::vector<double>& p, Situation at) {
  const std::array<double, 4> memory{0.5, -0.3, at.velocity, at.time_s};
  if (const HiddenState* hidden = effect.hidden()) at.memory = std::span(memory).first(hidden->size());
  const Term term = effect.term(p, at);
  const EncoderPart* encoder = effect.encoder();
  const CurrentSensorPart* sensor = effect.currentSensor();
  return {term.load_Nm, term.friction_Nm, term.voltage_V,
          encoder != nullptr ? encoder->shown(p, at.position) - at.position : 0.0,
          sensor != nullptr ? sensor->sensed(p, at.current, 40.0) - at.current : 0.0};
}

/// A moment in which most effects do something.
Situation moment(int k) {
  Situation at;
  at.time_s = 0.7 + 1.3 * k;
  at.position = -7.9 + 1.1 * k;
  at.velocity = (k % 2 == 0 ? 1.0 : -1.0) * (0.2 + 0.9 * k);
  at.acceleration = 30.0 - 7.0 * k;
  at.direction = k % 2 == 0 ? 1.0 : -1.0;
  at.current = at.direction * (0.1 + 0.05 * k);
  at.driveTorque = 0.07 * at.current;
  at.input = 1.5 * at.current;
  at.supply_V = 24.0;
  at.rest_s = 0.4;
  at.travel = 0.3 * k;
  return at;
}

void verifyWords(const std::string& text, bool sentence) {
  const QString words = QString::fromStdString(text);
  static const QRegularExpression broken(R"(\b-?(nan|inf)\b|%[sdgf])", QRegularExpression::CaseInsensitiveOption);
  QVERIFY2(words.size() > (sentence ? 20 : 3), text.c_str());
  QVERIFY2(!broken.match(words).hasMatch(), text.c_str());
  if (sentence) QVERIFY2(words.endsWith('.') && words.front().isUpper() && !words.contains("  "), text.c_str());
}

}  // namespace

void TestCatalogue::effects() {
  QTest::addColumn<const Effect*>("effect");
  for (const Effect* effect : catalogue()) QTest::newRow(std::string(effect->name()).c_str()) << effect;
}

void TestCatalogue::effectsOnAllDrives() {
  QTest::addColumn<const Effect*>("effect");
  QTest::addColumn<Excitation>("seen");
  const std::pair<const char*, Excitation> drives[]{{"voltage", richExcitation(DriveInput::voltage)},
                                                    {"current", richExcitation(DriveInput::current)},
                                                    {"torque", richExcitation(DriveInput::torque)},
                                                    {"force", richExcitation(DriveInput::torque, Axis::linear)}};
  for (const Effect* effect : catalogue()) {
    for (const auto& [name, seen] : drives)
      QTest::newRow((std::string(effect->name()) + ", " + name).c_str()) << effect << seen;
  }
}

void TestCatalogue::names_areThoseOfTheContract() {
  std::set<std::string_view> names;
  for (const Effect* effect : catalogue()) {
    QVERIFY(names.insert(effect->name()).second);
    QCOMPARE(findEffect(effect->name()), effect);
  }
  QCOMPARE(names, std::set<std::string_view>(contractNames.begin(), contractNames.end()));
  QVERIFY(findEffect("coging") == nullptr);
}

void TestCatalogue::entry_saysFormulaAndSource() {
  QFETCH(const Effect*, effect);
  verifyWords(std::string(effect->formula()), false);
  QVERIFY(effect->formula().find('=') != std::string_view::npos ||
          effect->formula().find("→") != std::string_view::npos ||
          effect->formula().find("≤") != std::string_view::npos);
  const std::string source(effect->source());
  verifyWords(source, false);
  // An author, a title and a year.
  static const QRegularExpression year(R"(\b(19|20)\d\d\b)");
  QVERIFY2(source.find('\'') != std::string::npos && year.match(source.c_str()).hasMatch(), source.c_str());
}

void TestCatalogue::parameters_endInTheirUnit() {
  QFETCH(const Effect*, effect);
  static const QRegularExpression unit(
      "_(Nm|N|rad|m|s|V|A|ohm|kg|kg_m2|rad_per_s|m_per_s|Nm_per_rad|N_per_m|Nm_s_per_rad|N_s_per_m|Nm_s2_per_rad2|"
      "N_s2_per_m2|ohm_per_A2|per_A2|per_s)$");
  for (const Axis axis : {Axis::rotary, Axis::linear}) {
    const auto specs = effect->parameters(axis);
    QVERIFY(!specs.empty());
    std::set<std::string> names;
    for (const ParameterSpec& spec : specs) {
      QVERIFY2(names.insert(spec.name).second, spec.name.c_str());
      QVERIFY2(spec.lower < spec.upper, spec.name.c_str());
      const bool pure = pureNumbers.contains(spec.name) ||
                        (effect->name() == "torque_ripple" && spec.name == "amplitude");  // relative
      QVERIFY2(pure || unit.match(spec.name.c_str()).hasMatch(), spec.name.c_str());
      if (axis == Axis::linear) QVERIFY2(spec.name.find("_Nm") == std::string::npos, spec.name.c_str());
    }
  }
}

void TestCatalogue::lookAlikes_areOtherEntries() {
  QFETCH(const Effect*, effect);
  const auto others = effect->lookAlikes();
  QVERIFY(!others.empty());
  for (const std::string_view other : others) {
    QVERIFY2(findEffect(other) != nullptr, std::string(other).c_str());
    QVERIFY(other != effect->name());
    QCOMPARE(std::count(others.begin(), others.end(), other), std::ptrdiff_t(1));
  }
}

void TestCatalogue::tells_haveBothSides() {
  QFETCH(const Effect*, effect);
  for (const Tell& tell : effect->tells()) {
    const Effect* other = findEffect(tell.beside);
    QVERIFY2(other != nullptr && other != effect, std::string(tell.beside).c_str());
    const auto back = other->tells();
    const auto it =
        std::find_if(back.begin(), back.end(), [effect](const Tell& one) { return one.beside == effect->name(); });
    QVERIFY2(it != back.end() && it->sign != tell.sign && !it->sign.empty(), std::string(tell.beside).c_str());
  }
}

void TestCatalogue::parts_belongTogether() {
  QFETCH(const Effect*, effect);
  if (effect->load() != nullptr) QVERIFY(effect->hidden() != nullptr && effect->hidden()->size() >= 2);
  if (effect->hidden() != nullptr) QVERIFY(effect->hidden()->size() <= 4);
  if (const CurrentSensorPart* sensor = effect->currentSensor(); sensor != nullptr && !sensor->sameForMotion().empty())
    QVERIFY(findEffect(sensor->sameForMotion()) != nullptr && effect->parameters(Axis::rotary).size() == 1);
  if (const OncePart* once = effect->once()) {
    const auto specs = effect->parameters(Axis::rotary);
    QVERIFY(once->start != once->duration && once->start < specs.size() && once->duration < specs.size());
    QVERIFY(specs[once->start].name.ends_with("_s") && specs[once->duration].name.ends_with("_s"));
  }
}

void TestCatalogue::twins_areMutual() {
  QFETCH(const Effect*, effect);
  const bool expected = effect->name() == "constant_load" || effect->name() == "coulomb_asymmetry";
  QCOMPARE(!effect->twin().empty(), expected);
  if (!expected) return;
  const Effect* twin = findEffect(effect->twin());
  QVERIFY(twin != nullptr && twin != effect);
  QCOMPARE(twin->twin(), effect->name());
}

void TestCatalogue::richData_givesShapes() {
  QFETCH(const Effect*, effect);
  // Voltage with current shows all but what belongs to a current drive alone.
  const auto shapes = effect->shapes(richExcitation(DriveInput::voltage));
  QVERIFY(!shapes.empty());
  QVERIFY2(shapes.size() < 200, qPrintable(QString::number(shapes.size())));
}

void TestCatalogue::poorData_givesNoShapeOutOfBounds() {
  QFETCH(const Effect*, effect);
  for (const Axis axis : {Axis::rotary, Axis::linear}) {
    Excitation still;
    still.axis = axis;
    still.step_s = 1e-3;
    for (const Shape& shape : effect->shapes(still)) {
      for (const auto& set : shape)
        QVERIFY2(outOfBounds(*effect, set, axis).isEmpty(), qPrintable(outOfBounds(*effect, set, axis)));
    }
  }
}

void TestCatalogue::shapes_areWithinBounds() {
  QFETCH(const Effect*, effect);
  QFETCH(Excitation, seen);
  for (const Shape& shape : effect->shapes(seen)) {
    QVERIFY(!shape.empty() && shape.size() <= 2);
    for (const auto& set : shape) {
      const QString wrong = outOfBounds(*effect, set, seen.axis);
      QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    }
    const std::vector<double> whole = effect->scaled(shape, std::vector<double>(shape.size(), 0.7));
    QVERIFY2(outOfBounds(*effect, whole, seen.axis).isEmpty(), qPrintable(outOfBounds(*effect, whole, seen.axis)));
    // A size to start from has to make sense, too.
    const std::vector<double> one = effect->scaled(shape, std::vector<double>(shape.size(), 0.5));
    QVERIFY2(effect->plausible(one, seen), effect->sentence(one, seen).c_str());
    for (const auto& variant : effect->variants(one, seen)) QVERIFY(outOfBounds(*effect, variant, seen.axis).isEmpty());
  }
}

void TestCatalogue::amplitude_scalesWhatTheEffectDoes() {
  QFETCH(const Effect*, effect);
  QFETCH(Excitation, seen);
  const std::set<std::string_view> ofShapeOnly{"presliding", "command_saturation", "transport_delay"};
  if (ofShapeOnly.contains(effect->name())) return;  // nothing in them is an amplitude
  const auto shapes = effect->shapes(seen);
  bool acts = shapes.empty() || effect->input(DriveInput::current) != nullptr;
  for (size_t s = 0; s < shapes.size(); s += 1 + shapes.size() / 12) {
    const Shape& shape = shapes[s];
    const std::vector<double> amplitude = shape.size() == 2 ? std::vector{0.4, -0.3} : std::vector{0.4};
    const std::vector<double> p = effect->scaled(shape, amplitude);
    QCOMPARE(p.size(), effect->parameters(seen.axis).size());
    for (int k = 0; k < 18; ++k) {
      Situation at = moment(k);
      at.axis = seen.axis;
      const auto whole = deedsOf(*effect, p, at);
      std::array<double, 5> sum{}, size{};
      for (size_t a = 0; a < shape.size(); ++a) {
        const auto part = deedsOf(*effect, shape[a], at);
        for (size_t d = 0; d < sum.size(); ++d) {
          sum[d] += amplitude[a] * part[d];
          size[d] += std::abs(part[d]);
        }
      }
      for (size_t d = 0; d < sum.size(); ++d) {
        COMPARE_WITHIN(whole[d], sum[d], 1e-9 * size[d] + 1e-13);
        acts = acts || std::abs(whole[d]) > 1e-9;
      }
    }
  }
  QVERIFY(acts);
}

void TestCatalogue::words_areWholeAndFinite() {
  QFETCH(const Effect*, effect);
  QFETCH(Excitation, seen);
  verifyWords(effect->neededExcitation(seen), true);
  const std::set<std::string_view> axes{"velocity", "angle", "time", "current", "travel", "frequency", ""};
  QVERIFY2(axes.contains(effect->drawnOver()), std::string(effect->drawnOver()).c_str());
  for (const Shape& shape : effect->shapes(seen)) {
    const std::string text = effect->sentence(effect->scaled(shape, std::vector<double>(shape.size(), 0.7)), seen);
    verifyWords(text, true);
    const auto words = QString::fromStdString(text).split(' ');
    const bool number = std::any_of(words.begin(), words.end(), [](const QString& word) {
      return std::any_of(word.begin(), word.end(), [](QChar c) { return c.isDigit(); });
    });
    QVERIFY2(number || text.find("once per turn") != std::string::npos, text.c_str());
    if (QTest::currentTestFailed()) return;
  }
}

void TestCatalogue::wrongSign_isNotPlausible() {
  const Excitation seen = richExcitation(DriveInput::voltage);
  for (const char* name : {"stribeck", "load_dependent_friction", "friction_warmup", "rising_stiction", "dead_time",
                           "winding_heating", "end_stop", "compliance", "backlash", "supply_sag"}) {
    const Effect& effect = *findEffect(name);
    const Shape shape = effect.shapes(seen).front();
    const std::vector<double> up{1.0}, down{-1.0};
    QVERIFY2(effect.plausible(effect.scaled(shape, up), seen), name);
    QVERIFY2(!effect.plausible(effect.scaled(shape, down), seen), name);
  }
}

/// A wave longer than the travel is any spring's, and what begins in the middle is no end.
void TestCatalogue::whatTheTravelDoesNotShow_isNotPlausible() {
  Excitation seen = richExcitation(DriveInput::torque);
  seen.axis = Axis::linear;
  const std::vector<double> whole{0.1 * seen.peakTorque, 0.3, 0.8 * seen.travel};
  const std::vector<double> part{0.1 * seen.peakTorque, 0.3, 1.3 * seen.travel};
  QVERIFY(findEffect("cogging")->plausible(whole, seen));
  QVERIFY(!findEffect("cogging")->plausible(part, seen));
  const double stiffness = seen.peakTorque / seen.travel;
  const std::vector<double> end{stiffness, seen.highest - 0.2 * seen.travel, 1.0, 0.0};
  const std::vector<double> middle{stiffness, seen.highest - 0.5 * seen.travel, 1.0, 0.0};
  QVERIFY(findEffect("end_stop")->plausible(end, seen));
  QVERIFY(!findEffect("end_stop")->plausible(middle, seen));
}

/// What repeats over a travel is seldom one wave; on a rotor the orders are tried one by one.
void TestCatalogue::waveOverATravel_hasOvertones() {
  Excitation seen = richExcitation(DriveInput::torque);
  const Effect& cogging = *findEffect("cogging");
  QVERIFY(cogging.besides(std::vector<double>{0.1 * seen.peakTorque, 0.3, 2.0}, seen).empty());
  seen.axis = Axis::linear;
  const double period = 0.6 * seen.travel;
  const auto others = cogging.besides(std::vector<double>{0.1 * seen.peakTorque, 0.3, period}, seen);
  QCOMPARE(others.size(), size_t(2));  // twice and three times as long is longer than the travel
  for (const auto& one : others) QVERIFY(one[2] < period && cogging.plausible(one, seen));
}

/// When within its row a measured current was read is the base's; a commanded one has no such freedom.
void TestCatalogue::aReadingWithinItsRow_isNoSkew() {
  Excitation seen = richExcitation(DriveInput::current);
  const std::vector<double> half{0.5 * seen.step_s}, two{2.0 * seen.step_s};
  const Effect& skew = *findEffect("channel_skew");
  QVERIFY(skew.plausible(half, seen) && skew.plausible(two, seen));
  seen.driveMeasured = true;
  QVERIFY(!skew.plausible(half, seen) && skew.plausible(two, seen));
}

/// Reversals under voltage give short peaks, which heat nothing.
void TestCatalogue::heatOfTheUsualCurrent_isWhatCounts() {
  Excitation seen = richExcitation(DriveInput::voltage);
  const double cold = seen.peakInput / seen.peakCurrent;
  const std::vector<double> warm{0.5 * cold / std::pow(seen.usualCurrent, 2), 10.0};
  seen.peakCurrent *= 10.0;
  QVERIFY(findEffect("winding_heating")->plausible(warm, seen));
  const std::vector<double> burnt{20.0 * cold / std::pow(seen.usualCurrent, 2), 10.0};
  QVERIFY(!findEffect("winding_heating")->plausible(burnt, seen));
}

void TestCatalogue::pushThatMayBeginAfterItsEnd_saysNothing() {
  const Excitation seen = richExcitation(DriveInput::torque);
  const Model model = servoModel(DriveInput::torque);
  const auto says = [&](double doubt_s) {
    EffectTerm push;
    push.effect = "external_disturbance";
    push.parameters = {{"torque_Nm", 0.006, 0.005, 0.007},
                       {"start_s", 17.0, 17.0 - doubt_s, 17.0 + doubt_s},
                       {"duration_s", 2.0, 1.5, 2.6}};
    return worthSaying(push, model, seen, {}, {});
  };
  QVERIFY(says(0.3));
  QVERIFY(!says(50.0));
}

QTEST_APPLESS_MAIN(TestCatalogue)
#include "tst_catalogue.moc"
