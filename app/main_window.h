// The window: the steps of the job on the left, the bar above, the live plots below, the page between.
#pragma once

#include <QMainWindow>
#include <memory>
#include <vector>

#include "widgets/file_chooser.h"

class QLabel;
class QListWidget;
class QStackedWidget;

namespace breakaway {

class LivePlots;
class Page;
struct Session;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow(Session& session, FileChooser& files, QWidget* parent = nullptr);

  /// Brings the page with this object name to the front.
  void showPage(const QString& objectName);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void buildPages(Session& session, FileChooser& files);
  void buildNavigation();
  void buildLiveDock(Session& session, FileChooser& files);
  void showIcons();
  void showLine(const QString& line, bool trouble);

  QListWidget* steps_ = nullptr;
  QStackedWidget* stack_ = nullptr;
  QLabel* line_ = nullptr;
  std::vector<Page*> pages_;
};

}  // namespace breakaway
