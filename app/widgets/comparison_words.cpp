#include "widgets/comparison_words.h"

#include <QCoreApplication>
#include <QStringList>

#include "session/language.h"
#include "widgets/axis_units.h"
#include "widgets/column_words.h"
#include "widgets/number_text.h"
#include "widgets/parameter_words.h"
#include "widgets/run_words.h"

namespace breakaway {

namespace {

QString comparisonText(const char* text) {
  return QCoreApplication::translate("ComparisonWords", text);
}

QString row(const QStringList& cells, bool bold) {
  QString line;
  for (const QString& cell : cells)
    line += QString("<td style='padding: 2px 16px 2px 0'>%1</td>")
                .arg(bold ? "<b>" + cell.toHtmlEscaped() + "</b>" : cell.toHtmlEscaped());
  return "<tr>" + line + "</tr>";
}

QString tableOf(const QStringList& heads, const QString& rows) {
  QString line;
  for (const QString& head : heads)
    line += "<th align='left' style='padding: 2px 16px 2px 0'>" + head.toHtmlEscaped() + "</th>";
  return rows.isEmpty() ? QString() : "<table><tr>" + line + "</tr>" + rows + "</table>";
}

QString valueText(const RunValue& value) {
  const ParameterWords words = wordsOf(Parameter{value.name, value.value, value.low, value.high});
  const QString with = QString("%1 %2").arg(words.value, words.unit).trimmed();
  return words.interval.isEmpty() ? with : QString("%1 (%2)").arg(with, words.interval);
}

QString percent(const ValueChange& change) {
  if (change.before.value == 0.0) return {};
  const double share = 100.0 * (change.after.value / change.before.value - 1.0);
  return QString("%1%2 %").arg(share < 0.0 ? "" : "+", numberText(share, 2));
}

QString valueRows(const RunComparison& comparison, bool beyond) {
  QString rows;
  for (const ValueChange& one : comparison.values) {
    if (one.beyond != beyond) continue;
    const QString name = wordsOf(Parameter{one.before.name, one.before.value, 0.0, 0.0}).name;
    rows += row({name, valueText(one.before), valueText(one.after), percent(one)}, beyond);
  }
  return rows;
}

QString mapRows(const RunComparison& comparison, bool beyond) {
  QString rows;
  for (const MapChange& one : comparison.maps) {
    if (one.isBeyond() != beyond) continue;
    const AxisUnits units = unitsOf(comparison.mapAfter->axis);
    const auto torque = [&](double value) {
      return QString("%1%2 %3").arg(value < 0.0 ? "" : "+", numberText(units.torqueScale * value), units.torque);
    };
    rows += row({inLanguage(one.quantity), torque(one.meanDifference),
                 "± " + numberText(units.torqueScale * one.meanHalfWidth, 2) + " " + units.torque,
                 comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "%1 of %2, by chance %3"))
                     .arg(one.beyond)
                     .arg(one.bins)
                     .arg(numberText(one.byChance, 2)),
                 torque(one.largest)},
                beyond);
  }
  return rows;
}

QString findings(const std::vector<std::string>& list, const char* form) {
  QString lines;
  for (const std::string& one : list)
    lines += "<p>" + comparisonText(form).arg(QString::fromStdString(one)).toHtmlEscaped() + "</p>";
  return lines;
}

QString part(const RunComparison& comparison, bool beyond) {
  return tableOf({comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Result")),
                  comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Before")),
                  comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "After")),
                  comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Change"))},
                 valueRows(comparison, beyond)) +
         tableOf({comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Map")),
                  comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Mean change")),
                  comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "95 %")),
                  comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Bins beyond")),
                  comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Largest"))},
                 mapRows(comparison, beyond));
}

QString channels(const RecordingComparison& recordings) {
  QString rows;
  const auto pair = [](double before, double after) {
    return QString("%1 → %2").arg(numberText(before, 3), numberText(after, 3));
  };
  for (const ChannelChange& one : recordings.channels) {
    const Column* column = columnNamed(one.channel);
    if (column == nullptr) continue;
    rows += row({QString("%1 (%2)").arg(wordsOf(*column), column->unit), pair(one.meanBefore, one.meanAfter),
                 pair(one.rmsBefore, one.rmsAfter), numberText(one.differenceRms, 3)},
                false);
  }
  return tableOf({comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Channel")),
                  comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Mean")),
                  comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Scatter")),
                  comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Difference (RMS)"))},
                 rows);
}

}  // namespace

QString titleOf(const RunComparison& comparison) {
  return QString("%1 → %2").arg(titleOf(comparison.before), titleOf(comparison.after));
}

QString pageOf(const RunComparison& comparison) {
  QString beyond = part(comparison, true);
  beyond += findings(comparison.findingsNew, QT_TRANSLATE_NOOP("ComparisonWords", "New: %1"));
  beyond += findings(comparison.findingsGone, QT_TRANSLATE_NOOP("ComparisonWords", "No longer found: %1"));
  const QString within = part(comparison, false);
  QString page;
  if (comparison.before.motor != comparison.after.motor)
    page += "<p>" + comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "The runs are of two motors.")) + "</p>";
  const auto heading = [](const QString& text) { return "<h3>" + text + "</h3>"; };
  if (comparison.recordings)
    return page +
           heading(comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Laid over each other from their beginnings"))) +
           "<p>" +
           comparisonText(
               QT_TRANSLATE_NOOP("ComparisonWords", "Over the %1 s that both last; the report has pictures."))
               .arg(numberText(comparison.recordings->length_s, 4)) +
           "</p>" + channels(*comparison.recordings);
  page +=
      beyond.isEmpty()
          ? heading(
                comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Nothing has changed beyond the 95 % intervals")))
          : heading(comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Changed beyond the 95 % intervals"))) + beyond;
  if (!within.isEmpty()) page += heading(comparisonText(QT_TRANSLATE_NOOP("ComparisonWords", "Within them"))) + within;
  return page;
}

}  // namespace breakaway
