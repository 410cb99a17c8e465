#include "widgets/map_export.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>

#include "base/atomic_file.h"
#include "friction/breakaway_table.h"
#include "friction/map_export.h"
#include "session/messages.h"
#include "widgets/controls.h"
#include "widgets/map_panel.h"

namespace breakaway {

namespace {

struct ExportFormat {
  const char* name;  ///< of exportMap(), or of the page
  const char* title;
  const char* ending;
};

constexpr ExportFormat formats[] = {
    {"csv", QT_TRANSLATE_NOOP("breakaway::MapExport", "Map as CSV"), ".csv"},
    {"json", QT_TRANSLATE_NOOP("breakaway::MapExport", "Map as JSON"), ".json"},
    {"c-header", QT_TRANSLATE_NOOP("breakaway::MapExport", "Map as C header"), ".h"},
    {"mat", QT_TRANSLATE_NOOP("breakaway::MapExport", "Map as MATLAB file"), ".mat"},
    {"png", QT_TRANSLATE_NOOP("breakaway::MapExport", "Picture as PNG"), ".png"},
    {"svg", QT_TRANSLATE_NOOP("breakaway::MapExport", "Picture as SVG"), ".svg"},
    {"breakaways", QT_TRANSLATE_NOOP("breakaway::MapExport", "All breakaways as CSV"), ".csv"},
};

}  // namespace

MapExport::MapExport(Messages& messages, FileChooser& files, MapPanel& picture, QWidget* parent)
    : QWidget(parent), messages_(messages), files_(files), picture_(picture) {
  auto* row = rowIn(this);
  format_ = new QComboBox(this);
  format_->setObjectName("exportFormat");
  format_->setToolTip(tr("What is written, and as what"));
  format_->setAccessibleName(tr("Form of the export"));
  format_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  format_->setMinimumContentsLength(14);  // the column is as wide as every page's
  for (const ExportFormat& format : formats) format_->addItem(tr(format.title), QString(format.name));
  export_ = pushButton(this, "exportMapButton", tr("Export…"));
  row->addWidget(format_, 1);
  row->addWidget(export_);
  connect(format_, &QComboBox::currentIndexChanged, this, &MapExport::showExport);
  connect(export_, &QPushButton::clicked, this, &MapExport::exportChosen);
  showExport();
}

void MapExport::show(const Commission& known) {
  known_ = known;
  showExport();
}

void MapExport::showExport() {
  const QString format = format_->currentData().toString();
  const bool needsMap = format != "png" && format != "svg" && format != "breakaways";
  QString obstacle;
  if (needsMap && !known_.knows(Known::map)) obstacle = tr("There is no map yet: run the breakaway sweep to its end");
  const bool moving = known_.identity.axis == Axis::linear && known_.knows(Known::runs);
  const bool drawn = (moving || known_.knows(Known::map)) && format != "breakaways";
  const bool nothing = known_.breakaways.empty() && !drawn;
  if (!needsMap && nothing) obstacle = tr("Nothing was measured yet");
  setAvailable(export_, tr("Write the file"), obstacle);
}

void MapExport::exportChosen() {
  const ExportFormat& format = formats[format_->currentIndex()];
  const QString name = format.name;
  files_.ask(this,
             {tr("Export the friction map"), tr("%1 (*%2)").arg(tr(format.title), format.ending),
              QString("map") + format.ending, true},
             [this, name](const QString& path) { writeExport(name, path); });
}

void MapExport::writeExport(const QString& format, const QString& path) {
  Result<void> written;
  if (format == "png" || format == "svg") {
    if (!picture_.savePicture(path, format == "svg")) written = Error{path.toStdString(), "cannot be written"};
  } else if (format == "breakaways") {
    written = writeFile(path.toStdString(), breakawayTable(known_.breakaways, known_.identity.axis));
  } else if (known_.knows(Known::map)) {
    written = exportMap(known_.map, format.toStdString(), path.toStdString());
  }
  messages_.say(written, tr("Written: %1").arg(path));
}

}  // namespace breakaway
