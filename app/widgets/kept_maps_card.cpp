#include "widgets/kept_maps_card.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <tuple>

#include "session/shown_maps.h"
#include "widgets/controls.h"
#include "widgets/elided_label.h"
#include "widgets/run_words.h"

namespace breakaway {

namespace {
constexpr int buttonWidth = 116;
}

KeptMapsCard::KeptMapsCard(ShownMaps& maps, QWidget* parent) : QFrame(parent), maps_(maps) {
  setProperty("role", "card");
  auto* column = columnIn(this, 8, {16, 12, 16, 12});
  column->addWidget(section(this, tr("Maps")));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
  const auto row = [&](const QString& title, const char* label, const char* name, const QString& text) {
    const int at = grid->rowCount();
    grid->addWidget(caption(this, title), at, 0);
    auto* which = new ElidedLabel(label, this);
    grid->addWidget(which, at, 1);
    auto* button = pushButton(this, name, text);
    button->setFixedWidth(buttonWidth);
    grid->addWidget(button, at, 2);
    return std::pair(which, button);
  };
  std::tie(opened_, today_) = row(tr("Shown"), "shownMap", "todaysMapButton", tr("Today's"));
  std::tie(earlier_, away_) = row(tr("Beneath"), "mapBeneath", "takeMapAwayButton", tr("Take away"));
  column->addLayout(grid);
  auto* choose = pushButton(this, "chooseMapButton", tr("Choose in Runs…"),
                            tr("A map of the project is opened or laid beneath there"));
  column->addWidget(choose);
  connect(today_, &QPushButton::clicked, this, [this] { maps_.open({}); });
  connect(away_, &QPushButton::clicked, this, [this] { maps_.layBeneath({}); });
  connect(choose, &QPushButton::clicked, this, &KeptMapsCard::runsAsked);
  connect(&maps_, &ShownMaps::changed, this, &KeptMapsCard::showMaps);
  showMaps();
}

void KeptMapsCard::showMaps() {
  const auto name = [](const std::optional<KeptMap>& map, const QString& none) {
    if (!map) return none;
    return map->run.name.empty() ? timeInWords(map->run) : QString::fromStdString(map->run.name);
  };
  opened_->setText(name(maps_.opened(), tr("today's")));
  earlier_->setText(name(maps_.earlier(), tr("none")));
  setAvailable(today_, maps_.opened().has_value(), tr("Shows what is measured at this bench again"),
               tr("It is what is shown"));
  setAvailable(away_, maps_.earlier().has_value(), tr("Takes the earlier map away"), tr("No map lies beneath"));
}

}  // namespace breakaway
