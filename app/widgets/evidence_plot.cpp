#include "widgets/evidence_plot.h"

#include <qcustomplot.h>

#include <QMouseEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/numbers.h"
#include "session/comparison.h"
#include "widgets/controls.h"
#include "widgets/degree_ticker.h"
#include "widgets/findings_list.h"
#include "widgets/look.h"
#include "widgets/number_text.h"
#include "widgets/residual_axis.h"
#include "widgets/true_minus.h"

namespace breakaway {

namespace {

constexpr int textGap_px = 24;        // at both sides of a text in the head, and between two
constexpr double nearSpacings = 2.5;  // of the middle one, between cells that a line joins
constexpr double barWidth_px = 6.0, lawWidth_px = 1.8, dot_px = 6.0;

}  // namespace

bool leadsOn(const ResidualMap& map, size_t cell) {
  if (cell + 1 >= map.centre.size() || !std::isfinite(map.mean[cell]) || !std::isfinite(map.mean[cell + 1]))
    return false;
  std::vector<double> spacings;
  for (size_t k = 1; k < map.centre.size(); ++k) spacings.push_back(map.centre[k] - map.centre[k - 1]);
  const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return map.centre[cell + 1] - map.centre[cell] <= nearSpacings * *middle;
}

EvidencePlot::EvidencePlot(Comparison& comparison, QWidget* parent)
    : QWidget(parent), comparison_(comparison), plot_(new QCustomPlot(this)) {
  setObjectName("evidencePlot");
  columnIn(this)->addWidget(plot_);
  plot_->setAccessibleName(tr("Residual torque over the finding's axis, before and after"));
  plot_->setMinimumSize(200, 90);
  plot_->setMouseTracking(true);
  plot_->plotLayout()->insertRow(0);
  plot_->plotLayout()->setRowSpacing(0);
  auto* head = new QCPLayoutGrid;
  plot_->plotLayout()->addElement(0, 0, head);
  const auto words = [this, head](int column, Qt::Alignment side) {
    auto* text = new QCPTextElement(plot_);
    text->setTextFlags(static_cast<int>(side | Qt::AlignVCenter));
    text->setMargins(QMargins(8, 0, 8, 0));
    head->addElement(0, column, text);
    return text;
  };
  title_ = words(0, Qt::AlignLeft);
  names_ = {words(1, Qt::AlignRight), words(2, Qt::AlignRight), words(3, Qt::AlignRight)};
  head->setColumnStretchFactors({1.0, 1e-3, 1e-3, 1e-3});
  plot_->plotLayout()->setRowStretchFactors({1e-3, 1.0});
  plot_->axisRect()->setMinimumMargins(QMargins(44, 7, 10, 3));
  plot_->yAxis->ticker()->setTickCount(4);
  hint_ = new QCPTextElement(plot_);
  plot_->axisRect()->insetLayout()->addElement(hint_, Qt::AlignCenter);
  plot_->installEventFilter(this);
  connect(&comparison_, &Comparison::evidenceChanged, this, &EvidencePlot::draw);
  connect(&comparison_, &Comparison::diagnosisChanged, this, &EvidencePlot::draw);
  onNewLook(this, [this] { draw(); });
  draw();
}

void EvidencePlot::draw() {
  const Look& look = Look::of(palette());
  dress(*plot_, look);
  plot_->clearPlottables();
  plot_->clearItems();
  const Evidence* evidence = comparison_.evidence();
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setVisible(evidence != nullptr);
    axis->grid()->setVisible(evidence != nullptr);
  }
  hint_->setVisible(evidence == nullptr);
  hint_->setFont(typed(Type::body));
  hint_->setTextColor(look.muted);
  hint_->setText(!comparison_.diagnosis()
                     ? tr("The residual torque over the finding's own axis comes with the diagnosis")
                 : comparison_.evidenceIsComing() ? tr("What unseen data show is being worked out")
                                                  : tr("No place stands out on unseen data"));
  title_->setTextColor(look.ink);
  title_->setFont(typed(Type::caption));
  title_->setVisible(evidence != nullptr);
  const bool law = evidence != nullptr && !evidence->law.at.empty();
  const std::array<QString, 3> names{tr("base model"), law ? tr("— its law") : QString(), tr("with findings")};
  for (size_t k = 0; k < names_.size(); ++k) {
    names_[k]->setText(names[k]);
    names_[k]->setTextColor(look.curve(k == 2 ? 0 : 1));
    names_[k]->setFont(typed(Type::caption, k != 1));
    names_[k]->setVisible(evidence != nullptr && !names[k].isEmpty());
  }
  if (evidence != nullptr) {
    const ShownAxis axis = shownAxis(evidence->axis, evidence->linear);
    showTitle();
    plot_->xAxis->setTicker(axis.unit == "°" ? QSharedPointer<QCPAxisTicker>(new RoundDegreeTicker)
                                             : QSharedPointer<QCPAxisTicker>(new PlainTicker));
    drawMap(evidence->before, 1);
    drawMap(evidence->after, 0);
    drawLaw();
    plot_->xAxis->rescale();
    plot_->xAxis->scaleRange(1.04);  // the outermost bins stand free of the edge
    plot_->yAxis->rescale();
    plot_->yAxis->scaleRange(1.15);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

/// With the finding's name where there is room for it.
void EvidencePlot::showTitle() {
  const Evidence* evidence = comparison_.evidence();
  if (evidence == nullptr) return;
  const QString title = (evidence->linear ? tr("Residual force (N) over %1, unseen, bands 95 %")
                                          : tr("Residual torque (mNm) over %1, unseen, bands 95 %"))
                            .arg(shownAxis(evidence->axis, evidence->linear).label());
  const QString whole = evidence->effect.empty() ? title : effectTitle(evidence->effect) + ": " + title;
  int room_px = width();
  for (QCPTextElement* name : names_)
    if (name->visible()) room_px -= QFontMetrics(name->font()).horizontalAdvance(name->text()) + textGap_px;
  const bool fits = QFontMetrics(title_->font()).horizontalAdvance(whole) + textGap_px <= room_px;
  title_->setText(fits ? whole : title);
}

void EvidencePlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showTitle();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

/// The law of the findings, as a line through what the base model leaves.
void EvidencePlot::drawLaw() {
  const auto& evidence = *comparison_.evidence();
  const double x = shownAxis(evidence.axis, evidence.linear).scale, y = evidence.linear ? 1.0 : 1e3;
  QCPGraph* line = plot_->addGraph();
  line->setName("law");
  for (size_t k = 0; k < evidence.law.at.size(); ++k) line->addData(x * evidence.law.at[k], y * evidence.law.value[k]);
  line->setPen(QPen(Look::of(palette()).curve(1), lawWidth_px));
}

void EvidencePlot::drawMap(const ResidualMap& map, int colour) {
  const Look& look = Look::of(palette());
  const auto& evidence = *comparison_.evidence();
  const double x = shownAxis(evidence.axis, evidence.linear).scale, y = evidence.linear ? 1.0 : 1e3;
  QCPGraph *low = plot_->addGraph(), *high = plot_->addGraph();  // unseen: the band's edges
  QCPGraph* alone = plot_->addGraph();                           // unseen: what stands without a neighbour
  auto* bars = new QCPErrorBars(plot_->xAxis, plot_->yAxis);
  QCPGraph* means = plot_->addGraph();
  bars->setDataPlottable(alone);
  const auto band = [&](double at, double mean, double half) {
    low->addData(at, mean - half);
    high->addData(at, mean + half);
  };
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  bool joined = false;  // to the cell before
  for (size_t k = 0; k < map.centre.size(); ++k) {
    if (!std::isfinite(map.mean[k])) continue;
    const double at = x * map.centre[k], mean = y * map.mean[k];
    const double half = std::isfinite(map.error[k]) ? y * normal95 * map.error[k] : 0.0;
    const bool leads = leadsOn(map, k);
    means->addData(at, mean);
    if (joined || leads) {
      band(at, mean, half);
    } else {
      alone->addData(at, mean);
      bars->addData(half);
    }
    if (!leads) {
      band(at, none, none);
      means->addData(at, none);
    }
    joined = leads;
  }
  for (QCPGraph* edge : {low, high, alone}) edge->setPen(Qt::NoPen);
  high->setBrush(look.band(colour));
  high->setChannelFillGraph(low);
  bars->setPen(QPen(look.measured(colour), barWidth_px, Qt::SolidLine, Qt::FlatCap));
  bars->setWhiskerWidth(0.0);
  bars->setSymbolGap(0.0);
  // The law goes through the first ones, where there is one; the second ones are what is left.
  const bool line = colour == 0 || comparison_.evidence()->law.at.empty();
  means->setLineStyle(line ? QCPGraph::lsLine : QCPGraph::lsNone);
  means->setPen(QPen(look.curve(colour), 1.2));
  means->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, look.curve(colour), dot_px));
}

