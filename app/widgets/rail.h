// The steps of the job, each with its state: done and what came of it, running and how far, or why not yet.
#pragma once

#include <QListWidget>

#include "widgets/step_state.h"

namespace breakaway {

class Rail : public QListWidget {
  Q_OBJECT

 public:
  static constexpr int width_px = 168;

  explicit Rail(QWidget* parent = nullptr);
  /// A new last row; `tool`: it is no step of the job and has no mark.
  void add(const QString& title, const QString& tip, bool tool);
  void setState(int row, const StepState& state);
  /// What its rows fill of its height.
  int rowsHeight_px() const;
};

}  // namespace breakaway
