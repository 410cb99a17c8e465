// A slot for a file: what it is for, which file is in it, and something about that. Pressed, it asks for another.
#pragma once

#include <QPushButton>

class QLabel;

namespace breakaway {

class ElidedLabel;

class FileSlot : public QPushButton {
  Q_OBJECT

 public:
  FileSlot(const char* objectName, const QString& title, const QString& tip, QWidget* parent);
  /// An empty name: nothing is in it.
  void show(const QString& name, const QString& about);
  using QWidget::show;

 private:
  QString title_;
  ElidedLabel* name_ = nullptr;
  QLabel* about_ = nullptr;
};

}  // namespace breakaway
