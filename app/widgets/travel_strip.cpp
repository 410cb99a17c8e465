#include "widgets/travel_strip.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/look.h"
#include "widgets/number_text.h"

namespace breakaway {

namespace {

constexpr double stripMm = 1e3;
constexpr double rail_px = 26.0, carriage_px = 12.0, side_px = 40.0, stop_px = 12.0;
constexpr double leastSpan_m = 0.1;  // before anything is known
constexpr int mostTicks = 10, leastHeight = 130;

/// A round step of 1, 2 or 5 that gives no more than `mostTicks`.
double roundStep(double span) {
  const double magnitude = std::pow(10.0, std::floor(std::log10(span / mostTicks)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (span / (digit * magnitude) <= mostTicks) return digit * magnitude;
  }
  return 10.0 * magnitude;
}

}  // namespace

TravelStrip::TravelStrip(QWidget* parent) : QWidget(parent) {
  setObjectName("travelStrip");
  setAccessibleName(tr("Position of the axis"));
}

void TravelStrip::show(std::optional<double> position_m, const std::optional<Travel>& travel,
                       std::optional<double> index_m) {
  if (!position_m) seenLow_m_ = seenHigh_m_ = 0.0;
  if (position_m) {
    seenLow_m_ = std::min(position_m_ ? seenLow_m_ : *position_m, *position_m);
    seenHigh_m_ = std::max(position_m_ ? seenHigh_m_ : *position_m, *position_m);
  }
  position_m_ = position_m;
  travel_ = travel;
  index_m_ = index_m;
  update();
}

TravelStrip::Scale TravelStrip::scale() const {
  const double left = side_px, width_px = std::max(1.0, width() - 2.0 * side_px);
  if (travel_) return {travel_->low_m, travel_->high_m, left, width_px};
  const double middle = 0.5 * (seenLow_m_ + seenHigh_m_);
  const double half = 0.5 * std::max(leastSpan_m, 1.2 * (seenHigh_m_ - seenLow_m_));
  return {middle - half, middle + half, left, width_px};
}

void TravelStrip::paintEvent(QPaintEvent*) {
  if (height() < leastHeight) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Scale at = scale();
  const double y = 0.42 * height();
  paintRail(painter, at, y);
  paintTicks(painter, at, y);
  if (position_m_) paintCarriage(painter, at, y);
}

void TravelStrip::paintRail(QPainter& painter, const Scale& at, double y) const {
  const Look& look = Look::of(palette());
  const QRectF rail(at.left_px, y - 0.5 * rail_px, at.width_px, rail_px);
  painter.setPen(QPen(look.border, 1));
  painter.setBrush(look.surface);
  painter.drawRect(rail);
  if (!travel_) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(look.grid);  // the margins, that nothing goes into
  const double margin_px = at.x(travel_->first_m()) - at.left_px;
  painter.drawRect(QRectF(rail.left(), rail.top(), margin_px, rail_px));
  painter.drawRect(QRectF(rail.right() - margin_px, rail.top(), margin_px, rail_px));
  painter.setBrush(look.muted);
  for (const double x : {rail.left() - stop_px, rail.right()})
    painter.drawRect(QRectF(x, rail.top() - 8.0, stop_px, rail_px + 16.0));
}

void TravelStrip::paintTicks(QPainter& painter, const Scale& at, double y) const {
  const Look& look = Look::of(palette());
  const double zero_m = index_m_.value_or(0.0), bottom = y + 0.5 * rail_px;
  const double step_m = roundStep(at.high_m - at.low_m);
  painter.setFont(typed(Type::caption));
  for (double tick = std::ceil((at.low_m - zero_m) / step_m); tick * step_m + zero_m <= at.high_m; ++tick) {
    const double x = at.x(tick * step_m + zero_m);
    painter.setPen(QPen(look.border, 1));
    painter.drawLine(QPointF(x, bottom), QPointF(x, bottom + 7.0));
    painter.setPen(look.muted);
    painter.drawText(QRectF(x - 40.0, bottom + 9.0, 80.0, 18.0), Qt::AlignCenter,
                     plainText(stripMm * tick * step_m, 6));
  }
  painter.setPen(look.muted);
  painter.drawText(QRectF(at.left_px, bottom + 28.0, at.width_px, 18.0), Qt::AlignCenter,
                   index_m_ ? tr("mm from the index") : tr("mm from power-up"));
  if (!index_m_) return;
  const double x = at.x(*index_m_);
  painter.setPen(Qt::NoPen);
  painter.setBrush(look.curve(2));
  painter.drawPolygon(
      QPolygonF{QPointF(x, bottom - 1.0), QPointF(x - 6.0, bottom - 12.0), QPointF(x + 6.0, bottom - 12.0)});
}

void TravelStrip::paintCarriage(QPainter& painter, const Scale& at, double y) const {
  const Look& look = Look::of(palette());
  const double x = std::clamp(at.x(*position_m_), at.left_px, at.left_px + at.width_px);
  painter.setPen(QPen(look.curve(0), 2));
  painter.drawLine(QPointF(x, y - 0.5 * rail_px - 8.0), QPointF(x, y + 0.5 * rail_px));
  painter.setPen(Qt::NoPen);
  painter.setBrush(look.curve(0));
  painter.drawRoundedRect(QRectF(x - 0.5 * carriage_px, y - 0.5 * rail_px - 16.0, carriage_px, 14.0), 2.0, 2.0);
  painter.setPen(look.ink);
  painter.setFont(typed(Type::section));
  const double shown_mm = stripMm * (*position_m_ - index_m_.value_or(0.0));
  const double textX = std::clamp(x - 70.0, 0.0, std::max(0.0, width() - 140.0));
  painter.drawText(QRectF(textX, y - 0.5 * rail_px - 48.0, 140.0, 26.0), Qt::AlignCenter,
                   tr("%1 mm").arg(fixedText(shown_mm, 2)));
}

}  // namespace breakaway
