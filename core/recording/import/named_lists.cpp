#include "recording/import/named_lists.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>
#include <vector>

#include "recording/import/npy.h"
#include "recording/import/text_layout.h"

namespace breakaway {

namespace {

constexpr std::string_view blanks = " \t\r\n;";

bool continuesName(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

/// Takes blanks and comments off the front.
void skipBetween(std::string_view& text) {
  while (!text.empty()) {
    const size_t begin = text.find_first_not_of(blanks);
    text.remove_prefix(std::min(begin, text.size()));
    if (text.empty() || (text.front() != '#' && text.front() != '%')) return;
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
}

/// "rpm" of "rpm = …", and takes it off with the mark; empty where no name stands.
std::string_view takeName(std::string_view& text) {
  size_t end = 0;
  while (end < text.size() && continuesName(text[end])) ++end;
  const std::string_view name = text.substr(0, end);
  const size_t mark = std::min(text.find_first_not_of(" \t", end), text.size());
  const bool named = end > 0 && std::isdigit(static_cast<unsigned char>(name.front())) == 0 && mark < text.size() &&
                     (text[mark] == '=' || text[mark] == ':');
  if (!named) return {};
  text.remove_prefix(mark + 1);
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  return name;
}

/// The numbers of "1, 2, 3", "1 2 3" or "1; 2; 3", also over several lines; nothing where a text stands among them, or
/// rows of several.
std::optional<std::vector<double>> numbersOf(std::string_view list) {
  constexpr std::string_view between = " \t\r\n,;";
  const TextLayout layout;
  const auto rows = static_cast<size_t>(std::count(list.begin(), list.end(), ';'));
  std::vector<double> numbers;
  while (true) {
    list.remove_prefix(std::min(list.find_first_not_of(between), list.size()));
    if (list.empty()) return rows == 0 || rows + 1 >= numbers.size() ? std::optional(numbers) : std::nullopt;
    const size_t end = std::min(list.find_first_of(between), list.size());
    TextNumber number;
    if (readCell(list.substr(0, end), layout, number) != TextCell::number || number.large) return std::nullopt;
    numbers.push_back(number.value);
    list.remove_prefix(end);
  }
}

/// The values behind a name, taken off the text.
std::optional<std::vector<double>> takeValues(std::string_view& text) {
  for (const std::string_view call : {"np.array(", "numpy.array(", "array("}) {
    if (text.starts_with(call)) text.remove_prefix(call.size());
  }
  if (text.empty()) return std::nullopt;
  const bool list = text.front() == '[' || text.front() == '(' || text.front() == '{';
  const char last = text.front() == '[' ? ']' : text.front() == '(' ? ')' : '}';
  const size_t end = list ? text.find(last) : std::min(text.find_first_of("\n;#%"), text.size());
  if (end == std::string_view::npos) return std::nullopt;
  auto numbers = numbersOf(text.substr(list ? 1 : 0, list ? end - 1 : end));
  text.remove_prefix(std::min(list ? end + 1 : end, text.size()));
  if (list && text.starts_with(")")) text.remove_prefix(1);
  return numbers;
}

}  // namespace

std::optional<Result<RawTable>> readNamedLists(std::string_view text, const std::string& name) {
  constexpr size_t mostColumns = 5000, shortest = 4;
  std::vector<RawColumn> columns;
  std::set<std::string_view> names;
  size_t longest = 0;
  for (skipBetween(text); !text.empty(); skipBetween(text)) {
    const std::string_view named = takeName(text);
    // A name that comes again labels rows: "RPM: 120, 118".
    if (named.empty() || columns.size() >= mostColumns || !names.insert(named).second) return std::nullopt;
    auto values = takeValues(text);
    if (!values) return std::nullopt;
    longest = std::max(longest, values->size());
    columns.push_back({{std::string(named), std::move(*values)}, {}});
  }
  if (longest < shortest) return std::nullopt;
  return tableOfColumns(std::move(columns), name);
}

}  // namespace breakaway
