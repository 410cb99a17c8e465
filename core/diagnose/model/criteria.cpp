#include "diagnose/model/criteria.h"

#include <fmt/format.h>
#include <array>

namespace breakaway {

namespace {

constexpr std::string_view ofError = "a squared error, a residual's energy, or a gain";
constexpr std::string_view ofFloor = "a perfect model's error, rms";
constexpr std::string_view ofChance = "chance";
constexpr std::string_view ofRig = "what any rig has";

constexpr std::array table{
    Criterion{"negligible", &Criteria::negligible, ofError,
              "a wave, an effect or a place that takes less away isn't looked at", "noise of the folds on sound rigs"},
    Criterion{"hardlyAny", &Criteria::hardlyAny, ofError,
              "an effect that takes less away is no finding; a model that leaves less leaves nothing",
              "noise of the folds on sound rigs"},
    Criterion{"little", &Criteria::little, ofError,
              "windows that hold less hardly count; an effect that lives in fewer windows can't be confirmed by others",
              "a decade down"},
    Criterion{"farLess", &Criteria::farLess, ofError,
              "a load, a push or a set that leaves so little needs no other sign", "half the error, rms"},
    Criterion{"half", &Criteria::half, ofError,
              "findings that explain less stand for something else; a rival that does half as well is tried",
              "more than everything else together"},
    Criterion{"clearlyLess", &Criteria::clearlyLess, ofError,
              "what leaves less is clearly better, what leaves its inverse clearly worse", "half of half"},
    Criterion{"hardlyLess", &Criteria::hardlyLess, ofError,
              "held-out data that show something have to fall below it; what leaves more than its inverse is worse",
              "twice what two fits of the same model differ by"},
    Criterion{"sureGain", &Criteria::sureGain, ofError,
              "the 95 % interval of a further effect's gain has to begin beyond it", "tuning trials of combinations"},
    Criterion{"atFloor", &Criteria::atFloor, ofFloor, "a model that errs by less lacks nothing that its sensors show",
              "scatter of the floor on clean trials"},
    Criterion{
        "nearFloor", &Criteria::nearFloor, ofFloor,
        "below it what may be zero or the friction's scatter is no finding; beyond it loads and exchanges are tried",
        "scatter of the floor on clean trials"},
    Criterion{"material", &Criteria::material, ofFloor,
              "in floors with wander: a model that errs by less lacks nothing that a sound rig hasn't",
              "imperfect trials"},
    Criterion{"settled", &Criteria::settled, ofFloor, "below it no further effect is looked for",
              "what a second effect has to make to be seen"},
    Criterion{
        "farOff", &Criteria::farOff, ofFloor,
        "windows that err by more, in floors with wander, tell of something that happens there; from a model that "
        "errs by more, effects are tried alone and in twos, and none of its sizes has a bound by profile; in readings' "
        "noise: a base that errs by more is fitted from other inertias, too",
        "restarts at the edge of standstill"},
    Criterion{"largestPValue", &Criteria::largestPValue, ofChance,
              "an effect's p-value, for the whole catalogue, has to be at most this", "one false name in a hundred"},
    Criterion{"likeliestByChance", &Criteria::likeliestByChance, ofChance,
              "a place that chance makes more often is none, and so is an effect that wander makes more often",
              "one false place in fifty"},
    Criterion{"beyondChance", &Criteria::beyondChance, ofChance,
              "an effect gains so many times the most that 199 sign flips gave; wander that no sound rig has is so "
              "many times what any may have",
              "clean trials"},
    Criterion{"apart", &Criteria::apart, ofChance, "standard errors beyond which one of two effects is the better name",
              "the 95 % interval"},
    Criterion{"farApart", &Criteria::farApart, ofChance,
              "standard errors beyond which a sign, a scale or an offset is known", "the 99.7 % interval"},
    Criterion{"soundPart", &Criteria::soundPart, ofRig,
              "of the friction, of an error or of windows: any rig may wander or lack so much", "brushes and bearings"},
    Criterion{
        "immaterial", &Criteria::immaterial, ofRig,
        "of the friction: a smaller torque is no finding and no place, a smaller constant load the base's bias, and "
        "friction scatters by so much from time to time",
        "brushes and bearings"},
    Criterion{"immaterialDrive", &Criteria::immaterialDrive, ofRig,
              "of the drive's peak torque: a smaller one is no finding", "converters of 11 bits"},
    Criterion{"runAway", &Criteria::runAway, ofRig,
              "an inertia so many times that of torque and acceleration has run away",
              "more than a torque constant may be off by"},
    Criterion{"energyBack", &Criteria::energyBack, ofRig,
              "of the energy that goes to and fro: if more comes back, a sign is wrong", "recordings of real drives"},
    Criterion{"fewestFarOff", &Criteria::fewestFarOff, ofRig,
              "windows, and so many of twenty: fewer are far off by accident", "restarts at the edge of standstill"},
};

}  // namespace

std::span<const Criterion> criteriaTable() {
  return table;
}

Result<Criteria> varied(Criteria criteria, std::string_view name, double factor) {
  std::string names;
  for (const Criterion& one : table) {
    if (one.name == name) {
      criteria.*one.value *= factor;
      return criteria;
    }
    names += (names.empty() ? "" : ", ") + std::string(one.name);
  }
  return Error{std::string(name), "is no criterion; there are: " + names};
}

std::string criteriaMarkdown() {
  std::string text = "| criterion | value | of | asks | set by |\n|---|---|---|---|---|\n";
  for (const Criterion& one : table)
    text +=
        fmt::format("| `{}` | {:g} | {} | {} | {} |\n", one.name, Criteria{}.*one.value, one.of, one.asks, one.setBy);
  return text;
}

}  // namespace breakaway
