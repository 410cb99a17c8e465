#include <matio.h>

#include <QRegularExpression>
#include <QTest>

#include "friction/map_export.h"
#include "support/temporary.h"

using namespace breakaway;

class TestMapExport : public QObject {
  Q_OBJECT
 private slots:
  void json_isReadBack();
  void csv_hasTheManualsColumns();
  void cHeader_compilesAsC();
  void cHeaders_ofTwoNames_standInOneProgram();
  void cHeader_tellsTheTorqueBetweenBins();
  void modelica_holdsATableOfEach();
  void mat_holdsTheColumns();
  void unknownFormat_namesTheKnownOnes();
  void missingField_isNamed();
  void textInANumber_isNamed();
  void brokenJson_isOneLine();
};

namespace {

FrictionMap someMap() {
  FrictionMap map;
  map.rig = "bench */ 3";
  map.turns = 2;
  map.totalVelocity_rad_per_s = 10.47;
  map.bins.resize(12);
  for (size_t k = 0; k < 12; ++k) {
    map.bins[k].angle_rad = 0.1 + 0.5 * static_cast<double>(k);
    for (size_t w = 0; w < 2; ++w) {
      const double level = 0.02 + 1e-3 * static_cast<double>(k + 3 * w);
      map.bins[k].way[w] = {{level, 1e-4}, {0.8 * level, 2e-4}, {2e-5, 1e-7}, 0.9 * level, 2, k == 3};
    }
  }
  for (auto& turns : map.turnStatic_Nm) turns.assign(2, std::vector<double>(12, 0.02));
  map.repeatability = {Repeatability{0.97, 1e-4}, Repeatability{0.98, 2e-4}};
  map.coulombAverage_Nm = {0.0161, 1e-4};
  map.viscousAverage_Nm_s_per_rad = {2.1e-5, 3e-7};
  map.settings = {{"dwell_s", 0.08}};
  return map;
}

std::string written(const test::TemporaryFolder& folder, const std::string& format) {
  const auto done = exportMap(someMap(), format, folder.path("map"));
  if (!done) qFatal("%s", done.error().message().c_str());
  return *readFile(folder.path("map"));
}

}  // namespace

void TestMapExport::json_isReadBack() {
  test::TemporaryFolder folder;
  written(folder, "json");
  const auto map = readMap(folder.path("map"));
  QVERIFY2(map.ok(), map.ok() ? "" : map.error().message().c_str());
  const FrictionMap is = someMap();
  QCOMPARE(map->bins.size(), is.bins.size());
  for (size_t k = 0; k < is.bins.size(); ++k) {
    for (size_t w = 0; w < 2; ++w) {
      QCOMPARE(map->bins[k].way[w].static_Nm, is.bins[k].way[w].static_Nm);
      QCOMPARE(map->bins[k].way[w].viscous_Nm_s_per_rad, is.bins[k].way[w].viscous_Nm_s_per_rad);
      QCOMPARE(map->bins[k].way[w].samples, is.bins[k].way[w].samples);
      QCOMPARE(map->bins[k].way[w].outlier, is.bins[k].way[w].outlier);
    }
  }
  QCOMPARE(map->turnStatic_Nm, is.turnStatic_Nm);
  QCOMPARE(map->coulombAverage_Nm, is.coulombAverage_Nm);
  QCOMPARE(map->repeatability[1].correlation, 0.98);
  QCOMPARE(map->settings, is.settings);
}

void TestMapExport::csv_hasTheManualsColumns() {
  test::TemporaryFolder folder;
  const QString text = QString::fromStdString(written(folder, "csv"));
  const QStringList lines = text.split('\n');
  QCOMPARE(lines.size(), 14);
  const QStringList columns = lines[0].split(',');
  for (const QString way : {"cw", "ccw"}) {
    for (const QString name : {"static_%1_Nm", "static_%1_std_Nm", "coulomb_%1_Nm", "coulomb_%1_std_Nm",
                               "viscous_%1_Nm_s_per_rad", "total_%1_Nm", "samples_%1"}) {
      QVERIFY2(columns.contains(name.arg(way)), qPrintable(name.arg(way)));
    }
  }
  const QStringList row = lines[3].split(',');
  const double cw = row[columns.indexOf("static_cw_Nm")].toDouble(),
               ccw = row[columns.indexOf("static_ccw_Nm")].toDouble();
  QVERIFY(std::abs(row[columns.indexOf("static_friction_Nm")].toDouble() - 0.5 * (cw + ccw)) < 1e-15);
  QVERIFY(std::abs(row[columns.indexOf("position_torque_Nm")].toDouble() - 0.5 * (cw - ccw)) < 1e-15);
}

