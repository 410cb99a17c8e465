// Plots in the look.
#include <qcustomplot.h>

#include <typeinfo>

#include "widgets/look.h"
#include "widgets/roomy_ticker.h"
#include "widgets/true_minus.h"

namespace breakaway {

namespace {

void dressAxis(QCPAxis& axis, const Look& look, const QFont& font) {
  axis.setBasePen(QPen(look.border, 1));
  axis.setTickPen(QPen(look.border, 1));
  axis.setSubTickPen(QPen(look.border, 1));
  axis.setTickLabelColor(look.muted);
  axis.setLabelColor(look.muted);
  axis.setTickLabelFont(font);
  axis.setLabelFont(font);
  axis.setTickLengthIn(0);
  axis.setTickLengthOut(4);
  axis.setSubTickLengthIn(0);
  axis.setSubTickLengthOut(0);
  axis.setLabelPadding(4);
  axis.setTickLabelPadding(4);
  axis.grid()->setPen(QPen(look.grid, 1));
  axis.grid()->setSubGridVisible(false);
  axis.grid()->setZeroLinePen(QPen(look.border, 1));
}

}  // namespace

void dress(QCPAxisRect& rect, const Look& look) {
  for (QCPAxis* axis : rect.axes()) dressAxis(*axis, look, typed(Type::caption));
  for (QCPAxis* axis : rect.axes()) {  // what a plot chose by itself stays
    const auto& ticker = *axis->ticker();
    if (typeid(ticker) != typeid(QCPAxisTicker)) continue;
    if (axis->axisType() == QCPAxis::atLeft)
      axis->setTicker(QSharedPointer<RoomyTicker>::create(*axis, ticker.tickCount()));
    else
      axis->setTicker(QSharedPointer<PlainTicker>::create());
  }
  rect.setBackground(QBrush(look.surface));
  rect.setMinimumSize(40, 16);  // where there is little room all are low, and no title is pushed out
}

void dress(QCPPolarAxisAngular& axis, const Look& look) {
  const QFont font = typed(Type::caption);
  axis.setBasePen(QPen(look.border, 1));
  axis.setTickPen(QPen(look.border, 1));
  axis.setSubTickPen(Qt::NoPen);
  axis.setTickLabelColor(look.muted);
  axis.setTickLabelFont(font);
  axis.grid()->setAngularPen(QPen(look.grid, 1));
  axis.grid()->setRadialPen(QPen(look.grid, 1));
  axis.grid()->setRadialSubGridPen(Qt::NoPen);
  axis.grid()->setAngularSubGridPen(Qt::NoPen);
  axis.grid()->setRadialZeroLinePen(Qt::NoPen);
  QCPPolarAxisRadial* radial = axis.radialAxis();
  radial->setBasePen(QPen(look.border, 1));
  radial->setTickPen(QPen(look.border, 1));
  radial->setSubTickPen(Qt::NoPen);
  radial->setTickLabelColor(look.muted);
  radial->setTickLabelFont(font);
  radial->setLabelColor(look.muted);
  radial->setLabelFont(font);
}

void dress(QCustomPlot& plot, const Look& look) {
  plot.setBackground(QBrush(look.surface));
  for (QCPAxisRect* rect : plot.axisRects()) dress(*rect, look);
  if (plot.legend == nullptr) return;
  QColor glass = look.surface;
  glass.setAlpha(215);
  plot.legend->setBrush(QBrush(glass));
  plot.legend->setBorderPen(Qt::NoPen);
  plot.legend->setTextColor(look.ink);
  plot.legend->setFont(typed(Type::caption));
  plot.legend->setIconSize(18, 8);
  plot.legend->setRowSpacing(0);
}

}  // namespace breakaway
