#include "commission/cause_search.h"

#include <cmath>
#include <utility>

#include "commission/held_beliefs.h"
#include "commission/steps/wiring_pulses.h"
#include "experiment/travel.h"

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

/// What has come in the shaft's way since the beginning; `blocked`: it was driven against that.
Message stopWords(const WiringFit& now, bool blocked, const Commission& known) {
  const auto moves = [](const WiringFit& fit, size_t way) { return fit.breakaway_A[way] && !fit.stopped[way]; };
  if (blocked && now.breakaway_A[0] && now.breakaway_A[1])
    return message(
        "{} was stopped though it moves freely both ways by now: a stop, or something else, is in its way near there",
        bodyText(known.identity.axis));
  if (!moves(*known.wiring, 0) || !moves(*known.wiring, 1) || moves(now, 0) == moves(now, 1)) return {};
  const Axis axis = known.identity.axis;
  return message("{} moves {} only: a stop, or a load, holds it the other way, which was free at the beginning",
                 bodyText(axis), wayText(moves(now, 1), axis));
}

/// What stood against the current and fell back without it.
Message fallWords(double fell_rad, Axis axis) {
  if (fell_rad == 0.0) return {};
  return message(
      "{} moved {} by {} as soon as nothing drove it: an arm or a load pushes it back, heavier than the current lifts; "
      "balance or hold it, or take it off",
      bodyText(axis), wayText(fell_rad > 0.0, axis),
      axis == Axis::linear ? millimetresText(std::abs(fell_rad)) : degreesText(std::abs(fell_rad)));
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
  Message cause = trip == Trip::contradiction ? check_->evidence() : Message();
  // The watch's words for the check's small pulses are no better than those for what it ended.
  const bool tells = check_->names() || (trip == Trip::contradiction && end_.trip != Trip::contradiction);
  if (cause.empty() && tells) cause = status.failure;
  if (cause.empty() && status.state == Procedure::State::finished) {
    const WiringFit now = fitWiring(*check_);
    cause = wiringChange(now, known);
    if (cause.empty()) cause = fallWords(check_->fell_rad(), known.identity.axis);
    if (cause.empty()) cause = stopWords(now, end_.trip == Trip::blocked, known);
  }
  if (cause.empty()) return end_.failure;
  return {end_.failure.place,
          message("{} (found by a wiring check after this: {})", cause, Message(end_.failure.fact))};
}

}  // namespace breakaway
