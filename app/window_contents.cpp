#include "window_contents.h"

#include <QAction>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "pages/compare_page.h"
#include "pages/connect_page.h"
#include "pages/friction_page.h"
#include "pages/hand_page.h"
#include "pages/home_page.h"
#include "pages/identify_page.h"
#include "pages/report_page.h"
#include "pages/runs_page.h"
#include "pages/tune_page.h"
#include "session/session.h"
#include "session/settings_edits.h"
#include "widgets/board_bar.h"
#include "widgets/closing.h"
#include "widgets/controls.h"
#include "widgets/live_plots.h"
#include "widgets/live_strip.h"
#include "widgets/log_drawer.h"
#include "widgets/look.h"
#include "widgets/page_room.h"
#include "widgets/parameters_dock.h"
#include "widgets/rail.h"
#include "widgets/theme_button.h"
#include "widgets/toast.h"

namespace breakaway {

namespace {
constexpr int gap_px = 4;  // around what is said, below the rail
}  // namespace

WindowContents::WindowContents(Session& session, FileChooser& files, QWidget* parent) : QWidget(parent) {
  setObjectName("windowContents");
  resize(parent->size());
  buildPages(session, files);
  buildRail();
  buildBelow(session, files);
  buildParameters(session, files);
  layOut(new BoardBar(session.connection, this));
  toast_ = new Toast(session.messages, this);
  connect(toast_, &Toast::clicked, this, [this](const QString& text) {
    showLog(true);
    log_->showLine(text);
  });
  rail_->installEventFilter(this);
  goTo(0);
}

bool WindowContents::busy() const {
  return std::any_of(pages_.begin(), pages_.end(), [](const Page* page) { return page->busy(); });
}

QVariant WindowContents::kept() const {
  return QVariantList{!parameters_->isHidden(), !log_->isHidden()};
}

void WindowContents::take(const QVariant& kept) {
  showParameters(kept.toList().value(0).toBool());
  showLog(kept.toList().value(1).toBool());
}

void WindowContents::buildPages(Session& session, FileChooser& files) {
  auto& [messages, connection, edits, project, bench, live, comparison, experiment, trial, keptResults, unfinished,
         runs, maps, profile] = session;
  pages_ = {new ConnectPage(connection, bench, profile, files, this),
            new IdentifyPage(connection, bench, this),
            new TunePage(connection, bench, edits, this),
            new HomePage(connection, bench, live, this),
            new FrictionPage(connection, bench, maps, messages, files, this),
            new ComparePage(bench, live, comparison, experiment, trial, project, files, this),
            new ReportPage(bench, comparison, messages, files, this),
            new HandPage(connection, bench, live, this),
            new RunsPage(project, runs, maps, comparison, files, this)};
  stack_ = new QStackedWidget(this);
  for (Page* page : pages_) {
    stack_->addWidget(page);
    connect(page, &Page::stateChanged, this, &WindowContents::showStates);
    connect(page, &Page::pageAsked, this, &WindowContents::showPage);
  }
}

void WindowContents::buildRail() {
  rail_ = new Rail(this);
  for (size_t k = 0; k < pages_.size(); ++k) {
    const int row = static_cast<int>(k);
    rail_->add(pages_[k]->title(), tr("Ctrl+%1").arg(row + 1), pages_[k]->isTool());
    auto* action = new QAction(this);
    action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + row)));
    connect(action, &QAction::triggered, this, [this, row] { rail_->setCurrentRow(row); });
    addAction(action);
  }
  connect(rail_, &Rail::currentRowChanged, this, &WindowContents::goTo);
  showStates();
}

void WindowContents::buildBelow(Session& session, FileChooser& files) {
  log_ = new LogDrawer(session.messages, this);
  log_->hide();
  live_ = new LivePlots(session.connection, session.live, session.messages, files, this);
  live_->hide();
  connect(live_, &LivePlots::largeAsked, this, &WindowContents::showLiveLarge);
  connect(live_, &LivePlots::heightChanged, this, &WindowContents::fitLive);
  strip_ = new LiveStrip(session.connection, session.live, session.messages, this);
  connect(strip_, &LiveStrip::plotsAsked, this, &WindowContents::showLive);
  connect(strip_, &LiveStrip::logAsked, this, [this] { showLog(!log_->isVisible()); });
  connect(log_, &LogDrawer::closed, this, [this] { showLog(false); });
}

