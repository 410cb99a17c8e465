// A sealed trial that is open: what it is, and, once the answer is in, what it concealed.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

namespace breakaway {

class TrialRun;

class TrialStrip : public QFrame {
  Q_OBJECT

 public:
  TrialStrip(TrialRun& trial, QWidget* parent);

 private:
  void show();

  TrialRun& trial_;
  QLabel* words_ = nullptr;
  QPushButton* unseal_ = nullptr;
};

}  // namespace breakaway
