// A report as text with pictures, as Qt draws it: for a preview and for paper.
#pragma once

#include <QImage>
#include <QList>
#include <QString>

#include "base/result.h"
#include "draw/html_chapters.h"

class QTextDocument;

namespace breakaway {

struct DrawnReport {
  QString html;  ///< figures are "figure:0", "figure:1", …
  QList<QImage> figures;
  QStringList chapters;  ///< all of the report's, whatever is left out
};

/// Draws what HtmlReport::html() gave, edited; in any thread. `width_px`: of the widest figure.
DrawnReport drawn(const std::string& html, const ReportEdit& edit, int width_px);

/// Puts it into a document.
void fill(QTextDocument& document, const DrawnReport& report);

/// A4 pages, the whole file or nothing; in any thread.
Result<void> writePdf(const DrawnReport& report, const std::string& path);

}  // namespace breakaway
