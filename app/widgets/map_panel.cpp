#include "widgets/map_panel.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "friction/static_average.h"
#include "widgets/axis_units.h"
#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/harmonics_plot.h"
#include "widgets/look.h"
#include "widgets/map_ghost.h"
#include "widgets/number_text.h"
#include "widgets/polar_plot.h"
#include "widgets/travel_plot.h"

namespace breakaway {

namespace {

struct ViewChip {
  MapView view;
  const char* name;
};

constexpr ViewChip views[] = {{MapView::turns, "viewTurns"},     {MapView::staticMean, "viewStatic"},
                              {MapView::coulomb, "viewCoulomb"}, {MapView::viscous, "viewViscous"},
                              {MapView::total, "viewTotal"},     {MapView::positionTorque, "viewPosition"}};

// Of what stands beside the circle.
constexpr int sideGap_px = 12, leastSide_px = 200, mostSide_px = 420, leastPolar = 232;
constexpr int chipGap_px = 4, wayGap_px = 12;

QFrame* plotCard(QWidget* parent) {
  auto* frame = card(parent);
  columnOf(frame)->setContentsMargins(12, 6, 6, 6);
  columnOf(frame)->setSpacing(2);
  return frame;
}

QLabel* legendIn(QWidget* parent, const char* objectName) {
  auto* legend = new QLabel(parent);
  legend->setObjectName(objectName);
  legend->setTextFormat(Qt::RichText);
  legend->setFont(typed(Type::caption));
  return legend;
}

/// Over the plot of a card, as long as there is nothing to draw: what brings it.
QLabel* hintOver(QFrame* frame, QWidget* plot, const char* objectName, const QString& words) {
  auto* place = new QGridLayout;
  auto* hint = explanation(frame, words, objectName);
  hint->setAlignment(Qt::AlignCenter);
  hint->setProperty("tone", "muted");
  hint->setTextInteractionFlags(Qt::NoTextInteraction);
  hint->setAttribute(Qt::WA_TransparentForMouseEvents);
  place->addWidget(plot, 0, 0);
  place->addWidget(hint, 0, 0);
  columnOf(frame)->addLayout(place, 1);
  return hint;
}

}  // namespace

MapPanel::MapPanel(QWidget* parent) : QWidget(parent) {
  auto* column = columnIn(this, 8);
  column->addWidget(buildChips());
  plots_ = new QStackedWidget(this);
  plots_->addWidget(buildRotor());
  auto* straight = plotCard(plots_);
  travelQuantity_ = new ElidedLabel("travelQuantity", straight);
  travel_ = new TravelPlot("travelPlot", TravelPlot::Places::travel, straight);
  travelLegend_ = legendIn(straight, "travelLegend");
  auto* head = new QHBoxLayout;
  head->addWidget(travelQuantity_, 1);
  head->addWidget(travelLegend_);
  columnOf(straight)->addLayout(head);
  columnOf(straight)->addWidget(travel_, 1);
  plots_->addWidget(straight);
  column->addWidget(plots_, 1);
  for (MapPlot* one : std::initializer_list<MapPlot*>{polar_, twin_, travel_}) {
    connect(fromZero_, &QPushButton::toggled, one, &MapPlot::setFromZero);
    connect(one, &MapPlot::reading, this, &MapPanel::reading);
  }
  onNewLook(this, [this] { showMap(); });
}

QWidget* MapPanel::buildChips() {
  auto* group = new QWidget(this);
  chips_ = new QBoxLayout(QBoxLayout::LeftToRight, group);
  chips_->setContentsMargins(0, 0, 0, 0);
  chips_->setSpacing(chipGap_px);
  auto *row = new QHBoxLayout, *under = new QHBoxLayout;
  for (QHBoxLayout* one : {row, under}) one->setSpacing(chipGap_px);
  chips_->addLayout(row);
  chips_->addLayout(under, 1);
  auto* kinds = new QButtonGroup(group);
  for (const ViewChip& one : views) {
    auto* chip = chipButton(group, one.name, shortNameOf(one.view), {});
    kinds->addButton(chip);
    views_.push_back(chip);
    row->addWidget(chip);
    connect(chip, &QPushButton::clicked, this, [this, view = one.view] {
      chosen_ = true;
      view_ = view;
      showMap();
    });
  }
  row->addStretch(1);
  wayGap_ = new QSpacerItem(wayGap_px, 1, QSizePolicy::Fixed, QSizePolicy::Minimum);
  under->addItem(wayGap_);
  for (const Way way : {Way::ccw, Way::cw}) {
    auto* chip = chipButton(group, way == Way::ccw ? "showCcw" : "showCw", {}, {});
    chip->setChecked(true);
    chip->setFixedWidth(56);
    ways_[way == Way::ccw ? 0 : 1] = chip;
    under->addWidget(chip);
    connect(chip, &QPushButton::toggled, this, &MapPanel::showMap);
  }
  under->addStretch(1);
  fromZero_ = chipButton(group, "radiusFromZero", tr("From zero"), {});
  fromZero_->setChecked(true);
  under->addWidget(fromZero_);
  return group;
}

/// In two rows where one has no room for all of them.
void MapPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const int whole_px = chips_->itemAt(0)->minimumSize().width() + chips_->itemAt(1)->minimumSize().width() + chipGap_px;
  const bool stacked = width() < whole_px + (chips_->direction() == QBoxLayout::TopToBottom ? wayGap_px : 0);
  if (stacked == (chips_->direction() == QBoxLayout::TopToBottom)) return;
  chips_->setDirection(stacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  wayGap_->changeSize(stacked ? 0 : wayGap_px, 1, QSizePolicy::Fixed, QSizePolicy::Minimum);
  chips_->itemAt(1)->layout()->invalidate();
}

QWidget* MapPanel::buildRotor() {
  auto* group = new QWidget(this);
  group->installEventFilter(this);
  auto* row = rowIn(group, sideGap_px);
  auto* around = plotCard(group);
  columnOf(around)->setContentsMargins(4, 4, 4, 4);
  columnOf(around)->setSpacing(0);
  // The words stand in the corners that a circle leaves free.
  auto* corners = new QGridLayout;
  polar_ = new PolarPlot("polarPlot", around);
  polar_->setMinimumSize(leastPolar, leastPolar);
  quantity_ = new ElidedLabel("polarQuantity", around);
  legend_ = legendIn(around, "polarLegend");
  legend_->setAlignment(Qt::AlignRight | Qt::AlignTop);
  quantity_->setContentsMargins(4, 0, 0, 0);
  legend_->setContentsMargins(0, 0, 4, 0);
  corners->addWidget(polar_, 0, 0, 1, 2);
  corners->addWidget(quantity_, 0, 0, Qt::AlignTop);
  corners->addWidget(legend_, 0, 1, Qt::AlignTop | Qt::AlignRight);
  ringLegend_ = legendIn(around, "ringLegend");
  ringLegend_->setContentsMargins(4, 0, 0, 4);
  corners->addWidget(ringLegend_, 0, 0, Qt::AlignBottom | Qt::AlignLeft);
  corners->setColumnStretch(0, 1);
  for (QWidget* words : std::initializer_list<QWidget*>{quantity_, legend_, ringLegend_})
    words->setAttribute(Qt::WA_TransparentForMouseEvents);
  columnOf(around)->addLayout(corners, 1);
  row->addWidget(around, 1);
  side_ = new QWidget(group);
  side_->setFixedWidth(leastSide_px);
  auto* column = columnIn(side_, sideGap_px);
  auto* twin = plotCard(side_);
  twinQuantity_ = new ElidedLabel("twinQuantity", twin);
  twin_ = new TravelPlot("twinPlot", TravelPlot::Places::turn, twin);
  columnOf(twin)->addWidget(twinQuantity_);
  twinHint_ = hintOver(twin, twin_, "twinHint",
                       tr("The same curves over the angle, from the first breakaways on: Run breakaway sweep"));
  auto* orders = plotCard(side_);
  harmonicsTitle_ = new ElidedLabel("harmonicsQuantity", orders);
  columnOf(orders)->addWidget(harmonicsTitle_);
  harmonics_ = new HarmonicsPlot(orders);
  harmonicsHint_ = hintOver(orders, harmonics_, "harmonicsHint",
                            tr("How often a turn the friction rises, as from poles or a shaft off its centre: comes "
                               "with the first whole turn"));
  column->addWidget(twin, 1);
  column->addWidget(orders, 1);
  row->addWidget(side_);
  return group;
}

/// The circle is as large as its place is high, as far as that leaves its neighbours their least width; these have the
/// rest.
bool MapPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && watched == plots_->widget(0)) {
    const QSize room = static_cast<QResizeEvent*>(event)->size();
    side_->setFixedWidth(std::clamp(room.width() - sideGap_px - room.height(), leastSide_px, mostSide_px));
  }
  return QWidget::eventFilter(watched, event);
}

