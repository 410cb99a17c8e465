#include "widgets/rotor_dial.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/look.h"
#include "widgets/number_text.h"

namespace breakaway {

namespace {

constexpr double figureRadius = 64.0;  // within it stands the angle
constexpr double leastRadius = 96.0;   // that a hand has room in

/// Zero to the right, growing counter-clockwise, as angles are drawn in textbooks and on the polar plot.
QPointF onCircle(double angle_rad, double radius) {
  return {radius * std::cos(angle_rad), -radius * std::sin(angle_rad)};
}

}  // namespace

RotorDial::RotorDial(QWidget* parent) : QWidget(parent) {
  setObjectName("rotorDial");
  setAccessibleName(tr("Rotor angle"));
}

void RotorDial::show(std::optional<double> angle_rad, std::optional<double> index_rad) {
  if (angle_rad_ == angle_rad && index_rad_ == index_rad) return;
  angle_rad_ = angle_rad;
  index_rad_ = index_rad;
  update();
}

void RotorDial::showWay(std::optional<double> begin_rad, std::optional<double> most_rad) {
  if (begin_rad_ == begin_rad && most_rad_ == most_rad) return;
  begin_rad_ = begin_rad;
  most_rad_ = most_rad;
  update();
}

void RotorDial::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(rect().center());
  const double radius = 0.5 * std::min(width(), height()) - 34.0;
  if (radius < leastRadius) return;
  paintScale(painter, radius);
  if (angle_rad_ && begin_rad_) paintWay(painter, radius);
  if (angle_rad_) paintHand(painter, radius);
}

void RotorDial::paintScale(QPainter& painter, double radius) const {
  const Look& look = Look::of(palette());
  painter.setPen(QPen(look.border, 1));
  painter.setBrush(look.surface);
  painter.drawEllipse(QPointF(0, 0), radius, radius);
  painter.setFont(typed(Type::caption));
  for (int degrees = 0; degrees < 360; degrees += 10) {
    const double angle_rad = degrees * std::numbers::pi / 180.0;
    const bool named = degrees % 30 == 0;
    painter.setPen(QPen(named ? look.muted : look.border, 1));
    painter.drawLine(onCircle(angle_rad, radius), onCircle(angle_rad, radius - (named ? 10 : 5)));
    if (!named) continue;
    const QPointF at = onCircle(angle_rad, radius + 17);
    painter.drawText(QRectF(at.x() - 24, at.y() - 10, 48, 20), Qt::AlignCenter, tr("%1°").arg(degrees));
  }
  if (!index_rad_) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(look.curve(2));
  painter.drawPolygon(
      QPolygonF{onCircle(0.0, radius - 1), onCircle(0.045, radius - 20), onCircle(-0.045, radius - 20)});
}

void RotorDial::paintWay(QPainter& painter, double radius) const {
  const Look& look = Look::of(palette());
  constexpr double width_px = 8.0, inside_px = 24.0, turn_deg = 360.0, sixteenths = 16.0;
  const double zero_rad = index_rad_.value_or(0.0), degree = 180.0 / std::numbers::pi;
  const double way_deg = std::clamp((*angle_rad_ - *begin_rad_) * degree, -turn_deg, turn_deg);
  const double at = radius - inside_px;
  painter.setPen(QPen(look.measured(0), width_px, Qt::SolidLine, Qt::FlatCap));
  painter.setBrush(Qt::NoBrush);
  painter.drawArc(
      QRectF(-at, -at, 2.0 * at, 2.0 * at),
      static_cast<int>(std::lround(std::remainder((*begin_rad_ - zero_rad) * degree, turn_deg) * sixteenths)),
      static_cast<int>(std::lround(way_deg * sixteenths)));
}

void RotorDial::paintHand(QPainter& painter, double radius) const {
  const Look& look = Look::of(palette());
  const double shown_rad = *angle_rad_ - index_rad_.value_or(0.0);
  painter.setPen(QPen(look.curve(0), 2.5, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(onCircle(shown_rad, figureRadius), onCircle(shown_rad, radius - 24));
  painter.setBrush(look.curve(0));
  painter.drawEllipse(onCircle(shown_rad, radius - 24), 5, 5);
  const double turn_deg = 360.0;
  const double degrees = std::fmod(std::fmod(shown_rad * 180.0 / std::numbers::pi, turn_deg) + turn_deg, turn_deg);
  painter.setPen(look.ink);
  painter.setFont(typed(Type::figure));
  painter.drawText(QRectF(-80, -18, 160, 36), Qt::AlignCenter, tr("%1°").arg(fixedText(degrees, 1)));
  painter.setPen(look.muted);
  painter.setFont(typed(Type::caption));
  painter.drawText(QRectF(-80, 18, 160, 20), Qt::AlignCenter, index_rad_ ? tr("from the index") : tr("from power-up"));
  if (!most_rad_) return;
  painter.setPen(look.accentLine);
  painter.drawText(QRectF(-80, 36, 160, 20), Qt::AlignCenter,
                   tr("%1° to go at most").arg(*most_rad_ * 180.0 / std::numbers::pi, 0, 'f', 0));
}

}  // namespace breakaway
