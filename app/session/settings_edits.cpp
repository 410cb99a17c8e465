#include "session/settings_edits.h"

#include <QFileInfo>
#include <algorithm>

namespace breakaway {

SettingsEdits::SettingsEdits(Connection& connection, Messages& messages, QObject* parent)
    : QObject(parent), connection_(connection), messages_(messages) {
  connect(&connection_, &Connection::came, this, &SettingsEdits::meetBoard);
  connect(&connection_, &Connection::left, this, &SettingsEdits::meetBoard);
  connect(&connection_, &Connection::settingsChanged, this, &SettingsEdits::takeAccepted);
  meetBoard();
}

/// Another board's values are never sent to this one.
void SettingsEdits::meetBoard() {
  before_ = accepted_ = edited_ = connection_.settings();
  history_ = {edited_};
  at_ = 0;
  asked_.clear();
  if (!connection_.connected()) profile_.reset();
  emit changed();
}

/// What was edited and isn't sent yet stays.
void SettingsEdits::takeAccepted() {
  const ControllerSettings now = connection_.settings();
  const bool refused = now == accepted_;
  size_t otherwise = 0;
  for (const auto& [name, setting] : profileParameters()) {
    const bool asked = !refused && std::find(asked_.begin(), asked_.end(), setting) != asked_.end();
    if (asked && !sameSetting(now.*setting, wanted_.*setting)) ++otherwise;
    if (asked || !isEdited(setting)) edited_.*setting = now.*setting;
  }
  accepted_ = now;
  if (otherwise > 0)
    messages_.warn(tr("The board took %1 of %2 settings otherwise than asked for; what it accepted is shown")
                       .arg(otherwise)
                       .arg(asked_.size()));
  asked_.clear();
  remember();
  emit changed();
}

size_t SettingsEdits::count() const {
  const auto all = profileParameters();
  return static_cast<size_t>(
      std::count_if(all.begin(), all.end(), [this](const ProfileParameter& one) { return isEdited(one.value); }));
}

void SettingsEdits::remember() {
  if (history_[at_] == edited_) return;
  history_.resize(at_ + 1);
  history_.push_back(edited_);
  at_ = history_.size() - 1;
}

void SettingsEdits::edit(const ControllerSettings& settings) {
  if (settings == edited_) return;
  edited_ = settings;
  remember();
  emit changed();
}

bool SettingsEdits::set(Setting setting, double value) {
  const SettingRange range = connection_.rangeOf(setting);
  if (!range.offered || !(value >= range.least && value <= range.most)) return false;
  ControllerSettings wanted = edited_;
  wanted.*setting = value;
  edit(wanted);
  return true;
}

void SettingsEdits::goTo(size_t at) {
  if (at >= history_.size()) return;
  at_ = at;
  edited_ = history_[at_];
  emit changed();
}

void SettingsEdits::revert(Setting setting) {
  ControllerSettings wanted = edited_;
  wanted.*setting = accepted_.*setting;
  edit(wanted);
}

void SettingsEdits::apply(const std::vector<Setting>& chosen) {
  asked_.clear();
  wanted_ = accepted_;
  for (const Setting setting : chosen) {
    if (!isEdited(setting)) continue;
    asked_.push_back(setting);
    wanted_.*setting = edited_.*setting;
  }
  if (!asked_.empty()) connection_.configure(wanted_);
}

void SettingsEdits::apply() {
  std::vector<Setting> all;
  for (const auto& [name, setting] : profileParameters()) all.push_back(setting);
  apply(all);
}

void SettingsEdits::openProfile(const QString& path) {
  auto read = readProfile(path.toStdString());
  if (!read) return messages_.warn(read.error());
  profilePath_ = path;
  profile_ = std::move(*read);
  emit changed();
}

QString SettingsEdits::profileSource() const {
  if (!profile_) return {};
  return tr("%1, saved from %2").arg(QFileInfo(profilePath_).fileName(), QString::fromStdString(profile_->device));
}

bool SettingsEdits::differsFromProfile(Setting setting) const {
  return profile_ && connection_.rangeOf(setting).offered &&
         !sameSetting(profile_->settings.*setting, accepted_.*setting);
}

void SettingsEdits::takeFromProfile(const std::vector<Setting>& chosen) {
  if (!profile_) return;
  ControllerSettings wanted = edited_;
  for (const Setting setting : chosen) {
    const SettingRange range = connection_.rangeOf(setting);
    const double value = profile_->settings.*setting;
    if (range.offered) wanted.*setting = std::clamp(value, range.least, std::max(range.least, range.most));
  }
  edit(wanted);
}

}  // namespace breakaway
