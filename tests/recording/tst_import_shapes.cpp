#include <QTest>
#include <cmath>

#include "recording/import/import.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

/// The shapes in which programs write their rows.
class TestImportShapes : public QObject {
  Q_OBJECT
 private slots:
  void markThatAllLinesBeginWith_isNoPartOfTheTable_data();
  void markThatAllLinesBeginWith_isNoPartOfTheTable();
  void labelBeforeEachNumber_isItsName_data();
  void labelBeforeEachNumber_isItsName();
  void listsOfEachRowBesideATime_areColumns_data();
  void listsOfEachRowBesideATime_areColumns();
  void objectsInAList_areColumnsOfTheirOwn();
  void objectsThatDescribeColumns_areNoSamples();
  void rowsWithTheirNamesBeside_stayRows();
  void stampInBrackets_isTheTime_data();
  void stampInBrackets_isTheTime();
  void coloursOfATerminal_areNoText();
  void rowsOfATagAndAValue_areSignals();
  void namesInAnOlderEncoding_areUnderstood_data();
  void namesInAnOlderEncoding_areUnderstood();
  void umlautsOfWindows_stayThose();
  void unitBehindAComma_isTheNames();
  void marksOfThousands_areNoDecimals_data();
  void marksOfThousands_areNoDecimals();
  void nameOfEachLine_isNoNameOfAList();
  void rowsOfSignalsInTurn_makeNoPauses();
  void rowsOfAxesWithOneStamp_askForTheColumnThatPartsThem();
  void referenceWithoutAUnit_goesAboutAsFar();
  void semicolonThatEndsEachRow_isNoPartOfACell_data();
  void semicolonThatEndsEachRow_isNoPartOfACell();

 private:
  Result<Imported> imported(const QString& text) {
    return importRecording(folder_.write("log.txt", text.toStdString()));
  }
  TemporaryFolder folder_;
};

constexpr int rows = 60;

void TestImportShapes::markThatAllLinesBeginWith_isNoPartOfTheTable_data() {
  QTest::addColumn<QString>("mark");
  QTest::addColumn<QString>("head");
  QTest::addColumn<QString>("separator");
  QTest::newRow("a dump with a word before the names")
      << "@D"
      << "@D BEGIN straight 1 150\n@D INFO period_ms=10 samples=60 result=OK\n@D COLS t_ms,angle_rad,rpm\n"
      << ",";
  QTest::newRow("a word with a colon") << "DATA:"
                                       << "DATA: t_ms,angle_rad,rpm\n"
                                       << ",";
  QTest::newRow("names without it") << "row"
                                    << "t_ms;angle_rad;rpm\n"
                                    << ";";
}

void TestImportShapes::markThatAllLinesBeginWith_isNoPartOfTheTable() {
  QFETCH(QString, mark);
  QFETCH(QString, head);
  QFETCH(QString, separator);
  QString text = head;
  for (int k = 0; k < rows; ++k)
    text += mark + " " +
            QStringList{QString::number(10 * k), QString::number(std::sin(0.1 * k)),
                        QString::number(95.493 * std::cos(0.1 * k))}
                .join(separator) +
            "\n";
  const auto log = imported(text);
  VERIFY_OK(log);
  QCOMPARE(log->recording.rows(), size_t{rows});
  QVERIFY(std::abs(log->recording.time()[rows - 1] - 0.01 * (rows - 1)) < 1e-9);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - std::sin(1.0)) < 1e-4);
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[10] - 10.0 * std::cos(1.0)) < 1e-3);
}

void TestImportShapes::labelBeforeEachNumber_isItsName_data() {
  QTest::addColumn<QString>("row");
  QTest::newRow("parted by commas") << "t %1, angle %2, rpm %3\n";
  QTest::newRow("cells of their own") << "t,%1,angle,%2,rpm,%3\n";
  QTest::newRow("parted by blanks") << "t %1 angle %2 rpm %3\n";
}

void TestImportShapes::labelBeforeEachNumber_isItsName() {
  QFETCH(QString, row);
  QString text;
  for (int k = 0; k < rows; ++k) text += row.arg(0.01 * k).arg(std::sin(0.1 * k)).arg(95.493 * std::cos(0.1 * k));
  const auto log = imported(text);
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.time()[10] - 0.1) < 1e-9);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - std::sin(1.0)) < 1e-4);
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[10] - 10.0 * std::cos(1.0)) < 1e-3);
}

void TestImportShapes::listsOfEachRowBesideATime_areColumns_data() {
  QTest::addColumn<bool>("bySignal");
  QTest::newRow("a list per row") << false;
  QTest::newRow("a list per signal") << true;
}