MapPlot& MapPanel::plot() const {
  return plots_->currentIndex() == 0 ? static_cast<MapPlot&>(*polar_) : *travel_;
}

void MapPanel::show(const Commission& known) {
  known_ = known;
  const bool linear = known.identity.axis == Axis::linear;
  plots_->setCurrentIndex(linear ? 1 : 0);
  travel_->setTravel(known.travel);
  fromZero_->setToolTip(
      linear ? tr("Whether the scale begins at zero, or below the least value, so that variation is easier to see")
             : tr("Whether the radius begins at zero, or below the least value, so that variation is easier to see"));
  for (const Way way : {Way::ccw, Way::cw}) {
    QPushButton* chip = ways_[way == Way::ccw ? 0 : 1];
    chip->setText(shortWayName(way, known.identity.axis));
    chip->setAccessibleName(wayName(way, known.identity.axis));
    chip->setToolTip(tr("Whether the curves %1 are shown").arg(wayName(way, known.identity.axis)));
  }
  showViews();
  showMap();
}

/// A view that somebody chose stays; otherwise the first one that has something to show.
void MapPanel::showViews() {
  if (!obstacleTo(view_, known_).isEmpty()) chosen_ = false;
  bool found = chosen_;
  for (size_t k = 0; k < views_.size(); ++k) {
    const QString obstacle = obstacleTo(views[k].view, known_);
    setAvailable(views_[k], nameOf(views[k].view, known_.identity.axis), obstacle);
    if (found || !obstacle.isEmpty()) continue;
    found = true;
    view_ = views[k].view;
  }
  if (!found) view_ = MapView::turns;
}

