#include "widgets/run_names.h"

#include <QCoreApplication>

namespace breakaway {

QString nameOf(RunKind kind) {
  const auto translated = [](const char* text) { return QCoreApplication::translate("RunName", text); };
  switch (kind) {
    case RunKind::turning:
      return translated(QT_TRANSLATE_NOOP("RunName", "Moving slowly"));
    case RunKind::hand:
      return translated(QT_TRANSLATE_NOOP("RunName", "Driven by hand"));
    case RunKind::step:
      return translated(QT_TRANSLATE_NOOP("RunName", "Velocity step"));
    case RunKind::positionStep:
      return translated(QT_TRANSLATE_NOOP("RunName", "Position step"));
    case RunKind::wiring:
      return translated(QT_TRANSLATE_NOOP("RunName", "Wiring check"));
    case RunKind::identification:
      return translated(QT_TRANSLATE_NOOP("RunName", "Identification"));
    case RunKind::homing:
      return translated(QT_TRANSLATE_NOOP("RunName", "Homing"));
    case RunKind::velocitySweep:
      return translated(QT_TRANSLATE_NOOP("RunName", "Velocity sweep"));
    case RunKind::breakaway:
      return translated(QT_TRANSLATE_NOOP("RunName", "Breakaway sweep"));
    case RunKind::trial:
      return translated(QT_TRANSLATE_NOOP("RunName", "Trial of the map"));
    case RunKind::experiment:
      return translated(QT_TRANSLATE_NOOP("RunName", "Experiment"));
    case RunKind::none:
      break;
  }
  return {};
}

bool endsByItself(RunKind kind) {
  return kind != RunKind::turning && kind != RunKind::hand && kind != RunKind::none;
}

}  // namespace breakaway
