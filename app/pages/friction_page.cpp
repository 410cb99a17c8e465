#include "pages/friction_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <cmath>

#include "base/atomic_file.h"
#include "friction/map_export.h"
#include "polar_views.h"
#include "session.h"
#include "widgets/controls.h"
#include "widgets/facts_table.h"
#include "widgets/look.h"
#include "widgets/polar_plot.h"
#include "widgets/run_panel.h"

namespace breakaway {

namespace {

constexpr PolarView views[] = {PolarView::turns,   PolarView::staticMean, PolarView::coulomb,
                               PolarView::viscous, PolarView::total,      PolarView::positionTorque};

struct ExportFormat {
  const char* name;  ///< of exportMap(), or of the page
  const char* title;
  const char* ending;
};

constexpr ExportFormat formats[] = {
    {"csv", QT_TRANSLATE_NOOP("FrictionPage", "Map as CSV"), ".csv"},
    {"json", QT_TRANSLATE_NOOP("FrictionPage", "Map as JSON"), ".json"},
    {"c-header", QT_TRANSLATE_NOOP("FrictionPage", "Map as C header"), ".h"},
    {"mat", QT_TRANSLATE_NOOP("FrictionPage", "Map as MATLAB file"), ".mat"},
    {"png", QT_TRANSLATE_NOOP("FrictionPage", "Picture as PNG"), ".png"},
    {"svg", QT_TRANSLATE_NOOP("FrictionPage", "Picture as SVG"), ".svg"},
    {"breakaways", QT_TRANSLATE_NOOP("FrictionPage", "All breakaways as CSV"), ".csv"},
};

QString withInterval(const std::optional<Estimate>& estimate, double scale, const QString& unit) {
  if (!estimate) return FrictionPage::tr("not measured");
  return FrictionPage::tr("%1 ± %2 %3")
      .arg(scale * estimate->value, 0, 'f', 2)
      .arg(1.96 * scale * estimate->standardError, 0, 'f', 2)
      .arg(unit);
}

QSpinBox* countBox(QWidget* parent, const char* objectName, const QString& name, int least, int most, int value) {
  auto* box = new QSpinBox(parent);
  box->setObjectName(objectName);
  box->setAccessibleName(name);
  box->setRange(least, most);
  box->setValue(value);
  box->setAlignment(Qt::AlignRight);
  return box;
}

QDoubleSpinBox* numberBox(QWidget* parent, const char* objectName, const QString& name, double least, double most,
                          double value, const QString& suffix) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(objectName);
  box->setAccessibleName(name);
  box->setRange(least, most);
  box->setDecimals(1);
  box->setValue(value);
  box->setSuffix(suffix);
  box->setAlignment(Qt::AlignRight);
  return box;
}

}  // namespace

FrictionPage::FrictionPage(Session& session, FileChooser& files, QWidget* parent)
    : Page("frictionPage", tr("Friction"), "friction", parent), session_(session), files_(files) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 10, 16, 6);
  row->setSpacing(20);
  row->addWidget(buildControls());
  row->addWidget(buildMap(), 1);
  connect(&session_, &Session::connectionChanged, this, &FrictionPage::showConnection);
  connect(&session_, &Session::runChanged, this, &FrictionPage::showMotion);
  connect(&session_, &Session::measured, this, &FrictionPage::showMotion);
  connect(&session_, &Session::surveyChanged, this, &FrictionPage::showSurvey);
  showConnection();
  showSurvey();
}

QWidget* FrictionPage::buildControls() {
  auto* side = new QWidget(this);
  side->setFixedWidth(336);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(heading(side, tr("Friction around the rotor")));
  column->addWidget(buildVelocityGroup());
  column->addWidget(buildBreakawayGroup());
  run_ = new RunPanel("frictionRun", {RunKind::velocitySweep, RunKind::breakaway}, side);
  column->addWidget(run_);
  column->addWidget(rule(side));
  averages_ = new FactsTable("frictionAverages", side);
  column->addWidget(averages_);
  column->addStretch(1);
  column->addWidget(buildExport());
  return side;
}

QWidget* FrictionPage::buildVelocityGroup() {
  auto* group = new QWidget(this);
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  highest_ = numberBox(group, "highestSpeed", tr("Highest speed"), 1.0, 2000.0, 100.0, tr(" rad/s"));
  highest_->setToolTip(tr("Speeds lie between 6 % of it and it, in equal ratios, each both ways"));
  speeds_ = countBox(group, "speedCount", tr("Number of speeds"), 2, 12, 4);
  speeds_->setSuffix(tr(" speeds"));
  duration_ = numberBox(group, "speedDuration", tr("Time at each speed"), 0.5, 120.0, 10.0, tr(" s"));
  duration_->setToolTip(tr("At least this long at each speed, and then on to the end of the turn"));
  row->addWidget(highest_, 3);
  row->addWidget(speeds_, 3);
  row->addWidget(duration_, 2);
  velocity_ = pushButton(group, "velocitySweepButton", tr("Run velocity sweep"));
  column->addWidget(caption(group, tr("Constant speeds up to")));
  column->addLayout(row);
  column->addWidget(velocity_);
  connect(velocity_, &QPushButton::clicked, this, [this] {
    session_.sweepVelocity(highest_->value(), static_cast<size_t>(speeds_->value()), duration_->value());
  });
  return group;
}