void EvidencePlot::read(double at) {
  const auto& evidence = *comparison_.evidence();
  const ShownAxis axis = shownAxis(evidence.axis, evidence.linear);
  const double y = evidence.linear ? 1.0 : 1e3;
  const auto near = [&](const ResidualMap& map) {
    size_t best = 0;
    for (size_t k = 0; k < map.centre.size(); ++k)
      if (std::abs(axis.scale * map.centre[k] - at) < std::abs(axis.scale * map.centre[best] - at)) best = k;
    return best;
  };
  if (evidence.before.centre.empty() || evidence.after.centre.empty()) return;
  const auto value = [&](const ResidualMap& map, size_t k) {
    return std::isfinite(map.mean[k]) ? estimateText({map.mean[k], map.error[k]}, y, evidence.linear ? "N" : "mNm")
                                      : tr("too little data");
  };
  const size_t before = near(evidence.before), after = near(evidence.after);
  emit reading(tr("%1 %2    before %3    after %4")
                   .arg(numberText(axis.scale * evidence.before.centre[before]), axis.unit,
                        value(evidence.before, before), value(evidence.after, after)));
}

bool EvidencePlot::eventFilter(QObject* watched, QEvent* event) {
  if (watched == plot_ && event->type() == QEvent::MouseMove && comparison_.evidence())
    read(plot_->xAxis->pixelToCoord(static_cast<QMouseEvent*>(event)->position().x()));
  return QWidget::eventFilter(watched, event);
}

}  // namespace breakaway
