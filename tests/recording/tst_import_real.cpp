#include <QTest>
#include <cmath>

#include "recording/csv.h"
#include "recording/import/import.h"
#include "support/real_recordings.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::realRecordings;

class TestImportReal : public QObject {
  Q_OBJECT
 private slots:
  void emps_equalsItsRecording();
  void rawPwmLog_equalsItsRecording();
  void processedPwmLog_isRefused();
};

/// Same columns in the same order, and every value within half a unit of the last digit that the reference kept.
static void compare(const Recording& got, const Recording& wanted, const std::vector<double>& halfDigits) {
  QCOMPARE(got.rows(), wanted.rows());
  QCOMPARE(got.channels().size(), wanted.channels().size());
  for (size_t c = 0; c < halfDigits.size(); ++c) {
    const Channel &a = got.channels()[c], &b = wanted.channels()[c];
    QCOMPARE(a.name, b.name);
    for (size_t k = 0; k < got.rows(); ++k) {
      QVERIFY2(std::abs(a.values[k] - b.values[k]) <= halfDigits[c] * (1.0 + 1e-6) + 1e-12,
               qPrintable(QString("%1, row %2: %3, expected %4")
                              .arg(a.name.c_str())
                              .arg(k + 1)
                              .arg(a.values[k], 0, 'g', 12)
                              .arg(b.values[k], 0, 'g', 12)));
    }
  }
}

void TestImportReal::emps_equalsItsRecording() {
  NEEDS_REAL_RECORDINGS();
  const auto imported = importRecording(realRecordings() + "/emps/DATA_EMPS.mat");
  VERIFY_OK(imported);
  const auto wanted = readCsv(realRecordings() + "/emps/DATA_EMPS.csv");
  VERIFY_OK(wanted);
  compare(imported->recording, *wanted, {1e-7, 5e-11, 5e-5, 5e-7, 5e-9});
}

void TestImportReal::rawPwmLog_equalsItsRecording() {
  NEEDS_REAL_RECORDINGS();
  const auto imported = importRecording(realRecordings() + "/bam_xl330/import/raw_sin_time_square_kp400.json");
  VERIFY_OK(imported);
  const auto wanted = readCsv(realRecordings() + "/bam_xl330/sin_time_square_kp400.csv");
  VERIFY_OK(wanted);
  compare(imported->recording, *wanted, {5e-7, 5e-7, 5e-5, 5e-6, 5e-2, 5e-6, 5e-7, 0.0, 0.0});
}

void TestImportReal::processedPwmLog_isRefused() {
  NEEDS_REAL_RECORDINGS();
  const auto imported = importRecording(realRecordings() + "/bam_xl330/import/processed_sin_time_square_kp400.json");
  QVERIFY(!imported.ok());
  QVERIFY2(imported.error().message().find("interpolated across the register's 16 bit wrap") != std::string::npos,
           imported.error().message().c_str());
}

QTEST_APPLESS_MAIN(TestImportReal)
#include "tst_import_real.moc"
