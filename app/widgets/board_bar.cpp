#include "widgets/board_bar.h"

#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QTime>
#include <QVBoxLayout>
#include <QWidgetAction>
#include <cmath>

#include "session/connection.h"
#include "session/language.h"
#include "widgets/controls.h"
#include "widgets/duration_text.h"
#include "widgets/elided_label.h"
#include "widgets/facts_table.h"
#include "widgets/look.h"
#include "widgets/run_names.h"

namespace breakaway {

namespace {

constexpr int railWidth = 168, chipWidth = 232, badgeWidth = 100, progressWidth = 144, leftWidth = 150;

/// A dot whose colour says how things stand.
class Dot : public QWidget {
 public:
  explicit Dot(QWidget* parent) : QWidget(parent) { setFixedSize(10, 10); }
  void show(const QColor& colour) {
    colour_ = colour;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour_);
    painter.drawEllipse(rect());
  }

 private:
  QColor colour_;
};

/// The program's icon, as sharp as the screen.
class Sign : public QWidget {
 public:
  explicit Sign(QWidget* parent) : QWidget(parent) { setFixedSize(size_px, size_px); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    QIcon(":/icons/breakaway.svg").paint(&painter, rect());
  }

 private:
  static constexpr int size_px = 26;
};

}  // namespace

BoardBar::BoardBar(Connection& connection, QWidget* parent) : QWidget(parent), connection_(connection) {
  setObjectName("boardBar");
  setFixedHeight(height_px);
  auto* row = rowIn(this, 12, {0, 0, 16, 0});
  auto* brand = new QWidget(this);
  brand->setFixedWidth(railWidth - 12);
  auto* name = new QLabel(tr("Breakaway"), brand);
  name->setFont(typed(Type::section));
  auto* side = rowIn(brand, 8, {14, 0, 0, 0});
  side->addWidget(new Sign(brand));
  side->addWidget(name, 1);
  row->addWidget(brand);
  row->addWidget(buildBoard());
  simulated_ = new QLabel(tr("SIMULATED"), this);
  simulated_->setObjectName("simulatedLabel");
  simulated_->setFont(typed(Type::caption, true));
  simulated_->setProperty("badge", "simulated");
  simulated_->setAlignment(Qt::AlignCenter);
  simulated_->setFixedSize(badgeWidth, 24);
  simulated_->setToolTip(tr("This board and its motor are computed; no hardware moves"));
  QSizePolicy slot = simulated_->sizePolicy();
  slot.setRetainSizeWhenHidden(true);
  simulated_->setSizePolicy(slot);
  row->addWidget(simulated_);
  row->addWidget(buildRun(), 1);
  stop_ = new QPushButton(tr("STOP"), this);
  stop_->setObjectName("stopButton");
  stop_->setProperty("role", "stop");
  stop_->setAccessibleName(tr("Stop the motor"));
  stop_->setToolTip(tr("Stop the motor at once and open its windings. Esc and Space do the same from anywhere."));
  stop_->setFixedSize(160, 36);
  auto* key = new QLabel(tr("Esc"), stop_);
  key->setObjectName("stopKey");
  key->setFont(typed(Type::caption));
  key->setProperty("role", "onStop");
  key->setAttribute(Qt::WA_TransparentForMouseEvents);
  rowIn(stop_, 0, {0, 0, 12, 0})->addWidget(key, 0, Qt::AlignRight | Qt::AlignVCenter);
  connect(stop_, &QPushButton::pressed, &connection_, &Connection::stop);
  row->addWidget(stop_);
  connect(&connection_, &Connection::changed, this, &BoardBar::showConnection);
  connect(&connection_, &Connection::linkChanged, this, &BoardBar::showLink);
  connect(&connection_, &Connection::linkChanged, this, &BoardBar::showRun);
  connect(&connection_, &Connection::runChanged, this, &BoardBar::showRun);
  onNewLook(this, [this] { showConnection(); });
  showConnection();
}

QWidget* BoardBar::buildBoard() {
  auto* chip = new QPushButton(this);
  chip->setObjectName("boardChip");
  chip->setAccessibleName(tr("The board in detail"));
  chip->setToolTip(tr("Device, firmware, link and lost samples"));
  chip->setFixedSize(chipWidth, 28);
  auto* row = rowIn(chip, 8, {10, 0, 22, 0});
  dot_ = new Dot(chip);
  device_ = new ElidedLabel("deviceLabel", chip);
  device_->setAccessibleName(tr("Device"));
  link_ = new ElidedLabel("linkLabel", chip);
  link_->setAccessibleName(tr("Link"));
  link_->setFont(typed(Type::caption));
  link_->setProperty("tone", "muted");
  link_->setAlignment(Qt::AlignVCenter | Qt::AlignRight);
  row->addWidget(dot_);
  row->addWidget(device_, 4);
  row->addWidget(link_, 5);
  for (QWidget* part : {dot_, static_cast<QWidget*>(device_), static_cast<QWidget*>(link_)})
    part->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* menu = new QMenu(chip);
  menu->setObjectName("boardDetails");
  details_ = new FactsTable("boardFacts", menu);
  details_->setContentsMargins(12, 8, 12, 8);
  auto* action = new QWidgetAction(menu);
  action->setDefaultWidget(details_);
  menu->addAction(action);
  chip->setMenu(menu);
  return chip;
}

