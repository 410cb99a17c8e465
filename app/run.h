// A procedure as the window sees it: which one, how far, and a copy of what it has measured so far.
#pragma once

#include <QMetaType>
#include <functional>
#include <memory>
#include <variant>

#include "experiment/drive.h"

namespace breakaway {

enum class RunKind { none, turning };

using RunResult = std::variant<std::monostate>;

struct RunSnapshot {
  RunKind kind = RunKind::none;
  Procedure::Status status;
  RunResult result;

  bool running() const { return kind != RunKind::none && status.state == Procedure::State::running; }
};

/// What the I/O thread runs: `read` copies the partial result and is called in the I/O thread.
struct Run {
  RunKind kind = RunKind::none;
  std::shared_ptr<Procedure> procedure;
  std::function<RunResult()> read;
};

}  // namespace breakaway

Q_DECLARE_METATYPE(breakaway::RunSnapshot)
