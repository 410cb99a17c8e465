#include "widgets/map_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/look.h"
#include "widgets/map_views.h"
#include "widgets/polar_plot.h"
#include "widgets/travel_plot.h"

namespace breakaway {

namespace {

constexpr MapView views[] = {MapView::turns,   MapView::staticMean, MapView::coulomb,
                             MapView::viscous, MapView::total,      MapView::positionTorque};

}  // namespace

MapPanel::MapPanel(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* strip = new QHBoxLayout;
  view_ = new QComboBox(this);
  view_->setObjectName("polarView");
  view_->setAccessibleName(tr("What the map's plot shows"));
  for (const MapView view : views) view_->addItem(nameOf(view), static_cast<int>(view));
  fromZero_ = new QCheckBox(this);
  fromZero_->setObjectName("radiusFromZero");
  fromZero_->setChecked(true);
  quantity_ = new QLabel(this);
  quantity_->setObjectName("polarQuantity");
  strip->addWidget(view_);
  strip->addWidget(fromZero_);
  strip->addStretch(1);
  strip->addWidget(quantity_);
  column->addLayout(strip);
  plots_ = new QStackedWidget(this);
  plots_->addWidget(new PolarPlot("polarPlot", plots_));
  plots_->addWidget(new TravelPlot("travelPlot", plots_));
  column->addWidget(plots_, 1);
  legend_ = new QLabel(this);
  legend_->setObjectName("polarLegend");
  reading_ = new QLabel(this);
  reading_->setObjectName("polarReading");
  for (QLabel* line : {legend_, reading_}) {
    line->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    column->addWidget(line);
  }
  connect(view_, &QComboBox::currentIndexChanged, this, [this] {
    chosen_ = true;
    showMap();
  });
  for (int k = 0; k < plots_->count(); ++k) {
    auto* one = static_cast<MapPlot*>(plots_->widget(k));
    connect(fromZero_, &QCheckBox::toggled, one, &MapPlot::setFromZero);
    connect(one, &MapPlot::reading, reading_, &QLabel::setText);
  }
}

MapPlot& MapPanel::plot() const {
  return *static_cast<MapPlot*>(plots_->currentWidget());
}

void MapPanel::show(const Commission& known) {
  known_ = known;
  const bool linear = known.identity.axis == Axis::linear;
  plots_->setCurrentIndex(linear ? 1 : 0);
  static_cast<TravelPlot*>(plots_->widget(1))->setTravel(known.travel);
  fromZero_->setText(linear ? tr("Scale from zero") : tr("Radius from zero"));
  fromZero_->setToolTip(linear
                            ? tr("Off: the scale begins below the least value, so that variation is easier to see")
                            : tr("Off: the radius begins below the least value, so that variation is easier to see"));
  showViews();
  showMap();
}

/// A view that somebody chose stays; otherwise the first one that has something to show.
void MapPanel::showViews() {
  const QSignalBlocker ours(view_);
  const auto* items = qobject_cast<QStandardItemModel*>(view_->model());
  if (!obstacleTo(views[view_->currentIndex()], known_).isEmpty()) chosen_ = false;
  int first = -1;
  for (int k = 0; k < view_->count(); ++k) {
    const QString obstacle = obstacleTo(views[k], known_);
    view_->setItemText(k, nameOf(views[k], known_.identity.axis));
    items->item(k)->setEnabled(obstacle.isEmpty());
    items->item(k)->setToolTip(obstacle);
    if (first < 0 && obstacle.isEmpty()) first = k;
  }
  if (!chosen_) view_->setCurrentIndex(std::max(first, 0));
}

void MapPanel::showMap() {
  const MapPicture picture = pictureOf(views[view_->currentIndex()], known_);
  plot().show(picture.curves, picture.quantity, picture.unit);
  quantity_->setText(known_.identity.axis == Axis::linear ? QString() : tr("Radius: %1").arg(picture.quantity));
  reading_->setText(picture.curves.empty() ? QString()
                                           : tr("Point at the plot, or use its arrow keys, to read a value"));
  showLegend();
}

void MapPanel::showLegend() {
  const Look look = Look::of(palette());
  QStringList parts;
  bool outliers = false, bands = false;
  for (const MapCurve& curve : plot().curves()) {
    parts << QString("<span style='color:%1; font-weight:bold'>%2</span> %3")
                 .arg(look.curve(curve.colour).name(), curve.dashed ? "╌╌" : "──", curve.name.toHtmlEscaped());
    for (const MapPoint& point : curve.points) {
      outliers = outliers || point.outlier;
      bands = bands || point.standardError > 0.0;
    }
  }
  if (bands && known_.identity.axis == Axis::linear) parts << tr("band: 95 % interval");
  if (outliers)
    parts << QString("<span style='color:%1; font-weight:bold'>✕</span> %2").arg(look.trouble.name(), tr("outlier"));
  legend_->setText(parts.isEmpty() ? tr("Nothing measured yet: home, then run a sweep") : parts.join(" &nbsp; "));
}

bool MapPanel::savePicture(const QString& path, bool svg) {
  return svg ? plot().saveSvg(path) : plot().savePng(path);
}

void MapPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (legend_ != nullptr && event->type() == QEvent::PaletteChange) showLegend();
}

}  // namespace breakaway
