#include "widgets/board_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "session/connection.h"
#include "widgets/controls.h"
#include "widgets/look.h"

namespace breakaway {

BoardBar::BoardBar(Connection& connection, QWidget* parent) : QWidget(parent), connection_(connection) {
  setObjectName("boardBar");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* row = rowIn(this, 14, {12, 5, 8, 5});
  device_ = addField("deviceLabel", tr("Device"), 190);
  firmware_ = addField("firmwareLabel", tr("Firmware"), 110);
  link_ = addField("linkLabel", tr("Link"), 130);
  lost_ = addField("lostLabel", tr("Lost samples"), 90);
  state_ = addField("stateLabel", tr("State"), 0);
  simulated_ = new QLabel(tr("SIMULATED"), this);
  simulated_->setObjectName("simulatedLabel");
  simulated_->setFont(sized(font(), 1.0, true));
  simulated_->setToolTip(tr("This board and its motor are computed; no hardware moves"));
  row->addWidget(simulated_);
  stop_ = new QPushButton(tr("STOP"), this);
  stop_->setObjectName("stopButton");
  stop_->setAccessibleName(tr("Stop the motor"));
  stop_->setToolTip(tr("Stop the motor at once and open its windings. Esc and Space do the same from anywhere."));
  stop_->setMinimumSize(150, 38);
  connect(stop_, &QPushButton::pressed, &connection_, &Connection::stop);
  row->addWidget(stop_);
  styleStop();
  connect(&connection_, &Connection::changed, this, &BoardBar::showConnection);
  connect(&connection_, &Connection::linkChanged, this, &BoardBar::showLink);
  connect(&connection_, &Connection::runChanged, this, &BoardBar::showState);
  connect(&connection_, &Connection::linkChanged, this, &BoardBar::showState);
  showConnection();
}

QLabel* BoardBar::addField(const char* objectName, const QString& title, int width) {
  auto* column = new QVBoxLayout;
  column->setSpacing(0);
  auto* name = new QLabel(title, this);
  name->setFont(sized(font(), 0.82));
  auto* value = new QLabel(this);
  value->setObjectName(objectName);
  value->setAccessibleName(title);
  value->setFont(sized(font(), 1.0, true));
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  value->setMinimumWidth(width);
  name->setBuddy(value);
  column->addWidget(name);
  column->addWidget(value);
  static_cast<QHBoxLayout*>(layout())->addLayout(column, width == 0 ? 1 : 0);
  return value;
}

void BoardBar::showConnection() {
  const Identity& identity = connection_.identity();
  const bool connected = connection_.connected();
  device_->setText(connected ? QString::fromStdString(identity.device) : tr("none"));
  firmware_->setText(connected ? QString::fromStdString(identity.firmware) : tr("–"));
  simulated_->setVisible(connected && identity.simulated);
  showLink();
  showState();
  update();
}

void BoardBar::showLink() {
  const LinkStatus& link = connection_.link();
  if (!connection_.connected()) {
    link_->setText(tr("–"));
    lost_->setText(tr("–"));
    return;
  }
  const double rate_Hz = connection_.identity().loopRate_Hz;
  QString rate = rate_Hz < 1e3 ? tr("%1 Hz").arg(rate_Hz, 0, 'f', 0) : tr("%1 kHz").arg(rate_Hz / 1e3, 0, 'f', 1);
  if (connection_.identity().simulated && link.realTimeFactor > 0.0)
    rate += tr(", %1 × real time").arg(link.realTimeFactor, 0, 'f', 1);
  link_->setText(rate);
  lost_->setText(QString::number(link.lost));
}

void BoardBar::showState() {
  state_->setText(connection_.stateWords());
  state_->setToolTip(connection_.stateWords());
}

void BoardBar::styleStop() {
  const Look look = Look::of(palette());
  stop_->setStyleSheet(
      QStringLiteral(
          "QPushButton { background: %1; color: white; font-weight: bold; font-size: %2pt; border: 1px solid %3;"
          " border-radius: 4px; padding: 4px 22px; }"
          "QPushButton:hover { background: %4; } QPushButton:pressed { background: %3; }"
          "QPushButton:focus { border: 2px solid %5; }")
          .arg(look.stop.name())
          .arg(font().pointSizeF() * 1.35, 0, 'f', 1)
          .arg(look.stop.darker(130).name(), look.stop.lighter(112).name(), look.ink.name()));
}

void BoardBar::paintEvent(QPaintEvent*) {
  const Look look = Look::of(palette());
  QPainter painter(this);
  painter.fillRect(rect(), connection_.identity().simulated ? look.simulated : look.panel);
  painter.setPen(look.line);
  painter.drawLine(rect().bottomLeft(), rect().bottomRight());
}

void BoardBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (stop_ != nullptr && event->type() == QEvent::PaletteChange) styleStop();
}

}  // namespace breakaway
