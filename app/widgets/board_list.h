// The boards one can connect to: simulated presets, what is plugged into serial ports, and the network.
#pragma once

#include <QListWidget>
#include <vector>

#include "firmware_link/transport/serial_ports.h"

namespace breakaway {

/// Looks for ports once a second while it is shown; the choice stays where it is.
class BoardList : public QListWidget {
  Q_OBJECT

 public:
  explicit BoardList(QWidget* parent = nullptr);
  /// The chosen board's address; empty when none is chosen.
  QString address() const;
  /// Adds a simulated rig of one's own and chooses it.
  void addRig(const QString& name, const QString& uri);
  void showPorts(const std::vector<SerialPort>& ports);

 private:
  QListWidgetItem* add(int row, const QString& text, const QString& uri, const QString& tip);
  void addTitle(const QString& text);
  int rowBelowRigs() const;

  std::vector<QString> shown_;  ///< addresses of the ports in the list
};

}  // namespace breakaway
