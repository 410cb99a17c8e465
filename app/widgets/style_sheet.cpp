#include "widgets/style_sheet.h"

#include <QHash>

#include "widgets/look.h"

namespace breakaway {

namespace {

// Sizes are pixels on a grid of 4: controls 28 high, a radius of 4, a focus ring of 2.
constexpr const char* sheet = R"(
QToolTip { background: @surface; color: @ink; border: 1px solid @border; padding: 4px; }
QPushButton, QToolButton { background: @surface; color: @ink; border: 1px solid @border; border-radius: 4px;
  padding: 0 12px; min-height: 26px; }
QToolButton { padding: 0 8px; max-height: 26px; }
QPushButton::menu-indicator, QToolButton::menu-indicator { image: url(:/icons/arrow-down.svg); width: 10px; height: 10px;
  subcontrol-origin: padding; subcontrol-position: center right; right: 8px; }
QPushButton:hover, QToolButton:hover { background: @selected; }
QPushButton:pressed, QToolButton:pressed, QPushButton:checked, QToolButton:checked { background: @selected;
  border-color: @accentLine; }
QPushButton:disabled, QToolButton:disabled { background: @page; color: @disabled; border-color: @hairline; }
QPushButton:focus, QToolButton:focus { border: 2px solid @accentLine; padding: 0 11px; min-height: 24px; }
QToolButton:focus { padding: 0 7px; max-height: 24px; }
QPushButton[role="primary"] { background: @accent; color: #ffffff; border-color: @accent; font-weight: 600; }
QPushButton[role="primary"]:hover { background: @accentHover; }
QPushButton[role="primary"]:disabled { background: @page; color: @disabled; border-color: @border; }
QPushButton[role="primary"]:focus { border: 2px solid @ink; }
QPushButton[role="hold"] { min-height: 118px; }
QPushButton[role="hold"]:focus { min-height: 116px; }
QPushButton[role="chip"] { padding: 0 10px; }
QPushButton[role="chip"]:checked { color: @accentLine; border-color: @accentLine; background: @selected; }
QPushButton[role="chip"]:focus { padding: 0 9px; }
QPushButton[role="stop"] { background: @stop; color: #ffffff; border: 1px solid @stopBorder; font-weight: 700; font-size: 15px; }
QLabel[role="onStop"] { color: #ffffff; background: transparent; }
QPushButton[role="stop"]:hover { background: @stopHover; }
QPushButton[role="stop"]:focus { border: 2px solid @ink; }
QToolButton[role="bare"], QPushButton[role="bare"] { background: transparent; border: 2px solid transparent; padding: 0 6px;
  min-height: 24px; text-align: left; }
QToolButton[role="bare"]:hover, QPushButton[role="bare"]:hover { background: @selected; }
QToolButton[role="bare"]:focus, QPushButton[role="bare"]:focus { border-color: @accentLine; }
QFrame[role="card"] { background: @surface; border: 1px solid @hairline; border-radius: 4px; }
QFrame[role="card"][tone="good"] { border-left: 4px solid @good; }
QFrame[role="card"][tone="warning"] { border-left: 4px solid @warning; }
QFrame[role="card"][tone="trouble"] { border-left: 4px solid @trouble; }
QFrame[role="card"][tone="running"] { border: 1px solid @accentLine; }
QFrame[role="chip"] { background: @surface; border: 1px solid @border; border-radius: 4px; }
QFrame[role="chip"][tone="good"] { background: @goodBack; border-color: @good; }
QFrame[role="chip"][tone="warning"] { background: @warningBack; border-color: @warning; }
QFrame[role="chip"][tone="trouble"] { background: @troubleBack; border-color: @trouble; }
QLabel[tone="muted"] { color: @muted; }
QLabel[tone="good"] { color: @good; }
QLabel[tone="warning"] { color: @warning; }
QLabel[tone="trouble"] { color: @trouble; }
QLabel[tone="accent"] { color: @accentLine; }
QLabel[badge="good"] { color: @good; background: @goodBack; border-radius: 4px; padding: 2px 8px; font-weight: 600; }
QLabel[badge="warning"] { color: @warning; background: @warningBack; border-radius: 4px; padding: 2px 8px; font-weight: 600; }
QLabel[badge="trouble"] { color: @trouble; background: @troubleBack; border-radius: 4px; padding: 2px 8px; font-weight: 600; }
QLabel[badge="open"] { color: @muted; padding: 2px 8px; }
QLabel[badge="running"] { color: @accentLine; background: @selected; border-radius: 4px; padding: 2px 8px; font-weight: 600; }
QLabel[badge="simulated"] { color: @simulatedInk; background: @simulated; border-radius: 4px; padding: 2px 8px; font-weight: 600; }
QLineEdit, QAbstractSpinBox, QComboBox { background: @surface; color: @ink; border: 1px solid @border; border-radius: 4px;
  padding: 0 8px; min-height: 26px; selection-background-color: @accent; selection-color: #ffffff; }
QLineEdit:focus, QAbstractSpinBox:focus, QComboBox:focus { border: 2px solid @accentLine; padding: 0 7px; min-height: 24px; }
QLineEdit:disabled, QAbstractSpinBox:disabled, QComboBox:disabled { background: @page; color: @disabled;
  border-color: @hairline; }
QAbstractSpinBox[edited="true"] { background: @warningBack; border-color: @warning; }
QAbstractSpinBox { padding-right: 2px; }
QTableWidget QComboBox { margin: 2px; max-height: 26px; }
QComboBox::drop-down { border: 0; width: 22px; subcontrol-origin: padding; subcontrol-position: center right; }
QComboBox::down-arrow { image: url(:/icons/arrow-down.svg); width: 10px; height: 10px; }
QComboBox QAbstractItemView { background: @surface; color: @ink; border: 1px solid @border;
  selection-background-color: @accent; selection-color: #ffffff; outline: 0; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { border: 0; width: 16px; subcontrol-origin: border; background: transparent; }
QAbstractSpinBox::up-button { subcontrol-position: top right; }
QAbstractSpinBox::down-button { subcontrol-position: bottom right; }
QAbstractSpinBox::up-arrow { image: url(:/icons/arrow-up.svg); width: 8px; height: 8px; }
QAbstractSpinBox::down-arrow { image: url(:/icons/arrow-down.svg); width: 8px; height: 8px; }
QAbstractSpinBox::up-arrow:disabled, QAbstractSpinBox::up-arrow:off, QAbstractSpinBox::down-arrow:disabled,
QAbstractSpinBox::down-arrow:off { image: none; }
QCheckBox { spacing: 8px; min-height: 24px; border: 2px solid transparent; border-radius: 4px; }
QCheckBox:focus { border-color: @accentLine; }
QCheckBox:disabled { color: @disabled; }
QCheckBox::indicator, QAbstractItemView::indicator { width: 16px; height: 16px; border: 1px solid @border; border-radius: 4px; background: @surface; }
QCheckBox::indicator:checked, QAbstractItemView::indicator:checked { background: @accent; border-color: @accentLine; image: url(:/icons/check.svg); }
QSlider { min-height: 20px; }
QSlider::groove:horizontal { height: 4px; background: @border; border-radius: 2px; }
QSlider::sub-page:horizontal { background: @accentLine; border-radius: 2px; }
QSlider::sub-page:horizontal:disabled { background: @border; }
QSlider::handle:horizontal { width: 12px; margin: -6px 0; border-radius: 8px; border: 2px solid @accentLine; background: @surface; }
QSlider::handle:horizontal:disabled { border-color: @border; }
QSlider::handle:horizontal:focus { background: @accentLine; }
QProgressBar { background: @hairline; border: 0; border-radius: 4px; max-height: 8px; min-height: 8px; color: transparent; }
QProgressBar::chunk { background: @accentLine; border-radius: 4px; }
QProgressBar[tone="warning"]::chunk { background: @warning; }
QAbstractItemView { background: @surface; color: @ink; border: 1px solid @hairline; border-radius: 4px; outline: 0;
  alternate-background-color: @page; selection-background-color: @accent; selection-color: #ffffff; }
QAbstractItemView:focus { border: 2px solid @accentLine; }
QListView#boardList { padding: 4px; }
QListView#boardList::item { padding: 4px; }
QHeaderView { background: @surface; border: 0; }
QHeaderView::section { background: @surface; color: @muted; border: 0; border-bottom: 1px solid @hairline; padding: 4px; }
QTableCornerButton::section { background: @surface; border: 0; }
QScrollArea { border: 0; background: transparent; }
QScrollArea > QWidget > QWidget[role="column"] { background: transparent; }
QScrollBar:vertical { width: 12px; background: transparent; margin: 0; }
QScrollBar:horizontal { height: 12px; background: transparent; margin: 0; }
QScrollBar::handle { background: @border; border-radius: 3px; margin: 3px; min-height: 24px; min-width: 24px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QWidget[role="rail"] { background: @surface; }
QMenu { background: @surface; color: @ink; border: 1px solid @border; padding: 4px; }
QMenu::item { padding: 4px 16px; border-radius: 4px; }
QMenu::item:selected { background: @accent; color: #ffffff; }
QMenu::item:disabled { color: @disabled; }
QTextBrowser { background: @surface; }
QTextBrowser#reportPreview { background: @paper; color: @paperInk; }
QPlainTextEdit { background: @surface; color: @ink; border: 1px solid @border; border-radius: 4px; padding: 2px 4px; }
QPlainTextEdit:focus { border: 2px solid @accentLine; padding: 1px 3px; }
)";

}  // namespace

QString styleSheet(const Look& look) {
  const QHash<QString, QColor> colours{
      {"page", look.page},
      {"surface", look.surface},
      {"ink", look.ink},
      {"muted", look.muted},
      {"paper", Look::light().surface},  // as it is printed
      {"paperInk", Look::light().ink},
      {"disabled", look.disabled},
      {"border", look.border},
      {"hairline", look.hairline},
      {"accent", look.accent},
      {"accentLine", look.accentLine},
      {"accentHover", mixed(look.accent, Qt::black, 0.15)},
      {"selected", look.selected},
      {"stop", look.stop},
      {"stopBorder", look.stopBorder},
      {"stopHover", mixed(look.stop, Qt::black, 0.15)},
      {"trouble", look.trouble},
      {"troubleBack", look.troubleBack},
      {"warning", look.warning},
      {"warningBack", look.warningBack},
      {"good", look.good},
      {"goodBack", look.goodBack},
      {"simulated", look.simulated},
      {"simulatedInk", look.dark ? QColor(0x1c1530) : QColor(Qt::white)},
  };
  // Word by word: no name may be taken for the beginning of a longer one.
  const QString form = QString::fromLatin1(sheet);
  QString filled;
  for (qsizetype at = 0; at < form.size();) {
    if (form[at] != '@') {
      filled += form[at++];
      continue;
    }
    qsizetype end = at + 1;
    while (end < form.size() && form[end].isLetter()) ++end;
    filled += colours.value(form.mid(at + 1, end - at - 1)).name();
    at = end;
  }
  return filled;
}

}  // namespace breakaway
