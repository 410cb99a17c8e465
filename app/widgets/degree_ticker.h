// Angles with their sign at each tick, so that they need no line of their own for it.
#pragma once

#include <qcustomplot.h>

#include "widgets/true_minus.h"

namespace breakaway {

class DegreeTicker : public TrueMinus<QCPAxisTickerFixed> {
 public:
  explicit DegreeTicker(double step_deg) { setTickStep(step_deg); }

 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    return TrueMinus::getTickLabel(tick, locale, format, precision) + QChar(0xb0);
  }
};

/// At parts of a turn that divide it evenly, as many as there is room for; finer than a degree by decimals.
class RoundDegreeTicker : public PlainTicker {
 protected:
  double getTickStep(const QCPRange& range) override {
    const double wanted = range.size() / tickCount();
    for (const double step : {1.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0, 180.0, 360.0})
      if (wanted > 0.5 && wanted <= step) return step;
    return QCPAxisTicker::getTickStep(range);
  }
};

}  // namespace breakaway
