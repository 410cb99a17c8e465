#include "widgets/look.h"

#include <qcustomplot.h>

#include <QFile>
#include <QPainter>
#include <QSvgRenderer>
#include <array>

namespace breakaway {

namespace {

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto blend = [share](int x, int y) { return static_cast<int>(x + (y - x) * share); };
  return {blend(a.red(), b.red()), blend(a.green(), b.green()), blend(a.blue(), b.blue())};
}

QPalette paletteOf(const QColor& window, const QColor& base, const QColor& ink, const QColor& accent) {
  QPalette palette(window);
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, mixed(base, window, 0.5));
  palette.setColor(QPalette::Button, mixed(window, ink, 0.04));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    palette.setColor(role, ink);
    palette.setColor(QPalette::Disabled, role, mixed(ink, window, 0.55));
  }
  palette.setColor(QPalette::ToolTipBase, mixed(window, ink, 0.08));
  palette.setColor(QPalette::PlaceholderText, mixed(ink, base, 0.5));
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, accent);
  return palette;
}

void dressAxis(QCPAxis& axis, const Look& look, const QFont& font) {
  axis.setBasePen(QPen(look.line, 1));
  axis.setTickPen(QPen(look.line, 1));
  axis.setSubTickPen(QPen(look.line, 1));
  axis.setTickLabelColor(look.muted);
  axis.setLabelColor(look.ink);
  axis.setTickLabelFont(font);
  axis.setLabelFont(font);
  axis.setTickLengthIn(0);
  axis.setTickLengthOut(4);
  axis.setSubTickLengthIn(0);
  axis.setSubTickLengthOut(0);
  axis.setLabelPadding(3);
  axis.setTickLabelPadding(3);
  axis.grid()->setPen(QPen(look.grid, 1));
  axis.grid()->setSubGridVisible(false);
  axis.grid()->setZeroLinePen(QPen(look.line, 1));
}

}  // namespace

QColor Look::curve(int index) const {
  static const std::array<QColor, 7> onLight{
      QColor(0x00, 0x72, 0xb2), QColor(0xd5, 0x5e, 0x00), QColor(0x00, 0x8f, 0x68), QColor(0xb0, 0x55, 0x8c),
      QColor(0xb8, 0x86, 0x00), QColor(0x2f, 0x93, 0xc8), QColor(0x55, 0x55, 0x55)};
  static const std::array<QColor, 7> onDark{
      QColor(0x56, 0xb4, 0xe9), QColor(0xe6, 0x8a, 0x2e), QColor(0x1f, 0xc0, 0x93), QColor(0xd9, 0x8f, 0xba),
      QColor(0xf0, 0xe4, 0x42), QColor(0x3d, 0x95, 0xd0), QColor(0xb8, 0xb8, 0xb8)};
  return (dark ? onDark : onLight)[static_cast<size_t>(index) % onLight.size()];
}

Look Look::of(const QPalette& palette) {
  Look look;
  const QColor window = palette.color(QPalette::Window);
  const QColor ink = palette.color(QPalette::WindowText);
  look.dark = window.lightness() < ink.lightness();
  look.page = palette.color(QPalette::Base);
  look.panel = window;
  look.ink = ink;
  look.muted = mixed(ink, window, 0.35);
  look.line = mixed(window, ink, look.dark ? 0.32 : 0.28);
  look.grid = mixed(look.page, ink, look.dark ? 0.13 : 0.09);
  look.accent = palette.color(QPalette::Highlight);
  look.simulated =
      mixed(window, look.dark ? QColor(0x8f, 0x5f, 0xc8) : QColor(0x8a, 0x4f, 0xd0), look.dark ? 0.38 : 0.20);
  look.good = look.curve(2);
  look.warning = look.dark ? QColor(0xf0, 0xb4, 0x30) : QColor(0x9a, 0x62, 0x00);
  look.trouble = look.dark ? QColor(0xff, 0x7b, 0x6b) : QColor(0xb4, 0x1c, 0x10);
  look.band = look.curve(4);
  look.band.setAlpha(look.dark ? 46 : 52);
  return look;
}

QPalette lightPalette() {
  return paletteOf(QColor(0xef, 0xf0, 0xf2), QColor(0xff, 0xff, 0xff), QColor(0x1d, 0x21, 0x27),
                   QColor(0x1f, 0x6f, 0xb5));
}

QPalette darkPalette() {
  return paletteOf(QColor(0x22, 0x25, 0x2a), QColor(0x18, 0x1a, 0x1e), QColor(0xe2, 0xe5, 0xe9),
                   QColor(0x2d, 0x7d, 0xc4));
}

void dress(QCPAxisRect& rect, const Look& look) {
  const QFont font = sized(rect.parentPlot()->font(), 0.88);
  for (QCPAxis* axis : rect.axes()) dressAxis(*axis, look, font);
  rect.setBackground(QBrush(look.page));
}

void dress(QCPPolarAxisAngular& axis, const Look& look) {
  const QFont font = sized(axis.parentPlot()->font(), 0.88);
  axis.setBasePen(QPen(look.line, 1));
  axis.setTickPen(QPen(look.line, 1));
  axis.setSubTickPen(Qt::NoPen);
  axis.setTickLabelColor(look.muted);
  axis.setTickLabelFont(font);
  axis.grid()->setAngularPen(QPen(look.grid, 1));
  axis.grid()->setRadialPen(QPen(look.grid, 1));
  axis.grid()->setRadialSubGridPen(Qt::NoPen);
  axis.grid()->setAngularSubGridPen(Qt::NoPen);
  axis.grid()->setRadialZeroLinePen(Qt::NoPen);
  QCPPolarAxisRadial* radial = axis.radialAxis();
  radial->setBasePen(QPen(look.line, 1));
  radial->setTickPen(QPen(look.line, 1));
  radial->setSubTickPen(Qt::NoPen);
  radial->setTickLabelColor(look.muted);
  radial->setTickLabelFont(font);
  radial->setLabelColor(look.ink);
  radial->setLabelFont(font);
}

void dress(QCustomPlot& plot, const Look& look) {
  plot.setBackground(QBrush(look.page));
  for (QCPAxisRect* rect : plot.axisRects()) dress(*rect, look);
  if (plot.legend != nullptr) {
    plot.legend->setBrush(QBrush(QColor(look.page.red(), look.page.green(), look.page.blue(), 215)));
    plot.legend->setBorderPen(Qt::NoPen);
    plot.legend->setTextColor(look.ink);
    plot.legend->setFont(sized(plot.font(), 0.88));
    plot.legend->setIconSize(18, 8);
    plot.legend->setRowSpacing(0);
  }
}

QIcon lineIcon(const QString& name, const QPalette& palette) {
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray drawing = file.readAll();
  const auto painted = [&drawing](const QColor& ink) {
    QSvgRenderer renderer(QByteArray(drawing).replace("currentColor", ink.name().toUtf8()));
    QPixmap pixmap(48, 48);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    renderer.render(&painter);
    return pixmap;
  };
  QIcon icon;
  icon.addPixmap(painted(palette.color(QPalette::WindowText)), QIcon::Normal);
  icon.addPixmap(painted(palette.color(QPalette::HighlightedText)), QIcon::Selected);
  icon.addPixmap(painted(palette.color(QPalette::Disabled, QPalette::WindowText)), QIcon::Disabled);
  return icon;
}

QFont sized(const QFont& font, double factor, bool bold) {
  QFont result = font;
  result.setPointSizeF(font.pointSizeF() * factor);
  result.setBold(bold);
  return result;
}

}  // namespace breakaway
