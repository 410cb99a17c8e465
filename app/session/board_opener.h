// How a board on a port is reached: opened without holding up the window, and again by itself when the link was lost.
#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <functional>
#include <memory>

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

  /// Opens at once what is simulated, the rest in a thread of its own. Ends what was under way.
  void open(const BoardRequest& request);
  /// The drive that came was lost: tries again until it comes back or close() is called.
  void lost(const QString& why);
  /// Nothing is under way any more; the drive, if there is one, belongs to somebody else.
  void close();
  /// A drive that nobody had to open.
  void keep();

  ConnectionState state() const { return state_; }
  /// Why it failed or was lost, in one line; empty otherwise.
  const QString& trouble() const { return trouble_; }

 signals:
  void changed();

 private:
  void attempt();
  void take(unsigned number, Result<std::unique_ptr<Drive>>& opened);
  void enter(ConnectionState state, const QString& trouble);

  Taker taker_;
  BoardRequest request_;
  ConnectionState state_ = ConnectionState::none;
  QString trouble_;
  unsigned number_ = 0;  ///< of the attempt that still counts
  QTimer retry_;
  QThreadPool pool_;
};

}  // namespace breakaway
