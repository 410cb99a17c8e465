// Names and values in two aligned columns, the values selectable.
#pragma once

#include <QGridLayout>
#include <QWidget>
#include <vector>

class QLabel;

namespace breakaway {

struct Fact {
  QString name;
  QString value;
  QString help;
};

class FactsTable : public QWidget {
  Q_OBJECT

 public:
  explicit FactsTable(const char* objectName, QWidget* parent = nullptr);
  void show(const std::vector<Fact>& facts);
  /// Values of more characters may take several lines; for columns that are narrower than most.
  void setOneLine(int characters) { oneLine_ = characters; }
  using QWidget::show;
  QString value(const QString& name) const;

 private:
  int oneLine_ = 30;
  QGridLayout* grid_;
  std::vector<std::pair<QLabel*, QLabel*>> rows_;
};

}  // namespace breakaway
