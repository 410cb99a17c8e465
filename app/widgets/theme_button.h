// Light, dark, or as the desktop has it; the choice is kept.
#pragma once

#include <QPushButton>

class QLabel;

namespace breakaway {

class ThemeButton : public QPushButton {
  Q_OBJECT

 public:
  explicit ThemeButton(QWidget* parent = nullptr);

 private:
  void showTheme();

  QLabel* text_ = nullptr;
};

}  // namespace breakaway
