// Times with their unit at each tick, so that they need no line of their own for it.
#pragma once

#include <qcustomplot.h>

#include <QCoreApplication>

namespace breakaway {

class SecondsTicker : public QCPAxisTicker {
  Q_DECLARE_TR_FUNCTIONS(breakaway::SecondsTicker)

 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    return tr("%1 s").arg(QCPAxisTicker::getTickLabel(tick, locale, format, precision));
  }
};

}  // namespace breakaway
