// Light, dark, or as the desktop has it; and the language from the next start on. The choices are kept.
#pragma once

#include <QPushButton>

class QLabel;

namespace breakaway {

class ThemeButton : public QPushButton {
  Q_OBJECT

 public:
  explicit ThemeButton(QWidget* parent = nullptr);

 signals:
  /// Says from when on which language is spoken.
  void languageKept(const QString& line);

 private:
  void showTheme();

  QLabel* text_ = nullptr;
};

}  // namespace breakaway
