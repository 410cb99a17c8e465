#include "widgets/live_strip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "session/connection.h"
#include "session/live_samples.h"
#include "session/messages.h"
#include "widgets/controls.h"
#include "widgets/look.h"
#include "widgets/number_text.h"
#include "widgets/while_shown.h"

using namespace std::chrono_literals;

namespace breakaway {

namespace {
constexpr int stripRailWidth = 168, nameWidth = 70, valueWidth = 60, unitWidth = 38, lineWidth = 48, logWidth = 120;
constexpr double lineSpan_s = 5.0, manyDigits = 1e5;  // from there on decimals have no room
constexpr size_t linePoints = 64;
}  // namespace

class LiveStrip::Sparkline : public QWidget {
 public:
  Sparkline(int colour, QWidget* parent) : QWidget(parent), colour_(colour) { setFixedSize(lineWidth, 20); }
  void show(std::vector<double> values, double leastSpan) {
    if (values.empty() && values_.empty()) return;
    values_ = std::move(values);
    leastSpan_ = leastSpan;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    if (values_.size() < 2) return;
    const auto [low, high] = std::minmax_element(values_.begin(), values_.end());
    const double span = std::max(*high - *low, leastSpan_), middle = 0.5 * (*high + *low);
    QPolygonF line;
    for (size_t k = 0; k < values_.size(); ++k) {
      const double x = static_cast<double>(k) / static_cast<double>(values_.size() - 1);
      line << QPointF(x * (width() - 1), (0.5 - 0.9 * (values_[k] - middle) / span) * (height() - 2) + 1.0);
    }
    QPainter painter(this);
    painter.setPen(QPen(Look::of(palette()).curve(colour_), 1));
    painter.drawPolyline(line);
  }

 private:
  int colour_;
  std::vector<double> values_;
  double leastSpan_ = 1.0;
};

LiveStrip::LiveStrip(const Connection& connection, const LiveSamples& live, const Messages& messages, QWidget* parent)
    : QWidget(parent), connection_(connection), live_(live), messages_(messages), channels_(liveChannels(false)) {
  setObjectName("liveStrip");
  setFixedHeight(height_px);
  auto* row = rowIn(this, 4, {8, 0, 16, 0});
  open_ = toolButton(this, "liveButton", tr("Live"), tr("Plots of what comes from the board, below the page (Ctrl+L)"));
  open_->setCheckable(true);
  open_->setProperty("role", "bare");
  open_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  open_->setShortcut(QKeySequence("Ctrl+L"));
  open_->setFixedWidth(stripRailWidth - 16);
  connect(open_, &QToolButton::toggled, this, &LiveStrip::plotsAsked);
  row->addWidget(open_);
  row->addSpacing(8);
  const auto label = [this](int width, Qt::Alignment where, bool small) {
    auto* text = new QLabel(this);
    text->setFixedWidth(width);
    text->setAlignment(where | Qt::AlignVCenter);
    if (small) {
      text->setFont(typed(Type::caption));
      text->setProperty("tone", "muted");
    }
    return text;
  };
  for (size_t k = 0; k < numbers_.size(); ++k) {
    numbers_[k] = {label(nameWidth, Qt::AlignRight, true), label(valueWidth, Qt::AlignRight, false),
                   label(unitWidth, Qt::AlignLeft, true), new Sparkline(std::array{2, 3, 4, 0}[k], this)};
    for (QWidget* part :
         std::initializer_list<QWidget*>{numbers_[k].name, numbers_[k].value, numbers_[k].unit, numbers_[k].line})
      row->addWidget(part);
    row->addStretch(1);
  }
  log_ = pushButton(this, "logButton", tr("Log"), tr("What was said so far"));
  log_->setFixedSize(logWidth, 24);
  log_->setStyleSheet("min-height: 20px;");
  connect(log_, &QPushButton::clicked, this, &LiveStrip::logAsked);
  row->addWidget(log_);
  connect(&connection_, &Connection::changed, this, &LiveStrip::nameChannels);
  connect(&messages_, &Messages::said, this, &LiveStrip::countUnread);
  connect(&messages_, &Messages::read, this, &LiveStrip::countUnread);
  new WhileShown(this, 100ms, [this] { return refresh(); });
  nameChannels();
  countUnread();
  showOpen(false);
  onNewLook(this, [this] { showOpen(open_->isChecked()); });
}

void LiveStrip::nameChannels() {
  channels_ = liveChannels(live_.board().axis == Axis::linear);
  for (size_t k = 0; k < numbers_.size(); ++k) {
    numbers_[k].name->setText(channels_[k].name);
    numbers_[k].unit->setText(channels_[k].unit);
    numbers_[k].value->setAccessibleName(channels_[k].name);
  }
  refresh();
}

bool LiveStrip::refresh() {
  const LiveHistory& history = live_.history();
  const auto newest = live_.current();
  for (size_t k = 0; k < numbers_.size(); ++k) {
    const LiveChannel& channel = channels_[k];
    const double value = newest ? channel.of(*newest) : 0.0;
    numbers_[k].value->setText(!newest                        ? tr("–")
                               : std::abs(value) < manyDigits ? steadyNumber(value, channel.leastSpan)
                                                              : fixedText(value, 0));
    std::vector<double> line;
    if (newest) {
      const double rate_Hz = std::max(1.0, connection_.identity().loopRate_Hz);
      const auto span = static_cast<uint64_t>(lineSpan_s * rate_Hz);
      const uint64_t first = std::max(history.first(), history.end() > span ? history.end() - span : 0);
      const uint64_t every = std::max<uint64_t>(1, span / linePoints);
      for (uint64_t at = first; at < history.end(); at += every) line.push_back(channel.of(history.at(at)));
    }
    numbers_[k].line->show(std::move(line), channel.leastSpan);
  }
  return newest.has_value();
}

void LiveStrip::countUnread() {
  log_->setText(messages_.unread() == 0 ? tr("Log") : tr("Log: %1 new").arg(messages_.unread()));
  dressAs(log_, "tone", messages_.unreadTrouble() != nullptr ? "trouble" : QString());
}

void LiveStrip::showOpen(bool open) {
  open_->setChecked(open);
  open_->setArrowType(open ? Qt::DownArrow : Qt::UpArrow);
}

void LiveStrip::paintEvent(QPaintEvent*) {
  const Look& look = Look::of(palette());
  QPainter painter(this);
  painter.fillRect(rect(), look.surface);
  painter.setPen(look.hairline);
  painter.drawLine(rect().topLeft(), rect().topRight());
}

}  // namespace breakaway
