#include "recording/import/xlsx.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstring>
#include <pugixml.hpp>
#include <set>

#include "recording/import/text_table.h"

namespace breakaway {

namespace {

constexpr size_t mostSheetColumns = 16384;
constexpr size_t mostCells = 100'000'000;
constexpr size_t mostXml = size_t{256} << 20;  ///< bytes of one part; as a tree it takes ten times as much
constexpr int deepestText = 20;

/// The element's name without its namespace.
std::string_view localName(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node childOf(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_node& child : node.children()) {
    if (localName(child) == name) return child;
  }
  return {};
}

Result<void> load(const ZipArchive& archive, const std::string& member, const std::string& name,
                  pugi::xml_document& document) {
  auto text = archive.read(member);
  if (!text) return text.error();
  if (text->size() > mostXml)
    return Error{name + ", " + member, message("is more than 256 MB of XML; save the sheet as CSV")};
  const auto parsed =
      document.load_buffer(text->data(), text->size(), pugi::parse_default | pugi::parse_ws_pcdata_single);
  if (!parsed) return Error{name + ", " + member, message("is no well-formed XML")};
  return {};
}

/// All texts within an element, one after the other.
void appendText(const pugi::xml_node& node, std::string& text, int depth = 0) {
  if (depth > deepestText) return;
  for (const pugi::xml_node& child : node.children()) {
    if (localName(child) == "rPh") continue;  // how it is pronounced
    if (localName(child) == "t") {
      text += child.text().get();
    } else if (localName(child) == "r" || localName(child) == "is") {
      appendText(child, text, depth + 1);
    }
  }
}

std::vector<std::string> sharedTexts(const ZipArchive& archive, const std::string& name) {
  std::vector<std::string> texts;
  pugi::xml_document document;
  if (!archive.has("xl/sharedStrings.xml") || !load(archive, "xl/sharedStrings.xml", name, document)) return texts;
  for (const pugi::xml_node& item : document.document_element().children()) {
    std::string text;
    appendText(item, text);
    texts.push_back(std::move(text));
  }
  return texts;
}

bool isDateFormat(std::string_view code) {
  bool quoted = false, bracketed = false;
  for (const char c : code) {
    if (c == '"') quoted = !quoted;
    if (c == '[') bracketed = true;
    if (c == ']') bracketed = false;
    if (quoted || (bracketed && std::strchr("hms", c) == nullptr)) continue;
    if (std::strchr("dyhs", c) != nullptr) return true;
  }
  return false;
}

/// The numbers of the cell styles whose numbers are days.
std::set<unsigned> dateStyles(const ZipArchive& archive, const std::string& name) {
  std::set<unsigned> styles;
  pugi::xml_document document;
  if (!archive.has("xl/styles.xml") || !load(archive, "xl/styles.xml", name, document)) return styles;
  std::set<unsigned> formats{14, 15, 16, 17, 18, 19, 20, 21, 22, 45, 46, 47};
  for (const pugi::xml_node& format : childOf(document.document_element(), "numFmts").children()) {
    if (isDateFormat(format.attribute("formatCode").value())) formats.insert(format.attribute("numFmtId").as_uint());
  }
  unsigned index = 0;
  for (const pugi::xml_node& style : childOf(document.document_element(), "cellXfs").children()) {
    if (formats.contains(style.attribute("numFmtId").as_uint())) styles.insert(index);
    ++index;
  }
  return styles;
}

/// Column number of a reference such as "AB12"; `otherwise` when there is none.
size_t columnOf(std::string_view reference, size_t otherwise) {
  size_t column = 0;
  for (const char c : reference) {
    if (c < 'A' || c > 'Z') break;
    column = 26 * column + static_cast<size_t>(c - 'A' + 1);
    if (column > mostSheetColumns) return otherwise;
  }
  return column == 0 ? otherwise : column - 1;
}

/// Days since 1899-12-30 as a date and time, or a time alone within the first day.
std::string clockText(double days) {
  constexpr long long day_us = 86400000000, epoch_days = 25569;
  const long long all_us = std::llround(days * static_cast<double>(day_us));
  const long long day = all_us / day_us, micro = all_us % day_us;
  char text[80];
  const auto clock = [&](char* at, size_t size) {
    std::snprintf(at, size, "%02lld:%02lld:%02lld.%06lld", micro / 3600000000, micro / 60000000 % 60,
                  micro / 1000000 % 60, micro % 1000000);
  };
  if (day == 0) {
    clock(text, sizeof text);
    return text;
  }
  const std::chrono::year_month_day date{std::chrono::sys_days{std::chrono::days{day - epoch_days}}};
  const int used = std::snprintf(text, sizeof text, "%04d-%02u-%02uT", static_cast<int>(date.year()),
                                 static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
  clock(text + used, sizeof text - static_cast<size_t>(used));
  return text;
}

/// A cell without what would part cells or lines.
void appendCell(std::string_view cell, std::string& out) {
  for (const char c : cell) out += c == '\t' || c == '\n' || c == '\r' || c == '"' ? ' ' : c;
}

struct Sheet {
  std::string text;  ///< cells parted by tabs
  size_t rows = 0, width = 0, numbers = 0;

  bool tooWide() const { return rows * width > mostCells; }
};

Sheet sheetOf(const pugi::xml_node& worksheet, const std::vector<std::string>& shared,
              const std::set<unsigned>& dates) {
  Sheet sheet;
  for (const pugi::xml_node& row : childOf(worksheet, "sheetData").children()) {
    if (sheet.tooWide()) return sheet;
    size_t next = 0;
    std::string line;
    for (const pugi::xml_node& cell : row.children()) {
      const size_t column = std::max(columnOf(cell.attribute("r").value(), next), next);
      line.append(column - next, '\t');
      next = column;
      const std::string_view type = cell.attribute("t").value();
      const char* value = childOf(cell, "v").text().get();
      if (type == "s") {
        size_t index = shared.size();
        std::from_chars(value, value + std::strlen(value), index);
        if (index < shared.size()) appendCell(shared[index], line);
      } else if (type == "inlineStr") {
        std::string text;
        appendText(childOf(cell, "is"), text);
        appendCell(text, line);
      } else if (type == "e") {
      } else if (type == "str" || type == "b" || type == "d") {
        appendCell(value, line);
      } else if (*value != '\0') {
        ++sheet.numbers;
        const bool date = !dates.empty() && dates.contains(cell.attribute("s").as_uint());
        const double days = date ? std::strtod(value, nullptr) : 0.0;
        if (date && days >= 0.0 && days < 1e6) {
          line += clockText(days);
        } else {
          line += value;
        }
      }
      line += '\t';
      ++next;
    }
    if (!line.empty()) line.pop_back();
    sheet.width = std::max(sheet.width, next);
    ++sheet.rows;
    sheet.text += line;
    sheet.text += '\n';
  }
  return sheet;
}

}  // namespace

bool isWorkbook(const ZipArchive& archive) {
  return archive.has("xl/workbook.xml");
}

Result<RawTable> readWorkbook(const ZipArchive& archive, const std::string& name) {
  const auto shared = sharedTexts(archive, name);
  const auto dates = dateStyles(archive, name);
  Sheet best;
  std::string bestMember;
  size_t sheets = 0;
  for (const std::string& member : archive.members()) {
    if (!member.starts_with("xl/worksheets/") || !member.ends_with(".xml")) continue;
    pugi::xml_document document;
    if (const auto done = load(archive, member, name, document); !done) return done.error();
    ++sheets;
    Sheet sheet = sheetOf(document.document_element(), shared, dates);
    if (bestMember.empty() || sheet.numbers > best.numbers) {
      best = std::move(sheet);
      bestMember = member;
    }
  }
  if (best.numbers < 2) return Error{name, message("is an Excel workbook without a table of numbers")};
  if (best.tooWide()) return Error{name, message("has a sheet of more than 100 million cells")};
  // Rows that end earlier than others are filled up, so that all have the same number of cells.
  std::string filled;
  filled.reserve(best.text.size() + 64);
  size_t cells = 1;
  for (const char c : best.text) {
    if (c == '\t') ++cells;
    if (c == '\n') {
      filled.append(best.width - std::min(best.width, cells), '\t');
      cells = 1;
    }
    filled += c;
  }
  best.text = {};
  auto table = readTextTable(filled, name);
  if (!table) return table.error();
  if (sheets > 1)
    table->remarks.push_back(message("of {} sheets the one with the most numbers was read ({})", sheets,
                                     bestMember.substr(std::strlen("xl/worksheets/"))));
  return table;
}

}  // namespace breakaway
