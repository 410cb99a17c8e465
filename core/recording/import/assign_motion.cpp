#include "recording/import/assign_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string_view>

#include "recording/import/columns_beside.h"
#include "recording/import/drive_evidence.h"
#include "recording/import/motion_beside.h"
#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settle_motion.h"
#include "recording/import/whose.h"

namespace breakaway {

namespace {

// What each thing that is known is worth; a rank's step is 1.
constexpr double aColumn = 14.0;                  // that stands first among those that mean the same
constexpr double tellsMore = 1.5;                 // an angle tells the speed, too
constexpr double evidence = 10.0;                 // that a motion, a name or a drive is for a choice, or against it
constexpr double besideMotors = -1.5 * evidence;  // none of the motor's, where the motor's own moves otherwise
constexpr double clearly = 3.0;                   // ahead of another motion
constexpr double ownDrive = 4.0;                  // that is called as the motion is

// Of what two motions have in common.
constexpr double much = 0.9, little = 0.5;

constexpr double moreThanNoise = 0.15;  // of a drive that a motion explains

enum class Owner { nobody, another, joint, motor };

/// A column that may be where the motor is or how fast.
struct Mover {
  size_t column = 0;
  bool angle = false;
  double worth = 0.0;
  Owner owner = Owner::nobody;
  Words called = {};               ///< without the words of quantities
  std::vector<double> place = {};  ///< an angle, unwound
  std::vector<double> speed = {};  ///< or how much it changes from row to row
  Whose whose = {};
  double driven = 0.0;
  bool hasOwnDrive = false;
};

/// A choice: places among the movers.
struct Chosen {
  std::optional<size_t> angle = {}, speed = {};
  double points = -std::numeric_limits<double>::infinity();
};

class Assignment {
 public:
  Assignment(const RawTable& table, const std::vector<int>& ranks, const std::vector<Choice>& choices)
      : table_(table), choices_(choices) {
    static constexpr size_t most = 8;  // of each, those that stand first
    for (const bool angle : {true, false}) {
      std::vector<size_t> columns;
      for (size_t c = 0; c < choices.size(); ++c) {
        if (choices[c].name.to == (angle ? "angle_rad" : "velocity_rad_per_s") &&
            rangeOf(table.columns[c].channel.values) > 0.0 && !table.columns[c].fault)
          columns.push_back(c);
      }
      std::stable_sort(columns.begin(), columns.end(), [&](size_t a, size_t b) { return ranks[a] < ranks[b]; });
      columns.resize(std::min(columns.size(), most));
      for (const size_t c : columns) movers_.push_back(moverOf(c, angle, ranks[c]));
    }
  }

  const std::vector<Mover>& movers() const { return movers_; }

  /// The first of each, as ranks alone have it.
  Chosen byRank() const {
    Chosen first;
    for (size_t k = movers_.size(); k-- > 0;) (movers_[k].angle ? first.angle : first.speed) = k;
    return first;
  }

  bool areFixed() const {
    return std::any_of(movers_.begin(), movers_.end(),
                       [this](const Mover& one) { return choices_[one.column].byMap || choices_[one.column].byTool; });
  }

  /// Whether there is nothing to choose: one of each at most, by one name.
  bool isPlain() const {
    const Chosen first = byRank();
    if (movers_.size() < 2) return true;
    if (movers_.size() > 2 || !first.angle || !first.speed) return false;
    const Mover &angle = movers_[*first.angle], &speed = movers_[*first.speed];
    return !strangers(angle, speed);
  }

  /// How much two have in common, whatever their units and signs (0 to 1); nothing where nobody can tell.
  std::optional<double> common(size_t one, size_t other) {
    const auto key = std::minmax(one, other);
    auto known = common_.find(key);
    if (known == common_.end()) known = common_.emplace(key, compare(movers_[key.first], movers_[key.second])).first;
    return known->second;
  }

  bool differ(size_t one, size_t other) { return common(one, other).value_or(1.0) < little; }

  void findDrives() {
    static constexpr size_t most = 6;
    static constexpr auto outputs = std::to_array<std::string_view>({"control", "ctrl", "u", "action", "effort"});
    size_t drives = 0;
    for (const std::string_view to : {"torque_Nm", "current_A", "voltage_V", "duty", ""}) {
      for (size_t c = 0; c < choices_.size() && drives < most; ++c) {
        const RawColumn& column = table_.columns[c];
        bool open = choices_[c].name.to == to && !column.fault && rangeOf(column.channel.values) > 0.0;
        if (to.empty()) open = open && firstIn(wordsOf(column.channel.name, true), outputs) != nullptr;
        if (!open) continue;
        ++drives;
        const Whose whose = whoseIs(column, choices_[c]);
        const bool owned = std::any_of(movers_.begin(), movers_.end(), [&whose](const Mover& one) {
          return kinshipOf(one.whose, whose) == Kinship::own;
        });
        for (Mover& one : movers_) {
          const Kinship kin = kinshipOf(one.whose, whose);
          one.hasOwnDrive = one.hasOwnDrive || (!to.empty() && kin == Kinship::own);
          if (owned && kin == Kinship::apart) continue;  // another's
          const std::vector<double> drive = begin(table_.columns[c].channel.values);
          one.driven = std::max(one.driven, drivenBy(rowsOf(drive), one.speed, drive, {}));
        }
      }
    }
  }