void TestImportShapes::listsOfEachRowBesideATime_areColumns() {
  QFETCH(bool, bySignal);
  QStringList times, positions, first, second;
  for (int k = 0; k < rows; ++k) {
    const QString a = QString::number(std::sin(0.1 * k)), b = QString::number(std::cos(0.1 * k));
    times += QString::number(0.01 * k);
    positions += "[" + a + "," + b + "]";
    first += a;
    second += b;
  }
  const QString lists = bySignal ? "[" + first.join(',') + "],[" + second.join(',') + "]" : positions.join(',');
  const auto log =
      imported(R"({"rate": 100, "time_s": [)" + times.join(',') + R"(], "joint_position": [)" + lists + "]}");
  VERIFY_OK(log);
  QCOMPARE(log->recording.rows(), size_t{rows});
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - std::sin(1.0)) < 1e-4);
  QCOMPARE(log->columns.size(), size_t{3});
}

void TestImportShapes::objectsInAList_areColumnsOfTheirOwn() {
  QString text;
  for (int k = 0; k < rows; ++k)
    text += QString(R"({"t": %1, "m": [{"id": 1, "pos": %2}, {"id": 2, "pos": %3}]})")
                .arg(0.01 * k)
                .arg(std::sin(0.1 * k))
                .arg(std::cos(0.1 * k)) +
            "\n";
  const auto log = imported(text);
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - std::sin(1.0)) < 1e-4);
}

void TestImportShapes::objectsThatDescribeColumns_areNoSamples() {
  QStringList samples;
  for (int k = 0; k < rows; ++k) samples += QString("[%1,%2]").arg(10 * k).arg(57.29578 * std::sin(0.1 * k));
  const auto log =
      imported(R"({"columns": [{"name": "t", "unit": "ms"}, {"name": "theta", "unit": "deg"}], "data": [)" +
               samples.join(",") + "]}");
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.time()[10] - 0.1) < 1e-9);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - std::sin(1.0)) < 1e-4);
}

void TestImportShapes::rowsWithTheirNamesBeside_stayRows() {
  QStringList data, index;
  for (int k = 0; k < rows; ++k) {
    data += QString("[%1,%2]").arg(0.01 * k).arg(std::sin(0.1 * k));
    index += QString::number(k);
  }
  const auto log = imported(R"({"columns": ["time_s", "angle_rad"], "index": [)" + index.join(',') + R"(], "data": [)" +
                            data.join(',') + "]}");
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - std::sin(1.0)) < 1e-4);
}

void TestImportShapes::stampInBrackets_isTheTime_data() {
  QTest::addColumn<QString>("head");
  QTest::addColumn<QString>("row");
  const QString date = "[2024-05-01 10:20:1%1.%2]";
  QTest::newRow("a date before cells") << "[2024-05-01 10:20:09.000] angle_rad,rpm\n" << date + " %4,%5";
  QTest::newRow("a date before cells without names' own") << "angle_rad,rpm\n" << date + " %4,%5";
  QTest::newRow("a date before labels") << QString() << date + " angle_rad=%4 rpm=%5";
  QTest::newRow("seconds since 1970 in round brackets")
      << QString() << "(171455881%1.%2000)  can0  ANGLE: %4 rad, SPEED: %5 rpm";
  QTest::newRow("a number before cells") << "angle_rad;rpm\n"
                                         << "[1%1.%2] %4;%5";
}

void TestImportShapes::stampInBrackets_isTheTime() {
  QFETCH(QString, head);
  QFETCH(QString, row);
  QString text = head;
  for (int k = 0; k < rows; ++k) {
    QString line = row;
    line.replace("%1", QString::number(k / 10)).replace("%2", QString("%1").arg(100 * (k % 10), 3, 10, QChar('0')));
    line.replace("%4", QString::number(std::sin(0.1 * k))).replace("%5", QString::number(9.5493 * std::cos(0.1 * k)));
    text += line + "\n";
  }
  const auto log = imported(text);
  VERIFY_OK(log);
  QCOMPARE(log->recording.rows(), size_t{rows});
  QVERIFY(std::abs(log->recording.time()[rows - 1] - log->recording.time()[0] - 0.1 * (rows - 1)) < 1e-6);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - std::sin(1.0)) < 1e-4);
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[10] - std::cos(1.0)) < 1e-3);
}

void TestImportShapes::coloursOfATerminal_areNoText() {
  QString text = "\x1b[0;32mI (312) app: start\x1b[0m\n";
  for (int k = 0; k < rows; ++k)
    text += QString("\x1b[0;32mI (%1) motor: pos=%2 iq=%3\x1b[0m\n").arg(500 + 10 * k).arg(std::sin(0.1 * k)).arg(0.5);
  const auto log = imported(text);
  VERIFY_OK(log);
  QCOMPARE(log->recording.rows(), size_t{rows});
  QVERIFY(log->recording.has("angle_rad") && log->recording.has("current_A"));
}

