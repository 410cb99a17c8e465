// What closing the window asks and keeps: it asks only while the motor turns, and size and place are there again.
#pragma once

class QMainWindow;
class QWidget;

namespace breakaway {

class Connection;

/// Whether the window may close now. Where the motor is powered, a question is put over `window`, which blocks nothing,
/// and the answer stops the motor and closes.
bool mayClose(QWidget& window, Connection& connection);

/// Size and place as they were when keepLayout() was called last; false: they were never kept, and the window is made
/// no larger than its screen.
bool restoreLayout(QMainWindow& window);
void keepLayout(const QMainWindow& window);

/// Whether the board's settings stood beside the page when the window was closed.
bool parametersKeptOpen();
void keepParametersOpen(bool open);

}  // namespace breakaway
