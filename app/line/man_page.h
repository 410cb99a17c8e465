// A program's man page.
#pragma once

#include <string>

#include "line/option_table.h"

namespace breakaway::line {

/// The page of section 1, for groff's man macros; `version` stands at its foot ("breakaway 0.2.0").
std::string manPage(const Table& table, const std::string& version);

}  // namespace breakaway::line
