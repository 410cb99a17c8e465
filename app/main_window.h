// The window: the bar above, the steps of the job on the left, the page between, and the live strip below.
#pragma once

#include <QMainWindow>
#include <vector>

#include "widgets/file_chooser.h"

class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace breakaway {

class Connection;
class LivePlots;
class LiveStrip;
class LogDrawer;
class Manual;
class Page;
class PageRoom;
class ParametersDock;
class Rail;
class SettingsEdits;
class Toast;
struct Session;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow(Session& session, FileChooser& files, QWidget* parent = nullptr);

  /// Brings the page with this object name to the front.
  void showPage(const QString& objectName);
  /// Opens or closes the plots below the page.
  void showLive(bool open);
  /// The plots in the page's place, where they have the room for all of their curves.
  void showLiveLarge(bool large);
  /// Opens or closes the board's settings beside the page.
  void showParameters(bool open);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void buildPages(Session& session, FileChooser& files);
  void buildRail();
  void buildBelow(Session& session, FileChooser& files);
  void buildHelp();
  void buildParameters(Session& session, FileChooser& files);
  void countEdits(const SettingsEdits& edits);
  void layOut(QWidget* bar);
  void goTo(int row);
  void showStates();
  void showLog(bool open);
  void showHelp(const QWidget* about);
  void fitLive();

  Connection& connection_;
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
  Manual* manual_ = nullptr;
  bool liveOpen_ = false, liveLarge_ = false;
  std::vector<Page*> pages_;
};

}  // namespace breakaway
