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

/// Enabled with what it does as its tooltip, or disabled with why not.
void setAvailable(QWidget* control, bool available, const QString& tip, const QString& reason);
/// Available when `reason` is empty.
void setAvailable(QWidget* control, const QString& tip, const QString& reason);

/// What is put into `widget` stands in a column, or in a row; a spacing of -1 is the style's.
QVBoxLayout* columnIn(QWidget* widget, int spacing = -1, const QMargins& margins = {});
QHBoxLayout* rowIn(QWidget* widget, int spacing = -1, const QMargins& margins = {});

/// A heading of a page, and a wrapped line of explanation below it.
QLabel* heading(QWidget* parent, const QString& text);
QLabel* explanation(QWidget* parent, const QString& text, const char* objectName = "");
/// A heading of a group of controls.
QLabel* caption(QWidget* parent, const QString& text);
/// A thin line between groups.
QFrame* rule(QWidget* parent);

}  // namespace breakaway
