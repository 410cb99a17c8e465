// Text with one value per line, by its name: long tables, line protocols.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "recording/import/raw_table.h"
#include "recording/import/text_layout.h"
#include "recording/import/text_names.h"

namespace breakaway {

/// Lines that tell names and stamps themselves: InfluxDB's line protocol, Teleplot's. Nothing: the text is none.
std::optional<Result<RawTable>> readLineProtocol(std::string_view text, char lineEnd, const std::string& name);

/// A table whose columns tell time, name and value, so that each row is one signal's; `rows`: from the first row on.
/// Nothing: each row has all signals.
std::optional<Result<RawTable>> readLongTable(std::string_view rows, char lineEnd, const TextLayout& layout,
                                              const TextNames& names, const std::string& name);

/// Whether a column of this name tells a signal's name, or its value.
bool tellsSignal(std::string_view column);
bool tellsValue(std::string_view column);

}  // namespace breakaway
