#include "widgets/drawn_report.h"

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>
#include <QTextDocument>
#include <QUrl>
#include <tuple>

#include "base/atomic_file.h"

namespace breakaway {

namespace {

constexpr double ratio = 2.0;  // pixels of a picture to each of the text's
constexpr int margin_mm = 16, paperWidth_px = 640;
constexpr const char* reportSheet =
    "body { font-family: sans-serif; } h1 { font-size: 20px; } h2 { font-size: 16px; margin-top: 16px; }"
    "h3 { font-size: 14px; } .verdict { background: #f4f6f8; } th, td { padding: 2px 12px 2px 0; text-align: left; } "
    "th { font-size: 11px; } "
    "pre { white-space: pre-wrap; }";

/// From `from` on: the next stretch that begins and ends so, its end behind it; both npos where there is none.
std::pair<qsizetype, qsizetype> stretch(const QString& text, const QString& begin, const QString& end, qsizetype from) {
  const qsizetype first = text.indexOf(begin, from);
  if (first < 0) return {-1, -1};
  const qsizetype last = text.indexOf(end, first);
  return {first, last < 0 ? text.size() : last + end.size()};
}

/// Its colours for dark screens are what Qt's reader of SVG can't tell from the others.
QString withoutStyle(QString text) {
  for (auto [first, last] = stretch(text, "<style>", "</style>", 0); first >= 0;
       std::tie(first, last) = stretch(text, "<style>", "</style>", first))
    text.remove(first, last - first);
  return text;
}

/// A figure as a block of its own: what Qt's reader doesn't know it takes as a part of what stands before it, the last
/// item of a list for example.
QString withPlainFigures(QString text) {
  return text.replace("<figure>", "<div>")
      .replace("</figure>", "</div>")
      .replace("<figcaption>", "<p>")
      .replace("</figcaption>", "</p>");
}

QImage pictureOf(const QString& svg, int width_px) {
  QSvgRenderer renderer(svg.toUtf8());
  QSize size = renderer.defaultSize();
  if (size.isEmpty()) return {};
  if (size.width() > width_px) size = size * (static_cast<double>(width_px) / size.width());
  QImage picture(size * ratio, QImage::Format_RGB32);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  renderer.render(&painter);
  painter.end();
  picture.setDevicePixelRatio(ratio);
  return picture;
}

}  // namespace

DrawnReport drawn(const std::string& html, const ReportEdit& edit, int width_px) {
  DrawnReport report;
  for (const std::string& chapter : chaptersOf(html)) report.chapters << QString::fromStdString(chapter);
  const QString text = withPlainFigures(withoutStyle(QString::fromStdString(editedReport(html, edit))));
  qsizetype done = 0;
  for (auto [first, last] = stretch(text, "<svg", "</svg>", 0); first >= 0;
       std::tie(first, last) = stretch(text, "<svg", "</svg>", last)) {
    const QImage picture = pictureOf(text.mid(first, last - first), width_px);
    report.html += text.mid(done, first - done) + QString("<img src=\"figure:%1\" width=\"%2\" height=\"%3\">")
                                                      .arg(report.figures.size())
                                                      .arg(picture.width() / ratio)
                                                      .arg(picture.height() / ratio);
    report.figures << picture;
    done = last;
  }
  report.html += text.mid(done);
  return report;
}

void fill(QTextDocument& document, const DrawnReport& report) {
  document.clear();
  document.setDefaultStyleSheet(reportSheet);
  for (qsizetype k = 0; k < report.figures.size(); ++k)
    document.addResource(QTextDocument::ImageResource, QUrl(QString("figure:%1").arg(k)), report.figures[k]);
  document.setHtml(report.html);
}

Result<void> writePdf(const DrawnReport& report, const std::string& path) {
  QBuffer pages;
  pages.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&pages);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(margin_mm, margin_mm, margin_mm, margin_mm), QPageLayout::Millimeter);
    writer.setCreator("breakaway");
    QTextDocument document;
    fill(document, report);
    writer.setResolution(static_cast<int>(paperWidth_px / ((210.0 - 2.0 * margin_mm) / 25.4)));
    document.setPageSize(QSizeF(writer.width(), writer.height()));
    document.print(&writer);
  }
  return writeFile(path, pages.data().toStdString());
}

}  // namespace breakaway
