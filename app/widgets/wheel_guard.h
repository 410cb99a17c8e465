// The wheel scrolls; it changes a value only where the focus is.
#pragma once

#include <QObject>

namespace breakaway {

/// A filter on the whole application.
class WheelGuard : public QObject {
 public:
  explicit WheelGuard(QObject* parent);
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace breakaway