void TestImportShapes::rowsOfATagAndAValue_areSignals() {
  QString text = "Tag,Timestamp,Value,Quality\n";
  for (int k = 0; k < rows; ++k) {
    const QString stamp = QString("2024-05-01 10:20:%1.%2").arg(10 + k / 10).arg(100 * (k % 10), 3, 10, QChar('0'));
    text += QString("Motor1.Speed_rpm,%1,%2,Good\nMotor1.Current_A,%1,0.5,Good\n").arg(stamp).arg(10 * k);
  }
  const auto log = imported(text);
  VERIFY_OK(log);
  QCOMPARE(log->recording.rows(), size_t{rows});
  QVERIFY(log->recording.has("velocity_rad_per_s") && log->recording.has("current_A"));
}

void TestImportShapes::namesInAnOlderEncoding_areUnderstood_data() {
  QTest::addColumn<QByteArray>("head");
  // 时间,角度,电流 and 時間,角度,電流 and 시간,각도,전류
  QTest::newRow("GB 18030") << QByteArray("\xCA\xB1\xBC\xE4(s),\xBD\xC7\xB6\xC8(deg),\xB5\xE7\xC1\xF7(A)\n");
  QTest::newRow("Shift JIS") << QByteArray("\x8E\x9E\x8A\xD4(s),\x8Ap\x93x(deg),\x93\x64\x97\xAC(A)\n");
  // Время, Угол, Ток and čas, úhel, proud
  QTest::newRow("Windows-1251")
      << QByteArray("\xC2\xF0\xE5\xEC\xFF, s,\xD3\xE3\xEE\xEB (deg),\xD2\xEE\xEA (A)\n").replace(", s,", " (s),");
  QTest::newRow("Windows-1250") << QByteArray(
      "\xE8"
      "as (s),\xFAhel (deg),pr\xB9"
      "d (A)\n");
  QTest::newRow("EUC-KR") << QByteArray("\xBD\xC3\xB0\xA3(s),\xB0\xA2\xB5\xB5(deg),\xC0\xFC\xB7\xF9(A)\n");
}

void TestImportShapes::namesInAnOlderEncoding_areUnderstood() {
  QFETCH(QByteArray, head);
  QByteArray text = head;
  for (int k = 0; k < rows; ++k) text += QString("%1,%2,0.5\n").arg(0.01 * k).arg(90.0 * std::sin(0.1 * k)).toUtf8();
  const auto log = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(log);
  QVERIFY(log->recording.has("angle_rad") && log->recording.has("current_A"));
}

void TestImportShapes::umlautsOfWindows_stayThose() {
  QByteArray text =
      "Zeit [s];Dr\xFC"
      "cker Winkel [\xB0];Pr\xFC"
      "fstrom [A]\n";
  for (int k = 0; k < rows; ++k) text += QString("%1;%2;0.5\n").arg(0.01 * k).arg(90.0 * std::sin(0.1 * k)).toUtf8();
  const auto log = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(log);
  QCOMPARE(log->columns[2].from, std::string("Prüfstrom [A]"));
  QVERIFY(log->recording.has("angle_rad"));
}

void TestImportShapes::rowsOfAxesWithOneStamp_askForTheColumnThatPartsThem() {
  QString text = "time_s,rotor,angle_deg\n";
  for (int k = 0; k < rows; ++k)
    text += QString("%1,1,%2\n%1,2,%3\n").arg(0.01 * k).arg(90.0 * std::sin(0.1 * k)).arg(40.0 * std::cos(0.3 * k));
  const auto log = imported(text);
  QVERIFY(!log);
  QVERIFY(log.error().message().find("{\"split\": \"rotor\"}") != std::string::npos);
}

void TestImportShapes::referenceWithoutAUnit_goesAboutAsFar() {
  const auto first = [this](double scale) {
    QString text = "time_s,rpm,target_w\n";
    for (int k = 0; k < rows; ++k)
      text += QString("%1,%2,%3\n").arg(0.01 * k).arg(955.0 * std::cos(0.1 * k)).arg(scale * 955.0 * std::cos(0.1 * k));
    const auto log = imported(text);
    return log ? log->recording.channel("velocity_reference_rad_per_s").front() : 0.0;
  };
  QVERIFY(std::abs(first(1.0) - 100.0) < 0.1);
  QVERIFY(std::abs(first(0.1047) - 100.0) < 0.1);
}

