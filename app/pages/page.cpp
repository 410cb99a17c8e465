#include "pages/page.h"

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/look.h"

namespace breakaway {

namespace {
constexpr int margin = 16, gutter = 24, headButtonHeight = 32, primaryWidth = 224, readingHeight = 28,
              narrowBelow_px = 1000, stackedGap = 12;
}  // namespace

Page::Page(const char* objectName, const QString& title, QWidget* parent) : QWidget(parent), title_(title) {
  setObjectName(objectName);
  setAccessibleName(title);
  auto* column = columnIn(this, 12, {margin, 8, margin, 12});
  auto* top = new QHBoxLayout;
  top->setSpacing(8);
  words_ = new QVBoxLayout;
  words_->setSpacing(0);
  head_ = new ElidedLabel("pageTitle", this);
  head_->setFont(typed(Type::title));
  sentence_ = new ElidedLabel("pageSentence", this);
  sentence_->setProperty("tone", "muted");
  words_->addWidget(head_);
  words_->addWidget(sentence_);
  top->addLayout(words_, 1);
  gap_ = new QSpacerItem(gutter - 8, 1, QSizePolicy::Fixed, QSizePolicy::Minimum);
  top->addItem(gap_);
  buttons_ = new QHBoxLayout;
  buttons_->setSpacing(8);
  top->addLayout(buttons_);
  top_ = new QVBoxLayout;
  top_->setSpacing(4);
  top_->addLayout(top);
  column->addLayout(top_);
  body_ = new QHBoxLayout;
  body_->setSpacing(gutter);
  picture_ = new QVBoxLayout;
  picture_->setSpacing(8);
  body_->addLayout(picture_, 1);
  column->addLayout(body_, 1);
}

void Page::setHead(const QString& title, const QString& sentence) {
  heading_ = title;
  head_->setText(narrow_ ? title_ : heading_);
  sentence_->setText(sentence);
}

QPushButton* Page::addPrimary(const char* objectName, const QString& text) {
  auto* button = pushButton(this, objectName, text);
  button->setProperty("role", "primary");
  button->setFixedSize(primaryWidth, headButtonHeight);
  buttons_->addWidget(button);
  return button;
}

QPushButton* Page::addSecondary(const char* objectName, const QString& text, int width) {
  auto* button = pushButton(this, objectName, text);
  button->setFixedSize(width, headButtonHeight);
  buttons_->insertWidget(0, button);
  return button;
}

QVBoxLayout* Page::settings() {
  if (settings_ != nullptr) return settings_;
  auto* area = new QScrollArea(this);
  area->setObjectName(objectName() + "Settings");
  area->setFocusPolicy(Qt::NoFocus);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidgetResizable(true);
  area->setFixedWidth(settingsWidth);
  auto* content = new QWidget(area);
  content->setProperty("role", "column");
  settings_ = columnIn(content, 12);
  area->setWidget(content);
  area->viewport()->setAutoFillBackground(false);
  content->setAutoFillBackground(false);
  body_->insertWidget(0, area);
  settingsArea_ = area;
  content->installEventFilter(this);
  return settings_;
}

void Page::addReading(const char* objectName) {
  readingFrame_ = new QFrame(this);
  readingFrame_->setProperty("role", "card");
  readingFrame_->setFixedHeight(readingHeight);
  auto* row = rowIn(readingFrame_, 0, {12, 0, 12, 0});
  reading_ = new ElidedLabel(objectName, readingFrame_);
  reading_->setAccessibleName(tr("Reading"));
  reading_->setAlignment(Qt::AlignVCenter | Qt::AlignLeft);
  row->addWidget(reading_);
  picture_->addWidget(readingFrame_);
}

void Page::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitIn();
}

void Page::setAlone(bool alone) {
  alone_ = alone;
  fitIn();
}

void Page::fitIn() {
  const bool narrow = !alone_ && width() < narrowBelow_px;
  if (narrow_ == narrow) return;
  narrow_ = narrow;
  arrange();
}

void Page::arrange() {
  (narrow_ ? top_ : words_)->addWidget(sentence_);
  gap_->changeSize(narrow_ ? 0 : gutter - 8, 1, QSizePolicy::Fixed, QSizePolicy::Minimum);
  head_->setText(narrow_ ? title_ : heading_);
  if (!staysBeside()) stack(narrow_);
  if (readingFrame_ != nullptr) (narrow_ ? static_cast<QVBoxLayout*>(layout()) : picture_)->addWidget(readingFrame_);
}

void Page::stack(bool stacked) {
  body_->setDirection(stacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  body_->setSpacing(stacked ? stackedGap : gutter);
  if (settingsArea_ == nullptr) return;
  if (stacked) {
    settingsArea_->setMinimumWidth(0);
    settingsArea_->setMaximumWidth(QWIDGETSIZE_MAX);
    giveSettingsTheirHeight();
  } else {
    settingsArea_->setFixedWidth(settingsWidth);
    settingsArea_->setMinimumHeight(0);
    settingsArea_->setMaximumHeight(QWIDGETSIZE_MAX);
  }
}

void Page::giveSettingsTheirHeight() {
  const int width_px = settingsArea_->viewport()->width();
  settingsArea_->setFixedHeight(settings_->hasHeightForWidth() ? settings_->totalHeightForWidth(width_px)
                                                               : settings_->totalSizeHint().height());
}

/// What the settings say has changed, or their width.
bool Page::eventFilter(QObject* watched, QEvent* event) {
  const bool ofSettings = settingsArea_ != nullptr && watched == settingsArea_->widget();
  const bool changed = event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize;
  if (ofSettings && changed && body_->direction() == QBoxLayout::TopToBottom) giveSettingsTheirHeight();
  return QWidget::eventFilter(watched, event);
}

void Page::read(const QString& text) {
  reading_->setText(text);
}

void Page::setState(const StepState& state) {
  if (state_ == state) return;
  state_ = state;
  emit stateChanged();
}

}  // namespace breakaway
