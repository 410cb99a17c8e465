// What closing the window asks, which is only while the motor turns, and what the next start finds as it was.
#pragma once

class QMainWindow;
class QWidget;

namespace breakaway {

class Connection;

/// Whether the window may close now. Where the motor is powered, a question is put over `window`, which blocks nothing,
/// and the answer stops the motor and closes.
bool mayClose(QWidget& window, Connection& connection);

/// Size and place, how sweeps are measured and what the live plots show, as they were when keepLayout() was called
/// last; false: a size was never kept, and the window is made no larger than its screen.
bool restoreLayout(QMainWindow& window);
void keepLayout(QMainWindow& window);

/// Whether the board's settings stood beside the page when the window was closed.
bool parametersKeptOpen();
void keepParametersOpen(bool open);

}  // namespace breakaway