QWidget* FrictionPage::buildBreakawayGroup() {
  auto* group = new QWidget(this);
  auto* column = new QVBoxLayout(group);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(4);
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  bins_ = countBox(group, "bins", tr("Angles per turn"), 8, 720, 90);
  bins_->setSuffix(tr(" angles"));
  bins_->setToolTip(tr("Breakaways per turn, evenly spaced"));
  turns_ = countBox(group, "turns", tr("Turns each way"), 1, 10, 2);
  turns_->setSuffix(tr(" turns each way"));
  row->addWidget(bins_, 1);
  row->addWidget(turns_, 1);
  breakaway_ = pushButton(group, "breakawaySweepButton", tr("Run breakaway sweep"));
  column->addWidget(caption(group, tr("Breakaway from standstill at")));
  column->addLayout(row);
  column->addWidget(breakaway_);
  connect(breakaway_, &QPushButton::clicked, this, [this] {
    session_.sweepBreakaway(static_cast<size_t>(bins_->value()), static_cast<size_t>(turns_->value()));
  });
  return group;
}

QWidget* FrictionPage::buildExport() {
  auto* group = new QWidget(this);
  auto* row = new QHBoxLayout(group);
  row->setContentsMargins(0, 0, 0, 0);
  format_ = new QComboBox(group);
  format_->setObjectName("exportFormat");
  format_->setAccessibleName(tr("Form of the export"));
  for (const ExportFormat& format : formats) format_->addItem(tr(format.title), QString(format.name));
  export_ = pushButton(group, "exportMapButton", tr("Export…"));
  row->addWidget(format_, 1);
  row->addWidget(export_);
  connect(format_, &QComboBox::currentIndexChanged, this, &FrictionPage::showExport);
  connect(export_, &QPushButton::clicked, this, &FrictionPage::exportChosen);
  return group;
}

QWidget* FrictionPage::buildMap() {
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* strip = new QHBoxLayout;
  view_ = new QComboBox(side);
  view_->setObjectName("polarView");
  view_->setAccessibleName(tr("What the polar plot shows"));
  for (const PolarView view : views) view_->addItem(nameOf(view), static_cast<int>(view));
  fromZero_ = new QCheckBox(tr("Radius from zero"), side);
  fromZero_->setObjectName("radiusFromZero");
  fromZero_->setChecked(true);
  fromZero_->setToolTip(tr("Off: the radius begins below the least value, so that variation is easier to see"));
  quantity_ = new QLabel(side);
  quantity_->setObjectName("polarQuantity");
  strip->addWidget(view_);
  strip->addWidget(fromZero_);
  strip->addStretch(1);
  strip->addWidget(quantity_);
  column->addLayout(strip);
  plot_ = new PolarPlot("polarPlot", side);
  column->addWidget(plot_, 1);
  legend_ = new QLabel(side);
  legend_->setObjectName("polarLegend");
  reading_ = new QLabel(side);
  reading_->setObjectName("polarReading");
  for (QLabel* line : {legend_, reading_}) {
    line->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    column->addWidget(line);
  }
  connect(view_, &QComboBox::currentIndexChanged, this, &FrictionPage::showMap);
  connect(fromZero_, &QCheckBox::toggled, plot_, &PolarPlot::setRadiusFromZero);
  connect(plot_, &PolarPlot::reading, reading_, &QLabel::setText);
  return side;
}

void FrictionPage::showConnection() {
  if (session_.connected()) highest_->setValue(session_.reachableSpeed_rad_per_s());
  showMotion();
}

void FrictionPage::showMotion() {
  run_->show(session_.run());
  const bool identified = session_.survey().identification.has_value();
  const QString first =
      identified ? QString()
                 : tr(" The motor is identified first: about a minute, standing and then turning both ways.");
  setAvailable(velocity_, tr("Turns at constant speeds, both ways, over whole turns.") + first,
               session_.sweepObstacle());
  setAvailable(breakaway_,
               tr("Steps around the rotor; at each angle the current rises slowly until the shaft moves.") + first,
               session_.sweepObstacle());
}

void FrictionPage::showSurvey() {
  const FrictionSurvey& survey = session_.survey();
  auto* items = qobject_cast<QStandardItemModel*>(view_->model());
  for (int k = 0; k < view_->count(); ++k) {
    const QString obstacle = obstacleTo(views[k], survey);
    items->item(k)->setEnabled(obstacle.isEmpty());
    items->item(k)->setToolTip(obstacle);
  }
  if (!obstacleTo(views[view_->currentIndex()], survey).isEmpty()) view_->setCurrentIndex(0);
  showAverages();
  showMap();
  showExport();
}

