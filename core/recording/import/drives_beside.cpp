#include "recording/import/drives_beside.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>

#include "recording/import/columns_beside.h"
#include "recording/import/drive_evidence.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settle_motion.h"
#include "recording/import/settling.h"
#include "recording/import/whose.h"

namespace breakaway {

namespace {

constexpr auto windingDrives = std::to_array<std::string_view>({"current_A", "voltage_V", "duty"});

class DrivesBeside {
 public:
  DrivesBeside(const RawTable& table, const std::vector<size_t>& motion, std::vector<Choice>& choices)
      : table_(table), motion_(motion), choices_(choices) {
    for (size_t c = 0; c < choices.size(); ++c) {
      whose_.push_back(whoseIs(table.columns[c], choices[c]));
      moves_.push_back(movesBy(c));
    }
  }

  void judge(size_t c) {
    const bool torque = choices_[c].name.to == "torque_Nm", electric = isIn(windingDrives, choices_[c].name.to);
    const Kinship kin = kinshipToMotion(c);
    if (kin != Kinship::apart) {
      const auto namesake = kin == Kinship::untold ? namesakeOf(c) : std::nullopt;
      if (namesake && !moveTogether(*namesake))
        return setAside(choices_[c], message("belongs to {}, which isn't taken", nameOf(*namesake)));
      if (torque && kin == Kinship::untold) judgeUntoldTorque(c);
      if (electric && kin == Kinship::untold && isOfLoad(c) && choices_[c].name.guess.empty())
        choices_[c].name.guess = message("is called otherwise than {}", nameOf(motion_.front()));
      return;
    }
    if (const auto other = moverOf(c)) {
      if (electric && moveTogether(*other)) return;
      return setAside(choices_[c], message("belongs to {}, which isn't taken", nameOf(*other)));
    }
    if (std::any_of(motion_.begin(), motion_.end(), [&](size_t m) { return areDifferentJoints(whose_[m], whose_[c]); }))
      return setAside(choices_[c], message("is another joint's than {}", nameOf(motion_.front())));
    const size_t m = motion_.front();
    const bool behindGear =
        torque && whose_[c].side == Whose::Side::driven && whose_[m].side == Whose::Side::motor && isDriven();
    if (behindGear) return setAside(choices_[c], message("may be behind a gear, and {} is the motor's", nameOf(m)));
    if (choices_[c].name.guess.empty()) choices_[c].name.guess = message("is called otherwise than {}", nameOf(m));
  }

  /// "car_position_m", "rack_pos_mm" beside the motor's own rotation is what it moves, with the force there.
  void setMovedAside() {
    static constexpr auto linear = std::to_array<std::string_view>(
        {"position_m", "velocity_m_per_s", "force_N", "position_reference_m", "velocity_reference_m_per_s"});
    const auto motor = std::find_if(motion_.begin(), motion_.end(), [this](size_t m) {
      return whose_[m].side == Whose::Side::motor && choices_[m].name.to.find("rad") != std::string::npos;
    });
    const auto turns = [](const Choice& one) { return one.name.to == "torque_Nm" || one.name.to == "angle_rad"; };
    if (motor == motion_.end() || std::none_of(choices_.begin(), choices_.end(), turns)) return;  // a screw's nut
    for (size_t c = 0; c < choices_.size(); ++c) {
      const bool moved = whose_[c].side != Whose::Side::motor && !whose_[c].owner.empty();
      for (const std::string_view to : linear) {
        if (moved && open(c, to)) setAside(choices_[c], message("is what {} moves", nameOf(*motor)));
      }
    }
  }

  /// Of several for one thing: the motion's own, where one is.
  void preferOwn(std::string_view to) {
    const auto isOwn = [&](size_t c) { return open(c, to) && calledAlike(c); };
    size_t own = 0;
    while (own < choices_.size() && !isOwn(own)) ++own;
    if (own == choices_.size()) return;
    for (size_t c = 0; c < choices_.size(); ++c) {
      const Kinship kin = kinshipToMotion(c);
      const bool untold = to == "torque_Nm" && kin == Kinship::untold && isOnSideOf(own, motion_.front());
      if (open(c, to) && (kin == Kinship::apart || untold))
        setAside(choices_[c], message("is called otherwise than {}, as {} is", nameOf(motion_.front()), nameOf(own)));
    }
  }

