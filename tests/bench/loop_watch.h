// How long single events keep a window's thread: nobody's click is taken meanwhile.
#pragma once

#include <time.h>

#include <QApplication>
#include <algorithm>
#include <chrono>
#include <vector>

namespace breakaway::test {

/// An application that times each of its events, with all that comes of it before the next.
class WatchedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override {
    if (within_) return QApplication::notify(receiver, event);
    within_ = true;
    const QString what =
        QString("%1 %2, event %3").arg(receiver->metaObject()->className(), receiver->objectName()).arg(event->type());
    const double wall = wall_s(), own = own_s();
    const bool done = QApplication::notify(receiver, event);
    if (own_ms_.empty() || 1e3 * (own_s() - own) > worst_ms_) {
      worst_ms_ = 1e3 * (own_s() - own);
      worst_ = what;
    }
    wall_ms_.push_back(1e3 * (wall_s() - wall));
    own_ms_.push_back(1e3 * (own_s() - own));
    within_ = false;
    return done;
  }

  void forget() {
    wall_ms_.clear();
    own_ms_.clear();
  }
  size_t events() const { return wall_ms_.size(); }
  /// By the clock on the wall, in ms: with what other processes took. Share 1: the worst.
  double wall_ms(double share) const { return quantile(wall_ms_, share); }
  /// In the thread's own processor time, in ms: on an idle machine it is the same.
  double own_ms(double share) const { return quantile(own_ms_, share); }
  /// Whose event the worst one was, by own time.
  const QString& worst() const { return worst_; }
  /// What the thread took of a core in all of them, in s.
  double ownTotal_s() const {
    double sum_ms = 0.0;
    for (const double one : own_ms_) sum_ms += one;
    return 1e-3 * sum_ms;
  }

 private:
  static double wall_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  static double own_s() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }
  static double quantile(std::vector<double> all, double share) {
    if (all.empty()) return 0.0;
    std::sort(all.begin(), all.end());
    return all[std::min(all.size() - 1, static_cast<size_t>(share * static_cast<double>(all.size())))];
  }

  bool within_ = false;
  std::vector<double> wall_ms_, own_ms_;
  double worst_ms_ = 0.0;
  QString worst_;
};

}  // namespace breakaway::test