void FrictionPage::showAverages() {
  const FrictionSurvey& survey = session_.survey();
  std::vector<Fact> facts{
      {tr("Coulomb average"), withInterval(survey.coulombAverage_Nm(), 1e3, tr("mNm")),
       tr("Mean of both ways at zero speed, 95 % interval")},
      {tr("Viscous average"), withInterval(survey.viscousAverage_Nm_s_per_rad(), 1e6, tr("µNm s/rad")),
       tr("Slope with speed, 95 % interval")}};
  if (survey.map) {
    const auto mean = [&survey](Way way) {
      double sum_Nm = 0.0;
      for (const MapBin& bin : survey.map->bins) sum_Nm += bin.way[static_cast<size_t>(way)].static_Nm.value;
      return tr("%1 mNm").arg(1e3 * sum_Nm / static_cast<double>(survey.map->bins.size()), 0, 'f', 2);
    };
    facts.push_back({tr("Static, ccw mean"), mean(Way::ccw), {}});
    facts.push_back({tr("Static, cw mean"), mean(Way::cw), {}});
    const auto& repeat = survey.map->repeatability;
    if (survey.map->turns > 1) {
      facts.push_back({tr("Turns correlate"),
                       tr("ccw %1, cw %2").arg(repeat[1].correlation, 0, 'f', 3).arg(repeat[0].correlation, 0, 'f', 3),
                       tr("Turns differ by %1 (ccw) and %2 mNm rms (cw)")
                           .arg(1e3 * repeat[1].rmsDifference_Nm, 0, 'f', 3)
                           .arg(1e3 * repeat[0].rmsDifference_Nm, 0, 'f', 3)});
    }
  }
  averages_->show(facts);
}

void FrictionPage::showMap() {
  const PolarPicture picture = pictureOf(views[view_->currentIndex()], session_.survey());
  plot_->show(picture.curves, picture.quantity, picture.unit);
  quantity_->setText(tr("Radius: %1").arg(picture.quantity));
  reading_->setText(picture.curves.empty() ? QString()
                                           : tr("Point at the plot, or use its arrow keys, to read a value"));
  showLegend();
}

void FrictionPage::showLegend() {
  const Look look = Look::of(palette());
  QStringList parts;
  bool outliers = false;
  for (const PolarCurve& curve : plot_->curves()) {
    parts << QString("<span style='color:%1; font-weight:bold'>%2</span> %3")
                 .arg(look.curve(curve.colour).name(), curve.dashed ? "╌╌" : "──", curve.name.toHtmlEscaped());
    for (const PolarPoint& point : curve.points) outliers = outliers || point.outlier;
  }
  if (outliers)
    parts << QString("<span style='color:%1; font-weight:bold'>✕</span> %2").arg(look.trouble.name(), tr("outlier"));
  legend_->setText(parts.isEmpty() ? tr("Nothing measured yet: home, then run a sweep") : parts.join(" &nbsp; "));
}

void FrictionPage::showExport() {
  const FrictionSurvey& survey = session_.survey();
  const QString format = format_->currentData().toString();
  const bool needsMap = format != "png" && format != "svg" && format != "breakaways";
  QString obstacle;
  if (needsMap && !survey.map) obstacle = tr("There is no map yet: run the breakaway sweep to its end");
  if (!needsMap && survey.events.empty()) obstacle = tr("Nothing was measured yet");
  setAvailable(export_, tr("Write the file"), obstacle);
}

void FrictionPage::exportChosen() {
  const ExportFormat& format = formats[format_->currentIndex()];
  const QString name = format.name;
  files_.ask(this,
             {tr("Export the friction map"), tr("%1 (*%2)").arg(tr(format.title), format.ending),
              QString("map") + format.ending, true},
             [this, name](const QString& path) { writeExport(name, path); });
}

bool FrictionPage::writeExport(const QString& format, const QString& path) {
  Result<void> written;
  const FrictionSurvey& survey = session_.survey();
  if (format == "png" || format == "svg") {
    if (!(format == "png" ? plot_->savePng(path) : plot_->saveSvg(path)))
      written = Error{path.toStdString(), "cannot be written"};
  } else if (format == "breakaways") {
    written = writeFile(path.toStdString(), breakawayTable(survey.events));
  } else if (survey.map) {
    written = exportMap(*survey.map, format.toStdString(), path.toStdString());
  }
  session_.say(written ? tr("Written: %1").arg(path) : QString::fromStdString(written.error().message()),
               !written.ok());
  return written.ok();
}

void FrictionPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (legend_ != nullptr && event->type() == QEvent::PaletteChange) showLegend();
}

}  // namespace breakaway
