#include "recording/import/list_cells.h"

#include <algorithm>
#include <vector>

#include "recording/import/text_layout.h"

namespace breakaway {

namespace {

using ListCells = std::vector<std::string_view>;

/// The line's cells, parted by commas outside quotes, quotes left on.
void splitQuoted(std::string_view line, ListCells& cells) {
  cells.clear();
  size_t start = 0;
  bool quoted = false;
  for (size_t k = 0; k <= line.size(); ++k) {
    const bool end = k == line.size();
    if (!end && line[k] == '"') quoted = !quoted;
    if (!end && (line[k] != ',' || quoted)) continue;
    cells.push_back(withoutBlanks(line.substr(start, k - start)));
    start = k + 1;
  }
}

/// What stands in the brackets of a quoted list of numbers.
std::optional<std::string_view> listIn(std::string_view cell) {
  if (cell.size() < 4 || cell.front() != '"' || cell.back() != '"') return std::nullopt;
  cell = withoutBlanks(cell.substr(1, cell.size() - 2));
  if (cell.starts_with("array(") && cell.ends_with(")")) {
    const size_t open = cell.find('[');
    if (open == std::string_view::npos) return std::nullopt;
    cell = withoutBlanks(cell.substr(open, cell.size() - open - 1));
  }
  const bool brackets =
      cell.size() >= 2 && ((cell.front() == '[' && cell.back() == ']') || (cell.front() == '(' && cell.back() == ')'));
  if (!brackets || cell.find_first_of("'\"[(", 1) != std::string_view::npos) return std::nullopt;
  return withoutBlanks(cell.substr(1, cell.size() - 2));
}

/// A list's items; commas or blanks part them.
void itemsOf(std::string_view list, ListCells& items) {
  items.clear();
  while (!list.empty()) {
    const size_t end = list.find_first_of(", \t");
    items.push_back(list.substr(0, end));
    const size_t next = end == std::string_view::npos ? end : list.find_first_not_of(", \t", end);
    list = next == std::string_view::npos ? std::string_view{} : list.substr(next);
  }
}

/// How many items each cell of the line holds; 0 for one that is no list.
std::vector<size_t> lengthsOf(const ListCells& cells) {
  std::vector<size_t> lengths;
  ListCells items;
  for (const std::string_view cell : cells) {
    const auto list = listIn(cell);
    if (list) itemsOf(*list, items);
    lengths.push_back(list ? items.size() : 0);
  }
  return lengths;
}

bool hasList(const std::vector<size_t>& lengths) {
  return std::any_of(lengths.begin(), lengths.end(), [](size_t length) { return length > 0; });
}

void appendNames(const ListCells& names, const std::vector<size_t>& lengths, std::string& out) {
  for (size_t c = 0; c < names.size(); ++c) {
    std::string_view name = names[c];
    if (lengths[c] > 1 && name.size() >= 2 && name.front() == '"') name = name.substr(1, name.size() - 2);
    for (size_t k = 0; k < std::max<size_t>(1, lengths[c]); ++k) {
      if (!out.empty() && out.back() != '\n') out += ',';
      out += name;
      if (lengths[c] > 1) out += "[" + std::to_string(k) + "]";
    }
  }
  out += '\n';
}

void appendRow(const ListCells& cells, std::string& out) {
  ListCells items;
  bool first = true;
  for (const std::string_view cell : cells) {
    const auto list = listIn(cell);
    if (list) {
      itemsOf(*list, items);
    } else {
      items.assign(1, cell);
    }
    for (const std::string_view item : items) {
      if (!first) out += ',';
      first = false;
      out += item;
    }
  }
  out += '\n';
}

}  // namespace

std::optional<std::string> withListsInCells(std::string_view text) {
  constexpr size_t searched = 20000;
  const std::string_view head = text.substr(0, searched);
  const bool maybe = head.find("\"[") != std::string_view::npos || head.find("\"(") != std::string_view::npos ||
                     head.find("\"array(") != std::string_view::npos;
  if (!maybe) return std::nullopt;
  const char lineEnd = lineEndOf(text);
  std::string out, before;
  ListCells cells, names;
  std::vector<size_t> lengths;
  while (!text.empty()) {
    const std::string_view line = takeLine(text, lineEnd);
    splitQuoted(withoutBlanks(line), cells);
    const auto found = lengthsOf(cells);
    if (lengths.empty() && !hasList(found)) {
      if (!names.empty() || !before.empty()) out += before + "\n";
      names = cells;
      before = line;
      if (out.size() > searched) return std::nullopt;
      continue;
    }
    if (lengths.empty()) {
      lengths = found;
      if (names.size() != cells.size()) return std::nullopt;
      appendNames(names, lengths, out);
    }
    if (!hasList(found) && cells.size() != lengths.size()) continue;  // a line cut short
    if (found != lengths) return std::nullopt;
    appendRow(cells, out);
  }
  return lengths.empty() ? std::nullopt : std::optional(std::move(out));
}

}  // namespace breakaway