  bool moveOtherwise() {
    for (size_t k = 0; k < movers_.size(); ++k) {
      for (size_t j = 0; j < k; ++j) {
        if (differ(k, j)) return true;
      }
    }
    return false;
  }

  /// The best choice; of those whose motion is another one than `than`'s, where it is given.
  Chosen best(const std::optional<Chosen>& than = {}) {
    Chosen best;
    const auto isOther = [&](const Chosen& one) {
      if (!than) return true;
      const size_t its = one.angle.value_or(one.speed.value_or(0)),
                   thans = than->angle.value_or(than->speed.value_or(0));
      return its != thans && differ(its, thans);
    };
    std::vector<std::optional<size_t>> angles{std::nullopt}, speeds{std::nullopt};
    for (size_t k = 0; k < movers_.size(); ++k) (movers_[k].angle ? angles : speeds).emplace_back(k);
    for (const auto& angle : angles) {
      for (const auto& speed : speeds) {
        if (!angle && !speed) continue;
        const Chosen one{angle, speed, pointsOf(angle, speed)};
        if (one.points > best.points && isOther(one)) best = one;
      }
    }
    return best;
  }

 private:
  static constexpr size_t mostRows = 100'000;

  static std::vector<double> begin(const std::vector<double>& values) {
    const auto count = static_cast<std::ptrdiff_t>(std::min(mostRows, values.size()));
    return {values.begin(), values.begin() + count};
  }

  static std::vector<double> rowsOf(const std::vector<double>& values) {
    std::vector<double> rows(values.size());
    std::iota(rows.begin(), rows.end(), 0.0);
    return rows;
  }

  Mover moverOf(size_t c, bool angle, int rank) const {
    Mover one;
    one.column = c;
    one.angle = angle;
    one.worth = aColumn - rank + (angle ? tellsMore : 0.0);
    one.owner = ownerAt(c);
    one.called = wordsBesideQuantity(table_, c);
    one.whose = whoseIs(table_.columns[c], choices_[c]);
    std::vector<double> values = begin(table_.columns[c].channel.values);
    if (!angle) {
      one.speed = std::move(values);
      return one;
    }
    if (const auto period = periodOf(values, {}, std::nullopt)) unwind(values, *period, {});
    one.speed = changesOf(values);
    one.place = std::move(values);
    return one;
  }

  Owner ownerAt(size_t c) const {
    static constexpr auto motors =
        std::to_array<std::string_view>({"motor", "mot", "rotor", "shaft", "servo", "stepper", "rpm", "wheel"});
    const Words words = wordsOf(table_.columns[c].channel.name, true);
    const ColumnName& name = choices_[c].name;
    const bool encoder =
        std::any_of(words.begin(), words.end(), [](const std::string& one) { return one.starts_with("enc"); });
    const bool drivenAngle = name.to == "angle_rad" && firstIn(words, drivenWords) != nullptr;
    if ((firstIn(words, motors) != nullptr || encoder || name.unit == "rpm") && !drivenAngle) return Owner::motor;
    if (firstIn(words, jointWords) != nullptr || !name.group.empty()) return Owner::joint;
    return name.qualified ? Owner::another : Owner::nobody;
  }

  /// Called by different words: "robot_velocity" beside "hood_angle".
  bool strangers(const Mover& angle, const Mover& speed) const {
    const ColumnName &of = choices_[angle.column].name, &how = choices_[speed.column].name;
    if (kinshipOf(angle.whose, speed.whose) == Kinship::apart) return true;
    const auto isOtherThan = [](const Mover& motor, const Mover& one) {  // "dyno_angle" beside "motor_speed"
      return motor.whose.side == Whose::Side::motor && one.whose.side == Whose::Side::untold &&
             std::any_of(one.called.begin(), one.called.end(), [](const std::string& word) {
               return !isIn(decorations, word) && !isNumber(word) && unitNamed(word) == nullptr &&
                      quantityNamed(word) == nullptr;
             });
    };
    if (isOtherThan(angle, speed) || isOtherThan(speed, angle)) return true;
    if (of.qualified && how.qualified) return angle.called != speed.called;
    return of.qualified && of.unit.empty() && !how.unit.empty() && speed.owner == Owner::motor &&
           angle.owner == Owner::another;
  }

