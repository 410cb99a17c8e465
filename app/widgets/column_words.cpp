#include "widgets/column_words.h"

#include <QCoreApplication>

namespace breakaway {

namespace {

struct Called {
  const char* words;
  const char* linear;  ///< where it is another on a linear axis
};

Called calledAs(Quantity quantity) {
  switch (quantity) {
    case Quantity::time:
      return {QT_TRANSLATE_NOOP("ColumnWords", "time"), nullptr};
    case Quantity::position:
      return {QT_TRANSLATE_NOOP("ColumnWords", "angle"), QT_TRANSLATE_NOOP("ColumnWords", "position")};
    case Quantity::velocity:
      return {QT_TRANSLATE_NOOP("ColumnWords", "speed"), QT_TRANSLATE_NOOP("ColumnWords", "linear speed")};
    case Quantity::voltage:
      return {QT_TRANSLATE_NOOP("ColumnWords", "motor voltage"), nullptr};
    case Quantity::duty:
      return {QT_TRANSLATE_NOOP("ColumnWords", "duty cycle"), nullptr};
    case Quantity::current:
      return {QT_TRANSLATE_NOOP("ColumnWords", "current"), nullptr};
    case Quantity::torque:
      return {QT_TRANSLATE_NOOP("ColumnWords", "torque"), QT_TRANSLATE_NOOP("ColumnWords", "force")};
    case Quantity::supply:
      return {QT_TRANSLATE_NOOP("ColumnWords", "supply voltage"), nullptr};
    case Quantity::temperature:
      return {QT_TRANSLATE_NOOP("ColumnWords", "winding temperature"), nullptr};
    case Quantity::positionReference:
      return {QT_TRANSLATE_NOOP("ColumnWords", "angle asked for"),
              QT_TRANSLATE_NOOP("ColumnWords", "position asked for")};
    case Quantity::velocityReference:
      return {QT_TRANSLATE_NOOP("ColumnWords", "speed asked for"),
              QT_TRANSLATE_NOOP("ColumnWords", "linear speed asked for")};
    case Quantity::currentReference:
      return {QT_TRANSLATE_NOOP("ColumnWords", "current asked for"), nullptr};
    case Quantity::disturbance:
      return {QT_TRANSLATE_NOOP("ColumnWords", "disturbance torque"),
              QT_TRANSLATE_NOOP("ColumnWords", "disturbance force")};
    case Quantity::index:
      return {QT_TRANSLATE_NOOP("ColumnWords", "index pulse"), nullptr};
    case Quantity::enabled:
      return {QT_TRANSLATE_NOOP("ColumnWords", "windings on"), nullptr};
  }
  return {"", nullptr};
}

}  // namespace

QString wordsOf(const Column& column) {
  const Called called = calledAs(column.quantity);
  const bool linear = called.linear != nullptr && column.axis == Axis::linear;
  return QCoreApplication::translate("ColumnWords", linear ? called.linear : called.words);
}

}  // namespace breakaway
