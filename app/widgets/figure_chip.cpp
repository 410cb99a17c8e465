#include "widgets/figure_chip.h"

#include <QGridLayout>
#include <QLabel>

#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/look.h"

namespace breakaway {

namespace {
constexpr int chipHeight = 44;
}  // namespace

FigureChip::FigureChip(const char* objectName, const QString& title, QWidget* parent) : QFrame(parent) {
  setObjectName(objectName);
  setProperty("role", "chip");
  setFixedHeight(chipHeight);
  // The name has the chip's whole width; what is asked and what it is share the line beneath.
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(8, 3, 8, 3);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(0);
  grid->setColumnStretch(0, 1);
  title_ = new ElidedLabel("", this);
  title_->setText(title);
  rule_ = new ElidedLabel("", this);
  for (QLabel* label : {title_, rule_}) label->setFont(typed(Type::caption));
  grid->addWidget(title_, 0, 0, 1, 2);
  grid->addWidget(rule_, 1, 0);
  value_ = new QLabel(this);
  value_->setAccessibleName(title);
  value_->setFont(typed(Type::section));
  value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(value_, 1, 1);
}

void FigureChip::show(const QString& value, const QString& rule, const QString& tone) {
  value_->setText(value);
  rule_->setText(rule);
  layout()->activate();  // what it is has its width at once
  dressAs(this, "tone", tone);
  for (QLabel* label : {title_, rule_, value_}) dressAs(label, "tone", tone);
}

QString FigureChip::value() const {
  return value_->text();
}

}  // namespace breakaway
