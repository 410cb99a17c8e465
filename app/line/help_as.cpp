#include "line/help_as.h"

#include "line/completion.h"
#include "line/man_page.h"
#include "line/option_table.h"

namespace breakaway::line {

std::optional<Result<std::string>> helpAs(const CLI::App& app, const std::string& version,
                                          const std::vector<std::string>& words) {
  if (words.empty() || words[0] != "--help-as") return {};
  const std::string form = words.size() == 2 ? words[1] : std::string();
  const Table table = tableOf(app);
  if (form == "man") return Result<std::string>(manPage(table, version));
  if (form == "bash") return Result<std::string>(bashCompletion(table));
  if (form == "zsh") return Result<std::string>(zshCompletion(table));
  if (form == "fish") return Result<std::string>(fishCompletion(table));
  return Result<std::string>(Error{"--help-as", "expected one of: man, bash, zsh, fish"});
}

}  // namespace breakaway::line
