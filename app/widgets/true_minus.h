// Tick labels with minus signs, where the plot's own have hyphens.
#pragma once

#include <qcustomplot.h>

#include "widgets/number_text.h"

namespace breakaway {

template <class Ticker>
class TrueMinus : public Ticker {
 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    return typeset(Ticker::getTickLabel(tick, locale, format, precision));
  }
};

using PlainTicker = TrueMinus<QCPAxisTicker>;

}  // namespace breakaway
