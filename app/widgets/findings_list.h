// What is missing, as a ranked list of sentences; each finding can be left out of the simulation.
#pragma once

#include <QWidget>

class QVBoxLayout;

namespace breakaway {

class Comparison;
struct Finding;

class FindingsList : public QWidget {
  Q_OBJECT

 public:
  explicit FindingsList(Comparison& comparison, QWidget* parent = nullptr);

 signals:
  /// A place on this axis was chosen.
  void axisChosen(const QString& axis);

 private:
  void rebuild();
  void addFinding(QVBoxLayout& column, const Finding& finding);
  void addPlaces(QVBoxLayout& column);
  void addText(QVBoxLayout& column, const QString& text, const char* objectName = "");

  Comparison& comparison_;
  QWidget* content_ = nullptr;
};

/// "Cogging" from `cogging`, "Load dependent friction" from `load_dependent_friction`.
QString effectTitle(const std::string& effect);

}  // namespace breakaway
