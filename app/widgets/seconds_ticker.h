// Times with their unit at each tick, so that they need no line of their own for it.
#pragma once

#include <qcustomplot.h>

#include <QCoreApplication>

#include "widgets/true_minus.h"

namespace breakaway {

class SecondsTicker : public PlainTicker {
  Q_DECLARE_TR_FUNCTIONS(breakaway::SecondsTicker)

 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    return tr("%1 s").arg(PlainTicker::getTickLabel(tick, locale, format, precision));
  }
};

}  // namespace breakaway
