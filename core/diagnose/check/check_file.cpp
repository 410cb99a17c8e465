// The check in words and as JSON (resources/help/files.md).
#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "diagnose/check/check.h"
#include "diagnose/effects/wording.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

std::string nameText(const Sight& sight) {
  return std::string(sight.effect->name());
}

/// "1.2 mNm (8 % of the friction)", or the first parameter where it is no torque.
std::string sizeText(const Sight& sight, const Check& check) {
  const Parameter& first = sight.smallest.front();
  if (!sight.torque) return fmt::format("{} {:.2g}", first.name, first.value);
  const double friction = physicsOf(check.base).coulomb;
  const std::string share =
      friction > 0.0 ? " (" + fmt::format("{:.2g} %", 100.0 * *sight.torque / friction) + ")" : "";
  return torqueText(*sight.torque, check.axis) + share;
}

/// The other parameters that it was looked at with.
std::string atText(const Sight& sight) {
  std::string text;
  for (size_t k = 1; k < sight.smallest.size(); ++k) {
    if (sight.smallest[k].name == "phase_rad" || sight.smallest[k].value == 0.0) continue;
    text += fmt::format("{}{} {:.3g}", text.empty() ? "" : ", ", sight.smallest[k].name, sight.smallest[k].value);
  }
  return text;
}

const char* limitText(SightLimit limit) {
  switch (limit) {
    case SightLimit::sensors:
      return "what the sensors tell";
    case SightLimit::wander:
      return "torque that wanders";
    case SightLimit::smallness:
      return "smaller ones matter to nobody";
    case SightLimit::grid:
      return "the smallest that is looked for";
  }
  return "";
}

size_t shownOnes(const Check& check) {
  return static_cast<size_t>(
      std::count_if(check.effects.begin(), check.effects.end(), [](const Sight& one) { return one.shown(); }));
}

nlohmann::ordered_json jsonOf(const ChannelQuality& q, Axis axis) {
  const std::string unit = axis == Axis::rotary ? "_rad" : "_m";
  return {{"recording", q.recording},
          {"rows", q.rows},
          {"duration_s", q.duration_s},
          {"rate_Hz", q.rate_Hz},
          {"jitter_s", q.jitter_s},
          {"missing_rows", q.missingRows},
          {"longest_step_s", q.longestGap_s},
          {"repeated_part", q.repeatedPart},
          {"unread_part", q.unreadPart},
          {"reading_step" + unit, q.readingStep},
          {"declared_count" + unit, q.declaredCount},
          {"reading_noise" + unit, q.readingNoise},
          {"current_noise_A", q.currentNoise_A},
          {"rest_part", q.restPart},
          {"forwards_part", q.forwardsPart},
          {"reversals", q.reversals},
          {"travel" + unit, q.travel},
          {"fastest" + unit + "_per_s", q.fastest},
          {"drive", q.driveColumn},
          {"drive_peak", q.drivePeak},
          {"at_limit_part", q.atLimitPart},
          {"drive_reverses", q.driveReverses}};
}

nlohmann::ordered_json jsonOf(const Sight& sight, const Check& check) {
  nlohmann::ordered_json json{{"effect", sight.effect->name()}, {"shown", sight.shown()}};
  json["smallest"] = nlohmann::ordered_json::object();
  for (const Parameter& one : sight.smallest) json["smallest"][one.name] = one.value;
  const double friction = physicsOf(check.base).coulomb;
  json["share_of_friction"] =
      sight.torque && friction > 0.0 ? nlohmann::ordered_json(*sight.torque / friction) : nlohmann::ordered_json();
  json["limit"] = sight.shown() ? nlohmann::ordered_json(nameOf(sight.limit)) : nlohmann::ordered_json();
  json["why_not"] = sight.why;
  json["experiment"] = sight.experiment;
  return json;
}

}  // namespace

std::string inShort(const Check& check) {
  if (check.misread) return "Misread: " + check.misread->sentence + ".";
  return fmt::format("These recordings can show {} of {} effects.", shownOnes(check), check.effects.size());
}

std::string inWords(const Check& check) {
  std::string out = inShort(check) + "\n";
  if (check.misread) out += "With " + check.misread->mended + ":\n";
  for (const std::string& one : check.channelWords) out += "- " + one + "\n";
  for (const std::string& one : check.remarks) out += "Note: " + one + ".\n";
  if (shownOnes(check) > 0) {
    out += fmt::format("{:<28} {:<34} {:<32} {}\n", "can show", "from about", "limited by", "at");
    for (const Sight& one : check.effects) {
      if (one.shown())
        out += fmt::format("{:<28} {:<34} {:<32} {}\n", nameText(one), sizeText(one, check), limitText(one.limit),
                           atText(one));
    }
  }
  for (const Sight& one : check.effects) {
    if (!one.shown())
      out += "Can't show " + nameText(one) + ": " + one.why + "." +
             (one.experiment.empty() ? "" : " " + one.experiment) + "\n";
  }
  if (!check.next.empty()) out += "Next: " + check.next + "\n";
  return out;
}

std::string checkJson(const Check& check) {
  using Json = nlohmann::ordered_json;
  Json json{{"schema", "breakaway.check/1"}};
  json["misread"] = check.misread ? Json{{"what", check.misread->what},
                                         {"of", check.misread->ofBench ? "bench" : "recording"},
                                         {"factor", check.misread->factor},
                                         {"sentence", check.misread->sentence},
                                         {"mended", check.misread->mended}}
                                  : Json();
  json["channels"] = Json::array();
  for (const ChannelQuality& one : check.channels) json["channels"].push_back(jsonOf(one, check.axis));
  json["sentences"] = check.channelWords;
  json["base"] = Json::object();
  for (const Parameter& one : check.base.base)
    json["base"][one.name] = {{"value", one.value}, {"ci95", {one.low95, one.high95}}};
  const double friction = physicsOf(check.base).coulomb;
  json["wander"] = {{check.axis == Axis::linear ? "rms_N" : "rms_Nm", check.wander.rms},
                    {"share_of_friction", friction > 0.0 ? check.wander.rms / friction : 0.0},
                    {"correlation_s", check.wander.rms > 0.0 ? check.wander.time_s : 0.0}};
  json["error"] = check.error;
  json["floor"] = check.floor;
  json["effects"] = Json::array();
  for (const Sight& one : check.effects) json["effects"].push_back(jsonOf(one, check));
  json["next_experiment"] = check.next;
  json["remarks"] = check.remarks;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace breakaway
