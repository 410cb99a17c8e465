#include "widgets/facts_table.h"

#include <QLabel>

#include "widgets/look.h"

namespace breakaway {

FactsTable::FactsTable(const char* objectName, QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  setObjectName(objectName);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(16);
  grid_->setVerticalSpacing(4);
  grid_->setColumnStretch(1, 1);
}

void FactsTable::show(const std::vector<Fact>& facts) {
  while (rows_.size() > facts.size()) {
    delete rows_.back().first;
    delete rows_.back().second;
    rows_.pop_back();
  }
  while (rows_.size() < facts.size()) {
    auto* name = new QLabel(this);
    auto* value = new QLabel(this);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    const int row = static_cast<int>(rows_.size());
    grid_->addWidget(name, row, 0);
    grid_->addWidget(value, row, 1);
    rows_.emplace_back(name, value);
  }
  for (size_t k = 0; k < facts.size(); ++k) {
    rows_[k].first->setText(facts[k].name);
    rows_[k].second->setText(facts[k].value);
    rows_[k].second->setAccessibleName(facts[k].name);
    rows_[k].second->setFont(sized(font(), 1.0, true));
    for (QLabel* label : {rows_[k].first, rows_[k].second}) label->setToolTip(facts[k].help);
  }
}

QString FactsTable::value(const QString& name) const {
  for (const auto& [label, value] : rows_) {
    if (label->text() == name) return value->text();
  }
  return {};
}

}  // namespace breakaway
