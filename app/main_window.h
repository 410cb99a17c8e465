// The window, whatever language it speaks: its title, its place, the keys that stop the motor, and what is in it.
#pragma once

#include <QMainWindow>
#include <QTimer>
#include <optional>

#include "session/language.h"
#include "widgets/file_chooser.h"
#include "window_contents.h"

namespace breakaway {

class Manual;
struct Session;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  MainWindow(Session& session, FileChooser& files, QWidget* parent = nullptr);

  void showPage(const QString& objectName) { contents_->showPage(objectName); }
  void showLive(bool open) { contents_->showLive(open); }
  void showLiveLarge(bool large) { contents_->showLiveLarge(large); }
  void showParameters(bool open) { contents_->showParameters(open); }
  /// Speaks it from now on, and at later starts: what is in the window is made anew, and what was set in it set again.
  /// That waits while the motor turns, for then STOP is never away, and while a question or a written report would be
  /// lost; one line says so.
  void chooseLanguage(Language language);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void buildHelp();
  void showHelp(const QWidget* about);
  void makeContents();
  void speakWhenItMay();
  /// Why what is in the window can't be made anew now: in words, empty where it takes but a moment; nothing if it can.
  std::optional<QString> obstacle() const;
  void makeContentsAnew();

  Session& session_;
  FileChooser& files_;
  WindowContents* contents_ = nullptr;
  Manual* manual_ = nullptr;
  Language wanted_ = spokenLanguage();
  QString told_;  ///< why it waits
  QTimer next_;
};

}  // namespace breakaway
