// Small makers that give every control its object name, its accessible name and, when it is disabled, the reason.
#pragma once

#include <QMargins>
#include <QString>

class QFrame;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;
class QWidget;

namespace breakaway {

QToolButton* toolButton(QWidget* parent, const char* objectName, const QString& text, const QString& tip);
QPushButton* pushButton(QWidget* parent, const char* objectName, const QString& text, const QString& tip = {});
/// One of several that stay pressed: what is shown.
QPushButton* chipButton(QWidget* parent, const char* objectName, const QString& text, const QString& tip);

/// Enabled with what it does as its tooltip, or disabled with why not.
void setAvailable(QWidget* control, bool available, const QString& tip, const QString& reason);
/// Available when `reason` is empty.
void setAvailable(QWidget* control, const QString& tip, const QString& reason);

/// Sets one of the style sheet's properties ("role", "tone", "badge") and draws the widget anew.
void dressAs(QWidget* widget, const char* property, const QString& value);

/// What is put into `widget` stands in a column, or in a row; a spacing of -1 is the style's.
QVBoxLayout* columnIn(QWidget* widget, int spacing = -1, const QMargins& margins = {});
QHBoxLayout* rowIn(QWidget* widget, int spacing = -1, const QMargins& margins = {});

/// A framed group on the page, its contents in a column with margins.
QFrame* card(QWidget* parent);
QVBoxLayout* columnOf(QFrame* card);
/// A card's heading.
QLabel* section(QWidget* parent, const QString& text);
/// A wrapped line of explanation, which can be selected.
QLabel* explanation(QWidget* parent, const QString& text, const char* objectName = "");
/// Small and muted.
QLabel* caption(QWidget* parent, const QString& text);

}  // namespace breakaway
