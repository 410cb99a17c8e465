// Drive by hand: the motor runs while a button is held, within the limits on the page.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "pages/page.h"
#include "session/hand_drive.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace breakaway {

class BenchRuns;
class Connection;
class LiveSamples;

class HandPage : public Page {
  Q_OBJECT
  Q_PROPERTY(QVariant kept READ kept WRITE take USER true)

 public:
  HandPage(Connection& connection, BenchRuns& bench, const LiveSamples& live, QWidget* parent = nullptr);
  bool isTool() const override { return true; }

  /// What is held in each mode.
  QVariant kept() const;
  void take(const QVariant& kept);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* buildSettings();
  QWidget* buildButtons();
  QWidget* buildNumbers();
  QWidget* buildStep();
  QPushButton* holdButton(QWidget* parent, const char* objectName, double way);
  void choose(HandMode mode);
  void wordForAxis();
  void hold(double way);
  void jog(double way);
  double speedLimit() const;
  void letGo();
  /// Nothing moves on while nobody looks at the page.
  void leave();
  void showState();
  bool showNumbers();

  Connection& connection_;
  BenchRuns& bench_;
  const LiveSamples& live_;
  HandMode mode_ = HandMode::speed;
  std::shared_ptr<HandGrip> grip_, jogGrip_;
  std::optional<bool> worded_;  ///< for a linear axis, or a rotor
  std::array<QPushButton*, 3> modes_{};
  std::array<double, 3> targets_{1.0, 0.2, 5.0};  ///< by mode, as shown
  QDoubleSpinBox* target_ = nullptr;
  QDoubleSpinBox* mostSpeed_ = nullptr;
  QDoubleSpinBox* most_A_ = nullptr;
  QDoubleSpinBox* step_ = nullptr;
  QDoubleSpinBox* stepSpeed_ = nullptr;
  std::array<QPushButton*, 2> jogs_{};     ///< one step, ways as buttons_
  std::array<QPushButton*, 2> buttons_{};  ///< against growing angle, towards it
  std::array<QLabel*, 4> numbers_{};
  std::array<QLabel*, 4> units_{};
};

}  // namespace breakaway
