// What is missing, as a ranked list of sentences; each finding can be left out of the simulation.
#pragma once

#include <QWidget>
#include <string>
#include <utility>
#include <vector>

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
  /// What this finding rests on is to be shown.
  void evidenceChosen(const QString& effect);

 private:
  void rebuild();
  void showLinks();
  void addFinding(QVBoxLayout& column, const Finding& finding);
  void addRivals(QVBoxLayout& column, const Finding& finding);
  void addPlaces(QVBoxLayout& column);
  void addText(QVBoxLayout& column, const QString& text, const char* objectName = "");

  Comparison& comparison_;
  QWidget* content_ = nullptr;
  std::vector<std::pair<std::string, QWidget*>> links_;  ///< effect, and what leads to its evidence
};

/// "Cogging" from `cogging`, "Load dependent friction" from `load_dependent_friction`.
QString effectTitle(const std::string& effect);

}  // namespace breakaway