void MapPanel::showMap() {
  for (size_t k = 0; k < views_.size(); ++k) views_[k]->setChecked(views[k].view == view_);
  MapPicture picture = pictureOf(view_, known_);
  if (earlier_ && earlier_->axis == known_.identity.axis)
    breakaway::layBeneath(*earlier_, known_.knows(Known::map) ? &known_.map : nullptr, view_, picture);
  const bool ofWays = view_ != MapView::positionTorque;
  if (ofWays)
    std::erase_if(picture.curves,
                  [this](const MapCurve& curve) { return curve.colour < 2 && !ways_[curve.colour]->isChecked(); });
  const bool linear = known_.identity.axis == Axis::linear;
  plot().show(picture.curves, picture.quantity, picture.unit);
  const QString quantity = picture.quantity.left(1).toUpper() + picture.quantity.mid(1);
  quantity_->setText(quantity);
  travelQuantity_->setText(picture.curves.empty() ? tr("Nothing measured yet")
                                                  : tr("%1 over the travel").arg(quantity));
  twinQuantity_->setText(tr("Over rotor angle (%1)").arg(picture.unit));
  harmonicsTitle_->setText(tr("Harmonics (%1)").arg(picture.unit));
  if (!linear) showBeside(picture);
  showFigure(picture);
  showLegend(picture.curves);
  showRingLegend(picture);
  emit reading(picture.curves.empty() ? known_.knows(Known::index) ? tr("The map grows here, breakaway by breakaway")
                                                                   : tr("A sweep homes first; then the map grows here")
                                      : tr("Point at the plot, or use its arrow keys, to read a value"));
}

void MapPanel::setUnderWay(bool underWay) {
  if (underWay_ == underWay) return;
  underWay_ = underWay;
  showMap();
}

/// The twin has no room for a ring, the harmonics are of what is shown.
void MapPanel::showBeside(const MapPicture& picture) {
  std::vector<MapCurve> curves = picture.curves;
  std::erase_if(curves, [](const MapCurve& curve) { return curve.lifted != 0.0; });
  twin_->show(curves, {}, picture.unit);
  std::erase_if(curves, [](const MapCurve& curve) { return curve.part != MapPart::shown; });
  harmonics_->show(curves);
  twinHint_->setVisible(twin_->curves().empty());
  harmonicsHint_->setVisible(harmonics_->isEmpty());
}

void MapPanel::layBeneath(const std::optional<FrictionMap>& earlier) {
  earlier_ = earlier;
  showMap();
}

/// Of the whole map and both ways, as the averages beside it have it; none of a view without one number.
std::optional<Estimate> MapPanel::average() const {
  const AxisUnits units = unitsOf(known_.identity.axis);
  const auto shown = [](const Estimate& one, double scale) {
    return Estimate{scale * one.value, scale * one.standardError};
  };
  if (!known_.knows(Known::map)) return {};
  switch (view_) {
    case MapView::turns:
    case MapView::staticMean:
      return shown(staticAverage_Nm(known_.map), units.torqueScale);
    case MapView::coulomb:
      return shown(known_.map.coulombAverage_Nm, units.torqueScale);
    case MapView::viscous:
      return shown(known_.map.viscousAverage_Nm_s_per_rad, units.viscousScale);
    case MapView::total:
    case MapView::positionTorque:
      break;
  }
  return {};
}

