// The window: the bar above, the steps of the job on the left, the page between, and the live strip below.
#pragma once

#include <QMainWindow>
#include <vector>

#include "widgets/file_chooser.h"

class QStackedWidget;

namespace breakaway {

class Connection;
class LivePlots;
class LiveStrip;
class LogDrawer;
class Manual;
class Page;
class Rail;
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

 protected:
  void resizeEvent(QResizeEvent* event) override;

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void buildPages(Session& session, FileChooser& files);
  void buildRail();
  void buildBelow(Session& session, FileChooser& files);
  void buildHelp();
  void layOut(QWidget* bar);
  void goTo(int row);
  void showStates();
  void showLog(bool open);
  void showHelp(const QWidget* about);
  void fitLive();

  Connection& connection_;
  Rail* rail_ = nullptr;
  QStackedWidget* stack_ = nullptr;
  LogDrawer* log_ = nullptr;
  LivePlots* live_ = nullptr;
  LiveStrip* strip_ = nullptr;
  Toast* toast_ = nullptr;
  Manual* manual_ = nullptr;
  bool liveOpen_ = false;
  std::vector<Page*> pages_;
};

}  // namespace breakaway
