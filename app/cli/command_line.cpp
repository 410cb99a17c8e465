#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "base/json_object.h"

namespace breakaway::cli {

namespace {

std::vector<std::string> commandsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* one : app.get_subcommands(nullptr)) names.push_back(one->get_name());
  return names;
}

const CLI::App* commandNamed(const CLI::App& app, const std::string& name) {
  for (const CLI::App* one : app.get_subcommands(nullptr)) {
    if (one->get_name() == name) return one;
  }
  return nullptr;
}

std::string didYouMean(const std::string& name, const std::vector<std::string>& known) {
  const auto suggestion = nearestName(name, known);
  return suggestion ? " (did you mean " + *suggestion + "?)" : std::string();
}

std::string unknownCommand(const CLI::App& app, const std::string& name) {
  return "knows no command " + name + didYouMean(name, commandsOf(app)) + "; see breakaway --help";
}

/// The first of a command's words that looks like an option and is none of its own.
std::string unknownOption(const CLI::App& command, const std::vector<std::string>& words) {
  std::vector<std::string> known;
  for (const CLI::Option* one : command.get_options()) {
    for (const std::string& name : one->get_lnames()) known.push_back("--" + name);
  }
  for (size_t k = 1; k < words.size() && words[k] != "--"; ++k) {
    const std::string name = words[k].substr(0, words[k].find('='));
    if (!name.starts_with("--") || std::find(known.begin(), known.end(), name) != known.end()) continue;
    return command.get_name() + " knows no option " + name + didYouMean(name, known);
  }
  return {};
}

}  // namespace

void addCommon(CLI::App& app, const std::string& version, Manner& manner) {
  for (CLI::App* command : app.get_subcommands(nullptr)) {
    command->add_flag("--json", manner.json, "answer with one JSON object on standard output, for programs");
    command->add_flag("--quiet", manner.quiet, "no words and no progress; what is wrong is said all the same");
  }
  app.set_version_flag("--version", version);
  auto* help = app.add_subcommand("help", "Say what there is, or how a command is used");
  help->add_option("COMMAND", "whose help");
  help->footer("Example:\n  breakaway help diagnose");
  app.footer(
      "breakaway COMMAND --help tells a command's options with examples. Exit status: 0 done, 1 the bench failed on "
      "the "
      "way, 2 the input is wrong, 130 interrupted.");
}

std::optional<Result<std::string>> helpAskedFor(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty() || words[0] != "help") return {};
  if (words.size() == 1) return Result<std::string>(app.help());
  if (words[1].starts_with("-")) return {};
  const CLI::App* command = commandNamed(app, words[1]);
  if (command == nullptr) return Result<std::string>(Error{"", unknownCommand(app, words[1])});
  return Result<std::string>(command->help("breakaway"));
}

std::string complaint(const CLI::App& app, const std::vector<std::string>& words, const std::string& why) {
  if (words.empty()) return why + "; see breakaway --help";
  const CLI::App* command = commandNamed(app, words[0]);
  if (command == nullptr && !words[0].starts_with("-")) return unknownCommand(app, words[0]);
  if (command == nullptr) return why + "; see breakaway --help";
  const std::string unknown = unknownOption(*command, words);
  return (unknown.empty() ? why : unknown) + "; see breakaway " + words[0] + " --help";
}

Result<void> checkTogether(const CLI::App& command, const Manner& manner) {
  size_t fromStandardInput = 0;
  for (const CLI::Option* one : command.get_options()) {
    if (one->get_name() == "--out") continue;
    for (const std::string& value : one->results()) fromStandardInput += value == "-" ? 1 : 0;
  }
  if (fromStandardInput > 1) return Error{"-", "is named twice, but standard input can be read once only"};
  if (manner.json && writesToStandardOutput(command))
    return Error{"--json", "has no place where --out - has standard output for itself"};
  return {};
}

std::optional<std::uint64_t> seedOf(const CLI::App& command) {
  const CLI::Option* option = command.get_option_no_throw("--seed");
  if (option == nullptr) return {};
  const std::string text = option->count() > 0 ? option->results().front() : option->get_default_str();
  std::uint64_t seed = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), seed);
  return read.ec == std::errc() ? std::optional(seed) : std::nullopt;
}

bool writesToStandardOutput(const CLI::App& command) {
  const CLI::Option* out = command.get_option_no_throw("--out");
  return out != nullptr && out->count() > 0 && out->results().front() == "-";
}

}  // namespace breakaway::cli