void WindowContents::buildParameters(Session& session, FileChooser& files) {
  parameters_ = new ParametersDock(session.connection, session.edits, files, this);
  parameters_->hide();
  connect(parameters_, &ParametersDock::closed, this, [this] { showParameters(false); });
  parametersButton_ = pushButton(this, "parametersButton", tr("Parameters"),
                                 tr("The board's settings beside the page: compare, edit, apply (Ctrl+P)"));
  parametersButton_->setProperty("role", "bare");
  parametersButton_->setFixedSize(Rail::width_px, 32);
  parametersButton_->setStyleSheet("padding-left: 12px;");
  const auto turn = [this] { showParameters(parameters_->isHidden()); };
  connect(parametersButton_, &QPushButton::clicked, this, turn);
  auto* action = new QAction(this);
  action->setShortcut(QKeySequence("Ctrl+P"));
  connect(action, &QAction::triggered, this, turn);
  addAction(action);
  connect(&session.edits, &SettingsEdits::changed, this, [this, &edits = session.edits] { countEdits(edits); });
  countEdits(session.edits);
}

void WindowContents::countEdits(const SettingsEdits& edits) {
  const size_t count = edits.count();
  parametersButton_->setText(count == 0 ? tr("Parameters") : tr("Parameters: %1 edited").arg(count));
}

void WindowContents::showParameters(bool open) {
  keepParametersOpen(open);
  if (open) showLiveLarge(false);
  for (Page* page : pages_) page->setAlone(!open);
  room_->setScrolls(open);
  parameters_->setVisible(open);
  fitLive();
}

void WindowContents::layOut(QWidget* bar) {
  auto* column = columnIn(this, 0);
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  auto* side = new QWidget(this);
  side->setProperty("role", "rail");
  side->setAttribute(Qt::WA_StyledBackground);
  auto* left = columnIn(side, 0);
  left->addWidget(rail_, 1);
  left->addWidget(parametersButton_);
  auto* help =
      pushButton(side, "helpButton", tr("Manual (F1)"), tr("The manual on this page; F1 on what is under the cursor"));
  help->setProperty("role", "bare");
  help->setFixedSize(Rail::width_px, 32);
  help->setStyleSheet("padding-left: 12px;");
  connect(help, &QPushButton::clicked, this, [this] { emit helpAsked(stack_->currentWidget()); });
  left->addWidget(help);
  auto* theme = new ThemeButton(this);
  connect(theme, &ThemeButton::languageChosen, this, &WindowContents::languageChosen);
  left->addWidget(theme);
  auto* right = below_ = new QVBoxLayout;
  right->setSpacing(0);
  room_ = new PageRoom(stack_, this);
  auto* above = new QHBoxLayout;
  above->setSpacing(0);
  above->addWidget(room_, 1);
  above->addWidget(parameters_);
  right->addLayout(above, 1);
  right->addWidget(log_);
  right->addWidget(live_);
  row->addWidget(side);
  row->addLayout(right, 1);
  column->addWidget(bar);
  column->addLayout(row, 1);
  column->addWidget(strip_);
}

void WindowContents::goTo(int row) {
  showLiveLarge(false);
  // Together they may ask for more room than there is, and the window would grow.
  if (!pages_[static_cast<size_t>(row)]->wantsLive()) live_->hide();
  // Only the page that is shown says how much room the window needs.
  for (Page* page : pages_) {
    const auto policy = page == pages_[static_cast<size_t>(row)] ? QSizePolicy::Preferred : QSizePolicy::Ignored;
    page->setSizePolicy(policy, policy);
  }
  room_->setLeast(pages_[static_cast<size_t>(row)]->leastWidth_px());
  stack_->setCurrentIndex(row);
  if (rail_->currentRow() != row) rail_->setCurrentRow(row);
  fitLive();
}

