// A double click presses a button twice: the second time only where the button still says what was clicked.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

class QAbstractButton;

namespace breakaway {

/// A filter on the whole application.
class ClickGuard : public QObject {
 public:
  explicit ClickGuard(QObject* parent);
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QPointer<QAbstractButton> pressed_;
  QString said_;
};

}  // namespace breakaway
