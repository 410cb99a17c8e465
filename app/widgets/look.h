// The program's own look: colours for light and dark, the type scale, and the manners of its plots.
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <functional>

class QCPAxis;
class QCPAxisRect;
class QCPPolarAxisAngular;
class QCustomPlot;
class QWidget;

namespace breakaway {

/// Text on `page`, `surface` and on its own `…Back` has a contrast of 4.5:1 at least; `border`, `accent` and the curves
/// have 3:1.
struct Look {
  bool dark = false;
  QColor page, surface;         ///< behind everything; of cards, fields and plots
  QColor ink, muted, disabled;  ///< of text
  QColor border;                ///< of what can be pressed or filled in
  QColor hairline;              ///< around cards and between rows: decoration
  QColor grid;                  ///< of plots
  QColor accent, accentLine;    ///< as a field with white text; as text or line
  QColor selected;              ///< behind what is chosen
  QColor stop, stopBorder;
  QColor trouble, troubleBack, warning, warningBack, good, goodBack;
  QColor simulated, simulatedBack;  ///< of everything that a simulated board drives

  /// By meaning: 0 counter-clockwise or the model, 1 clockwise or before, 2 to 4 others; index wraps.
  QColor curve(int index) const;
  /// Of the same curve as it was measured: thick and pale.
  QColor measured(int index) const;
  /// Of its interval.
  QColor band(int index) const;

  static const Look& light();
  static const Look& inDark();
  /// The one that the palette was made of.
  static const Look& of(const QPalette& palette);
};

enum class Theme { system, light, dark };
/// What the person chose last.
Theme keptTheme();
void keepTheme(Theme theme);
/// Whether the desktop prefers dark colours: by its settings portal, else by its own palette.
bool desktopIsDark();
/// Style, font, palette and style sheet of the whole application; may be called again at any time.
void wear(Theme theme);
QPalette paletteOf(const Look& look);

/// In pixels of a screen at 100 %.
enum class Type { caption = 11, body = 13, section = 15, title = 20, figure = 28 };
/// The application's font in that size; section, title and figure are semi-bold, the others only if `bold`.
QFont typed(Type type, bool bold = false);

/// Axes, grid, labels and background of a plot in the look; called again whenever the palette changes.
void dress(QCustomPlot& plot, const Look& look);
void dress(QCPAxisRect& rect, const Look& look);
void dress(QCPPolarAxisAngular& axis, const Look& look);

/// Calls `dress` whenever the widget's palette or font has changed, as long as the widget lives.
void onNewLook(QWidget* widget, std::function<void()> dress);

/// How much brighter one is than the other, 1 to 21, as WCAG 2.1 defines the contrast ratio; both opaque.
double contrast(const QColor& a, const QColor& b);
/// `share` of b over a.
QColor mixed(const QColor& a, const QColor& b, double share);

}  // namespace breakaway
