// The verdict in one sentence with two bars: the error on unseen data before and after, and what even a perfect model
// would leave.
#pragma once

#include <QFrame>

class QLabel;

namespace breakaway {

class Comparison;
class ElidedLabel;

class VerdictCard : public QFrame {
  Q_OBJECT

 public:
  explicit VerdictCard(Comparison& comparison, QWidget* parent = nullptr);

 private:
  class Bars;

  void show();

  Comparison& comparison_;
  ElidedLabel* title_ = nullptr;
  QLabel* figure_ = nullptr;
  QLabel* change_ = nullptr;
  QLabel* proof_ = nullptr;
  Bars* bars_ = nullptr;
};

}  // namespace breakaway