QWidget* BoardBar::buildRun() {
  auto* group = new QWidget(this);
  auto* row = rowIn(group, 12);
  const auto lines = [group](ElidedLabel* above, ElidedLabel* below) {
    auto* column = new QVBoxLayout;
    column->setSpacing(0);
    column->setContentsMargins(0, 4, 0, 4);
    below->setFont(typed(Type::caption));
    below->setProperty("tone", "muted");
    column->addWidget(above);
    column->addWidget(below);
    return column;
  };
  run_ = new ElidedLabel("stateLabel", group);
  run_->setAccessibleName(tr("State"));
  run_->setFont(typed(Type::body, true));
  activity_ = new ElidedLabel("activityLabel", group);
  activity_->setAccessibleName(tr("Activity"));
  row->addLayout(lines(run_, activity_), 1);
  progress_ = new QProgressBar(group);
  progress_->setObjectName("runProgress");
  progress_->setAccessibleName(tr("Progress of what runs"));
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedSize(progressWidth, 8);
  QSizePolicy slot = progress_->sizePolicy();
  slot.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(slot);
  row->addWidget(progress_, 0, Qt::AlignVCenter);
  left_ = new ElidedLabel("timeLeft", group);
  left_->setAccessibleName(tr("Time left"));
  end_ = new ElidedLabel("timeOfEnd", group);
  end_->setAccessibleName(tr("When it ends"));
  auto* time = new QWidget(group);
  time->setFixedWidth(leftWidth);
  auto* times = columnIn(time, 0);
  times->addLayout(lines(left_, end_));
  row->addWidget(time);
  return group;
}

/// That it is simulated says the badge; what its own name says beyond that is shown.
QString BoardBar::deviceWords() const {
  const QString device = QString::fromStdString(connection_.identity().device);
  return connection_.identity().simulated ? device.section(", ", -1) : device;
}

QString BoardBar::linkWords() const {
  const LinkStatus& link = connection_.link();
  const double rate_Hz = connection_.identity().loopRate_Hz;
  const QString rate = rate_Hz < 1e3 ? tr("%1 Hz").arg(rate_Hz, 0, 'f', 0) : tr("%1 kHz").arg(rate_Hz / 1e3, 0, 'f', 2);
  return tr("%1, %2 lost").arg(rate).arg(link.lost);
}

void BoardBar::showConnection() {
  const Look& look = Look::of(palette());
  const bool connected = connection_.connected();
  const ConnectionState state = connection_.state();
  const bool trying = state == ConnectionState::connecting || state == ConnectionState::reconnecting;
  device_->setText(connected ? deviceWords() : tr("No board"));
  static_cast<Dot*>(dot_)->show(connected ? look.good : trying ? look.warning : look.disabled);
  simulated_->setVisible(connected && connection_.identity().simulated);
  showLink();
  showRun();
  update();
}

void BoardBar::showLink() {
  if (!connection_.connected()) {
    link_->setText({});
    details_->show({{tr("Device"), tr("none"), {}}, {tr("State"), connection_.stateWords(), {}}});
    return;
  }
  link_->setText(linkWords());
  const Identity& identity = connection_.identity();
  std::vector<Fact> facts{{tr("Device"), QString::fromStdString(boardName(identity)), {}},
                          {tr("Firmware"), QString::fromStdString(identity.firmware), {}},
                          {tr("Address"), connection_.uri(), {}},
                          {tr("Samples"), tr("%1 a second").arg(identity.loopRate_Hz, 0, 'f', 0), {}},
                          {tr("Lost samples"), QString::number(connection_.link().lost), {}},
                          {tr("State"), connection_.stateWords(), {}}};
  if (identity.simulated)
    facts.push_back({tr("Pace"), tr("%1 × real time").arg(connection_.link().realTimeFactor, 0, 'f', 1), {}});
  details_->show(facts);
}

void BoardBar::showRun() {
  const RunSnapshot& run = connection_.run();
  if (!run.running()) {
    // "idle, windings open": what the line beneath says as well is left out.
    const QString words = connection_.stateWords().section(", ", 0, 0);
    run_->setText(words.left(1).toUpper() + words.mid(1));
    const bool again = connection_.state() == ConnectionState::reconnecting;
    activity_->setText(again                      ? tr("tries again every second, motor off")
                       : !connection_.connected() ? tr("choose a board on the first page")
                       : connection_.powered()    ? tr("STOP opens the windings")
                                                  : tr("windings open"));
    progress_->hide();
    left_->setText({});
    end_->hide();
    return;
  }
  progress_->setVisible(endsByItself(run.kind));
  run_->setText(nameOf(run.kind));
  activity_->setText(inLanguage(run.status.activity));
  progress_->setValue(static_cast<int>(std::lround(1000.0 * std::clamp(run.status.progress, 0.0, 1.0))));
  const double factor = connection_.identity().simulated ? connection_.link().realTimeFactor : 1.0;
  if (!endsByItself(run.kind) || factor <= 0.0) {
    left_->setText(endsByItself(run.kind) ? tr("Working it out") : tr("Until STOP"));
    end_->hide();
    return;
  }
  const double left_s = run.status.remaining_s / factor;
  left_->setText(tr("%1 left").arg(durationText(left_s)));
  end_->show();
  end_->setText(tr("done at %1").arg(QTime::currentTime().addSecs(std::lround(left_s)).toString("HH:mm")));
}

void BoardBar::paintEvent(QPaintEvent*) {
  const Look& look = Look::of(palette());
  QPainter painter(this);
  const bool simulated = connection_.connected() && connection_.identity().simulated;
  painter.fillRect(rect(), simulated ? look.simulatedBack : look.surface);
  painter.setPen(look.hairline);
  painter.drawLine(rect().bottomLeft(), rect().bottomRight());
}

}  // namespace breakaway
