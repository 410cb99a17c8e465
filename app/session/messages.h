// Lines for the person at the bench, from whoever has something to say to whoever shows them.
#pragma once

#include <QObject>
#include <QString>

#include "base/result.h"
#include "session/language.h"

namespace breakaway {

class Messages : public QObject {
  Q_OBJECT

 public:
  void say(const QString& line) { emit said(line, false); }
  /// Something failed.
  void warn(const QString& line) { emit said(line, true); }
  void warn(const Error& error) { warn(inLanguage(error.said())); }
  /// `line` where it was done, else why not.
  void say(const Result<void>& done, const QString& line) { done ? say(line) : warn(done.error()); }

 signals:
  void said(const QString& line, bool trouble);
};

}  // namespace breakaway
