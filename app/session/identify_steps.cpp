#include "session/identify_steps.h"

#include <QCoreApplication>

#include "commission/motor_tests.h"
#include "session/language.h"

namespace breakaway {

namespace {

struct Planned {
  Known fact;
  const char* title;
  const char* moves;
};

constexpr Planned ofRotor[] = {{Known::sensorZero, QT_TRANSLATE_NOOP("IdentifyStep", "Zero"),
                                QT_TRANSLATE_NOOP("IdentifyStep", "moves nothing, windings open")},
                               {Known::wiring, QT_TRANSLATE_NOOP("IdentifyStep", "Wiring"),
                                QT_TRANSLATE_NOOP("IdentifyStep", "a few small pulses, a tenth of a turn at most")},
                               {Known::windingTest, QT_TRANSLATE_NOOP("IdentifyStep", "Winding"),
                                QT_TRANSLATE_NOOP("IdentifyStep", "stands, until each ramp just moves it")},
                               {Known::roughMotor, QT_TRANSLATE_NOOP("IdentifyStep", "Spin"),
                                QT_TRANSLATE_NOOP("IdentifyStep", "turns both ways, up to half the supply, 24 s")},
                               {Known::reversal, QT_TRANSLATE_NOOP("IdentifyStep", "Reversal"),
                                QT_TRANSLATE_NOOP("IdentifyStep", "swings to and fro by constant current, 5 s")},
                               {Known::bridge, QT_TRANSLATE_NOOP("IdentifyStep", "Bridge"),
                                QT_TRANSLATE_NOOP("IdentifyStep", "moves nothing: all tests together")},
                               {Known::motor, QT_TRANSLATE_NOOP("IdentifyStep", "Scale"),
                                QT_TRANSLATE_NOOP("IdentifyStep", "moves nothing: what the current's scale is worth")}};

constexpr Planned ofAxis[] = {{Known::sensorZero, QT_TRANSLATE_NOOP("IdentifyStep", "Zero"),
                               QT_TRANSLATE_NOOP("IdentifyStep", "moves nothing, windings open")},
                              {Known::wiring, QT_TRANSLATE_NOOP("IdentifyStep", "Wiring"),
                               QT_TRANSLATE_NOOP("IdentifyStep", "a few small pulses, millimetres at most")},
                              {Known::ends, QT_TRANSLATE_NOOP("IdentifyStep", "Ends"),
                               QT_TRANSLATE_NOOP("IdentifyStep", "feels for both ends of the travel, 20 s")},
                              {Known::windingTest, QT_TRANSLATE_NOOP("IdentifyStep", "Winding"),
                               QT_TRANSLATE_NOOP("IdentifyStep", "stands, until each ramp just moves it")},
                              {Known::roughMotor, QT_TRANSLATE_NOOP("IdentifyStep", "Strokes"),
                               QT_TRANSLATE_NOOP("IdentifyStep", "strokes to and fro by voltage, 12 s")},
                              {Known::bridge, QT_TRANSLATE_NOOP("IdentifyStep", "Bridge"),
                               QT_TRANSLATE_NOOP("IdentifyStep", "moves nothing: all tests together")},
                              {Known::motor, QT_TRANSLATE_NOOP("IdentifyStep", "Scale"),
                               QT_TRANSLATE_NOOP("IdentifyStep", "moves nothing: what the current's scale is worth")}};

QString words(const char* text) {
  return QCoreApplication::translate("IdentifyStep", text);
}

std::vector<Measured> resultsOf(Known fact, const Commission& known) {
  const bool linear = known.linear();
  const double torque = linear ? 1.0 : 1e3;
  // Until the scale is on, the figures are those of the tests so far.
  const IdentifiedMotor& motor = known.motor;
  const auto resistance = [&](const Estimate& value) {
    return Measured{words(QT_TRANSLATE_NOOP("IdentifyStep", "R")), value, 1.0,
                    words(QT_TRANSLATE_NOOP("IdentifyStep", "Ω"))};
  };
  const Measured constant{
      linear ? words(QT_TRANSLATE_NOOP("IdentifyStep", "Kf")) : words(QT_TRANSLATE_NOOP("IdentifyStep", "Kt")),
      motor.torqueConstant_Nm_per_A, torque,
      linear ? words(QT_TRANSLATE_NOOP("IdentifyStep", "N/A")) : words(QT_TRANSLATE_NOOP("IdentifyStep", "mNm/A"))};
  const Measured inertia{
      linear ? words(QT_TRANSLATE_NOOP("IdentifyStep", "m")) : words(QT_TRANSLATE_NOOP("IdentifyStep", "J")),
      motor.inertia_kg_m2, linear ? 1.0 : 1e7,
      linear ? words(QT_TRANSLATE_NOOP("IdentifyStep", "kg")) : words(QT_TRANSLATE_NOOP("IdentifyStep", "g cm²"))};
  switch (fact) {
    case Known::sensorZero:
      return {{words(QT_TRANSLATE_NOOP("IdentifyStep", "offset")), known.sensorZero_A, 1e3,
               words(QT_TRANSLATE_NOOP("IdentifyStep", "mA"))}};
    case Known::wiring: {
      std::vector<Measured> seen;
      if (known.wiring && known.wiring->resistance_ohm.standardError > 0.0)
        seen.push_back(resistance(known.wiring->resistance_ohm));
      if (known.wiring && known.wiring->backEmf_V_s_per_rad.standardError > 0.0)
        seen.push_back({words(QT_TRANSLATE_NOOP("IdentifyStep", "Ke")), known.wiring->backEmf_V_s_per_rad,
                        linear ? 1.0 : 1e3,
                        linear ? words(QT_TRANSLATE_NOOP("IdentifyStep", "V s/m"))
                               : words(QT_TRANSLATE_NOOP("IdentifyStep", "mV s/rad"))});
      return seen;
    }
    case Known::windingTest:
      if (!known.tests) return {};
      return {resistance(known.tests->winding.line.resistance_ohm),
              {words(QT_TRANSLATE_NOOP("IdentifyStep", "L/R")), known.tests->winding.timeConstant_s, 1e3,
               words(QT_TRANSLATE_NOOP("IdentifyStep", "ms"))}};
    case Known::roughMotor:
      return {
          constant,
          {words(QT_TRANSLATE_NOOP("IdentifyStep", "F")), motor.coulomb_Nm, torque,
           linear ? words(QT_TRANSLATE_NOOP("IdentifyStep", "N")) : words(QT_TRANSLATE_NOOP("IdentifyStep", "mNm"))}};
    case Known::reversal:
      return {inertia};
    case Known::bridge:
      return {resistance(motor.resistance_ohm),
              {words(QT_TRANSLATE_NOOP("IdentifyStep", "dead zone")), motor.deadZone_V, 1e3,
               words(QT_TRANSLATE_NOOP("IdentifyStep", "mV"))}};
    case Known::motor:
      return {constant,
              {words(QT_TRANSLATE_NOOP("IdentifyStep", "B")), motor.viscous_Nm_s_per_rad, linear ? 1.0 : 1e6,
               linear ? words(QT_TRANSLATE_NOOP("IdentifyStep", "N s/m"))
                      : words(QT_TRANSLATE_NOOP("IdentifyStep", "µNm s/rad"))}};
    default:
      return {};
  }
}

bool identifies(RunKind kind) {
  return kind != RunKind::none && kind != RunKind::turning && kind != RunKind::hand && kind != RunKind::step &&
         kind != RunKind::positionStep && kind != RunKind::experiment;
}

}  // namespace

std::vector<IdentifyStep> identifySteps(const Commission& known, const RunSnapshot& run) {
  const auto planned = known.linear() ? std::vector<Planned>(std::begin(ofAxis), std::end(ofAxis))
                                      : std::vector<Planned>(std::begin(ofRotor), std::end(ofRotor));
  std::vector<IdentifyStep> steps;
  bool reached = false;  // the first step that isn't known yet is the one that runs, or failed
  for (const Planned& one : planned) {
    IdentifyStep step{one.fact, words(one.title), words(one.moves), IdentifyStep::State::open, {}, {}};
    if (known.knows(one.fact)) {
      step.state = IdentifyStep::State::passed;
      step.results = resultsOf(one.fact, known);
    } else if (!reached && identifies(run.kind)) {
      reached = true;
      if (run.running()) step.state = IdentifyStep::State::running;
      if (run.status.state == Procedure::State::failed) {
        step.state = IdentifyStep::State::failed;
        step.trouble = inLanguage(run.status.failure);
      }
    }
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace breakaway
