#include "recording/import/raw_table.h"

#include <algorithm>

namespace breakaway {

void rememberText(RawColumn& column, size_t row, std::string_view text) {
  constexpr size_t mostKinds = 64, longestKind = 100;
  if (column.manyTexts) return;
  auto at = std::find(column.texts.begin(), column.texts.end(), text);
  if (at == column.texts.end()) {
    column.manyTexts = column.texts.size() >= mostKinds || text.size() > longestKind;
    if (column.manyTexts) {
      column.texts.clear();
      column.textOf.clear();
      return;
    }
    at = column.texts.emplace(column.texts.end(), text);
  }
  column.textOf.resize(row);
  column.textOf.push_back(static_cast<uint16_t>(at - column.texts.begin() + 1));
}

}  // namespace breakaway
