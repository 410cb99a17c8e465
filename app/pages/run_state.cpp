#include "pages/run_state.h"

#include <QCoreApplication>
#include <algorithm>

#include "session/connection.h"
#include "session/language.h"

namespace breakaway {

StepState stateOf(const Connection& connection, const std::vector<RunKind>& kinds) {
  const auto translated = [](const char* text) { return QCoreApplication::translate("RunState", text); };
  if (!connection.connected()) return {StepMark::open, translated(QT_TRANSLATE_NOOP("RunState", "needs a board"))};
  const RunSnapshot& run = connection.run();
  if (std::find(kinds.begin(), kinds.end(), run.kind) == kinds.end()) return {};
  switch (run.status.state) {
    case Procedure::State::running:
      return {StepMark::running,
              translated(QT_TRANSLATE_NOOP("RunState", "%1 % done")).arg(100.0 * run.status.progress, 0, 'f', 0)};
    case Procedure::State::failed:
      return {StepMark::trouble, inLanguage(run.status.failure)};
    case Procedure::State::stopped:
      return {StepMark::paused, translated(QT_TRANSLATE_NOOP("RunState", "stopped"))};
    case Procedure::State::finished:
      break;
  }
  return {};
}

}  // namespace breakaway
