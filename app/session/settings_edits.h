// What is edited of the board's settings and not sent yet: one state for all that edit them, with undo.
#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <vector>

#include "experiment/profile.h"
#include "session/connection.h"
#include "session/messages.h"

namespace breakaway {

class SettingsEdits : public QObject {
  Q_OBJECT

 public:
  using Setting = double ControllerSettings::*;

  SettingsEdits(Connection& connection, Messages& messages, QObject* parent = nullptr);

  const ControllerSettings& edited() const { return edited_; }
  /// What the board has.
  const ControllerSettings& accepted() const { return accepted_; }
  /// What it had when it was connected.
  const ControllerSettings& before() const { return before_; }
  bool isEdited(Setting setting) const { return !sameSetting(edited_.*setting, accepted_.*setting); }
  size_t count() const;

  void edit(const ControllerSettings& settings);
  /// Refuses, and changes nothing, where the board doesn't offer it, or not this value.
  bool set(Setting setting, double value);
  bool canUndo() const { return at_ > 0; }
  bool canRedo() const { return at_ + 1 < history_.size(); }
  void undo() { goTo(at_ - 1); }
  void redo() { goTo(at_ + 1); }
  void revert(Setting setting);
  void revertAll() { edit(accepted_); }

  /// Asks the board for these edits, or for all; the others stay edits.
  void apply(const std::vector<Setting>& chosen);
  void apply();

  /// A profile beside the board; nothing is edited by it.
  void openProfile(const QString& path);
  const std::optional<Profile>& profile() const { return profile_; }
  /// Its file and board.
  QString profileSource() const;
  bool differsFromProfile(Setting setting) const;
  /// Edits these to what the profile holds, as far as the board offers them.
  void takeFromProfile(const std::vector<Setting>& chosen);

 signals:
  void changed();

 private:
  void meetBoard();
  void takeAccepted();
  void goTo(size_t at);
  void remember();

  Connection& connection_;
  Messages& messages_;
  ControllerSettings edited_, accepted_, before_;
  std::vector<ControllerSettings> history_;  ///< what was set, `at_` is now
  size_t at_ = 0;
  std::vector<Setting> asked_;  ///< of the board, which hasn't answered yet
  ControllerSettings wanted_;
  std::optional<Profile> profile_;
  QString profilePath_;
};

}  // namespace breakaway
