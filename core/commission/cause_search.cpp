#include "commission/cause_search.h"

#include <utility>

#include "commission/held_beliefs.h"
#include "commission/steps/wiring_pulses.h"

namespace breakaway {

namespace {

constexpr double coast_s = 1.0;

bool isOfWiring(Trip trip) {
  switch (trip) {
    case Trip::overCurrent:
    case Trip::encoderJump:
    case Trip::blocked:
    case Trip::overSpeed:
    case Trip::contradiction:
      return true;
    case Trip::none:
    case Trip::openSensor:
    case Trip::supplyLow:
    case Trip::supplyHigh:
    case Trip::windingHeat:
      break;
  }
  return false;
}

}  // namespace

bool leavesCauseOpen(const EarlyEnd& end, const Commission& known) {
  if (!known.knows(Known::wiring) || end.failure.place == contradictionPlace) return false;
  if (end.state == Procedure::State::stopped || end.trip != Trip::none) return isOfWiring(end.trip);
  return end.state == Procedure::State::failed;
}

CauseSearch::CauseSearch(EarlyEnd end, const OnBench& on) : end_(std::move(end)), check_(wiringCheckOn(on, coast_s)) {
}

StepRun CauseSearch::run() const {
  return {"wiring-again", check_};
}

Error CauseSearch::conclude(Trip trip, Commission& known) const {
  const auto status = check_->status();
  Message cause;
  if (check_->names() || trip == Trip::contradiction)
    cause = status.failure;
  else if (status.state == Procedure::State::finished)
    cause = wiringChange(fitWiring(*check_), known);
  if (cause.empty()) return end_.failure;
  return {end_.failure.place,
          message("{} (found by a wiring check after this: {})", cause, Message(end_.failure.fact))};
}

}  // namespace breakaway
