// A tour through the window in one palette: every page in each of its states, as pictures.
#pragma once

#include <QString>
#include <QTemporaryDir>
#include <functional>

#include "base/result.h"
#include "main_window.h"
#include "session/session.h"

namespace breakaway {

/// A screen: its size in its own pixels, how many of them make one of the window's, and what that adds to a name.
struct Screen {
  QSize size;
  qreal ratio;
  const char* name;
};

/// Nobody is there to answer but with the one path that was prepared, if any.
class PreparedAnswer : public FileChooser {
 public:
  QString path;
  void ask(QWidget*, const FileQuestion&, Answer answer) override {
    if (!path.isEmpty()) answer(path);
  }
};

class Tour {
 public:
  Tour(const QString& folder, const QString& theme);
  /// Errors: what could not be reached, or written.
  Result<void> run();

 private:
  using Condition = std::function<bool()>;

  bool wait(const Condition& reached, int timeout_ms = 120'000);
  void report(const QString& name);
  void settle(int time_ms);
  void press(const char* button);
  void shoot(const QString& name);
  void shoot(const QString& name, const Screen& screen);
  void connectBoard();
  void loseLink();
  void compareProfile();
  void parameters(const QString& profile);
  void live();
  void identify();
  void tune();
  void home();
  void sweep();
  void layBeneath();
  void compare();
  void openLog();
  void overlay();
  void sealedTrial();
  void linear();

  QString folder_, theme_;
  QTemporaryDir project_;  ///< of this tour alone
  PreparedAnswer files_;
  Session session_;
  MainWindow window_;
  QString trouble_;
};

}  // namespace breakaway
