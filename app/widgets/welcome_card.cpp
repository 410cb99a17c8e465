#include "widgets/welcome_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "widgets/controls.h"
#include "widgets/look.h"

namespace breakaway {

namespace {

constexpr int pictureWidth = 176, pictureHeight = 120, buttonWidth = 176;

/// Points of y(x), x from 0 to 1, in a rectangle whose bottom is y = 0 and whose top is 1.
template <class Curve>
QPolygonF sampled(const QRectF& room, const Curve& curve) {
  constexpr int points = 120;
  QPolygonF line;
  for (int k = 0; k <= points; ++k) {
    const double x = static_cast<double>(k) / points;
    line << QPointF(room.left() + x * room.width(), room.bottom() - curve(x) * room.height());
  }
  return line;
}

void paintMap(QPainter& painter, const QRectF& room, const Look& look) {
  const QPointF middle = room.center();
  const double reach = 0.5 * room.height();
  painter.setPen(QPen(look.grid, 1));
  for (const double share : {0.5, 0.75, 1.0}) painter.drawEllipse(middle, share * reach, share * reach);
  const auto around = [&](double mean, double phase) {
    constexpr int places = 180;
    QPolygonF line;
    for (int k = 0; k < places; ++k) {
      const double at = 2.0 * std::numbers::pi * k / places;
      const double radius =
          reach * (mean + 0.1 * std::cos(at - phase) + 0.05 * std::cos(3.0 * at + phase) + 0.01 * std::cos(12.0 * at));
      line << middle + QPointF(radius * std::cos(at), -radius * std::sin(at));
    }
    return line;
  };
  painter.setPen(QPen(look.measured(0), 1.4, Qt::DashLine));
  painter.drawPolygon(around(0.55, 0.9));
  painter.setPen(QPen(look.curve(0), 2));
  painter.drawPolygon(around(0.68, 0.9));
  painter.setPen(QPen(look.curve(1), 2));
  painter.drawPolygon(around(0.82, 0.3));
}

void paintStep(QPainter& painter, const QRectF& room, const Look& look) {
  painter.setPen(QPen(look.grid, 1));
  for (const double share : {0.0, 0.4, 0.8}) painter.drawPolyline(sampled(room, [share](double) { return share; }));
  const auto rise = [](double per) {
    return [per](double x) { return 0.8 * (1.0 - std::exp(-per * std::max(0.0, x - 0.08))); };
  };
  for (const auto& [colour, per] : {std::pair{4, 3.0}, std::pair{2, 5.0}, std::pair{3, 9.0}}) {
    painter.setPen(QPen(look.measured(colour), 3));
    painter.drawPolyline(sampled(room, rise(per)));
  }
  painter.setPen(QPen(look.curve(0), 2));
  painter.drawPolyline(sampled(room, [](double x) {
    const double late = std::max(0.0, x - 0.08);
    return 0.8 * (1.0 - std::exp(-11.0 * late) * std::cos(14.0 * late));
  }));
}

void paintVerdict(QPainter& painter, const QRectF& room, const Look& look) {
  const double bar = 18.0, apart = 10.0, top = room.top() + 10.0, line = room.left() + 0.13 * room.width();
  painter.fillRect(QRectF(room.left(), top, room.width(), bar), look.curve(1));
  painter.fillRect(QRectF(room.left(), top + bar + apart, 0.16 * room.width(), bar), look.curve(0));
  painter.setPen(QPen(look.good, 2));
  painter.drawLine(QPointF(line, room.top()), QPointF(line, top + 2.0 * bar + 2.0 * apart));
  const QRectF below = room.adjusted(0.0, 2.0 * bar + 3.0 * apart, 0.0, 0.0);
  painter.setPen(QPen(look.curve(1), 1.4));
  painter.drawPolyline(sampled(below, [](double x) { return 0.45 + 0.4 * std::sin(9.0 * x) * (0.4 + x); }));
  painter.setPen(QPen(look.curve(0), 1.4));
  painter.drawPolyline(sampled(below, [](double x) { return 0.45 + 0.03 * std::sin(57.0 * x); }));
}

class Picture : public QWidget {
 public:
  Picture(WelcomePicture picture, QWidget* parent) : QWidget(parent), picture_(picture) {
    setFixedSize(pictureWidth, pictureHeight);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    constexpr double margin = 4.0;
    const Look& look = Look::of(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF room = QRectF(rect()).adjusted(margin, margin, -margin, -margin);
    switch (picture_) {
      case WelcomePicture::map:
        return paintMap(painter, room, look);
      case WelcomePicture::step:
        return paintStep(painter, room, look);
      case WelcomePicture::verdict:
        return paintVerdict(painter, room, look);
    }
  }

 private:
  WelcomePicture picture_;
};

}  // namespace

WelcomeCard::WelcomeCard(QWidget* parent) : QFrame(parent) {
  setObjectName("welcomeCard");
  setProperty("role", "card");
  auto* area = new QScrollArea(this);  // beside plots of what comes in there is less room
  area->setObjectName("welcomeArea");
  area->setFocusPolicy(Qt::NoFocus);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidgetResizable(true);
  columnIn(this, 0, {4, 4, 4, 4})->addWidget(area);
  content_ = new QWidget(area);
  content_->setProperty("role", "column");
  auto* column = columnIn(content_, 4, {16, 12, 16, 12});
  area->setWidget(content_);
  area->viewport()->setAutoFillBackground(false);
  content_->setAutoFillBackground(false);
  column->addWidget(section(content_, tr("What this bench answers")));
  auto* how =
      explanation(content_, tr("Each can be tried at once, without a motor: simulated boards do all that real ones "
                               "do. Nothing moves before you ask for it."));
  how->setProperty("tone", "muted");
  column->addWidget(how);
  add(WelcomePicture::map, {"frictionPage", "tryFrictionButton"}, tr("How much friction, and where around the turn"),
      tr("The torque that breaks the rotor away at every angle, both ways, over last month's map: as CSV, C header, "
         "figure or report."),
      tr("Try Friction"), tr("Connects the simulated servo and opens Friction; nothing moves yet"));
  add(WelcomePicture::step, {"tunePage", "tryTuneButton"}, tr("How the loop will answer, before it moves"),
      tr("Gains move a foretold step, Bode plot and poles; the step that is measured then lies over it."),
      tr("Try Tune"), tr("Connects the simulated servo and opens Tune; nothing moves yet"));
  add(WelcomePicture::verdict, {"comparePage", "tryCompareButton"}, tr("What a simulation of the motor leaves out"),
      tr("A recording and a bench file give a verdict in one sentence, proved on data that the fit never saw."),
      tr("Try Compare"), tr("Opens Compare, which needs no board: Example there is a recording to begin with"));
  column->addStretch(1);
}

void WelcomeCard::add(WelcomePicture picture, const Names& names, const QString& title, const QString& sentence,
                      const QString& button, const QString& tip) {
  static_cast<QVBoxLayout*>(content_->layout())->addStretch(1);
  auto* row = new QHBoxLayout;
  row->setSpacing(20);
  row->addWidget(new Picture(picture, content_), 0, Qt::AlignVCenter);
  auto* words = new QVBoxLayout;
  words->setSpacing(4);
  auto* head = new QLabel(title, content_);
  head->setFont(typed(Type::body, true));
  head->setWordWrap(true);
  words->addStretch(1);
  words->addWidget(head);
  words->addWidget(explanation(content_, sentence));
  words->addSpacing(4);
  auto* go = pushButton(content_, names.button, button, tip);
  go->setMinimumWidth(buttonWidth);
  words->addWidget(go, 0, Qt::AlignLeft);
  words->addStretch(1);
  row->addLayout(words, 1);
  static_cast<QVBoxLayout*>(content_->layout())->addLayout(row);
  connect(go, &QPushButton::clicked, this,
          [this, page = QString(names.page), picture] { emit tryAsked(page, picture != WelcomePicture::verdict); });
}

}  // namespace breakaway
