#include "export/program_name.h"

#include <set>
#include <vector>

#include "export/model_program.h"

namespace breakaway {

namespace {

const std::set<std::string>& wordsOf(const std::string& form) {
  static const std::set<std::string> matlab{
      "break",  "case", "catch",     "classdef", "continue",   "else",   "elseif", "end",    "for", "function",
      "global", "if",   "otherwise", "parfor",   "persistent", "return", "spmd",   "switch", "try", "while"};
  static const std::set<std::string> modelica{
      "algorithm", "and",          "annotation",    "assert",      "block",     "break",      "class",     "connect",
      "connector", "constant",     "constrainedby", "der",         "discrete",  "each",       "else",      "elseif",
      "elsewhen",  "encapsulated", "end",           "enumeration", "equation",  "expandable", "extends",   "external",
      "false",     "final",        "flow",          "for",         "function",  "if",         "import",    "impure",
      "in",        "initial",      "inner",         "input",       "loop",      "model",      "not",       "operator",
      "or",        "outer",        "output",        "package",     "parameter", "partial",    "protected", "public",
      "pure",      "record",       "redeclare",     "replaceable", "return",    "stream",     "then",      "true",
      "type",      "when",         "while",         "within"};
  static const std::set<std::string> none;
  return form == "matlab" ? matlab : form == "modelica" ? modelica : none;
}

/// Names that the program gives beside its own, variables among them, which would hide a class.
std::set<std::string> namesIn(const Model& model) {
  std::set<std::string> names{"start", "pick", "State", "Sampled", "Real", "s", "before", "dt_s"};
  std::vector<LeftOut> leftOut;
  const Program program = programOf(model, leftOut);
  for (const Function& one : program.functions) {
    names.insert(one.name);
    for (const auto& more : {one.arguments, one.outputs, one.locals()}) names.insert(more.begin(), more.end());
  }
  for (const Constant& one : program.constants) names.insert(one.name);
  return names;
}

}  // namespace

std::optional<std::string> nameFault(const std::string& form, const std::string& name) {
  if (!isIdentifier(name)) return "expected letters, digits and _, a letter first";
  if (wordsOf(form).contains(name)) return "which the language keeps for itself";
  return {};
}

std::optional<std::string> nameFault(const Model& model, const std::string& form, const std::string& name) {
  if (auto fault = nameFault(form, name)) return fault;
  if ((form == "matlab" || form == "modelica") && namesIn(model).contains(name))
    return "which is the name of something in it";
  return {};
}

}  // namespace breakaway
