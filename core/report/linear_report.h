// A commissioned linear axis in words and as a report, drawn over its travel.
#pragma once

#include <string>

#include "commission/commission.h"

namespace breakaway {

std::string linearReportHtml(const Commission& done, bool hasTruth);
/// The averages in a few lines of plain text.
std::string linearInWords(const Commission& done);

}  // namespace breakaway
