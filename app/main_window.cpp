#include "main_window.h"

#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QStackedWidget>
#include <QTime>
#include <QVBoxLayout>

#include "pages/compare_page.h"
#include "pages/connect_page.h"
#include "pages/friction_page.h"
#include "pages/home_page.h"
#include "pages/report_page.h"
#include "pages/tune_page.h"
#include "session/session.h"
#include "widgets/board_bar.h"
#include "widgets/controls.h"
#include "widgets/live_plots.h"
#include "widgets/look.h"
#include "widgets/stop_keys.h"

namespace breakaway {

MainWindow::MainWindow(Session& session, FileChooser& files, QWidget* parent) : QMainWindow(parent) {
  setObjectName("mainWindow");
  setWindowTitle(tr("Breakaway"));
  setWindowIcon(QIcon(":/icons/breakaway.svg"));
  setDockOptions(QMainWindow::AnimatedDocks);
  setMenuWidget(new BoardBar(session.connection, this));
  buildPages(session, files);
  buildNavigation();
  buildLiveDock(session, files);
  new StopKeys([&connection = session.connection] { connection.stop(); }, this);
  connect(&session.messages, &Messages::said, this, &MainWindow::showLine);
  showIcons();
  steps_->setFocus();
  resize(1366, 768);
}

void MainWindow::buildPages(Session& session, FileChooser& files) {
  auto& [messages, connection, bench, live, comparison] = session;
  pages_ = {new ConnectPage(connection, bench, messages, files, this),
            new TunePage(connection, bench, this),
            new HomePage(connection, bench, live, this),
            new FrictionPage(connection, bench, messages, files, this),
            new ComparePage(bench, live, comparison, files, this),
            new ReportPage(bench, comparison, messages, files, this)};
  stack_ = new QStackedWidget(this);
  for (Page* page : pages_) stack_->addWidget(page);
}

void MainWindow::buildNavigation() {
  steps_ = new QListWidget(this);
  steps_->setObjectName("steps");
  steps_->setAccessibleName(tr("Steps of the job"));
  steps_->setFixedWidth(132);
  steps_->setFrameShape(QFrame::NoFrame);
  steps_->setIconSize(QSize(20, 20));
  steps_->setSpacing(1);
  steps_->setFont(sized(font(), 1.08));
  for (const Page* page : pages_) {
    auto* item = new QListWidgetItem(page->title(), steps_);
    item->setSizeHint(QSize(0, 36));
  }
  for (size_t k = 0; k < pages_.size(); ++k) {
    const int step = static_cast<int>(k);
    steps_->item(step)->setToolTip(tr("Ctrl+%1").arg(step + 1));
    auto* action = new QAction(this);
    action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + step)));
    connect(action, &QAction::triggered, this, [this, step] { steps_->setCurrentRow(step); });
    addAction(action);
  }
  connect(steps_, &QListWidget::currentRowChanged, stack_, &QStackedWidget::setCurrentIndex);
  line_ = new QLabel(this);
  line_->setObjectName("messageLine");
  line_->setAccessibleName(tr("Last message"));
  line_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  line_->setContentsMargins(10, 2, 10, 2);
  line_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  auto* right = new QVBoxLayout;
  right->setSpacing(0);
  right->addWidget(stack_, 1);
  right->addWidget(line_);
  auto* centre = new QWidget(this);
  auto* row = rowIn(centre, 0);
  row->addWidget(steps_);
  row->addLayout(right, 1);
  setCentralWidget(centre);
  steps_->setCurrentRow(0);
}

void MainWindow::buildLiveDock(Session& session, FileChooser& files) {
  auto* dock = new QDockWidget(tr("Live"), this);
  dock->setObjectName("liveDock");
  dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
  dock->setTitleBarWidget(new QWidget(dock));
  dock->setWidget(new LivePlots(session.connection, session.live, session.messages, files, dock));
  addDockWidget(Qt::BottomDockWidgetArea, dock);
  resizeDocks({dock}, {236}, Qt::Vertical);
}

void MainWindow::showIcons() {
  for (size_t k = 0; k < pages_.size(); ++k)
    steps_->item(static_cast<int>(k))->setIcon(lineIcon(pages_[k]->icon(), palette()));
}

void MainWindow::showPage(const QString& objectName) {
  for (size_t k = 0; k < pages_.size(); ++k) {
    if (pages_[k]->objectName() == objectName) steps_->setCurrentRow(static_cast<int>(k));
  }
}

void MainWindow::showLine(const QString& line, bool trouble) {
  const Look look = Look::of(palette());
  QPalette colours = palette();
  colours.setColor(QPalette::WindowText, trouble ? look.trouble : look.muted);
  line_->setPalette(colours);
  line_->setText(QTime::currentTime().toString("HH:mm:ss  ") + line);
  line_->setToolTip(line);
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (steps_ == nullptr || event->type() != QEvent::PaletteChange) return;
  showIcons();
  line_->setPalette(palette());
}

}  // namespace breakaway
