// A finished report for somebody: with a customer's name and remarks, and with the chapters that were chosen.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace breakaway {

struct ReportEdit {
  std::string customer, remarks;     ///< plain text; a line break stays one
  std::vector<std::string> leftOut;  ///< chapters, by their headings
};

/// The headings of a report's chapters in order, as plain text. `html` is what HtmlReport::html() gave.
std::vector<std::string> chaptersOf(const std::string& html);

/// The same report with what `edit` says below its title, and without the chapters that are left out. The title, the
/// verdict, and where it comes from always stay.
std::string editedReport(const std::string& html, const ReportEdit& edit);

}  // namespace breakaway
