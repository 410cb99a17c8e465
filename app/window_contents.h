// What is in the window: the bar above, the steps of the job on the left, the page between, and the live strip below.
// All of it is made of the session, so that it can be made anew at any time.
#pragma once

#include <QPointer>
#include <QVariant>
#include <QWidget>
#include <vector>

#include "session/language.h"
#include "widgets/file_chooser.h"

class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace breakaway {

class LivePlots;
class LiveStrip;
class LogDrawer;
class Page;
class PageRoom;
class ParametersDock;
class Rail;
class SettingsEdits;
class Toast;
struct Session;

class WindowContents : public QWidget {
  Q_OBJECT
  Q_PROPERTY(QVariant kept READ kept WRITE take USER true)

 public:
  WindowContents(Session& session, FileChooser& files, QWidget* parent);

  /// Brings the page with this object name to the front.
  void showPage(const QString& objectName);
  /// Opens or closes the plots below the page.
  void showLive(bool open);
  /// The plots in the page's place, where they have the room for all of their curves.
  void showLiveLarge(bool large);
  /// Opens or closes the board's settings beside the page.
  void showParameters(bool open);
  /// Whether a page waits for the end of something: it can't go now.
  bool busy() const;

  /// Whether the board's settings and the log are open.
  QVariant kept() const;
  void take(const QVariant& kept);

 signals:
  void languageChosen(breakaway::Language language);
  /// The manual is wanted, on what this is.
  void helpAsked(const QWidget* about);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// Tab; and what Qt does when the control with the focus is disabled or goes: the focus stays here then, at that
  /// control's place, instead of at whatever comes next.
  bool focusNextPrevChild(bool next) override;

 private:
  void buildPages(Session& session, FileChooser& files);
  void buildRail();
  void buildBelow(Session& session, FileChooser& files);
  void buildParameters(Session& session, FileChooser& files);
  void countEdits(const SettingsEdits& edits);
  void layOut(QWidget* bar);
  void goTo(int row);
  void showStates();
  void showLog(bool open);
  void fitLive();
  void placeToast();

  Rail* rail_ = nullptr;
  QStackedWidget* stack_ = nullptr;
  PageRoom* room_ = nullptr;
  ParametersDock* parameters_ = nullptr;
  QPushButton* parametersButton_ = nullptr;
  LogDrawer* log_ = nullptr;
  LivePlots* live_ = nullptr;
  LiveStrip* strip_ = nullptr;
  QVBoxLayout* below_ = nullptr;  ///< the page, and what stands below it
  Toast* toast_ = nullptr;
  QPointer<QWidget> left_;  ///< what had the focus and can't have it now
  bool liveOpen_ = false, liveLarge_ = false;
  std::vector<Page*> pages_;
};

}  // namespace breakaway
