// Light, dark, or as the desktop has it; and which language is spoken. The choices are kept.
#pragma once

#include <QPushButton>

#include "session/language.h"

class QLabel;

namespace breakaway {

class ThemeButton : public QPushButton {
  Q_OBJECT

 public:
  explicit ThemeButton(QWidget* parent = nullptr);

 signals:
  void languageChosen(breakaway::Language language);

 private:
  void showTheme();

  QLabel* text_ = nullptr;
};

}  // namespace breakaway
