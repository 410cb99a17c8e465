// A program's commands and options as one table, from its parser: what man pages and completions are made of.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace breakaway::line {

struct OptionRow {
  std::vector<std::string> names;    ///< "--out", "-h"; empty for what has only a place
  std::string value;                 ///< what stands after it: "TEXT", "FLOAT", a place's own name; empty: a flag
  std::vector<std::string> choices;  ///< the only values there are; empty: any
  std::string limits;                ///< of a value in words: "INT in [2 - 120]"; empty: none
  std::string preset;                ///< the value that it has without; empty: none
  std::string meaning;
  bool required = false, repeats = false;

  bool placed() const { return names.empty(); }
  /// A word that a file or folder may be.
  bool mayBeFile() const {
    return choices.empty() && (value == "TEXT" || value == "DIR" || (placed() && !value.empty()));
  }
};

struct CommandRow {
  std::string name, meaning, footer;
  std::vector<OptionRow> options;  ///< in the order in which they were declared, option groups in their place
};

struct Table {
  CommandRow program;  ///< its name, and its options before any command
  std::vector<CommandRow> commands;
};

/// All of `app`; hidden options are left out.
Table tableOf(const CLI::App& app);

}  // namespace breakaway::line
