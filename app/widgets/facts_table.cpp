#include "widgets/facts_table.h"

#include <QLabel>

#include "widgets/look.h"

namespace breakaway {

FactsTable::FactsTable(const char* objectName, QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  setObjectName(objectName);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(12);
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
    name->setProperty("tone", "muted");
    for (QLabel* label : {name, value}) {
      label->setTextInteractionFlags(Qt::TextSelectableByMouse);  // either, or their lines of writing differ by a pixel
      label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    }
    value->setMinimumWidth(1);  // a long value is cut, and doesn't push the page apart
    const int row = static_cast<int>(rows_.size());
    grid_->addWidget(name, row, 0);
    grid_->addWidget(value, row, 1);
    rows_.emplace_back(name, value);
  }
  for (size_t k = 0; k < facts.size(); ++k) {
    rows_[k].first->setText(facts[k].name);
    rows_[k].second->setText(facts[k].value);
    rows_[k].second->setWordWrap(facts[k].value.size() > oneLine_);
    rows_[k].second->setAccessibleName(facts[k].name);
    for (QLabel* label : {rows_[k].first, rows_[k].second})
      label->setToolTip(facts[k].help.isEmpty() ? facts[k].value : facts[k].help);
  }
}

QString FactsTable::value(const QString& name) const {
  for (const auto& [label, value] : rows_) {
    if (label->text() == name) return value->text();
  }
  return {};
}

}  // namespace breakaway