void TestImportShapes::marksOfThousands_areNoDecimals_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<double>("speed");
  const auto rowsOf = [](const QString& head, const QString& form) {
    QString text = head;
    for (int k = 0; k < rows; ++k) text += QString(form).replace("%1", QString::number(10 + k));
    return text;
  };
  QTest::newRow("dots, beside decimal commas") << rowsOf("t_s;speed_rad_s\n", "%1,5;1.234\n") << 1234.0;
  QTest::newRow("dots and a decimal comma") << rowsOf("t_s;speed_rad_s\n", "%1,5;-1.234.567,5\n") << -1234567.5;
  QTest::newRow("commas, beside decimal points") << rowsOf("t_s,speed_rad_s\n", "%1.5,\"1,234\"\n") << 1234.0;
  QTest::newRow("commas and a decimal point") << rowsOf("t_s,speed_rad_s\n", "%1.5,\"1,234.5\"\n") << 1234.5;
  QTest::newRow("apostrophes") << rowsOf("t_s;speed_rad_s\n", "%1.5;-1'234'567.5\n") << -1234567.5;
  QTest::newRow("narrow blanks") << rowsOf("t_s;speed_rad_s\n", "%1,5;1\u202f234,5\n") << 1234.5;
  QTest::newRow("decimal commas of three digits") << rowsOf("t_s;speed_rad_s\n", "%1,250;1,234\n") << 1.234;
  QTest::newRow("decimal points of three digits") << rowsOf("t_s;speed_rad_s\n", "%1.250;1.234\n") << 1.234;
  QTest::newRow("both marks for decimals") << rowsOf("t_s;speed_rad_s;x\n", "%1,5;1.234;0.5\n") << 1.234;
}

void TestImportShapes::marksOfThousands_areNoDecimals() {
  QFETCH(QString, text);
  QFETCH(double, speed);
  const auto log = imported(text);
  VERIFY_OK(log);
  QCOMPARE(log->recording.channel("velocity_rad_per_s")[5], speed);
}

void TestImportShapes::unitBehindAComma_isTheNames() {
  QString text = "Время, с;Угол, град;Скорость, об/мин;Ток, мА\n";
  for (int k = 0; k < rows; ++k)
    text += QString("%1;%2;%3;500\n").arg(0.01 * k).arg(90.0 * std::sin(0.1 * k)).arg(150.0 * std::cos(0.1 * k));
  const auto log = imported(text);
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s").front() - 15.708) < 1e-3);
  QVERIFY(std::abs(log->recording.channel("current_A").front() - 0.5) < 1e-9);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - 0.5 * M_PI * std::sin(1.0)) < 1e-4);
}

void TestImportShapes::nameOfEachLine_isNoNameOfAList() {
  QString text;
  for (int k = 0; k < rows; ++k) text += QString("RPM:%1,%2,%3,7\n").arg(100.5 + k).arg(200.5 + k).arg(k);
  const auto log = imported(text);
  QVERIFY(!log);
  QVERIFY(log.error().message().find("column_2, column_3") != std::string::npos);
}

void TestImportShapes::rowsOfSignalsInTurn_makeNoPauses() {
  QString text = "Timestamp,Arm/Position (deg),Arm/Velocity (deg/s)\n";
  for (int k = 0; k < rows; ++k)
    text += QString("%1,%2,\n%3,,5\n").arg(0.02 * k, 0, 'f', 4).arg(0.1 * k).arg(0.02 * k + 1e-4, 0, 'f', 4);
  const auto log = imported(text);
  VERIFY_OK(log);
  QCOMPARE(log->recording.rows(), size_t{rows});
  for (const auto& remark : log->remarks) QVERIFY(remark.english().find("pause") == std::string::npos);
}

void TestImportShapes::semicolonThatEndsEachRow_isNoPartOfACell_data() {
  QTest::addColumn<QString>("separator");
  QTest::newRow("commas") << ",";
  QTest::newRow("tabs") << "\t";
  QTest::newRow("blanks") << "  ";
}

void TestImportShapes::semicolonThatEndsEachRow_isNoPartOfACell() {
  QFETCH(QString, separator);
  QString text = "%time,position\n%[s],[deg]\n";
  for (int k = 0; k < rows; ++k)
    text += QString::number(0.01 * k) + separator + QString::number(57.29578 * std::sin(0.1 * k)) + ";\n";
  const auto log = imported(text);
  VERIFY_OK(log);
  QCOMPARE(log->recording.rows(), size_t(rows));
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - std::sin(1.0)) < 1e-4);
}

QTEST_APPLESS_MAIN(TestImportShapes)
#include "tst_import_shapes.moc"
