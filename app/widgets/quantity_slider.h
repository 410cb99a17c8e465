// One quantity by slider and by number, both showing the same value, with its unit.
#pragma once

#include <QWidget>
#include <optional>

class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace breakaway {

struct QuantityRange {
  double least = 0.0;
  double most = 1.0;
  int decimals = 3;
  bool logarithmic =
      false;  ///< the slider's travel is logarithmic above least + most/1000; its left end is `least` itself
};

class QuantitySlider : public QWidget {
  Q_OBJECT

 public:
  /// `objectName` names the whole; its parts are objectName + "Slider" and objectName + "Box".
  QuantitySlider(const QString& objectName, const QString& title, const QString& unit, const QString& help,
                 QWidget* parent);

  double value() const;
  /// Shows a value without telling anyone; the range grows to hold it.
  void show(double value);
  using QWidget::show;
  void setRange(const QuantityRange& range);
  /// What the board has: shown beneath the title, and as an edit where it is another than value().
  void setOnBoard(std::optional<double> value);
  /// From here on a rule is broken, which the groove shows; empty: no rule.
  void setRule(std::optional<double> most);
  void setUnit(const QString& unit);
  void setAvailable(bool available, const QString& reason);

 signals:
  /// A person chose another value.
  void chosen(double value);

 private:
  class MarkedSlider;

  int positionOf(double value) const;
  double valueOf(int position) const;
  void takeSlider(int position);
  void takeBox(double value);
  void showEdit();

  QString help_;
  QuantityRange range_;
  MarkedSlider* slider_ = nullptr;
  QDoubleSpinBox* box_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* onBoard_ = nullptr;
  std::optional<double> board_, rule_;
};

}  // namespace breakaway
