// Comparisons of numbers that say how far they are apart.
#pragma once

#include <QTest>
#include <cmath>

namespace breakaway::test {

inline bool within(double value, double expected, double relative) {
  return std::abs(value / expected - 1.0) < relative;
}

}  // namespace breakaway::test

#define COMPARE_WITHIN(actual, expected, bound)                                                         \
  QVERIFY2(std::abs((actual) - (expected)) <= (bound), qPrintable(QString("%1 against %2, apart by %3") \
                                                                      .arg(actual, 0, 'g', 15)          \
                                                                      .arg(expected, 0, 'g', 15)        \
                                                                      .arg((actual) - (expected))))
/// Apart by less than `relative` times the expected value.
#define VERIFY_WITHIN(actual, expected, relative)               \
  QVERIFY2(breakaway::test::within(actual, expected, relative), \
           qPrintable(QString("%1 against %2").arg(actual).arg(expected)))
