#include "widgets/quantity_slider.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyleOptionSlider>
#include <algorithm>
#include <cmath>

#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/look.h"
#include "widgets/number_text.h"

namespace breakaway {

namespace {
constexpr int travel = 1000, boxWidth = 136;
constexpr double sliderDecades = 3.0;  ///< of a logarithmic slider

/// Shows no zeros behind the last digit that says something.
class ShortBox : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;
  QString textFromValue(double value) const override {
    QString text = QDoubleSpinBox::textFromValue(value);
    const QString point = locale().decimalPoint(), zero = locale().zeroDigit();
    if (!text.contains(point)) return text;
    while (text.endsWith(zero)) text.chop(1);
    if (text.endsWith(point)) text.chop(point.size());
    return text;
  }
};

}  // namespace

/// With a mark where the board's value is, once another one is chosen, and the stretch in which a rule is broken.
class QuantitySlider::MarkedSlider : public QSlider {
 public:
  using QSlider::QSlider;

  void showMarks(std::optional<int> board, std::optional<int> rule) {
    if (board == board_ && rule == rule_) return;
    board_ = board;
    rule_ = rule;
    update();
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    QSlider::paintEvent(event);
    if (!board_ && !rule_) return;
    constexpr int markReach_px = 8, markWidth_px = 3, grooveHeight_px = 4;
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
    const auto at = [&](int position) {
      return handle.width() / 2 +
             QStyle::sliderPositionFromValue(minimum(), maximum(), position, width() - handle.width());
    };
    const Look& look = Look::of(palette());
    QPainter painter(this);
    painter.setClipRegion(QRegion(rect()) - QRegion(handle, QRegion::Ellipse));
    const int middle = handle.center().y() + 1;
    if (rule_) {
      const int from = at(*rule_);
      painter.fillRect(from, middle - grooveHeight_px / 2, width() - from, grooveHeight_px, look.trouble);
    }
    if (board_)
      painter.fillRect(at(*board_) - markWidth_px / 2, middle - markReach_px, markWidth_px, 2 * markReach_px,
                       look.curve(3));
  }

 private:
  std::optional<int> board_, rule_;
};

QuantitySlider::QuantitySlider(const QString& objectName, const QString& title, const QString& unit,
                               const QString& help, QWidget* parent)
    : QWidget(parent), help_(help) {
  setObjectName(objectName);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(2);
  title_ = new QLabel(title, this);
  title_->setToolTip(help);
  onBoard_ = new ElidedLabel("", this);
  onBoard_->setFont(typed(Type::caption));
  onBoard_->setProperty("tone", "muted");
  slider_ = new MarkedSlider(Qt::Horizontal, this);
  slider_->setObjectName(objectName + "Slider");
  slider_->setAccessibleName(title);
  slider_->setRange(0, travel);
  slider_->setPageStep(travel / 20);
  box_ = new ShortBox(this);
  box_->setObjectName(objectName + "Box");
  box_->setAccessibleName(title);
  box_->setSuffix(" " + unit);
  box_->setKeyboardTracking(false);
  box_->setFixedSize(boxWidth, 28);
  box_->setAlignment(Qt::AlignRight);
  box_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  title_->setBuddy(box_);
  grid->addWidget(title_, 0, 0);
  grid->addWidget(onBoard_, 1, 0);
  grid->addWidget(box_, 0, 1, 2, 1);
  grid->addWidget(slider_, 2, 0, 1, 2);
  setRange(range_);
  setAvailable(true, {});
  connect(slider_, &QSlider::valueChanged, this, &QuantitySlider::takeSlider);
  connect(box_, &QDoubleSpinBox::valueChanged, this, &QuantitySlider::takeBox);
}

double QuantitySlider::value() const {
  return box_->value();
}

void QuantitySlider::setRange(const QuantityRange& range) {
  const QSignalBlocker quietBox(box_), quietSlider(slider_);
  range_ = range;
  box_->setDecimals(range.decimals);
  box_->setRange(range.least, range.most);
  slider_->setValue(positionOf(box_->value()));
}

void QuantitySlider::setOnBoard(std::optional<double> value) {
  board_ = value;
  showEdit();
}

void QuantitySlider::setRule(std::optional<double> most) {
  rule_ = most;
  showEdit();
}

void QuantitySlider::showEdit() {
  // What the box can't show isn't an edit.
  const bool edited = board_ && std::abs(*board_ - box_->value()) > 0.6 * std::pow(10.0, -box_->decimals());
  onBoard_->setText(!board_  ? QString()
                    : edited ? tr("edited; on board %1").arg(numberText(*board_))
                             : tr("as on board"));
  dressAs(onBoard_, "tone", edited ? "warning" : "muted");
  dressAs(box_, "edited", edited ? "true" : "false");
  slider_->showMarks(edited ? std::optional(positionOf(*board_)) : std::nullopt,
                     rule_ && *rule_ < range_.most ? std::optional(positionOf(*rule_)) : std::nullopt);
}

void QuantitySlider::setUnit(const QString& unit) {
  box_->setSuffix(" " + unit);
}

void QuantitySlider::setAvailable(bool available, const QString& reason) {
  for (QWidget* part : std::initializer_list<QWidget*>{slider_, box_}) {
    part->setEnabled(available);
    part->setToolTip(available ? help_ : reason);
  }
}

void QuantitySlider::show(double value) {
  if (value > range_.most) {
    QuantityRange wider = range_;
    wider.most = value;
    setRange(wider);
  }
  const QSignalBlocker quietBox(box_), quietSlider(slider_);
  box_->setValue(value);
  if (!slider_->isSliderDown()) slider_->setValue(positionOf(value));
  showEdit();
}

int QuantitySlider::positionOf(double value) const {
  const double share = std::clamp((value - range_.least) / (range_.most - range_.least), 0.0, 1.0);
  if (!range_.logarithmic) return static_cast<int>(std::lround(share * travel));
  const double position = share <= 0.0 ? 0.0 : 1.0 + std::log10(share) / sliderDecades;
  return static_cast<int>(std::lround(std::clamp(position, 0.0, 1.0) * travel));
}

double QuantitySlider::valueOf(int position) const {
  const double share = static_cast<double>(position) / travel;
  const double height = range_.most - range_.least;
  if (!range_.logarithmic || position == 0) return range_.least + share * height;
  return range_.least + height * std::pow(10.0, sliderDecades * (share - 1.0));
}

void QuantitySlider::takeSlider(int position) {
  const QSignalBlocker quiet(box_);
  box_->setValue(valueOf(position));
  showEdit();
  emit chosen(box_->value());
}

void QuantitySlider::takeBox(double value) {
  const QSignalBlocker quiet(slider_);
  slider_->setValue(positionOf(value));
  showEdit();
  emit chosen(value);
}

}  // namespace breakaway
