#include "line/option_table.h"

#include <CLI/CLI.hpp>

namespace breakaway::line {

namespace {

/// The words between the braces of "TEXT:{a,b}"; none where there are no braces.
std::vector<std::string> choicesIn(const std::string& type) {
  const size_t open = type.find('{'), close = type.rfind('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

OptionRow rowOf(const CLI::Option& option) {
  OptionRow row;
  for (const std::string& name : option.get_snames()) row.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) row.names.push_back("--" + name);
  row.meaning = option.get_description();
  row.required = option.get_required();
  row.repeats = option.get_items_expected_max() > 1;
  if (option.get_items_expected_max() == 0) return row;
  const std::string type = option.get_type_name();
  row.choices = choicesIn(type);
  if (const size_t colon = type.find(':'); colon != std::string::npos && row.choices.empty())
    row.limits = type.substr(colon + 1);
  row.value = row.placed() ? option.get_name() : type.substr(0, type.find(':'));
  row.preset = option.get_default_str();
  return row;
}

void addOptions(const CLI::App& app, std::vector<OptionRow>& options) {
  for (const CLI::Option* one : app.get_options()) {
    if (!one->get_group().empty()) options.push_back(rowOf(*one));
  }
  for (const CLI::App* group : app.get_subcommands(nullptr)) {
    if (group->get_name().empty()) addOptions(*group, options);
  }
}

CommandRow commandOf(const CLI::App& app) {
  CommandRow command{app.get_name(), app.get_description(), app.get_footer(), {}};
  addOptions(app, command.options);
  return command;
}

}  // namespace

Table tableOf(const CLI::App& app) {
  Table table{commandOf(app), {}};
  for (const CLI::App* one : app.get_subcommands(nullptr)) {
    if (!one->get_name().empty()) table.commands.push_back(commandOf(*one));
  }
  return table;
}

}  // namespace breakaway::line
