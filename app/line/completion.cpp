#include "line/completion.h"

#include <fmt/format.h>

#include <algorithm>

namespace breakaway::line {

namespace {

std::string joined(const std::vector<std::string>& words, const char* between = " ") {
  return fmt::format("{}", fmt::join(words, between));
}

/// In single quotes, for every one of the shells.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char one : text) out += one == '\'' ? std::string("'\\''") : std::string(1, one);
  return out + "'";
}

std::string identifier(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return "_" + name;
}

/// What a list shows beside a word: the meaning up to its first colon, semicolon or full stop.
std::string brief(const std::string& meaning) {
  return meaning.substr(0, meaning.find_first_of(".:;\n"));
}

std::vector<std::string> optionNames(const CommandRow& command) {
  std::vector<std::string> names;
  for (const OptionRow& one : command.options) names.insert(names.end(), one.names.begin(), one.names.end());
  return names;
}

std::vector<std::string> commandNames(const Table& table) {
  std::vector<std::string> names;
  names.reserve(table.commands.size());
  for (const CommandRow& one : table.commands) names.push_back(one.name);
  return names;
}

const OptionRow* firstPlace(const CommandRow& command) {
  const auto found =
      std::find_if(command.options.begin(), command.options.end(), [](const OptionRow& one) { return one.placed(); });
  return found == command.options.end() ? nullptr : &*found;
}

/// The words that may stand first after a command, `help` having all of them.
std::vector<std::string> firstWords(const CommandRow& command, const Table& table) {
  if (command.name == "help") return commandNames(table);
  const OptionRow* place = firstPlace(command);
  return place == nullptr ? std::vector<std::string>() : place->choices;
}

/// For bash: what may follow an option, by "COMMAND:--option".
std::string bashValues(const CommandRow& command, const std::string& name) {
  std::string cases;
  for (const OptionRow& one : command.options) {
    if (one.placed() || one.value.empty()) continue;
    std::vector<std::string> patterns;
    patterns.reserve(one.names.size());
    for (const std::string& spelt : one.names) patterns.push_back(name + ":" + spelt);
    const std::string then =
        !one.choices.empty() ? "words=" + quoted(joined(one.choices)) : (one.mayBeFile() ? "files=yes" : "");
    cases += fmt::format("    {}) {} ;;\n", joined(patterns, " | "), then.empty() ? ":" : then);
  }
  return cases;
}

std::string bashWords(const CommandRow& command, const std::string& name, const std::vector<std::string>& first) {
  return fmt::format("        {}) options={} words={} ;;\n", name.empty() ? "''" : name,
                     quoted(joined(optionNames(command))), quoted(joined(first)));
}

/// For zsh's _arguments: one specification.
std::string zshOption(const OptionRow& row) {
  std::string meaning = brief(row.meaning);
  for (const char special : {'[', ']'}) std::replace(meaning.begin(), meaning.end(), special, ' ');
  const std::string values =
      !row.choices.empty() ? "(" + joined(row.choices) + ")" : (row.mayBeFile() ? "_files" : " ");
  if (row.placed()) return quoted((row.repeats ? "*:" : ":") + row.value + ":" + values);
  std::string all;
  for (const std::string& name : row.names) {
    const std::string value = row.value.empty() ? "" : ":" + row.value + ":" + values;
    all += (all.empty() ? "" : " ") + quoted((row.repeats ? "*" : "") + name + "[" + meaning + "]" + value);
  }
  return all;
}

std::string zshArguments(const CommandRow& command, const Table& table) {
  std::string text = "_arguments -s";
  for (OptionRow one : command.options) {
    if (command.name == "help" && one.placed()) one.choices = commandNames(table);
    text += " \\\n        " + zshOption(one);
  }
  return text;
}

std::string fishOption(const std::string& program, const std::string& when, const OptionRow& row) {
  std::string text = "complete -c " + program + " -n " + quoted(when);
  for (const std::string& name : row.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!row.choices.empty()) {
    text += " -x -a " + quoted(joined(row.choices));
  } else if (!row.value.empty()) {
    text += row.mayBeFile() ? " -r -F" : " -x";
  }
  return text + " -d " + quoted(brief(row.meaning)) + "\n";
}

std::string fishOptions(const std::string& program, const std::string& when, const CommandRow& command) {
  std::string text;
  for (const OptionRow& one : command.options) {
    if (!one.placed()) text += fishOption(program, when, one);
  }
  return text;
}

}  // namespace

std::string bashCompletion(const Table& table) {
  std::string values = bashValues(table.program, ""), words = bashWords(table.program, "", commandNames(table));
  for (const CommandRow& one : table.commands) {
    values += bashValues(one, one.name);
    words += bashWords(one, one.name, firstWords(one, table));
  }
  const std::string commands = table.commands.empty() ? "" : joined(commandNames(table), " | ");
  const std::string find =
      commands.empty() ? ""
                       : fmt::format("  case ${{COMP_WORDS[1]}} in {}) command=${{COMP_WORDS[1]}} ;; esac\n", commands);
  return fmt::format(R"(# bash completion of {0}
{1}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} command= options= words= files=
{2}  [ "$COMP_CWORD" -gt 1 ] || command=
  case $command:$before in
{3}    *)
      case $command in
{4}      esac
      if [[ $word == -* ]]; then
        words=$options
      elif [ -n "$command" ] && {{ [ "$COMP_CWORD" -gt 2 ] || [ -z "$words" ]; }}; then
        words= files=yes
      fi
      ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  [ -z "$files" ] || compopt -o default 2>/dev/null
}}
complete -F {1} {0}
)",
                     table.program.name, identifier(table.program.name), find, values, words);
}

std::string zshCompletion(const Table& table) {
  const std::string name = identifier(table.program.name);
  if (table.commands.empty()) {
    return fmt::format("#compdef {}\n{}\n", table.program.name, zshArguments(table.program, table));
  }
  std::string commands, cases;
  for (const CommandRow& one : table.commands) {
    commands += "    " + quoted(one.name + ":" + brief(one.meaning)) + "\n";
    cases += fmt::format("    {})\n      {}\n      ;;\n", one.name, zshArguments(one, table));
  }
  return fmt::format(R"(#compdef {0}
{1}() {{
  local -a commands
  commands=(
{2}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    {4}
    return
  fi
  shift words
  (( CURRENT-- ))
  case $words[1] in
{3}  esac
}}
{1} "$@"
)",
                     table.program.name, name, commands, cases, zshArguments(table.program, table));
}

std::string fishCompletion(const Table& table) {
  const std::string& program = table.program.name;
  std::string text = fishOptions(program, table.commands.empty() ? "true" : "__fish_use_subcommand", table.program);
  if (table.commands.empty()) return text;
  text = "complete -c " + program + " -n __fish_use_subcommand -f\n" + text;
  for (const CommandRow& one : table.commands) {
    const std::string when = "__fish_seen_subcommand_from " + one.name;
    text += fmt::format("complete -c {} -n __fish_use_subcommand -f -a {} -d {}\n", program, one.name,
                        quoted(brief(one.meaning)));
    if (const auto first = firstWords(one, table); !first.empty())
      text += fmt::format("complete -c {} -n {} -f -a {}\n", program, quoted(when), quoted(joined(first)));
    text += fishOptions(program, when, one);
  }
  return text;
}

}  // namespace breakaway::line