/// The one number of the page: the mean over the whole turn and both ways; while the map grows, of what there is.
void MapPanel::showFigure(const MapPicture& picture) {
  double sum = 0.0, errors = 0.0;
  size_t count = 0;
  std::array<bool, 2> has{};  // ccw, cw
  for (const MapCurve& curve : picture.curves) {
    if (curve.part != MapPart::shown) continue;
    if (curve.colour < 2 && !curve.points.empty()) has[curve.colour] = true;
    for (const MapPoint& point : curve.points) {
      if (point.outlier) continue;
      sum += point.value;
      errors += point.standardError;  // bins share theirs
      ++count;
    }
  }
  if (count == 0 || view_ == MapView::positionTorque) {
    const bool nothing = known_.breakaways.empty() && !known_.knows(Known::map);
    nothing&& underWay_ ? polar_->setFigure(tr("under way"), tr("–"),
                                            known_.knows(Known::index) ? tr("the map begins after the speeds")
                                                                       : tr("the map begins after homing"))
    : nothing ? polar_->setFigure(tr("nothing measured yet"), tr("–"), tr("Run breakaway sweep"))
                        : polar_->setFigure({}, {}, {});
    return;
  }
  const bool both = has[0] && has[1];
  const auto whole = both ? average() : std::nullopt;
  const auto points = static_cast<double>(count);
  const Estimate mean = whole.value_or(Estimate{sum / points, errors / points});
  const bool grows = std::any_of(picture.curves.begin(), picture.curves.end(),
                                 [](const MapCurve& curve) { return curve.part == MapPart::shown && !curve.closed; });
  const QString name = grows ? tr("mean so far") : both ? tr("mean, both ways") : tr("mean");
  if (!(mean.standardError > 0.0)) return polar_->setFigure(name, numberText(mean.value), picture.unit);
  // To the same place as in the averages.
  const QString text = estimateText(mean, 1.0, picture.unit);
  polar_->setFigure(name, text.section(' ', 0, 0), text.section(' ', 1));
}

void MapPanel::showLegend(const std::vector<MapCurve>& curves) {
  const Look& look = Look::of(palette());
  QStringList parts;
  const auto line = [&parts](const QColor& colour, bool dashed, const QString& name) {
    parts << QString("<span style='color:%1; font-weight:600'>%2 %3</span>")
                 .arg(colour.name(), dashed ? "╌" : "─", name.toHtmlEscaped());
  };
  bool outliers = false, earlier = false;
  const bool around = known_.identity.axis != Axis::linear;  // where the differences are a ring of cells
  for (const MapCurve& curve : curves) {
    if (curve.part == MapPart::noDifference || (around && curve.part == MapPart::difference)) continue;
    // Of the earlier map one line is enough: its curves have the colours of those above them.
    if (curve.part == MapPart::earlier && earlier) continue;
    earlier = earlier || curve.part == MapPart::earlier;
    curve.part == MapPart::earlier ? line(look.muted, true, tr("earlier"))
                                   : line(look.curve(curve.colour), curve.dashed, curve.name);
    outliers = outliers || std::any_of(curve.points.begin(), curve.points.end(),
                                       [](const MapPoint& point) { return point.outlier; });
  }
  if (outliers)
    parts << QString("<span style='color:%1; font-weight:600'>✕ %2</span>").arg(look.trouble.name(), tr("outlier"));
  legend_->setText(parts.join("<br>"));
  travelLegend_->setText(parts.join(" &nbsp; "));
}

/// Of the ring's two ends.
void MapPanel::showRingLegend(const MapPicture& picture) {
  const auto ring = std::find_if(picture.curves.begin(), picture.curves.end(),
                                 [](const MapCurve& curve) { return curve.part == MapPart::difference; });
  ringLegend_->setVisible(ring != picture.curves.end());
  if (ring == picture.curves.end()) return;
  double least = 0.0, most = 0.0;
  for (const MapPoint& point : ring->points) {
    if (!std::isfinite(point.value)) continue;
    least = std::min(least, point.value - ring->lifted);
    most = std::max(most, point.value - ring->lifted);
  }
  const Look& look = Look::of(palette());
  QStringList lines{ring->name.toHtmlEscaped()};
  for (const double by : {most, least}) {
    if (by == 0.0) continue;
    lines << QString("<span style='color:%1; font-weight:600'>■ %2%3 %4</span>")
                 .arg(ringInk(look, by, std::abs(by)).name(), by > 0.0 ? "+" : "−", numberText(std::abs(by), 2),
                      picture.unit);
  }
  ringLegend_->setText(lines.join("<br>"));
}

bool MapPanel::savePicture(const QString& path, bool svg) {
  return svg ? plot().saveSvg(path) : plot().savePng(path);
}

}  // namespace breakaway
