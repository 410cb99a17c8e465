#include "diagnose/simulate/model_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/json_object.h"
#include "base/made.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr const char* schema = "breakaway.model/1";

std::vector<Parameter> readParameters(JsonObject object) {
  std::vector<Parameter> parameters;
  for (const std::string& name : object.objectNames()) {
    JsonObject one = object.object(name);
    const double value = one.number("value");
    Parameter parameter{name, value, value, value};
    if (const auto ends = one.numbersIn("ci95"); ends.size() == 2) {
      parameter.low95 = ends[0];
      parameter.high95 = ends[1];
    } else {
      one.fault("ci95", "expected two numbers");
    }
    parameters.push_back(parameter);
  }
  return parameters;
}

/// JSON keeps no order, and a file leaves out what is absent at zero; everything else relies on the catalogue's list.
void inCatalogueOrder(EffectTerm& term, Axis axis) {
  const Effect* effect = findEffect(term.effect);
  if (effect == nullptr) return;
  std::vector<Parameter> ordered;
  size_t read = 0;
  for (const ParameterSpec& spec : effect->parameters(axis)) {
    const auto it = std::find_if(term.parameters.begin(), term.parameters.end(),
                                 [&spec](const Parameter& one) { return one.name == spec.name; });
    if (it != term.parameters.end()) {
      ordered.push_back(*it);
      ++read;
    } else if (spec.absentAtZero) {
      ordered.push_back({spec.name, 0.0, 0.0, 0.0});
    }
  }
  if (read == term.parameters.size()) term.parameters = std::move(ordered);
}

}  // namespace

Result<Model> readModel(const std::string& path) {
  auto root = JsonObject::fromFile(path);
  if (!root) return root.error();
  Model model;
  const std::string found = root->text("schema");
  if (found != schema) root->fault("schema", "is \"" + found + "\", expected \"" + schema + "\"");
  const std::string axis = root->text("axis");
  if (axis != "rotary" && axis != "linear") root->fault("axis", "is \"" + axis + "\", expected rotary or linear");
  model.axis = axis == "linear" ? Axis::linear : Axis::rotary;
  const std::string inputName = root->text("input");
  auto input = driveInputNamed(inputName, model.axis);
  Bench byReference;
  byReference.axis = model.axis;
  byReference.servo = ServoLaw{};
  if (inputName == byReference.inputChannel())
    model.servo = ServoLaw{.rate_Hz = root->object("controller", false).optionalNumber("rate_Hz", Allowed::positive)};
  else if (!input)
    root->fault("input", "is \"" + inputName + "\", expected a drive input of this axis");
  model.input = input.value_or(DriveInput::torque);
  model.supply_V = root->optionalNumber("supply_V", Allowed::positive);
  model.count = root->number("count", 0.0, Allowed::nonNegative);
  model.restartHorizon_s = root->number("restart_horizon_s", 0.05, Allowed::nonNegative);
  if (root->has("pendulum")) {
    JsonObject pendulum = root->object("pendulum");
    model.pendulum =
        Pendulum{pendulum.number("mass_kg", Allowed::nonNegative), pendulum.number("length_m", Allowed::positive),
                 pendulum.number("arm_mass_kg", 0.0, Allowed::nonNegative), 0.0};
  }
  model.base = readParameters(root->object("base"));
  if (model.servo) {
    for (const ServoNames& names : servoNamesOf(model.axis)) {
      if (model.baseValue(names.kp)) model.input = names.output;
    }
  }
  for (JsonObject& effect : root->objects("effects")) {
    EffectTerm term{effect.text("effect"), readParameters(effect.object("parameters"))};
    term.recording = effect.text("recording", "");
    model.effects.push_back(std::move(term));
  }
  if (const auto done = root->finish(); !done) return done.error();
  for (EffectTerm& term : model.effects) inCatalogueOrder(term, model.axis);
  if (physicsOf(model).inertia <= 0.0) return Error{path, "has an inertia that is not positive"};
  if (const auto terms = termsOf(model); !terms) return Error{path + ", " + terms.error().place, terms.error().fact};
  return model;
}

std::string modelText(const Model& model) {
  using Json = nlohmann::ordered_json;
  const auto parametersJson = [](const std::vector<Parameter>& parameters) {
    Json json = Json::object();
    for (const Parameter& one : parameters) json[one.name] = {{"value", one.value}, {"ci95", {one.low95, one.high95}}};
    return json;
  };
  Bench names;
  names.axis = model.axis;
  names.input = model.input;
  names.servo = model.servo;
  Json json{
      {"schema", schema}, {"axis", model.axis == Axis::rotary ? "rotary" : "linear"}, {"input", names.inputChannel()}};
  if (model.servo && model.servo->rate_Hz) json["controller"]["rate_Hz"] = *model.servo->rate_Hz;
  if (model.supply_V) json["supply_V"] = *model.supply_V;
  json["count"] = model.count;
  json["restart_horizon_s"] = model.restartHorizon_s;
  if (model.pendulum) {
    json["pendulum"] = {{"mass_kg", model.pendulum->mass_kg},
                        {"length_m", model.pendulum->length_m},
                        {"arm_mass_kg", model.pendulum->armMass_kg}};
  }
  json["base"] = parametersJson(model.base);
  json["effects"] = Json::array();
  for (const EffectTerm& term : model.effects) {
    json["effects"].push_back(
        {{"effect", term.effect}, {"parameters", parametersJson(presentParameters(term, model.axis))}});
    if (!term.recording.empty()) json["effects"].back()["recording"] = term.recording;
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<void> writeModel(const Model& model, const std::string& path) {
  return writeFile(path, withMade(modelText(model)));
}

}  // namespace breakaway
