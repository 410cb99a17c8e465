// Opens boards: one on a port without holding up the window, and again by itself when its link was lost.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <functional>
#include <memory>

#include "base/message.h"
#include "experiment/drive.h"
#include "firmware_link/transport/open_board.h"

namespace breakaway {

enum class ConnectionState { none, connecting, connected, failed, reconnecting };

/// A board that comes back is met as it is then: a new drive, its motor off, nothing written to it.
class BoardOpener : public QObject {
  Q_OBJECT

 public:
  using Taker = std::function<void(std::unique_ptr<Drive>)>;

  /// `taker` gets each drive that was opened, in this object's thread.
  explicit BoardOpener(Taker taker, QObject* parent = nullptr);
  ~BoardOpener() override;

  /// Opens a simulated board at once, any other in a thread of its own. Gives up an attempt that is under way.
  void open(const BoardRequest& request);
  /// The board that was opened is lost: tries again until it comes back or close() is called.
  void lost(const Message& why);
  /// Gives up an attempt that is under way; a drive that was handed over is not touched.
  void close();
  /// Somebody has a drive that was opened elsewhere: that counts as connected.
  void keep();

  ConnectionState state() const { return state_; }
  /// Why it failed or was lost, in one line; empty otherwise.
  const Message& trouble() const { return trouble_; }

 signals:
  void changed();

 private:
  void attempt();
  void take(unsigned number, Result<std::unique_ptr<Drive>>& opened);
  void enter(ConnectionState state, const Message& trouble);

  Taker taker_;
  BoardRequest request_;
  ConnectionState state_ = ConnectionState::none;
  Message trouble_;
  unsigned number_ = 0;  ///< of the attempt that still counts
  QTimer retry_;
  QThreadPool pool_;
};

}  // namespace breakaway
