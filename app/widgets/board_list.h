// The boards one can connect to: simulated presets, what is plugged into serial ports, and the network.
#pragma once

#include <QListWidget>
#include <QVariant>
#include <vector>

#include "firmware_link/transport/serial_ports.h"

namespace breakaway {

/// Looks for ports once a second while it is shown; the choice stays where it is.
class BoardList : public QListWidget {
  Q_OBJECT
  Q_PROPERTY(QVariant kept READ kept WRITE take USER true)

 public:
  /// Of an item: what the board is, in a word or two, written muted beside its name.
  static constexpr int aboutRole = Qt::UserRole + 2;

  explicit BoardList(QWidget* parent = nullptr);
  /// The chosen board's address; empty when none is chosen.
  QString address() const;
  /// Adds a simulated rig of one's own and chooses it.
  void addRig(const QString& name, const QString& uri);
  void showPorts(const std::vector<SerialPort>& ports);

  /// One's own rigs, and which board is chosen.
  QVariant kept() const;
  void take(const QVariant& kept);

 private:
  /// What the preset of this name is; its address where it isn't known here.
  static QString presetWords(const QString& preset, const QString& uri);
  QListWidgetItem* add(int row, const QString& text, const QString& uri, const QString& tip);
  void addTitle(const QString& text);
  int rowBelowRigs() const;

  QVariantMap ownRigs_;         ///< their addresses, by name
  std::vector<QString> shown_;  ///< addresses of the ports in the list
};

}  // namespace breakaway
