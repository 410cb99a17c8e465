// The runs of the project in the window: listed, found, named, opened, compared, and written out.
#include <qcustomplot.h>

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableView>
#include <QTextBrowser>
#include <QToolButton>

#include "app/desk.h"
#include "app/rendered_tree.h"
#include "friction/map_export.h"
#include "friction/static_average.h"
#include "recording/csv.h"
#include "session/language.h"
#include "support/noisy_map.h"
#include "support/temporary.h"
#include "widgets/facts_table.h"
#include "widgets/number_text.h"
#include "widgets/polar_plot.h"
#include "widgets/run_words.h"

using namespace breakaway;
using namespace breakaway::test;

class TestRuns : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void runs_areListedTheNewestFirst();
  void list_isFilteredByTextMotorAndKind();
  void nameAndRemark_areWrittenInPlaceAndKept();
  void runOfAnotherProgram_comesWithTheNextLook();
  void recording_isOpenedOnCompareAndSavedAsCsv();
  void recording_liesBeneathTheOneOnCompare();
  void twoRecordings_areComparedByChannel();
  void twoMaps_areComparedInWordsAndAsReport();
  void map_isOpenedOnFriction();
  void earlierMap_liesBeneathWithTheRingOfDifferences();
  void visiblePartOfARecording_isKeptAsARunOfItsOwn();
  void oneQuantity_hasOneDoubt();
  void values_standByImportanceWithTheirDoubt();
  void motors_haveAColumnWhereOneIsNamed();
  void recordingsEnd_isToldInTheLanguage();
  void page_fitsAndNothingIsCutOff_data();
  void page_fitsAndNothingIsCutOff();
};

namespace {

/// A window on a project that holds two maps of motor 0117, months apart, and a recording of another.
struct Archive {
  Archive() {
    auto project = Project::open(folder(), Project::Missing::isMade);
    if (!project) qFatal("%s", project.error().message().c_str());
    earlier = put(*project, mapRun(1.00, "2026-03-02T09:14:07Z"));
    later = put(*project, mapRun(1.25, "2026-06-02T09:14:07Z"));
    NewRun recording;
    recording.motor = "0042";
    recording.at = "2026-05-01T12:00:00Z";
    recording.write = [](const std::string& into) { return writeCsv(someRecording(), into + "/r.csv"); };
    recorded = put(*project, recording);
    desk.session.project.open(QString::fromStdString(folder()));
    desk.window.showPage("runsPage");
  }
  std::string folder() const { return place.filePath("p").toStdString(); }

  static ProjectRun put(Project& project, const NewRun& run) {
    const auto added = project.add(run);
    if (!added) qFatal("%s", added.error().message().c_str());
    return *added;
  }
  static NewRun mapRun(double scale, const char* at) {
    NewRun run;
    run.motor = "0117";
    run.at = at;
    run.write = [scale](const std::string& into) {
      return exportMap(noisyMap(0.02 * scale, 7), "json", into + "/map.json");
    };
    return run;
  }
  static Recording someRecording() {
    std::vector<double> time, angle;
    for (int k = 0; k < 400; ++k) {
      time.push_back(0.01 * k);
      angle.push_back(std::sin(time.back()));
    }
    const auto sealed = Recording::seal("r", {{"time_s", time}, {"angle_rad", angle}});
    return sealed.value();
  }
  int rows() { return table()->model()->rowCount(); }
  QTableView* table() { return named<QTableView>(desk.window, "runsTable"); }
  QString cell(int row, int column) { return table()->model()->index(row, column).data().toString(); }

  QTemporaryDir place;
  ProjectRun earlier, later, recorded;
  Desk desk;
};

enum Column { atColumn, kindColumn, motorColumn, deviceColumn, nameColumn, resultColumn, remarkColumn };

}  // namespace