  bool open(size_t c, std::string_view to) const {
    return choices_[c].name.to == to && !choices_[c].byMap && !choices_[c].byTool && !table_.columns[c].fault;
  }

 private:
  const std::string& nameOf(size_t c) const { return table_.columns[c].channel.name; }

  /// Whether it is called as something that moves, and not as what it shall do.
  bool movesBy(size_t c) const {
    const Words words = wordsOf(nameOf(c), true);
    if (firstIn(words, referenceWords) != nullptr || otherThingIn(words) != nullptr) return false;
    return std::any_of(words.begin(), words.end(),
                       [](const std::string& word) {
                         const Word* quantity = quantityNamed(word);
                         return quantity != nullptr && !quantity->weak &&
                                (quantity->kind == UnitKind::angle || quantity->kind == UnitKind::angularVelocity);
                       }) ||
           isIn(motions, choices_[c].name.to);
  }

  /// Called by the machine that loads a motor on a bench.
  bool isOfLoad(size_t c) const {
    static constexpr auto machines = std::to_array<std::string_view>({"dyno", "dynamometer"});
    const Words words = wordsOf(nameOf(c), true);
    return firstIn(words, loadWords) != nullptr || firstIn(words, machines) != nullptr;
  }

  Kinship kinshipToMotion(size_t c) const {
    Kinship most = Kinship::apart;
    for (const size_t m : motion_) most = std::max(most, kinshipOf(whose_[c], whose_[m]));
    return most;
  }

  bool calledAlike(size_t c) const {
    return std::any_of(motion_.begin(), motion_.end(), [&](size_t m) {
      const bool word = firstIn(whose_[c].owner, whose_[m].owner) != nullptr, side = isOnSideOf(c, m);
      return kinshipOf(whose_[c], whose_[m]) == Kinship::own && (word || side);
    });
  }

  /// A current, a voltage or a duty is there.
  bool isDriven() const {
    return std::any_of(choices_.begin(), choices_.end(),
                       [](const Choice& one) { return isIn(windingDrives, one.name.to); });
  }

  bool isTorque(size_t c) const {
    const Words words = wordsOf(nameOf(c), true);
    return std::any_of(words.begin(), words.end(), [](const std::string& word) {
      const Word* quantity = quantityNamed(word);
      return quantity != nullptr && !quantity->weak && quantity->kind == UnitKind::torque;
    });
  }

  /// Both called the motor's, or both what it drives.
  bool isOnSideOf(size_t c, size_t m) const {
    return whose_[c].side != Whose::Side::untold && whose_[c].side == whose_[m].side;
  }

  /// What else moves and is called as it is.
  std::optional<size_t> moverOf(size_t c) const {
    for (size_t k = 0; k < choices_.size(); ++k) {
      const bool others = k != c && moves_[k] && kinshipOf(whose_[k], whose_[c]) == Kinship::own;
      if (others && kinshipToMotion(k) == Kinship::apart) return k;
    }
    return std::nullopt;
  }

  /// What else moves and shares a word with it that the motion doesn't have.
  std::optional<size_t> namesakeOf(size_t c) const {
    for (size_t k = 0; k < choices_.size(); ++k) {
      const bool another = k != c && moves_[k] && std::find(motion_.begin(), motion_.end(), k) == motion_.end();
      if (another && firstIn(whose_[k].owner, whose_[c].owner) != nullptr && kinshipToMotion(k) != Kinship::own)
        return k;
    }
    return std::nullopt;
  }

  /// Its values as the motion's, but for a gear.
  bool moveTogether(size_t k) const {
    constexpr double much = 0.9;
    return std::any_of(motion_.begin(), motion_.end(), [&](size_t m) {
      const bool angle = isTurned(k), other = isTurned(m);
      if (angle == other) return std::abs(followingOf(speedAt(k), speedAt(m)).correlation) > much;
      std::vector<double> rows(table_.rows());
      std::iota(rows.begin(), rows.end(), 0.0);
      const auto both = compareMotion(rows, placeAt(angle ? k : m), valuesAt(angle ? m : k), {});
      return both && std::abs(both->correlation) > much;
    });
  }

