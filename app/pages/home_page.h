// Home: find the encoder's index, so that every angle counts from the same mark on the rotor.
#pragma once

#include <vector>

#include "pages/page.h"
#include "widgets/facts_table.h"

class QLabel;
class QPushButton;

namespace breakaway {

class BenchRuns;
class Connection;
class LiveSamples;
class RunPanel;

class HomePage : public Page {
  Q_OBJECT

 public:
  HomePage(Connection& connection, BenchRuns& bench, const LiveSamples& live, QWidget* parent = nullptr);

 private:
  QWidget* buildPlan();
  QWidget* buildResult();
  QString plan() const;
  QString travelPlan() const;
  void showConnection();
  std::vector<Fact> indexFacts() const;
  std::vector<Fact> travelFacts() const;
  void showResult();
  void showMotion();

  Connection& connection_;
  BenchRuns& bench_;
  QPushButton* home_ = nullptr;
  RunPanel* run_ = nullptr;
  FactsTable* result_ = nullptr;
  QLabel* plan_ = nullptr;
};

}  // namespace breakaway