void TestRuns::initTestCase() {
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestRuns::runs_areListedTheNewestFirst() {
  Archive archive;
  QTRY_COMPARE(archive.rows(), 3);
  QVERIFY2(archive.cell(0, atColumn).startsWith("2026-06-02"), qPrintable(archive.cell(0, atColumn)));
  QCOMPARE(archive.cell(0, kindColumn), QString("Friction map"));
  QCOMPARE(archive.cell(0, motorColumn), QString("0117"));
  QVERIFY2(archive.cell(0, resultColumn).startsWith("static 25"), qPrintable(archive.cell(0, resultColumn)));
  QVERIFY2(archive.cell(2, resultColumn).startsWith("static 20"), qPrintable(archive.cell(2, resultColumn)));
  QCOMPARE(archive.cell(1, kindColumn), QString("Recording"));
  QCOMPARE(named<QLabel>(archive.desk.window, "runsCount")->text(), QString("3 runs"));
}

void TestRuns::list_isFilteredByTextMotorAndKind() {
  Archive archive;
  QTRY_COMPARE(archive.rows(), 3);
  auto* motor = named<QComboBox>(archive.desk.window, "runsMotor");
  auto* kind = named<QComboBox>(archive.desk.window, "runsKind");
  auto* text = named<QLineEdit>(archive.desk.window, "runsText");
  motor->setCurrentIndex(motor->findData("0117"));
  QTRY_COMPARE(archive.rows(), 2);
  QTRY_COMPARE(named<QLabel>(archive.desk.window, "runsCount")->text(), QString("2 of 3 runs"));
  motor->setCurrentIndex(0);
  kind->setCurrentIndex(kind->findData("recording"));
  QTRY_COMPARE(archive.rows(), 1);
  QCOMPARE(archive.cell(0, motorColumn), QString("0042"));
  kind->setCurrentIndex(0);
  QTRY_COMPARE(archive.rows(), 3);
  text->setFocus();
  QTest::keyClicks(text, "2026-03");
  QTRY_COMPARE(archive.rows(), 1);
  QTest::keyClicks(text, " nowhere");
  QTRY_COMPARE(archive.rows(), 0);
}

void TestRuns::nameAndRemark_areWrittenInPlaceAndKept() {
  Archive archive;
  QTRY_COMPARE(archive.rows(), 3);
  const auto write = [&](int column, const QString& text) {
    const QModelIndex index = archive.table()->model()->index(2, column);
    archive.table()->setCurrentIndex(index);
    archive.table()->edit(index);
    auto* line = archive.table()->findChild<QLineEdit*>();
    QVERIFY(line != nullptr);
    line->selectAll();
    text.isEmpty() ? QTest::keyClick(line, Qt::Key_Delete) : QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
  };
  const auto kept = [&] {
    const auto project = Project::open(archive.folder());
    return project->index().find(archive.earlier.id).value();
  };
  write(nameColumn, "before greasing");
  QTRY_COMPARE(kept().name, std::string("before greasing"));
  write(remarkColumn, "cold, 12 °C");
  QTRY_COMPARE(kept().remark, std::string("cold, 12 °C"));
  QTRY_COMPARE(archive.cell(2, nameColumn), QString("before greasing"));
  QVERIFY2(!archive.desk.session.connection.powered(), "Space is a letter here");
  write(nameColumn, "");
  QTRY_COMPARE(kept().name, std::string());
  QCOMPARE(kept().remark, std::string("cold, 12 °C"));
}

void TestRuns::runOfAnotherProgram_comesWithTheNextLook() {
  Archive archive;
  QTRY_COMPARE(archive.rows(), 3);
  {
    auto other = Project::open(archive.folder());
    Archive::put(*other, Archive::mapRun(1.1, "2026-07-01T00:00:00Z"));
  }
  archive.desk.window.showPage("connectPage");
  archive.desk.window.showPage("runsPage");
  QTRY_COMPARE(archive.rows(), 4);
  QVERIFY(archive.cell(0, atColumn).startsWith("2026-07-01"));
}

void TestRuns::recording_isOpenedOnCompareAndSavedAsCsv() {
  Archive archive;
  QTRY_COMPARE(archive.rows(), 3);
  QVERIFY(!named<QPushButton>(archive.desk.window, "openRunButton")->isEnabled());
  archive.table()->selectRow(0);
  QTRY_VERIFY(named<QPushButton>(archive.desk.window, "saveRunCsvButton")->toolTip() == "The run has no recording");
  archive.table()->selectRow(1);
  QTRY_VERIFY(named<QPushButton>(archive.desk.window, "saveRunCsvButton")->isEnabled());
  const QString csv = archive.place.filePath("saved.csv");
  archive.desk.answers.byTitle["Save the run's recording"] = csv;
  press(archive.desk.window, "saveRunCsvButton");
  QTRY_VERIFY(QFile::exists(csv));
  QCOMPARE(readCsv(csv.toStdString())->rows(), size_t{400});
  press(archive.desk.window, "openRunButton");
  QTRY_VERIFY(archive.desk.session.comparison.recording().has_value());
  QVERIFY(named<QWidget>(archive.desk.window, "comparePage")->isVisible());
  QCOMPARE(archive.desk.session.comparison.recording()->rows(), size_t{400});
}

void TestRuns::recording_liesBeneathTheOneOnCompare() {
  Archive archive;
  QTRY_COMPARE(archive.rows(), 3);
  // What is shown begins later and elsewhere.
  const Recording kept = Archive::someRecording();
  std::vector<double> time(kept.time().begin(), kept.time().end());
  std::vector<double> angle(kept.channel("angle_rad").begin(), kept.channel("angle_rad").end());
  for (double& one : time) one += 7.0;
  for (double& one : angle) one += 2.0;
  archive.desk.session.comparison.takeRecording(
      Recording::seal("shown", {{"time_s", time}, {"angle_rad", angle}}).value());
  archive.table()->selectRow(1);
  auto* button = named<QPushButton>(archive.desk.window, "layMapBeneathButton");
  QTRY_VERIFY(button->isEnabled());
  press(archive.desk.window, "layMapBeneathButton");
  QTRY_VERIFY(archive.desk.session.comparison.beneath().has_value());
  QVERIFY(named<QWidget>(archive.desk.window, "comparePage")->isVisible());
  auto* plot = named<QCustomPlot>(archive.desk.window, "residualPlot");
  QTRY_VERIFY(plot->graph(0)->dataCount() > 0 && plot->graph(4)->dataCount() > 0);
  QCOMPARE(archive.desk.session.comparison.beneath()->name, archive.cell(1, atColumn));
  const auto first = plot->graph(4)->data()->constBegin(), shown = plot->graph(0)->data()->constBegin();
  QVERIFY(std::abs(first->key - 7.0) < 1e-9 && std::abs(first->value - shown->value) < 1e-9);
  QVERIFY(named<QToolButton>(archive.desk.window, "takeBeneathAwayButton")->isEnabled());
  named<QToolButton>(archive.desk.window, "takeBeneathAwayButton")->click();
  QVERIFY(!archive.desk.session.comparison.beneath() && plot->graph(4)->dataCount() == 0);
}

void TestRuns::twoRecordings_areComparedByChannel() {
  Archive archive;
  {
    auto project = Project::open(archive.folder());
    VERIFY_OK(project);
    NewRun again;
    again.at = "2026-05-03T12:00:00Z";
    again.write = [](const std::string& into) { return writeCsv(Archive::someRecording(), into + "/r.csv"); };
    VERIFY_OK(project->add(again));
  }
  archive.desk.session.runs.refresh();
  QTRY_COMPARE(archive.rows(), 4);
  archive.table()->selectRow(1);
  archive.table()->selectionModel()->select(archive.table()->model()->index(2, 0),
                                            QItemSelectionModel::Select | QItemSelectionModel::Rows);
  press(archive.desk.window, "compareRunsButton");
  auto* words = named<QTextBrowser>(archive.desk.window, "runComparisonWords");
  QTRY_VERIFY(words->isVisible());
  const QString said = words->toPlainText();
  QVERIFY2(said.contains("Laid over each other from their beginnings") && said.contains("(rad)"), qPrintable(said));
}

void TestRuns::twoMaps_areComparedInWordsAndAsReport() {
  Archive archive;
  QTRY_COMPARE(archive.rows(), 3);
  auto* compare = named<QPushButton>(archive.desk.window, "compareRunsButton");
  archive.table()->selectRow(0);
  QVERIFY(!compare->isEnabled());
  archive.table()->selectionModel()->select(archive.table()->model()->index(2, 0),
                                            QItemSelectionModel::Select | QItemSelectionModel::Rows);
  QVERIFY(compare->isEnabled());
  press(archive.desk.window, "compareRunsButton");
  auto* words = named<QTextBrowser>(archive.desk.window, "runComparisonWords");
  QTRY_VERIFY(words->isVisible());
  const QString said = words->toPlainText();
  QVERIFY2(said.startsWith("Changed beyond the 95 % intervals"), qPrintable(said));
  QVERIFY2(said.contains("Static average") && said.contains("+25 %") && said.contains("mNm"), qPrintable(said));
  archive.desk.answers.byTitle["Write the comparison of the runs into a folder"] = archive.place.filePath("cmp");
  press(archive.desk.window, "writeRunComparisonButton");
  QTRY_VERIFY(QFile::exists(archive.place.filePath("cmp/report.html")));
  QVERIFY(QFile::exists(archive.place.filePath("cmp/figures/map.svg")));
  press(archive.desk.window, "closeRunComparisonButton");
  QVERIFY(archive.table()->isVisible() && !words->isVisible());
}

void TestRuns::map_isOpenedOnFriction() {
  Archive archive;
  QTRY_COMPARE(archive.rows(), 3);
  archive.table()->selectRow(0);
  QTRY_VERIFY(named<QPushButton>(archive.desk.window, "openRunButton")->toolTip().contains("Friction"));
  QTest::keyClick(archive.table(), Qt::Key_Return);
  QTRY_VERIFY(named<QWidget>(archive.desk.window, "frictionPage")->isVisible());
  auto* title = named<QWidget>(archive.desk.window, "frictionPage")->findChild<QLabel*>("pageTitle");
  QVERIFY2(title->text().startsWith("Friction map of 2026-06-02"), qPrintable(title->text()));
  const auto* polar = named<PolarPlot>(archive.desk.window, "polarPlot");
  QCOMPARE(polar->curves().size(), size_t{2});
  QCOMPARE(polar->curves()[0].points.size(), size_t{90});
  QVERIFY(std::abs(polar->curves()[0].points[0].value - 27.5) < 1.0);
  QCOMPARE(named<FactsTable>(archive.desk.window, "frictionAverages")->value("Coulomb").left(4), QString("20.0"));
  const QString csv = archive.place.filePath("again.csv");
  QVERIFY(archive.desk.exported("csv", csv));
  press(archive.desk.window, "todaysMapButton");
  QVERIFY(title->text().startsWith("Friction around"));
  QVERIFY(polar->curves().empty());
  // A sweep that begins shows what it measures.
  archive.desk.session.runs.readMap(archive.later.id, &archive.desk.window,
                                    [&](const KeptMap& map) { archive.desk.session.maps.open(map); });
  QTRY_VERIFY(archive.desk.session.maps.opened().has_value());
  archive.desk.session.connection.open("simulated");
  archive.desk.window.showPage("frictionPage");
  press(archive.desk.window, "breakawaySweepButton");
  QTRY_VERIFY_WITH_TIMEOUT(!archive.desk.session.maps.opened().has_value(), patience_ms);
}

void TestRuns::earlierMap_liesBeneathWithTheRingOfDifferences() {
  Archive archive;
  QTRY_COMPARE(archive.rows(), 3);
  archive.table()->selectRow(2);
  QTRY_VERIFY(named<QPushButton>(archive.desk.window, "layMapBeneathButton")->isEnabled());
  press(archive.desk.window, "layMapBeneathButton");
  QTRY_VERIFY(named<QWidget>(archive.desk.window, "frictionPage")->isVisible());
  const auto* polar = named<PolarPlot>(archive.desk.window, "polarPlot");
  QCOMPARE(polar->curves().size(), size_t{2});  // alone, as long as nothing else is measured
  QVERIFY(polar->curves()[0].part == MapPart::earlier);
  archive.desk.session.runs.readMap(archive.later.id, &archive.desk.window,
                                    [&](const KeptMap& map) { archive.desk.session.maps.open(map); });
  QTRY_COMPARE(polar->curves().size(), size_t{6});
  const auto ring = std::find_if(polar->curves().begin(), polar->curves().end(),
                                 [](const MapCurve& curve) { return curve.part == MapPart::difference; });
  QVERIFY(ring != polar->curves().end());
  // 25 % of 20 mNm with a wave of a tenth.
  for (const MapPoint& point : ring->points)
    QVERIFY(std::abs(point.value - ring->lifted - 5.0 * (1.0 + 0.1 * std::cos(point.at))) < 1.0);
  double highest = 0.0;
  for (const MapCurve& curve : polar->curves())
    for (const MapPoint& point : curve.points)
      if (curve.part == MapPart::shown) highest = std::max(highest, point.value);
  QVERIFY2(ring->lifted > highest, "the ring lies outside");
  const auto* angular = qobject_cast<QCPPolarAxisAngular*>(
      named<QCustomPlot>(archive.desk.window, "polarPlotCanvas")->plotLayout()->element(0, 0));
  const auto share = [&](const MapPoint& point) {
    const QPointF away = polar->pixelOf(point) - angular->center();
    return std::hypot(away.x(), away.y()) / angular->radius();
  };
  for (const MapPoint& point : ring->points) QVERIFY(share(point) > 0.92 && share(point) < 0.99);
  double widest = 0.0;
  for (const MapCurve& curve : polar->curves()) {
    if (ofDifference(curve)) continue;
    for (const MapPoint& point : curve.points) widest = std::max(widest, share(point));
  }
  QVERIFY2(widest > 0.75 && widest < 0.92, qPrintable(QString::number(widest)));
  auto* canvas = const_cast<PolarPlot*>(polar);
  QTest::qWait(50);
  const QString read = canvas->readingAt(canvas->pixelOf(ring->points[20]));
  QVERIFY2(read.contains("now − earlier") && read.contains(QRegularExpression(": [345]\\.")), qPrintable(read));
  if (qEnvironmentVariableIsSet("BREAKAWAY_LOOK")) archive.desk.window.grab().save("/tmp/ghost.png");
  press(archive.desk.window, "takeMapAwayButton");
  QCOMPARE(polar->curves().size(), size_t{2});
}

void TestRuns::visiblePartOfARecording_isKeptAsARunOfItsOwn() {
  Archive archive;
  archive.desk.session.comparison.takeRecording(Archive::someRecording());
  archive.desk.window.showPage("comparePage");
  auto* keep = named<QPushButton>(archive.desk.window, "keepVisibleButton");
  QVERIFY2(!keep->isEnabled() && keep->toolTip().startsWith("All of it"), qPrintable(keep->toolTip()));
  auto* plots = named<QCustomPlot>(archive.desk.window, "residualPlot");
  plots->axisRect(0)->axis(QCPAxis::atBottom)->setRange(1.0, 2.0);
  press(archive.desk.window, "keepVisibleButton");
  archive.desk.window.showPage("runsPage");
  QTRY_COMPARE(archive.rows(), 4);
  QCOMPARE(archive.cell(0, nameColumn), QString("r, 1.000 s to 2.000 s"));
  const auto project = Project::open(archive.folder());
  const ProjectRun run = project->index().find("last").value();
  QCOMPARE(run.kind, std::string("recording"));
  const auto part = readCsv(project->pathOf(run, run.file("recording")->path));
  VERIFY_OK(part);
  QCOMPARE(part->rows(), size_t{101});
  QCOMPARE(part->channel("angle_rad")[0], std::sin(1.0));
}

/// The figure in the circle and the averages beside it.
void TestRuns::oneQuantity_hasOneDoubt() {
  Archive archive;
  archive.desk.session.runs.readMap(archive.later.id, &archive.desk.window,
                                    [&](const KeptMap& map) { archive.desk.session.maps.open(map); });
  QTRY_VERIFY(archive.desk.session.maps.opened().has_value());
  archive.desk.window.showPage("frictionPage");
  auto* averages = named<FactsTable>(archive.desk.window, "frictionAverages");
  const auto* canvas = named<QCustomPlot>(archive.desk.window, "polarPlotCanvas");
  const auto figure = [canvas] {
    QStringList words;
    for (int k = 0; k < canvas->itemCount(); ++k)
      if (const auto* text = qobject_cast<const QCPItemText*>(canvas->item(k))) words << text->text();
    return words.join(" | ");
  };
  press(archive.desk.window, "viewCoulomb");
  QVERIFY2(averages->value("Coulomb").contains("20.0 ± 0.5 mNm"), qPrintable(averages->value("Coulomb")));
  QVERIFY2(figure().contains("20.0 | ± 0.5 mNm"), qPrintable(figure()));
  press(archive.desk.window, "viewStatic");
  // A turn's bins share their errors: the mean of them is no better known than each.
  const QString one = averages->value("Static, ccw");
  QVERIFY2(one.contains("±") && !one.contains("± 0.0 "), qPrintable(one));
  const FrictionMap map = noisyMap(0.025, 7);
  const Estimate mean = staticAverage_Nm(map);
  QVERIFY2(figure().contains(estimateText(mean, 1e3, "mNm").replace(" ±", " | ±")), qPrintable(figure()));
  QVERIFY(mean.standardError > 0.9 * map.bins[0].way[0].static_Nm.standardError);
}

void TestRuns::values_standByImportanceWithTheirDoubt() {
  Archive archive;
  QTRY_COMPARE(archive.rows(), 3);
  archive.table()->selectRow(0);
  const auto* values = named<FactsTable>(archive.desk.window, "runValues");
  QTRY_VERIFY(!values->value("Static average").isEmpty());
  QVERIFY2(values->value("Coulomb average").contains("20.0 ± 0.5 mNm"), qPrintable(values->value("Coulomb average")));
  QCOMPARE(values->findChildren<QLabel*>().front()->text(), QString("Static average"));
  ProjectRun run;
  for (const char* name : {"back_emf_constant_V_s_per_rad", "coulomb_average_Nm", "inertia_kg_m2", "static_average_Nm",
                           "torque_constant_Nm_per_A"})
    run.values.push_back({name, 1.0, 0.9, 1.1});
  const std::vector<RunValue> sorted = byImportance(run);
  QCOMPARE(sorted.front().name, std::string("static_average_Nm"));
  QCOMPARE(sorted[2].name, std::string("torque_constant_Nm_per_A"));
  QCOMPARE(sorted.back().name, std::string("back_emf_constant_V_s_per_rad"));
}

void TestRuns::motors_haveAColumnWhereOneIsNamed() {
  Archive archive;
  QTRY_COMPARE(archive.rows(), 3);
  QVERIFY(!archive.table()->isColumnHidden(motorColumn));
  Desk desk;
  const QTemporaryDir place;
  auto project = Project::open(place.filePath("p").toStdString(), Project::Missing::isMade);
  VERIFY_OK(project);
  NewRun run = Archive::mapRun(1.0, "2026-03-02T09:14:07Z");
  run.motor.clear();
  Archive::put(*project, run);
  desk.session.project.open(place.filePath("p"));
  desk.window.showPage("runsPage");
  const auto* table = named<QTableView>(desk.window, "runsTable");
  QTRY_COMPARE(table->model()->rowCount(), 1);
  QVERIFY(table->isColumnHidden(motorColumn));
  QVERIFY(!table->isColumnHidden(nameColumn) && !table->isColumnHidden(remarkColumn));  // to write in
}

void TestRuns::recordingsEnd_isToldInTheLanguage() {
  ProjectRun run;
  run.kind = "recording";
  run.verdict = "3.9 s, 19280 samples, 12 lost; ended by: the link was lost";
  QCOMPARE(resultInWords(run), QString::fromStdString(run.verdict));
  speak(Language::german);
  const QString german = resultInWords(run);
  run.verdict =
      "3.9 s, 19280 samples, 1616 bytes damaged; ended by: a kill or a loss of power: the last second may be missing";
  const QString damaged = resultInWords(run);
  run.verdict = "61.0 s, 305000 samples";
  const QString whole = resultInWords(run);
  run.verdict = "nothing was recorded";
  const QString other = resultInWords(run);
  speak(Language::english);
  QVERIFY2(german.startsWith("3.9 s, 19280 Messwerte, 12 verloren; beendet: "), qPrintable(german));
  QVERIFY2(damaged.startsWith("3.9 s, 19280 Messwerte, 1616 Byte beschädigt; beendet: ein Abbruch"),
           qPrintable(damaged));
  QCOMPARE(whole, QString("61.0 s, 305000 Messwerte"));
  QCOMPARE(other, QString("nothing was recorded"));
}

void TestRuns::page_fitsAndNothingIsCutOff_data() {
  QTest::addColumn<bool>("german");
  QTest::newRow("in English") << false;
  QTest::newRow("in German") << true;
}

void TestRuns::page_fitsAndNothingIsCutOff() {
  QFETCH(bool, german);
  speak(german ? Language::german : Language::english);
  Archive archive;
  speak(Language::english);
  QTRY_COMPARE(archive.rows(), 3);
  for (const QSize size : {QSize(1280, 720), QSize(1366, 768)}) {
    archive.desk.window.resize(size);
    archive.table()->selectRow(0);
    const auto* values = named<FactsTable>(archive.desk.window, "runValues");
    QTRY_VERIFY(!values->findChildren<QLabel*>().isEmpty());
    QTest::qWait(20);
    QCOMPARE(archive.desk.window.size(), size);
    for (const QLabel* value : values->findChildren<QLabel*>()) {
      const QRect wanted = value->fontMetrics().boundingRect(0, 0, value->width(), 0, Qt::TextWordWrap, value->text());
      QVERIFY2(wanted.width() <= value->width() && wanted.height() <= value->height(), qPrintable(value->text()));
    }
    const QStringList cut = clipped(archive.desk.window), on = overlapping(archive.desk.window);
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join("; ")));
    QVERIFY2(on.isEmpty(), qPrintable(on.join("; ")));
    if (qEnvironmentVariableIsSet("BREAKAWAY_LOOK"))
      archive.desk.window.grab().save(QString("/tmp/runs-%1.png").arg(size.width()));
  }
}

JOURNEY_MAIN(TestRuns)
#include "tst_runs.moc"