  bool isTurned(size_t c) const {
    const Words words = wordsOf(nameOf(c), true);
    const bool speed = std::any_of(words.begin(), words.end(), [](const std::string& word) {
      const Word* quantity = quantityNamed(word);
      return quantity != nullptr && !quantity->weak && quantity->kind == UnitKind::angularVelocity;
    });
    return choices_[c].name.understood() ? isAngle(choices_[c].name.to) : !speed;
  }

  const std::vector<double>& valuesAt(size_t c) const { return table_.columns[c].channel.values; }

  std::vector<double> placeAt(size_t c) const {
    std::vector<double> place = valuesAt(c);
    if (const auto period = periodOf(place, {}, std::nullopt)) unwind(place, *period, {});
    return place;
  }

  std::vector<double> speedAt(size_t c) const { return isTurned(c) ? changesOf(placeAt(c)) : valuesAt(c); }

  /// A torque beside a motor's motion that something else is called by ("pedal_torque"), or beside both sides of a gear
  /// without a word of its side.
  void judgeUntoldTorque(size_t c) {
    const size_t m = motion_.front();
    const bool motors =
        std::any_of(motion_.begin(), motion_.end(), [&](size_t one) { return whose_[one].side == Whose::Side::motor; });
    const bool named = std::any_of(whose_[c].owner.begin(), whose_[c].owner.end(),
                                   [](const std::string& word) { return word.size() > 2; });  // "Te" is a symbol
    if (motors && whose_[c].side == Whose::Side::untold && named)
      return setAside(choices_[c], message("is called by something else than the motor, as {} is", nameOf(m)));
    if (whose_[c].side != Whose::Side::untold || whose_[m].side == Whose::Side::untold) return;
    const bool outputs = std::any_of(whose_.begin(), whose_.end(), [&](const Whose& one) {
      return one.side == Whose::Side::driven && isTorque(static_cast<size_t>(&one - whose_.data()));
    });
    if (motors && outputs && isDriven())  // "Command_Torque" beside "Output_Torque"
      return setAside(choices_[c], message("may be behind a gear, and {} is the motor's", nameOf(m)));
    for (size_t k = 0; k < choices_.size(); ++k) {
      const bool across = moves_[k] && whose_[k].side != Whose::Side::untold && whose_[k].side != whose_[m].side &&
                          whose_[k].axis == whose_[m].axis;
      constexpr double alike = 1.3;
      const double ratio = across ? rangeOf(valuesAt(k)) / rangeOf(valuesAt(m)) : 1.0;
      if (!across || isTurned(k) != isTurned(m) || (ratio < alike && ratio > 1.0 / alike)) continue;
      const Message why = message("nothing tells whether it is {}'s or {}'s", nameOf(m), nameOf(k));
      if (isDriven()) return setAside(choices_[c], why);
      choices_[c].name.guess = why;
      return;
    }
  }

  static constexpr auto motions =
      std::to_array<std::string_view>({"angle_rad", "velocity_rad_per_s", "position_m", "velocity_m_per_s"});

  const RawTable& table_;
  const std::vector<size_t>& motion_;
  std::vector<Choice>& choices_;
  std::vector<Whose> whose_;
  std::vector<bool> moves_;
};

}  // namespace

void setOthersDrivesAside(const RawTable& table, const std::vector<size_t>& motion, std::vector<Choice>& choices) {
  static constexpr auto drives =
      std::to_array<std::string_view>({"torque_Nm", "current_A", "voltage_V", "duty", "angle_reference_rad",
                                       "velocity_reference_rad_per_s", "current_reference_A", "torque_reference_Nm"});
  if (motion.empty()) return;
  DrivesBeside beside(table, motion, choices);
  beside.setMovedAside();
  for (const std::string_view to : drives) {
    for (size_t c = 0; c < choices.size(); ++c) {
      if (beside.open(c, to)) beside.judge(c);
    }
    beside.preferOwn(to);
  }
}

}  // namespace breakaway