void TestMapExport::cHeader_compilesAsC() {
  test::TemporaryFolder folder;
  QVERIFY(exportMap(someMap(), "c-header", folder.path("map.h")).ok());
  folder.write("use.c",
               "#include \"map.h\"\nint main(void) { return breakaway_map_static_cw_Nm[BREAKAWAY_MAP_BINS - 1] > 0.03f "
               "? 0 : 1; }\n");
  const std::string command = "cc -std=c99 -Wall -Werror -Wno-unused-const-variable -o " + folder.path("use") + " " +
                              folder.path("use.c") + " && " + folder.path("use");
  QCOMPARE(std::system(command.c_str()), 0);
}

void TestMapExport::cHeaders_ofTwoNames_standInOneProgram() {
  test::TemporaryFolder folder;
  FrictionMap right = someMap();
  for (MapBin& bin : right.bins) bin.way[1].coulomb_Nm.value *= 2.0;
  right.bins.resize(6);
  QVERIFY(exportMap(someMap(), "c-header", folder.path("left.h"), "left").ok());
  QVERIFY(exportMap(right, "c-header", folder.path("right.h"), "right_2").ok());
  folder.write("use.c",
               "#include \"left.h\"\n#include \"right.h\"\n"
               "int main(void) {\n  const float a = left_map_coulomb_ccw_Nm[0], b = right_2_map_coulomb_ccw_Nm[0];\n"
               "  if (LEFT_MAP_BINS != 12 || RIGHT_2_MAP_BINS != 6) return 1;\n"
               "  if (right_2_map_moving_Nm(0.1f, 1.0f) <= left_map_moving_Nm(0.1f, 1.0f)) return 2;\n"
               "  return b > 1.999f * a && b < 2.001f * a ? 0 : 3;\n}\n");
  const std::string command = "cc -std=c99 -Wall -Werror -Wno-unused-const-variable -o " + folder.path("use") + " " +
                              folder.path("use.c") + " && " + folder.path("use");
  QCOMPARE(std::system(command.c_str()), 0);
  QVERIFY(!QString::fromStdString(*readFile(folder.path("right.h"))).contains("breakaway", Qt::CaseInsensitive));
}

/// Half way between the first two bins, a turn away, and from the last over to the first.
void TestMapExport::cHeader_tellsTheTorqueBetweenBins() {
  test::TemporaryFolder folder;
  QVERIFY(exportMap(someMap(), "c-header", folder.path("map.h")).ok());
  folder.write("use.c",
               "#include <stdio.h>\n#include \"map.h\"\nint main(void) {\n  const float bin = 6.2831853f / 12.0f;\n"
               "  printf(\"%.7g %.7g %.7g %.7g\\n\", breakaway_map_moving_Nm(0.1f + 0.5f * bin, 10.0f),\n"
               "         breakaway_map_moving_Nm(0.1f + 0.5f * bin - 6.2831853f, -10.0f),\n"
               "         breakaway_map_moving_Nm(0.1f + 11.5f * bin, 10.0f), breakaway_map_moving_Nm(1.0f, 0.0f));\n"
               "  return 0;\n}\n");
  const std::string command = "cc -std=c99 -Wall -Werror -Wno-unused-const-variable -o " + folder.path("use") + " " +
                              folder.path("use.c") + " && " + folder.path("use") + " > " + folder.path("said");
  QCOMPARE(std::system(command.c_str()), 0);
  const QStringList said = QString::fromStdString(*readFile(folder.path("said"))).simplified().split(' ');
  const auto coulomb = [](double bin, int way) { return 0.8 * (0.02 + 1e-3 * (bin + 3.0 * way)); };
  const double expected[] = {coulomb(0.5, 1) + 2e-4, -coulomb(0.5, 0) - 2e-4, coulomb(5.5, 1) + 2e-4, 0.0};
  for (qsizetype k = 0; k < 4; ++k) QVERIFY2(std::abs(said[k].toDouble() - expected[k]) < 1e-6, qPrintable(said[k]));
}

