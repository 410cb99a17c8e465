#include "session/board_opener.h"

#include <chrono>
#include <utility>

#include "firmware_link/presets.h"

namespace breakaway {

using namespace std::chrono_literals;

BoardOpener::BoardOpener(Taker taker, QObject* parent) : QObject(parent), taker_(std::move(taker)) {
  retry_.setSingleShot(true);
  retry_.setInterval(1s);
  connect(&retry_, &QTimer::timeout, this, &BoardOpener::attempt);
}

BoardOpener::~BoardOpener() {
  pool_.waitForDone();
}

void BoardOpener::enter(ConnectionState state, const Message& trouble) {
  state_ = state;
  trouble_ = trouble;
  emit changed();
}

void BoardOpener::open(const BoardRequest& request) {
  close();
  request_ = request;
  if (isSimulated(request.uri)) {
    auto opened = openBoard(request);
    return take(number_, opened);
  }
  enter(ConnectionState::connecting, {});
  attempt();
}

void BoardOpener::attempt() {
  pool_.start([this, number = number_, request = request_] {
    const auto opened = std::make_shared<Result<std::unique_ptr<Drive>>>(openBoard(request));
    QMetaObject::invokeMethod(
        this, [this, number, opened] { take(number, *opened); }, Qt::QueuedConnection);
  });
}

void BoardOpener::take(unsigned number, Result<std::unique_ptr<Drive>>& opened) {
  if (number != number_) return;  // nobody waits for it any more
  if (opened) {
    state_ = ConnectionState::connected;
    trouble_ = {};
    taker_(std::move(*opened));
    emit changed();
  } else if (state_ == ConnectionState::reconnecting) {
    enter(state_, opened.error().said());
    retry_.start();
  } else {
    enter(ConnectionState::failed, opened.error().said());
  }
}

void BoardOpener::lost(const Message& why) {
  if (request_.uri.empty() || isSimulated(request_.uri)) return enter(ConnectionState::failed, why);
  ++number_;
  enter(ConnectionState::reconnecting, why);
  retry_.start();
}

void BoardOpener::close() {
  ++number_;
  retry_.stop();
  request_ = {};
  enter(ConnectionState::none, {});
}

void BoardOpener::keep() {
  close();
  enter(ConnectionState::connected, {});
}

}  // namespace breakaway
