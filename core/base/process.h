// What this process is told by the system it runs on.
#pragma once

namespace breakaway {

/// Whether a person sees at once what is written to standard error.
bool errorsGoToTerminal();

/// From now on a file beyond the size that the system allows is an error of writing, as a full disk is, and no end.
void takeSizeLimitAsError();

}  // namespace breakaway
