// The bar that is always there: which board, what runs and how far it is, and STOP. Everything has its slot, whatever
// it says.
#pragma once

#include <QWidget>

class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;

namespace breakaway {

class Connection;
class ElidedLabel;
class FactsTable;

class BoardBar : public QWidget {
  Q_OBJECT

 public:
  static constexpr int height_px = 44;

  explicit BoardBar(Connection& connection, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QWidget* buildBoard();
  QWidget* buildRun();
  void showConnection();
  void showLink();
  void showRun();
  QString deviceWords() const;
  QString linkWords() const;

  Connection& connection_;
  QWidget* dot_ = nullptr;
  ElidedLabel* device_ = nullptr;
  ElidedLabel* link_ = nullptr;
  FactsTable* details_ = nullptr;
  QLabel* simulated_ = nullptr;
  ElidedLabel* run_ = nullptr;
  ElidedLabel* activity_ = nullptr;
  QProgressBar* progress_ = nullptr;
  ElidedLabel* left_ = nullptr;
  ElidedLabel* end_ = nullptr;
  QPushButton* stop_ = nullptr;
};

}  // namespace breakaway