  static std::optional<double> compare(const Mover& one, const Mover& other) {
    if (one.angle != other.angle) {
      const Mover &angle = one.angle ? one : other, &speed = one.angle ? other : one;
      const auto motion = compareMotion(rowsOf(speed.speed), angle.place, speed.speed, {});
      return motion ? std::optional(std::abs(motion->correlation)) : std::nullopt;
    }
    const double alike = std::abs(likenessOf(one.speed, other.speed).correlation);
    if (one.angle) return alike;
    std::vector<double> first = one.speed, second = other.speed;  // one may tell no direction
    for (auto* values : {&first, &second}) {
      for (double& value : *values) value = std::abs(value);
    }
    const double asFast = likenessOf(first, second).correlation;
    return asFast > much ? std::max(asFast, alike) : alike;
  }

  /// What one is worth where several things move.
  double pointsOf(size_t k) {
    const Mover& one = movers_[k];
    double points = one.worth;
    bool beside = false, several = false;
    for (size_t j = 0; j < movers_.size(); ++j) {
      if (j == k || !differ(j, k)) continue;
      several = true;
      const bool told = movers_[j].angle || !choices_[movers_[j].column].name.unit.empty();
      beside = beside || (movers_[j].owner == Owner::motor && told);
    }
    if (several && one.owner == Owner::motor) points += evidence;
    if (beside && (one.owner == Owner::nobody || one.owner == Owner::another)) points += besideMotors;
    return points;
  }

  double pointsOf(const std::optional<size_t>& angle, const std::optional<size_t>& speed) {
    double points = 0.0, driven = 0.0;
    bool owns = false;
    for (const auto& one : {angle, speed}) {
      if (!one) continue;
      points += pointsOf(*one);
      owns = owns || movers_[*one].hasOwnDrive;
      driven = std::max(driven, movers_[*one].driven);
    }
    if (driven > moreThanNoise) points += evidence * driven;
    if (owns) points += ownDrive;
    if (!angle || !speed) return points;
    const double alike = common(*angle, *speed).value_or(much);
    if (alike >= much) points += evidence;
    if (alike < little && strangers(movers_[*angle], movers_[*speed])) return -std::numeric_limits<double>::max();
    return alike < little ? points - evidence : points;
  }

  const RawTable& table_;
  const std::vector<Choice>& choices_;
  std::vector<Mover> movers_;
  std::map<std::pair<size_t, size_t>, std::optional<double>> common_;
};

/// Why the one that ranks put first isn't taken.
Message whyNot(Assignment& all, const RawTable& table, size_t first, const Chosen& chosen) {
  const auto nameOf = [&](size_t k) { return table.columns[all.movers()[k].column].channel.name; };
  const bool angle = all.movers()[first].angle;
  const auto instead = angle ? chosen.angle : chosen.speed, partner = angle ? chosen.speed : chosen.angle;
  if (instead && partner && all.differ(first, *partner))
    return message("moves otherwise than {}, with which {} agrees", nameOf(*partner), nameOf(*instead));
  if (instead && partner && !all.differ(first, *instead))
    return message("is called otherwise than {}, as {} is", nameOf(*partner), nameOf(*instead));
  const size_t other = instead.value_or(partner.value_or(first));
  if (all.movers()[other].owner == Owner::motor)
    return message("moves otherwise than {}, which is the motor's", nameOf(other));
  if (all.movers()[other].driven > all.movers()[first].driven + little)
    return message("moves otherwise than {}, which what drives it explains", nameOf(other));
  return message("moves otherwise than {}, and is called by something else", nameOf(other));
}

}  // namespace

void assignMotion(const RawTable& table, const std::vector<int>& ranks, std::vector<Choice>& choices) {
  Assignment all(table, ranks, choices);
  if (all.areFixed() || all.isPlain()) return;
  if (all.moveOtherwise()) all.findDrives();
  const Chosen first = all.byRank(), chosen = all.best();
  std::vector<std::pair<size_t, Message>> aside;
  for (const auto& [by, now] : {std::pair(first.angle, chosen.angle), std::pair(first.speed, chosen.speed)}) {
    if (!by || by == now) continue;
    for (size_t k = 0; k < all.movers().size(); ++k) {
      if (all.movers()[k].angle == all.movers()[*by].angle && now != k)
        aside.emplace_back(all.movers()[k].column, whyNot(all, table, k, chosen));
    }
  }
  const Chosen second = all.best(chosen);
  const size_t taken = all.movers()[chosen.angle.value_or(chosen.speed.value_or(0))].column;
  if (std::isfinite(second.points) && chosen.points - second.points < clearly) {
    const size_t other = all.movers()[second.angle.value_or(second.speed.value_or(0))].column;
    if (choices[taken].name.guess.empty())
      choices[taken].name.guess =
          message("{} may be meant as well, and moves otherwise", table.columns[other].channel.name);
  }
  for (auto& [column, why] : aside) setAside(choices[column], std::move(why));
}

}  // namespace breakaway
