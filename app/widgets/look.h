// Colours and plot manners of the house, from the system's palette: light or dark, colour-blind-safe curves.
#pragma once

#include <QColor>
#include <QFont>
#include <QIcon>
#include <QPalette>
#include <QString>

class QCPAxis;
class QCPAxisRect;
class QCPPolarAxisAngular;
class QCustomPlot;

namespace breakaway {

struct Look {
  bool dark = false;
  QColor page, panel, ink, muted, line, grid, accent;
  QColor simulated;  ///< tint of everything that a simulated board drives
  QColor good, warning, trouble;
  QColor band;  ///< highlighted stretches
  QColor stop = QColor(0xc6, 0x1a, 0x1a);

  /// Okabe and Ito's colours, lightened or darkened so that each has contrast against the page; index wraps.
  QColor curve(int index) const;

  static Look of(const QPalette& palette);
};

/// The two palettes that `--screenshots` shows, and that stand in when the system names none.
QPalette lightPalette();
QPalette darkPalette();

/// Axes, grid, labels and background of a plot in the look; called again whenever the palette changes.
void dress(QCustomPlot& plot, const Look& look);
void dress(QCPAxisRect& rect, const Look& look);
void dress(QCPPolarAxisAngular& axis, const Look& look);

/// A line icon of resources/icons in the palette's ink.
QIcon lineIcon(const QString& name, const QPalette& palette);

/// The application's font, smaller or larger by a factor; with digits of equal width.
QFont sized(const QFont& font, double factor, bool bold = false);

}  // namespace breakaway
