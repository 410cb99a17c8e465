// Angles with their sign at each tick, so that they need no line of their own for it.
#pragma once

#include <qcustomplot.h>

namespace breakaway {

class DegreeTicker : public QCPAxisTickerFixed {
 public:
  explicit DegreeTicker(double step_deg) { setTickStep(step_deg); }

 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    return QCPAxisTickerFixed::getTickLabel(tick, locale, format, precision) + QChar(0xb0);
  }
};

}  // namespace breakaway
