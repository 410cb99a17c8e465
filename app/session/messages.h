// Lines for the person at the bench, from whoever has something to say to whoever shows them; and what was said so far.
#pragma once

#include <QObject>
#include <QString>
#include <deque>

#include "base/result.h"
#include "session/language.h"

namespace breakaway {

class Messages : public QObject {
  Q_OBJECT

 public:
  /// As it was said, in the language of that moment.
  struct Line {
    QString time, text;
    bool trouble = false;
  };

  void say(const QString& line) { add(line, false); }
  /// Something failed.
  void warn(const QString& line) { add(line, true); }
  void warn(const Error& error) { warn(inLanguage(error.said())); }
  /// `line` where it was done, else why not.
  void say(const Result<void>& done, const QString& line) { done ? say(line) : warn(done.error()); }

  static constexpr size_t mostLines = 1000;
  /// The newest last.
  const std::deque<Line>& lines() const { return lines_; }
  /// How many nobody has read yet.
  size_t unread() const { return unread_; }
  /// The newest of them that is trouble; nullptr if none is.
  const Line* unreadTrouble() const;
  void markRead();

 signals:
  void said(const QString& line, bool trouble);
  void read();

 private:
  void add(const QString& line, bool trouble);

  std::deque<Line> lines_;
  size_t unread_ = 0;
};

}  // namespace breakaway
