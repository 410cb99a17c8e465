#include "widgets/residual_plots.h"

#include <qcustomplot.h>

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "session/comparison.h"
#include "widgets/controls.h"
#include "widgets/degree_ticker.h"
#include "widgets/look.h"
#include "widgets/residual_axis.h"
#include "widgets/seconds_ticker.h"
#include "widgets/true_minus.h"

namespace breakaway {

namespace {
constexpr size_t mostDots = 4000;
constexpr int mostName = 24;         // characters beside the title
constexpr int topMargin_px = 7;      // half of a tick's label
constexpr int measuredWidth_px = 3;  // of its line; more points than such widths can't be told apart
}  // namespace

ResidualPlots::ResidualPlots(Comparison& comparison, QWidget* parent) : QWidget(parent), comparison_(comparison) {
  setObjectName("residualPlots");
  auto* layout = columnIn(this);
  buildPlot();
  layout->addWidget(plot_);
  connect(&comparison_, &Comparison::inputsChanged, this, &ResidualPlots::showAll);
  connect(&comparison_, &Comparison::overviewChanged, this, &ResidualPlots::draw);
  connect(&comparison_, &Comparison::beneathChanged, this, &ResidualPlots::draw);
  connect(&comparison_, &Comparison::tracesChanged, this, &ResidualPlots::draw);
  applyLook();
  onNewLook(this, [this] { applyLook(); });
}

void ResidualPlots::buildPlot() {
  plot_ = new QCustomPlot(this);
  plot_->setObjectName("residualPlot");
  plot_->setAccessibleName(tr("Measurement over simulation, and the residual beneath"));
  plot_->setMinimumSize(200, 120);
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  // Line by line: the outline of a thick polyline of many points takes Qt's rasteriser time with their square.
  plot_->setPlottingHint(QCP::phFastPolylines);
  plot_->plotLayout()->clear();
  plot_->plotLayout()->setRowSpacing(2);
  above_ = new QCPAxisRect(plot_);
  below_ = new QCPAxisRect(plot_);
  addHead(0);
  plot_->plotLayout()->addElement(1, 0, above_);
  addHead(1);
  plot_->plotLayout()->addElement(3, 0, below_);
  auto* left = new QCPMarginGroup(plot_);
  for (QCPAxisRect* rect : {above_, below_}) {
    rect->setLayer("background");
    for (QCPAxis* axis : rect->axes()) axis->grid()->setLayer("grid");
    rect->setMarginGroup(QCP::msLeft, left);
    rect->setMinimumMargins(QMargins(44, topMargin_px, 10, 3));
    rect->setRangeDrag(Qt::Horizontal);
    rect->setRangeZoom(Qt::Horizontal);
    rect->axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
  }
  above_->axis(QCPAxis::atBottom)->setTicker(QSharedPointer<SecondsTicker>::create());
  measured_ = plot_->addGraph(above_->axis(QCPAxis::atBottom), above_->axis(QCPAxis::atLeft));
  simulated_ = plot_->addGraph(above_->axis(QCPAxis::atBottom), above_->axis(QCPAxis::atLeft));
  for (QCPGraph*& graph : residual_)
    graph = plot_->addGraph(below_->axis(QCPAxis::atBottom), below_->axis(QCPAxis::atLeft));
  beneath_ = plot_->addGraph(above_->axis(QCPAxis::atBottom), above_->axis(QCPAxis::atLeft));
  wander_ = new QCPItemRect(plot_);
  for (QCPItemPosition* position : wander_->positions()) {
    position->setAxes(below_->axis(QCPAxis::atBottom), below_->axis(QCPAxis::atLeft));
    position->setAxisRect(below_);
    position->setTypeX(QCPItemPosition::ptAxisRectRatio);
    position->setTypeY(QCPItemPosition::ptPlotCoords);
  }
  wander_->setClipAxisRect(below_);
  wander_->setPen(Qt::NoPen);
  wander_->setLayer("grid");
  const auto follow = [this](QCPAxis* from, QCPAxis* to) {
    connect(from, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, [this, to](const QCPRange& range) {
      if (axis_ == "time") to->setRange(range);
    });
  };
  follow(above_->axis(QCPAxis::atBottom), below_->axis(QCPAxis::atBottom));
  follow(below_->axis(QCPAxis::atBottom), above_->axis(QCPAxis::atBottom));
  connect(above_->axis(QCPAxis::atBottom), qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, [this] {
    drawMeasured();
    drawBeneath();
    emit visibleChanged();
  });
  const auto inset = [this](QCPAxisRect* rect, Qt::Alignment where) {
    auto* text = new QCPTextElement(plot_);
    text->setMargins(QMargins(3, 0, 3, 0));
    rect->insetLayout()->addElement(text, where);
    return text;
  };
  hint_ = inset(above_, Qt::AlignCenter);
  wanderName_ = inset(below_, Qt::AlignBottom | Qt::AlignRight);
}

/// Above a plot its title, and at the right what its two curves are.
void ResidualPlots::addHead(size_t plot) {
  auto* head = new QCPLayoutGrid;
  plot_->plotLayout()->addElement(static_cast<int>(2 * plot), 0, head);
  const auto words = [&](int column, Qt::Alignment side) {
    auto* text = new QCPTextElement(plot_);
    text->setTextFlags(static_cast<int>(side | Qt::AlignVCenter));
    text->setMargins(QMargins(8, 0, 8, 0));
    head->addElement(0, column, text);
    return text;
  };
  titles_[plot] = words(0, Qt::AlignLeft);
  for (size_t curve = 0; curve < 2; ++curve)
    names_[2 * plot + curve] = words(static_cast<int>(curve) + 1, Qt::AlignRight);
  head->setColumnStretchFactors({1.0, 1e-3, 1e-3});
}

std::pair<double, double> ResidualPlots::visible_s() const {
  const QCPRange range = above_->axis(QCPAxis::atBottom)->range();
  return {range.lower, range.upper};
}

void ResidualPlots::applyLook() {
  const Look& look = Look::of(palette());
  dress(*plot_, look);
  measured_->setPen(QPen(look.muted, measuredWidth_px));
  beneath_->setPen(QPen(look.curve(1), 1, Qt::DashLine));
  simulated_->setPen(QPen(look.curve(0), 1));
  residual_[0]->setPen(QPen(look.curve(1), 1));
  residual_[1]->setPen(QPen(look.curve(0), 1));
  wander_->setBrush(look.band(2));
  const std::array<QColor, 4> inks{look.muted, look.curve(0), look.curve(1), look.curve(0)};
  for (size_t k = 0; k < names_.size(); ++k) {
    names_[k]->setTextColor(inks[k]);
    names_[k]->setFont(typed(Type::caption, true));
  }
  for (QCPTextElement* title : titles_) {
    title->setTextColor(look.ink);
    title->setFont(typed(Type::caption));
  }
  hint_->setTextColor(look.muted);
  hint_->setFont(typed(Type::body));
  wanderName_->setTextColor(look.curve(2));
  wanderName_->setFont(typed(Type::caption, true));
  draw();
}

void ResidualPlots::setAxis(const QString& axis) {
  if (axis_ == axis) return;
  axis_ = axis;
  draw();
  showAllOf(*below_);
}

void ResidualPlots::showAll() {
  draw();
  showAllOf(*above_);
  showAllOf(*below_);
}

void ResidualPlots::showAllOf(QCPAxisRect& rect) {
  const auto& recording = comparison_.recording();
  if (!recording || recording->rows() < 2) return;
  if (&rect == above_ || axis_ == "time") {
    rect.axis(QCPAxis::atBottom)->setRange(recording->time().front(), recording->time().back());
  } else {
    rect.axis(QCPAxis::atBottom)->rescale();
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

QVariant ResidualPlots::kept() const {
  QVariantList parts{axis_};
  for (const QCPAxisRect* rect : {above_, below_})
    parts << rect->axis(QCPAxis::atBottom)->range().lower << rect->axis(QCPAxis::atBottom)->range().upper;
  return parts;
}

void ResidualPlots::take(const QVariant& kept) {
  const QVariantList parts = kept.toList();
  setAxis(parts.value(0).toString());
  above_->axis(QCPAxis::atBottom)->setRange(parts.value(1).toDouble(), parts.value(2).toDouble());
  below_->axis(QCPAxis::atBottom)->setRange(parts.value(3).toDouble(), parts.value(4).toDouble());
}

void ResidualPlots::draw() {
  for (QCPItemRect* band : bands_) plot_->removeItem(band);
  bands_.clear();
  for (QCPGraph* graph : {beneath_, measured_, simulated_, residual_[0], residual_[1]}) graph->data()->clear();
  wander_->setVisible(inTorque());
  const auto& recording = comparison_.recording();
  nameParts();
  if (recording) {
    drawMeasurement(*recording);
    if (inTorque()) {
      drawTorques(*recording);
    } else if (!comparison_.shownTrace().position.empty()) {
      drawResiduals(*recording);
    }
    drawBands();
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

bool ResidualPlots::inTorque() const {
  return comparison_.torque().has_value();
}

bool ResidualPlots::linear() const {
  const auto& recording = comparison_.recording();
  return recording && recording->has("position_m");
}

double ResidualPlots::scale() const {
  return shownAxis("angle", linear()).scale;
}

/// No axis stands there before there is something to draw on it.
void ResidualPlots::nameParts() {
  const bool diagnosed = !comparison_.shownTrace().position.empty();
  const ShownAxis shown = shownAxis(axis_, linear());
  const QString over = shown.label();
  below_->axis(QCPAxis::atBottom)
      ->setTicker(shown.unit == "°" ? QSharedPointer<QCPAxisTicker>(new RoundDegreeTicker)
                                    : QSharedPointer<QCPAxisTicker>(new PlainTicker));
  for (QCPAxisRect* rect : {above_, below_}) {
    const bool drawn = rect == above_ ? comparison_.recording().has_value() : diagnosed;
    for (QCPAxis* axis : {rect->axis(QCPAxis::atLeft), rect->axis(QCPAxis::atBottom)}) {
      axis->setVisible(drawn);
      axis->grid()->setVisible(drawn);
    }
  }
  // Heads are as high as their text; before a diagnosis the measurement has all the room.
  plot_->plotLayout()->setRowStretchFactors({1e-3, 1.0, 1e-3, diagnosed ? 1.25 : 1e-3});
  above_->axis(QCPAxis::atBottom)->setTickLabels(axis_ != "time" || !diagnosed);
  titles_[0]->setText(!comparison_.recording() ? QString() : linear() ? tr("Position (mm)") : tr("Angle (°)"));
  titles_[1]->setText(!diagnosed ? QString()
                      : inTorque()
                          ? (linear() ? tr("Force left (N) over %1") : tr("Torque left (mNm) over %1")).arg(over)
                          : (linear() ? tr("Residual (mm) over %1") : tr("Residual (°) over %1")).arg(over));
  const bool beneath = comparison_.beneath() && comparison_.beneath()->linear == linear();
  names_[0]->setText(!comparison_.recording() ? QString()
                     : beneath ? tr("measured; dashed: %1").arg(comparison_.beneath()->name.left(mostName))
                               : tr("measured"));
  names_[1]->setText(inTorque()  ? tr("this motion can't be foreseen: the torque counts")
                     : diagnosed ? tr("simulated with findings")
                                 : QString());
  wanderName_->setText(inTorque() ? tr("95 % of what a perfect model leaves") : QString());
  names_[2]->setText(diagnosed ? tr("base model") : QString());
  names_[3]->setText(diagnosed ? tr("with findings") : QString());
  hint_->setText(comparison_.recording() ? QString()
                                         : tr("Open or drop a recording and its bench file, or press Example"));
}

/// As many points as the picture is wide, however long the recording is.
void ResidualPlots::drawMeasured() {
  const auto& overview = comparison_.overview();
  if (!overview) return;
  const auto [from_s, to_s] = visible_s();
  QVector<QCPGraphData> points;
  for (const Overview::Point& point : overview->between(from_s, to_s, mostParts()))
    points.append(QCPGraphData(point.time_s, scale() * point.value));
  drawSmooth(*measured_, points);
}

/// What goes to and fro within every few pixels fills them, and smoothing its edges would only take time.
void ResidualPlots::drawSmooth(QCPGraph& graph, const QVector<QCPGraphData>& points) {
  qsizetype turns = 0;
  for (qsizetype k = 2; k < points.size(); ++k)
    if ((points[k].value - points[k - 1].value) * (points[k - 1].value - points[k - 2].value) < 0.0) ++turns;
  graph.setAntialiased(turns < static_cast<qsizetype>(mostParts()) / 2);
  graph.data()->set(points, true);
}

/// More than such widths of the measured line can't be told apart.
size_t ResidualPlots::mostParts() const {
  return static_cast<size_t>(std::max(200, above_->width() / measuredWidth_px));
}

/// Both begin to move at the same time and place: encoders count from anywhere, and nobody starts two recordings alike.
void ResidualPlots::drawBeneath() {
  const auto& beneath = comparison_.beneath();
  const auto& overview = comparison_.overview();
  if (!beneath || !overview || beneath->linear != linear()) return;
  const Overview::Point here = overview->begin(), there = beneath->overview->begin();
  const double later_s = here.time_s - there.time_s, higher = here.value - there.value;
  const auto [from_s, to_s] = visible_s();
  QVector<QCPGraphData> points;
  for (const Overview::Point& point : beneath->overview->between(from_s - later_s, to_s - later_s, mostParts()))
    points.append(QCPGraphData(point.time_s + later_s, scale() * (point.value + higher)));
  drawSmooth(*beneath_, points);
}

void ResidualPlots::drawMeasurement(const Recording& recording) {
  drawMeasured();
  drawBeneath();
  const auto time = recording.time();
  // Simulated motion that can't be foreseen runs away, and says nothing of the model.
  const auto& simulated = inTorque() ? std::vector<double>() : comparison_.shownTrace().position;
  QVector<QCPGraphData> points;
  points.reserve(static_cast<qsizetype>(simulated.size()));
  for (size_t row = 0; row < std::min(simulated.size(), time.size()); ++row)
    points.append(QCPGraphData(time[row], scale() * simulated[row]));
  drawSmooth(*simulated_, points);
  QCPRange range;
  if (const auto& overview = comparison_.overview())
    range = QCPRange(scale() * overview->range().first, scale() * overview->range().second);
  bool found = false;
  const QCPRange alsoSimulated = simulated_->getValueRange(found);
  if (found) range.expand(alsoSimulated);
  const QCPRange alsoBeneath = beneath_->getValueRange(found);
  if (found) range.expand(alsoBeneath);
  const double span = std::max(range.size(), 1e-9);
  above_->axis(QCPAxis::atLeft)->setRange(range.lower - 0.08 * span, range.upper + 0.08 * span);
}

void ResidualPlots::drawResiduals(const Recording& recording) {
  const auto abscissa = residualAxis(axis_, comparison_.diagnosis()->base, recording, comparison_.shownTrace());
  const auto measured = recording.channel(linear() ? "position_m" : "angle_rad");
  const double across = shownAxis(axis_, linear()).scale;
  const auto draw = [&](QCPGraph& graph, const std::vector<double>& position) {
    QVector<QCPGraphData> points;
    const size_t every = axis_ == "time" ? 1 : std::max<size_t>(1, position.size() / mostDots);
    for (size_t row = 0; row < std::min(position.size(), abscissa.size()); row += every) {
      points.append(QCPGraphData(across * abscissa[row], scale() * (position[row] - measured[row])));
    }
    drawPoints(graph, points);
  };
  draw(*residual_[0], comparison_.baseTrace().position);
  draw(*residual_[1], comparison_.shownTrace().position);
  scaleResiduals();
}

/// What each model leaves of the torque, over time or over the same axes along the motion that was measured.
void ResidualPlots::drawTorques(const Recording& recording) {
  const TorqueView& view = *comparison_.torque();
  const auto abscissa = residualAxis(axis_, comparison_.diagnosis()->base, recording, view.along);
  const double across = shownAxis(axis_, linear()).scale;
  const double shown = shownAxis("current", linear()).scale;
  const double begin_s = recording.time().front();
  const bool line = axis_ == "time";
  const auto draw = [&](QCPGraph& graph, const TorqueTrace& trace) {
    QVector<QCPGraphData> points;
    const size_t every = line ? 1 : std::max<size_t>(1, trace.torque.size() / mostDots);
    for (size_t k = 0; k < trace.torque.size(); k += every) {
      if (!line && trace.row[k] >= abscissa.size()) continue;
      points.append(
          QCPGraphData(line ? begin_s + trace.time_s[k] : across * abscissa[trace.row[k]], shown * trace.torque[k]));
    }
    drawPoints(graph, points);
  };
  draw(*residual_[0], view.base);
  draw(*residual_[1], view.shown);
  scaleResiduals();
  wander_->topLeft->setCoords(0.0, shown * normal95 * view.wander);
  wander_->bottomRight->setCoords(1.0, -shown * normal95 * view.wander);
}

void ResidualPlots::drawPoints(QCPGraph& graph, const QVector<QCPGraphData>& points) {
  const bool line = axis_ == "time";
  graph.setLineStyle(line ? QCPGraph::lsLine : QCPGraph::lsNone);
  graph.setScatterStyle(line ? QCPScatterStyle() : QCPScatterStyle(QCPScatterStyle::ssDisc, graph.pen().color(), 2));
  graph.setAntialiased(false);  // as many as there are rows
  graph.setAdaptiveSampling(line);
  graph.data()->set(points, line);
}

void ResidualPlots::scaleResiduals() {
  below_->axis(QCPAxis::atLeft)->rescale();
  below_->axis(QCPAxis::atLeft)->scaleRange(1.1);
}

void ResidualPlots::drawBands() {
  const auto& diagnosis = comparison_.diagnosis();
  if (!diagnosis) return;
  const Look& look = Look::of(palette());
  const auto add = [&](QCPAxisRect* rect, double from, double to, double top, const QColor& ink) {
    auto* band = new QCPItemRect(plot_);
    for (QCPItemPosition* position : band->positions()) {
      position->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
      position->setAxisRect(rect);
      position->setTypeX(QCPItemPosition::ptPlotCoords);
      position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    band->topLeft->setCoords(from, top);
    band->bottomRight->setCoords(to, 1.0);
    band->setClipAxisRect(rect);
    band->setPen(Qt::NoPen);
    band->setBrush(ink);
    band->setLayer("grid");  // over the background, under the curves
    bands_.push_back(band);
  };
  for (const Place& place : diagnosis->where) {
    if (QString::fromStdString(place.axis) != axis_) continue;
    const double across = shownAxis(axis_, linear()).scale;
    add(below_, across * place.from, across * place.to, 0.0, look.band(4));
    if (axis_ == "time") add(above_, place.from, place.to, 0.0, look.band(4));
  }
  QColor heldout = look.curve(2);
  heldout.setAlpha(120);
  const auto time = comparison_.recording()->time();
  for (const auto& [first, last] : diagnosis->heldoutRows)
    add(above_, time[first], time[std::min(last, time.size()) - 1], 0.955, heldout);
}

}  // namespace breakaway
