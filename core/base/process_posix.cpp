#include "base/process.h"

#include <unistd.h>

#include <csignal>

namespace breakaway {

bool errorsGoToTerminal() {
  return ::isatty(STDERR_FILENO) == 1;
}

void takeSizeLimitAsError() {
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace breakaway