void WindowContents::showStates() {
  // Of the steps that nothing is in the way of, the first one is the next, unless one is begun before it.
  bool named = false;
  for (size_t k = 0; k < pages_.size(); ++k) {
    StepState state = pages_[k]->state();
    if (!named && !pages_[k]->isTool() && state.mark == StepMark::open && state.words.isEmpty()) {
      state.words = tr("next");
      named = true;
    }
    named = named || state.mark == StepMark::paused || state.mark == StepMark::running;
    rail_->setState(static_cast<int>(k), state);
  }
}

void WindowContents::showPage(const QString& objectName) {
  for (size_t k = 0; k < pages_.size(); ++k) {
    if (pages_[k]->objectName() == objectName) goTo(static_cast<int>(k));
  }
}

void WindowContents::showLive(bool open) {
  liveOpen_ = open;
  strip_->showOpen(open);
  fitLive();
}

void WindowContents::showLiveLarge(bool large) {
  if (liveLarge_ == large) return;
  liveLarge_ = large;
  live_->setLarge(large);
  if (large && !parameters_->isHidden()) showParameters(false);
  fitLive();
}

void WindowContents::showLog(bool open) {
  if (open) live_->hide();
  log_->setVisible(open);
  fitLive();
}

/// Open only where the page leaves room for it, and the log doesn't take it.
void WindowContents::fitLive() {
  const bool open = liveOpen_ && log_->isHidden() && pages_[static_cast<size_t>(stack_->currentIndex())]->wantsLive();
  const bool large = open && liveLarge_;
  const int height_px = live_->openHeight_px();
  live_->setMinimumHeight(height_px);
  live_->setMaximumHeight(large ? QWIDGETSIZE_MAX : height_px);
  if (large == room_->isVisibleTo(this)) {
    room_->setVisible(!large);
    below_->setStretch(0, large ? 0 : 1);  // an empty row takes its share, too
    below_->setStretchFactor(live_, large ? 1 : 0);
  }
  live_->setVisible(open);
}

/// Below the rail's rows, above what is at its foot.
void WindowContents::placeToast() {
  if (toast_ == nullptr) return;
  const QRect rail(rail_->mapTo(this, QPoint(0, 0)), rail_->size());
  toast_->keepIn(rail.adjusted(gap_px, rail_->rowsHeight_px() + gap_px, -gap_px, -gap_px));
}

bool WindowContents::eventFilter(QObject* watched, QEvent* event) {
  if (watched == rail_ && event->type() == QEvent::Resize) placeToast();
  if (watched == left_ && (event->type() == QEvent::EnabledChange || event->type() == QEvent::Show) && hasFocus() &&
      left_->isEnabled() && left_->isVisible())
    left_->setFocus(Qt::OtherFocusReason);
  return QWidget::eventFilter(watched, event);
}

bool WindowContents::focusNextPrevChild(bool next) {
  if (isHidden()) return QWidget::focusNextPrevChild(next);  // all of it goes: the window must not remember it
  QWidget* now = window()->focusWidget();
  if (now != nullptr && now != this && isAncestorOf(now) && (!now->isEnabled() || !now->isVisible())) {
    if (left_ != nullptr) left_->removeEventFilter(this);
    left_ = now;
    left_->installEventFilter(this);
    setFocus(Qt::OtherFocusReason);
    return true;
  }
  if (hasFocus() && left_ != nullptr) {
    const auto takes = [this](const QWidget* one) {
      return one->isEnabled() && one->isVisible() && (one->focusPolicy() & Qt::TabFocus) != 0 && isAncestorOf(one) &&
             one->focusProxy() == nullptr;
    };
    const auto follow = [next](QWidget* one) { return next ? one->nextInFocusChain() : one->previousInFocusChain(); };
    for (QWidget* one = follow(left_); one != left_; one = follow(one)) {
      if (!takes(one)) continue;
      one->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
      return true;
    }
  }
  return QWidget::focusNextPrevChild(next);
}

void WindowContents::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  parameters_->fitIn(width());
  fitLive();
}

}  // namespace breakaway
