#include "widgets/rival_bars.h"

#include <QPainter>
#include <algorithm>

#include "session/language.h"
#include "widgets/look.h"
#include "widgets/number_text.h"
#include "widgets/parameter_words.h"

namespace breakaway {

namespace {

constexpr int rowStep_px = 20, barHeight_px = 10, nameWidth_px = 132, gap_px = 6, leastBar_px = 40;
constexpr double whisker_px = 3.0;

QColor rivalColour(ErrorBar::Of of, bool alike, const Look& look) {
  switch (of) {
    case ErrorBar::Of::base:
      return look.curve(1);
    case ErrorBar::Of::found:
      return look.curve(0);
    case ErrorBar::Of::rival:
      return alike ? look.measured(0) : look.border;
    case ErrorBar::Of::floor:
      break;
  }
  return look.good;
}

}  // namespace

RivalBars::RivalBars(const Diagnosis& diagnosis, const Finding& finding, QWidget* parent) : QWidget(parent) {
  setObjectName("rivals_" + QString::fromStdString(finding.effect));
  setAccessibleName(tr("Error on unseen data, with others in the place of this finding"));
  QStringList lines;
  for (const ErrorBar& bar : rivalBars(diagnosis, finding)) {
    Row row{bar.of, inLanguage(bar.name), channelText(bar.error, diagnosis.fit.channel), bar.error, 0.0, 0.0};
    row.name.replace('_', ' ');
    if (!row.name.isEmpty()) row.name[0] = row.name[0].toUpper();
    QString line = tr("%1: %2").arg(row.name, row.value);
    if (bar.interval) {
      row.low95 = bar.interval->low;
      row.high95 = bar.interval->high;
      line += tr(" (%1 to %2)")
                  .arg(channelText(row.low95, diagnosis.fit.channel), channelText(row.high95, diagnosis.fit.channel));
    }
    if (const RivalScore* score = bar.rival) {
      row.alike = errsAlike(*score);
      line += row.alike ? tr(", which can't be told from the finding's")
                        : tr(", %1 to %2 times the finding's")
                              .arg(numberText(score->ratioLow95, 2), numberText(score->ratioHigh95, 2));
    }
    most_ = std::max({most_, row.error, row.high95});
    lines << line;
    rows_.push_back(std::move(row));
  }
  setToolTip(lines.join('\n'));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

int RivalBars::valueWidth() const {
  const QFontMetrics metrics(typed(Type::caption));
  int width = 0;
  for (const Row& row : rows_) width = std::max(width, metrics.horizontalAdvance(row.value));
  return width;
}

QSize RivalBars::sizeHint() const {
  return {nameWidth_px + 120 + valueWidth() + 2 * gap_px, rowStep_px * static_cast<int>(rows_.size())};
}

QSize RivalBars::minimumSizeHint() const {
  return {nameWidth_px + leastBar_px + valueWidth() + 2 * gap_px, sizeHint().height()};
}

void RivalBars::paintEvent(QPaintEvent*) {
  const Look& look = Look::of(palette());
  QPainter painter(this);
  const int values = valueWidth();
  const double left = nameWidth_px + gap_px, room = width() - left - values - gap_px;
  const auto at = [&](double error) { return left + room * error / std::max(most_, 1e-300); };
  for (size_t k = 0; k < rows_.size(); ++k) {
    const Row& row = rows_[k];
    const int y = rowStep_px * static_cast<int>(k);
    const double middle = y + 0.5 * rowStep_px;
    const bool floor = row.of == ErrorBar::Of::floor, found = row.of == ErrorBar::Of::found;
    painter.setFont(typed(Type::caption, found));
    painter.setPen(floor ? look.good : look.ink);
    painter.drawText(QRect(0, y, nameWidth_px, rowStep_px), Qt::AlignRight | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(row.name, Qt::ElideRight, nameWidth_px));
    painter.setFont(typed(Type::caption));
    painter.drawText(QRect(width() - values, y, values, rowStep_px), Qt::AlignRight | Qt::AlignVCenter, row.value);
    if (floor) continue;
    painter.fillRect(QRectF(left, middle - 0.5 * barHeight_px, std::max(1.0, at(row.error) - left), barHeight_px),
                     rivalColour(row.of, row.alike, look));
    if (!(row.high95 > row.low95)) continue;
    painter.setPen(QPen(look.ink, 1.2));
    painter.drawLine(QPointF(at(row.low95), middle), QPointF(at(row.high95), middle));
    for (const double end : {row.low95, row.high95})
      painter.drawLine(QPointF(at(end), middle - whisker_px), QPointF(at(end), middle + whisker_px));
  }
  const auto floor =
      std::find_if(rows_.begin(), rows_.end(), [](const Row& row) { return row.of == ErrorBar::Of::floor; });
  if (floor == rows_.end()) return;
  painter.setPen(QPen(look.good, 2));
  painter.drawLine(QPointF(at(floor->error), 0.0), QPointF(at(floor->error), height()));
}

}  // namespace breakaway
