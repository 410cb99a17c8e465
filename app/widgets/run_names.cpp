#include "widgets/run_names.h"

#include <QCoreApplication>

namespace breakaway {

QString nameOf(RunKind kind) {
  const auto translated = [](const char* text) { return QCoreApplication::translate("RunName", text); };
  switch (kind) {
    case RunKind::turning:
      return translated("Moving slowly");
    case RunKind::hand:
      return translated("Driven by hand");
    case RunKind::step:
      return translated("Velocity step");
    case RunKind::wiring:
      return translated("Wiring check");
    case RunKind::identification:
      return translated("Identification");
    case RunKind::homing:
      return translated("Homing");
    case RunKind::velocitySweep:
      return translated("Velocity sweep");
    case RunKind::breakaway:
      return translated("Breakaway sweep");
    case RunKind::trial:
      return translated("Trial of the map");
    case RunKind::experiment:
      return translated("Experiment");
    case RunKind::none:
      break;
  }
  return {};
}

bool endsByItself(RunKind kind) {
  return kind != RunKind::turning && kind != RunKind::hand && kind != RunKind::none;
}

}  // namespace breakaway
