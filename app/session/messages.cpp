#include "session/messages.h"

#include <QTime>
#include <algorithm>
#include <cstddef>

namespace breakaway {

void Messages::add(const QString& line, bool trouble) {
  lines_.push_back({QTime::currentTime().toString("HH:mm:ss"), line, trouble});
  if (lines_.size() > mostLines) lines_.pop_front();
  unread_ = std::min(unread_ + 1, lines_.size());
  emit said(line, trouble);
}

const Messages::Line* Messages::unreadTrouble() const {
  const auto end = lines_.rbegin() + static_cast<std::ptrdiff_t>(unread_);
  const auto found = std::find_if(lines_.rbegin(), end, [](const Line& line) { return line.trouble; });
  return found == end ? nullptr : &*found;
}

void Messages::markRead() {
  unread_ = 0;
  emit read();
}

}  // namespace breakaway
