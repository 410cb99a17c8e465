#include <QTest>
#include <filesystem>

#include "diagnose/effects/catalogue.h"
#include "house/include_rules.h"

using namespace breakaway::test;

class TestLayering : public QObject {
  Q_OBJECT
 private slots:
  void sources_keepTheLayering();
  void plantedBreach_isFound_data();
  void plantedBreach_isFound();
  void effects_areNamedInTheirOwnFilesOnly();
  void everyHeader_saysItsIdeaAndGuardsItself();
};

static std::string root() {
  return qgetenv("BREAKAWAY_SOURCE_DIR").toStdString();
}

void TestLayering::sources_keepTheLayering() {
  const Sources sources = readSources(root());
  QVERIFY2(sources.size() > 40, "the sources were not found");
  std::string all;
  for (const auto& one : breaches(sources)) all += one + "\n";
  QVERIFY2(all.empty(), all.c_str());
}

void TestLayering::plantedBreach_isFound_data() {
  QTest::addColumn<QString>("path");
  QTest::addColumn<QString>("include");
  QTest::addColumn<QString>("why");
  const auto row = [](const char* path, const char* include, const char* why) {
    QTest::newRow(qPrintable(QString("%1 %2").arg(path, include))) << path << include << why;
  };
  row("core/base/planted.h", "\"motor/bench.h\"", "base stands below motor");
  row("core/recording/planted.cpp", "\"diagnose/model/model.h\"", "recording stands below diagnose");
  row("core/observer/planted.h", "\"control/pid.h\"", "observer stands below control");
  row("core/stability/planted.cpp", "\"experiment/drive.h\"", "stability stands below experiment");
  row("core/diagnose/planted.cpp", "\"draw/svg_plot.h\"", "diagnose stands below draw");
  row("core/diagnose/planted.cpp", "\"report/diagnosis_report.h\"", "diagnose stands below report");
  row("core/identify/planted.cpp", "\"commission/commission.h\"", "identify stands below commission");
  row("core/commission/planted.cpp", "\"report/commission_report.h\"", "commission stands below report");
  row("core/commission/planted.cpp", "\"draw/svg_plot.h\"", "commission stands below draw");
  row("core/draw/planted.cpp", "\"friction/friction_map.h\"", "drawing knows only base");
  row("core/report/planted.cpp", "\"experiment/drive.h\"", "moves nothing");
  row("core/report/planted.cpp", "\"commission/job.h\"", "must not know core/experiment/drive.h");
  row("core/report/planted.cpp", "\"figures/all_figures.h\"", "report stands below figures");
  row("core/motor/planted.cpp", "<QString>", "core knows no Qt");
  row("core/motor/planted.cpp", "<QtCore/QString>", "core knows no Qt");
  row("core/motor/planted.cpp", "<unistd.h>", "the system's own stands in *_posix.cpp");
  row("core/base/planted.h", "<sys/stat.h>", "the system's own stands in *_posix.cpp");
  row("app/cli/planted.cpp", "<termios.h>", "the system's own stands in *_posix.cpp");
  row("core/recording/import/planted.h", "\"recording/import/json_cells.h\"", "JSON stays inside");
  row("core/motor/planted.h", "<nlohmann/json.hpp>", "JSON stays inside");
  row("core/motor/planted.h", "\"bench.h\"", "written from the layer's folder");
  row("core/motor/planted.cpp", "\"cli/command.h\"", "core stands on itself only");
  row("core/cellar/planted.cpp", "\"base/result.h\"", "no room of the plan");
  row("core/diagnose/planted.cpp", "\"plant/plant.h\"", "the search must not know core/plant/plant.h");
  row("core/diagnose/effects/planted.cpp", "\"motor/middle.h\"", "the search must not know core/plant/plant.h");
  row("core/diagnose/planted.cpp", "\"trial/sealed_trial.h\"", "diagnose stands below trial");
  row("core/diagnose/model/planted.h", "\"diagnose/effects/wave.h\"", "model stands below effects");
  row("core/diagnose/effects/planted.cpp", "\"diagnose/effects/catalogue.h\"", "effects stands below catalogue");
  row("core/diagnose/effects/catalogue.h", "\"diagnose/simulate/physics.h\"", "catalogue stands below simulate");
  row("core/diagnose/simulate/planted.h", "\"diagnose/fit/window.h\"", "simulate stands below fit");
  row("core/diagnose/fit/planted.cpp", "\"diagnose/screen/screen.h\"", "fit stands below screen");
  row("core/diagnose/screen/planted.cpp", "\"diagnose/search/model_fit.h\"", "screen stands below search");
  row("core/diagnose/search/planted.h", "\"diagnose/verdict/finding.h\"", "search stands below verdict");
  row("core/diagnose/verdict/planted.cpp", "\"diagnose/diagnosis.h\"", "verdict stands below diagnosis");
  row("core/diagnose/model/planted.cpp", "\"diagnose/diagnosis.h\"", "model stands below diagnosis");
  row("core/diagnose/attic/planted.cpp", "\"diagnose/model/effect.h\"", "attic is no step of diagnose");
  row("core/trial/planted.cpp", "\"diagnose/search/search.h\"", "trials know only");
  row("core/trial/planted.cpp", "\"diagnose/model/model.h\"", "trials know only");
  row("core/plant/planted.cpp", "\"trial/trial_rig.h\"", "plant stands below trial");
  row("core/plant/planted.cpp", "\"diagnose/model/model.h\"", "plant stands below diagnose");
  row("core/motor/planted.cpp", "\"plant/rig.h\"", "motor stands below plant");
  row("core/experiment/planted.cpp", "\"plant/rig.h\"", "nobody sees the plant");
  row("core/report/planted.cpp", "\"plant/rig.h\"", "nobody sees the plant");
  row("firmware_link/planted.cpp", "\"plant/plant.h\"", "only simulated boards see the plant");
  row("firmware_link/planted.cpp", "\"diagnose/model/model.h\"", "the link stands beside diagnose");
  row("firmware_link/planted.cpp", "<QSerialPortInfo>", "the link knows no Qt");
  row("firmware_link/transport/planted.cpp", "<QTcpSocket>", "the link knows no Qt");
  row("firmware_link/planted.cpp", "\"firmware_link/transport/serial_line.h\"", "transports stand above the link");
  row("firmware_link/planted.cpp", "\"session/connection.h\"", "the link stands beside");
  row("firmware_link/wire/planted.h", "<string>", "a board has no <string>");
  row("firmware_link/wire/planted.h", "\"control/tuning.h\"", "the wire stands on itself only");
  row("firmware_link/board/planted.h", "<vector>", "a board has no <vector>");
  row("firmware_link/board/planted.h", "\"experiment/drive.h\"", "wire, control and observers only");
  row("app/cli/planted.cpp", "\"widgets/time_plot.h\"", "commands see no window");
  row("app/cli/planted.cpp", "<QWidget>", "commands see no window");
  row("app/cli/planted.cpp", "\"main_window.h\"", "commands see no window");
  row("app/session/planted.h", "\"widgets/look.h\"", "the session knows no window");
  row("app/session/planted.cpp", "\"pages/tune_page.h\"", "the session knows no window");
  row("app/session/planted.cpp", "\"main_window.h\"", "the session knows no window");
  row("app/session/planted.cpp", "\"cli/inputs.h\"", "pages know no commands");
  row("app/session/planted.cpp", "\"session/session.h\"", "doesn't ask for the whole");
  row("app/widgets/planted.cpp", "\"pages/home_page.h\"", "widgets stand below pages");
  row("app/widgets/planted.cpp", "\"main_window.h\"", "below the window");
  row("app/pages/planted.cpp", "\"session/session.h\"", "doesn't ask for the whole");
  row("app/pages/planted.cpp", "\"firmware_link/simulated_board.h\"", "through the session");
  row("app/pages/planted.cpp", "\"firmware_link/transport/open_board.h\"", "through the session");
  row("app/planted.cpp", "\"plant/plant.h\"", "nobody sees the plant");
  row("app/pages/planted.cpp", "\"trial/sealed_trial.h\"", "nobody sees the plant");
  row("app/cli/planted.cpp", "\"trial/trial_rig.h\"", "nobody sees the plant");
}

