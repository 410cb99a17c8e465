// Identify: the motor's constants step by step, each with what it will move, its result with interval, and whether it
// passed.
#pragma once

#include <vector>

#include "pages/page.h"
#include "session/identify_steps.h"

class QFrame;
class QLabel;
class QPushButton;

namespace breakaway {

class BenchRuns;
class Connection;
class FactsTable;
class MotorTestsPlot;
class RunPanel;

class IdentifyPage : public Page {
  Q_OBJECT

 public:
  IdentifyPage(Connection& connection, BenchRuns& bench, QWidget* parent = nullptr);

 private:
  struct Card {
    QFrame* frame;
    QLabel *title, *badge, *moves, *result;
  };

  Card addCard(QVBoxLayout& column);
  QWidget* buildFacts();
  void showSteps();
  void showCard(const Card& card, int number, const IdentifyStep& step);
  void showFacts();
  void showButtons();

  Connection& connection_;
  BenchRuns& bench_;
  std::vector<Card> cards_;
  QPushButton* identify_ = nullptr;
  QPushButton* wiring_ = nullptr;
  RunPanel* run_ = nullptr;
  QFrame* outcome_ = nullptr;  ///< around it
  MotorTestsPlot* tests_ = nullptr;
  FactsTable* motor_ = nullptr;
  FactsTable* wires_ = nullptr;
};

}  // namespace breakaway
