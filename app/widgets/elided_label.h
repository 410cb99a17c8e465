// A line of text in a slot that doesn't grow with it: what doesn't fit ends in an ellipsis, and the tooltip says it
// all.
#pragma once

#include <QLabel>

namespace breakaway {

class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(const char* objectName = "", QWidget* parent = nullptr);
  /// What it asks for doesn't depend on the text.
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  /// Said whole in the place of a text that has no room; the tooltip says it all.
  void setShorter(const QString& text);
  /// What is drawn, before any ellipsis.
  QString shown() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QString shorter_;
};

}  // namespace breakaway