void TestLayering::plantedBreach_isFound() {
  QFETCH(QString, path);
  QFETCH(QString, include);
  QFETCH(QString, why);
  Sources sources{{"core/plant/plant.h", ""},
                  {"core/base/result.h", ""},
                  {"core/experiment/drive.h", ""},
                  {"core/commission/job.h", "#include \"experiment/drive.h\"\n"}};
  QVERIFY(breaches(sources).empty());
  if (include.contains("middle.h")) sources["core/motor/middle.h"] = "#include \"plant/plant.h\"\n";
  sources[path.toStdString()] = "#pragma once\n  # include " + include.toStdString() + "\n";
  auto found = breaches(sources);
  std::erase_if(found, [](const std::string& one) { return one.starts_with("core/motor/middle.h"); });
  QCOMPARE(found.size(), size_t(1));
  QVERIFY2(found[0].find(why.toStdString()) != std::string::npos && found[0].starts_with(path.toStdString()),
           found[0].c_str());
}

void TestLayering::effects_areNamedInTheirOwnFilesOnly() {
  std::vector<std::string> names;
  for (const breakaway::Effect* effect : breakaway::catalogue()) names.emplace_back(effect->name());
  Sources sources = readSources(root());
  std::string all;
  for (const auto& one : namedEffects(sources, names)) all += one + "\n";
  QVERIFY2(all.empty(), all.c_str());
  for (const char* path : {"core/diagnose/search/planted.cpp", "core/diagnose/planted.h", "core/report/planted.cpp",
                           "app/pages/planted.cpp"}) {
    sources[path] = "// \"stribeck\"\nif (finding.effect == \"cogging\") return;\n";
    QCOMPARE(namedEffects(sources, names), std::vector<std::string>{std::string(path) + " names cogging"});
    sources.erase(path);
  }
}

void TestLayering::everyHeader_saysItsIdeaAndGuardsItself() {
  for (const auto& [path, text] : readSources(root())) {
    if (!path.ends_with(".h")) continue;
    QVERIFY2(text.find("#pragma once\n") != std::string::npos, path.c_str());
    QVERIFY2(text.starts_with("// "), path.c_str());
  }
}

QTEST_APPLESS_MAIN(TestLayering)
#include "tst_layering.moc"
