#include "line/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace breakaway::line {

namespace {

/// Text that groff prints as it is.
std::string plain(const std::string& text) {
  std::string out;
  for (const char one : text) {
    const bool first = out.empty() || out.back() == '\n';
    if (first && (one == '.' || one == '\'')) out += "\\&";
    if (one == '-')
      out += "\\-";
    else if (one == '\\')
      out += "\\e";
    else
      out += one;
  }
  return out;
}

std::string joinedBy(const std::vector<std::string>& words, const char* between) {
  return fmt::format("{}", fmt::join(words, between));
}

std::string bold(const std::string& text) {
  return "\\fB" + plain(text) + "\\fR";
}

std::string valueOf(const OptionRow& row) {
  if (row.value.empty()) return {};
  return "\\fI" + plain(row.choices.empty() || row.placed() ? row.value : joinedBy(row.choices, "|")) + "\\fR" +
         (row.repeats ? " ..." : "");
}

std::string entry(const OptionRow& row) {
  std::string head;
  for (const std::string& name : row.names) head += (head.empty() ? "" : ", ") + bold(name);
  if (const std::string value = valueOf(row); !value.empty()) head += (head.empty() ? "" : " ") + value;
  std::vector<std::string> remarks;
  if (row.placed() && !row.choices.empty()) remarks.push_back("one of " + joinedBy(row.choices, ", "));
  if (!row.limits.empty()) remarks.push_back(row.limits);
  if (!row.preset.empty()) remarks.push_back("default: " + row.preset);
  if (row.required) remarks.emplace_back("required");
  const std::string remark = remarks.empty() ? "" : " (" + joinedBy(remarks, "; ") + ")";
  return ".TP\n" + head + "\n" + plain(row.meaning + remark) + "\n";
}

std::string entries(const CommandRow& command) {
  std::string text;
  for (const OptionRow& one : command.options) text += entry(one);
  return text;
}

/// What stands below a help: prose, and indented lines as they are typed.
std::string footer(const std::string& text) {
  std::string out;
  bool typed = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool indented = line.starts_with("  ");
    if (indented != typed) out += indented ? ".PP\n.nf\n.RS\n" : ".RE\n.fi\n";
    if (!indented && out.empty()) out += ".PP\n";
    out += plain(indented ? line.substr(2) : line) + "\n";
    typed = indented;
  }
  return out + (typed ? ".RE\n.fi\n" : "");
}

std::string synopsis(const Table& table) {
  const std::string name = bold(table.program.name);
  if (table.commands.empty()) return name + " [\\fIOPTIONS\\fR]\n";
  return name + " \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.br\n" + name + " " + bold("help") + " \\fICOMMAND\\fR\n";
}

std::string section(const CommandRow& command) {
  return ".SS " + plain(command.name) + "\n" + plain(command.meaning) + ".\n" + entries(command) +
         footer(command.footer);
}

/// "breakaway-board" as "BREAKAWAY\-BOARD"
std::string title(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char one) { return std::toupper(one); });
  return plain(name);
}

/// The text up to its first full stop or line's end, as a name's line has it.
std::string firstSentence(const std::string& text) {
  const size_t colon = text.find(": ");
  const std::string rest = colon == std::string::npos ? text : text.substr(colon + 2);
  return rest.substr(0, rest.find_first_of(".\n"));
}

}  // namespace

std::string manPage(const Table& table, const std::string& version) {
  std::string page = fmt::format(".TH {} 1 \"\" \"{}\" \"User Commands\"\n.ad l\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}",
                                 title(table.program.name), plain(version), plain(table.program.name),
                                 plain(firstSentence(table.program.meaning)), synopsis(table));
  page += ".SH DESCRIPTION\n" + plain(table.program.meaning) + "\n" + footer(table.program.footer);
  page += ".SH OPTIONS\n" + entries(table.program);
  if (!table.commands.empty()) page += ".SH COMMANDS\n";
  for (const CommandRow& one : table.commands) page += section(one);
  return page + ".SH ENVIRONMENT\n.TP\n\\fBBREAKAWAY_RESOURCES\\fR\n" +
         plain("the folder of presets and examples; without it, share/breakaway beside the program's own folder") +
         "\n.SH SEE ALSO\n" + plain("The manual: share/breakaway/help/index.md") +
         "\n.br\n.BR breakaway (1),\n.BR breakaway\\-board (1),\n.BR breakaway\\-gui (1)\n";
}

}  // namespace breakaway::line
