// What stands where a board's identity will: what the bench answers, as pictures, and a way to try each at once.
#pragma once

#include <QFrame>

namespace breakaway {

/// One of the answers, drawn as its page shows it: an example, no measurement.
enum class WelcomePicture { map, step, verdict };

class WelcomeCard : public QFrame {
  Q_OBJECT

 public:
  explicit WelcomeCard(QWidget* parent = nullptr);

 signals:
  /// That page is to be tried, on a simulated board where it takes one.
  void tryAsked(const QString& page, bool needsBoard);

 private:
  struct Names {
    const char* page;
    const char* button;
  };
  void add(WelcomePicture picture, const Names& names, const QString& title, const QString& sentence,
           const QString& button, const QString& tip);

  QWidget* content_ = nullptr;
};

}  // namespace breakaway