void TestMapExport::modelica_holdsATableOfEach() {
  test::TemporaryFolder folder;
  const QString text = QString::fromStdString(written(folder, "modelica"));
  const auto table = QRegularExpression("constant Real static_ccw_Nm\\[13, 2\\] = \\[([^\\]]*)\\];").match(text);
  const QStringList rows = table.captured(1).split("; ");
  QCOMPARE(rows.size(), qsizetype{13});
  const auto cell = [&rows](qsizetype row, int column) { return rows[row].split(", ")[column].toDouble(); };
  QCOMPARE(cell(12, 0) - cell(0, 0), turn_rad);  // what a periodic table takes for its period
  QCOMPARE(cell(12, 1), cell(0, 1));
  QCOMPARE(cell(11, 0), someMap().bins[11].angle_rad);
  QCOMPARE(cell(11, 1), someMap().bins[11].way[1].static_Nm.value);
  QVERIFY(text.contains("package BreakawayFrictionMap\n") && text.endsWith("end BreakawayFrictionMap;\n"));
  QVERIFY(!text.contains("_std_") && !text.contains("*/"));
}

void TestMapExport::mat_holdsTheColumns() {
  test::TemporaryFolder folder;
  written(folder, "mat");
  mat_t* file = Mat_Open(folder.path("map").c_str(), MAT_ACC_RDONLY);
  QVERIFY(file != nullptr);
  matvar_t* variable = Mat_VarRead(file, "static_ccw_Nm");
  QVERIFY(variable != nullptr);
  QCOMPARE(variable->dims[0], size_t{12});
  QCOMPARE(static_cast<const double*>(variable->data)[11], someMap().bins[11].way[1].static_Nm.value);
  Mat_VarFree(variable);
  Mat_Close(file);
  QCOMPARE(folder.names(), QStringList{"map"});
}

void TestMapExport::unknownFormat_namesTheKnownOnes() {
  const auto done = exportMap(someMap(), "xml", "nowhere");
  QVERIFY(!done.ok());
  QCOMPARE(done.error().message(),
           std::string("format xml: is unknown, expected csv, json, c-header, mat or modelica"));
}

void TestMapExport::missingField_isNamed() {
  test::TemporaryFolder folder;
  std::string text = written(folder, "json");
  const std::string field = "\"static_cw_Nm\"";
  text.replace(text.find(field), field.size(), "\"static_cw\"");
  const auto map = readMapText(text, "m.json");
  QVERIFY(!map.ok());
  QCOMPARE(map.error().message(), std::string("m.json, field bins[0].static_cw_Nm: is missing, expected a number"));
}

void TestMapExport::textInANumber_isNamed() {
  test::TemporaryFolder folder;
  std::string text = written(folder, "json");
  const std::string field = "\"turns\": 2";
  text.replace(text.find(field), field.size(), "\"turns\": \"two\"");
  const auto map = readMapText(text, "m.json");
  QVERIFY(!map.ok());
  QCOMPARE(map.error().message(), std::string("m.json, field turns: expected a number"));
}

void TestMapExport::brokenJson_isOneLine() {
  for (const char* text : {"", "{", "[]", "{\"schema\": \"breakaway.map/1\", \"bins\": [3]}",
                           "{\"schema\": \"breakaway.map/1\", \"bins\": {}}",
                           "{\"schema\": \"breakaway.map/1\", \"turns\": 1, \"bins\": [{}], \"repeatability\": 3}"}) {
    const auto map = readMapText(text, "m.json");
    QVERIFY2(!map.ok(), text);
    QVERIFY(map.error().message().find('\n') == std::string::npos);
  }
}

QTEST_APPLESS_MAIN(TestMapExport)
#include "tst_map_export.moc"
