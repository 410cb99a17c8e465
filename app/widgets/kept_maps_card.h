// Which map is shown and which lies beneath it, where they come from the project.
#pragma once

#include <QFrame>

class QPushButton;

namespace breakaway {

class ElidedLabel;
class ShownMaps;

class KeptMapsCard : public QFrame {
  Q_OBJECT

 public:
  explicit KeptMapsCard(ShownMaps& maps, QWidget* parent = nullptr);

 signals:
  /// Another one is to be chosen.
  void runsAsked();

 private:
  void showMaps();

  ShownMaps& maps_;
  ElidedLabel* opened_ = nullptr;
  ElidedLabel* earlier_ = nullptr;
  QPushButton* today_ = nullptr;
  QPushButton* away_ = nullptr;
};

}  // namespace breakaway
