#include "widgets/figure_chip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/look.h"

namespace breakaway {

namespace {
constexpr int height_px = 44, valueWidth = 84;
}  // namespace

FigureChip::FigureChip(const char* objectName, const QString& title, QWidget* parent) : QFrame(parent) {
  setObjectName(objectName);
  setProperty("role", "chip");
  setFixedHeight(height_px);
  auto* row = rowIn(this, 4, {8, 4, 8, 4});
  auto* words = new QVBoxLayout;
  words->setSpacing(0);
  title_ = new ElidedLabel("", this);
  title_->setText(title);
  rule_ = new ElidedLabel("", this);
  for (QLabel* label : {title_, rule_}) {
    label->setFont(typed(Type::caption));
    words->addWidget(label);
  }
  row->addLayout(words, 1);
  value_ = new QLabel(this);
  value_->setAccessibleName(title);
  value_->setFont(typed(Type::section));
  value_->setFixedWidth(valueWidth);
  value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(value_);
}

void FigureChip::show(const QString& value, const QString& rule, const QString& tone) {
  value_->setText(value);
  rule_->setText(rule);
  dressAs(this, "tone", tone);
  for (QLabel* label : {title_, rule_, value_}) dressAs(label, "tone", tone);
}

QString FigureChip::value() const {
  return value_->text();
}

}  // namespace breakaway
