// What there is: effects, criteria, presets, columns.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/inputs.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/model/criteria.h"
#include "firmware_link/presets.h"
#include "recording/columns.h"

namespace breakaway::cli {

namespace {

using Json = nlohmann::ordered_json;

Answer effects() {
  Answer answer;
  Json json{{"effects", Json::array()}};
  for (const Effect* effect : catalogue()) {
    answer.words += fmt::format("{:<30} {}\n", effect->name(), effect->formula());
    Json one{{"name", effect->name()}, {"formula", effect->formula()}, {"source", effect->source()}};
    for (const auto& [name, axis] :
         {std::pair("parameters_rotary", Axis::rotary), {"parameters_linear", Axis::linear}}) {
      one[name] = Json::array();
      for (const ParameterSpec& parameter : effect->parameters(axis)) one[name].push_back(parameter.name);
    }
    one["look_alikes"] = effect->lookAlikes();
    json["effects"].push_back(std::move(one));
  }
  answer.json = asText(json);
  return answer;
}

Answer criteria() {
  Answer answer;
  Json json{{"criteria", Json::array()}};
  for (const Criterion& one : criteriaTable()) {
    const double value = Criteria{}.*one.value;
    answer.words += fmt::format("{:<20} {:<8g} of {}: {}\n", one.name, value, one.of, one.asks);
    json["criteria"].push_back(
        {{"name", one.name}, {"value", value}, {"of", one.of}, {"asks", one.asks}, {"set_by", one.setBy}});
  }
  answer.json = asText(json);
  return answer;
}

Answer presets() {
  Answer answer;
  Json json{{"presets", Json::array()}};
  for (const std::string& name : presetNames()) {
    const std::string uri = "simulated:" + name;
    const auto rig = rigFileOf(uri);
    const std::string file = rig ? *rig : std::string();
    answer.words += fmt::format("{:<30} {}\n", uri, file);
    json["presets"].push_back({{"name", name}, {"uri", uri}, {"rig", file}, {"bench", benchFileBeside(file)}});
  }
  if (answer.words.empty()) answer.words = "no preset was found; BREAKAWAY_RESOURCES names the folder\n";
  answer.json = asText(json);
  return answer;
}

const char* wordsOf(const std::optional<Axis>& axis) {
  if (!axis) return "either";
  return *axis == Axis::rotary ? "rotary" : "linear";
}

Answer columnsOfRecordings() {
  Answer answer;
  Json json{{"columns", Json::array()}};
  for (const Column& one : columns()) {
    answer.words += fmt::format("{:<30} {:<8} {}\n", one.name, wordsOf(one.axis), one.meaning);
    json["columns"].push_back(
        {{"name", one.name}, {"unit", one.unit}, {"axis", wordsOf(one.axis)}, {"meaning", one.meaning}});
  }
  answer.json = asText(json);
  return answer;
}

}  // namespace

void addList(CLI::App& app, Job& chosen) {
  auto what = std::make_shared<std::string>();
  auto* command = app.add_subcommand(
      "list", "List the effects, what a diagnosis decides by, the simulated presets or the recordings' columns");
  command->add_option("WHAT", *what, "what to list")
      ->required()
      ->check(CLI::IsMember({"effects", "criteria", "presets", "columns"}));
  command->footer("Examples:\n  breakaway list effects\n  breakaway list criteria\n  breakaway list columns --json");
  command->callback([what, &chosen] {
    chosen = [what]() -> Outcome {
      if (*what == "effects") return Result<Answer>(effects());
      if (*what == "criteria") return Result<Answer>(criteria());
      return Result<Answer>(*what == "presets" ? presets() : columnsOfRecordings());
    };
  });
}

}  // namespace breakaway::cli
