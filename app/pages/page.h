// One step of the technician's job, and what all of them have: a head with one primary button, settings on the left,
// the picture on the right, a line beneath it for what is read off, and a state for the rail.
#pragma once

#include <QString>
#include <QVariant>
#include <QWidget>

#include "widgets/step_state.h"

class QFrame;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QSpacerItem;
class QVBoxLayout;

namespace breakaway {

class ElidedLabel;

class Page : public QWidget {
  Q_OBJECT

 public:
  Page(const char* objectName, const QString& title, QWidget* parent);

  const QString& title() const { return title_; }
  const StepState& state() const { return state_; }
  /// No step of the job, but something that is at hand all the time.
  virtual bool isTool() const { return false; }
  /// Whether plots of what comes from the board have room below it.
  virtual bool wantsLive() const { return true; }
  /// What it needs beside something else.
  int leastWidth_px() const { return 656; }
  /// Whether nothing stands beside it, or is about to: alone it asks for no more height than it needs then.
  void setAlone(bool alone);
  /// Whether something is under way whose end it waits for, so that it can't go now.
  virtual bool busy() const { return false; }

 signals:
  void stateChanged();
  /// What was asked for is on the page of this name.
  void pageAsked(const QString& objectName);

 protected:
  static constexpr int settingsWidth = 324;

  /// The page's title and one sentence beneath it; both elide.
  void setHead(const QString& title, const QString& sentence);
  /// Top right, in a slot of fixed width.
  QPushButton* addPrimary(const char* objectName, const QString& text);
  /// To the left of it.
  QPushButton* addSecondary(const char* objectName, const QString& text, int width = 144);
  /// Where the cards of the settings go; it scrolls when there is no room.
  QVBoxLayout* settings();
  /// Where the picture goes.
  QVBoxLayout* picture() const { return picture_; }
  /// Adds the reading line beneath the picture.
  void addReading(const char* objectName);
  void read(const QString& text);
  void setState(const StepState& state);
  /// Whether settings and picture stand side by side even where there is little room.
  virtual bool staysBeside() const { return false; }
  /// Beside something else there is less room: the sentence goes beneath the buttons, the picture beneath the settings,
  /// the reading line beneath all; what is higher than the window scrolls.
  bool narrow() const { return narrow_; }
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fitIn();
  void arrange();
  /// Settings above the picture, as high as they are, or to its left, where they scroll.
  void stack(bool stacked);
  void giveSettingsTheirHeight();

  QString title_, heading_;
  StepState state_;
  ElidedLabel* head_ = nullptr;
  ElidedLabel* sentence_ = nullptr;
  ElidedLabel* reading_ = nullptr;
  QFrame* readingFrame_ = nullptr;
  bool narrow_ = false, alone_ = true;
  QSpacerItem* gap_ = nullptr;    ///< before the buttons
  QVBoxLayout* words_ = nullptr;  ///< title and sentence
  QVBoxLayout* top_ = nullptr;    ///< the head's rows
  QHBoxLayout* buttons_ = nullptr;
  QHBoxLayout* body_ = nullptr;
  QVBoxLayout* settings_ = nullptr;
  QScrollArea* settingsArea_ = nullptr;
  QVBoxLayout* picture_ = nullptr;
};

}  // namespace breakaway
