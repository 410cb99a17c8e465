#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>

#include "support/temporary.h"

using breakaway::test::TemporaryFolder;

/// A room sees what it uses and nothing else: a planted include of a room above doesn't compile. Each source is
/// compiled as the build does it, alone or with others of its room, but for its text.
class TestRooms : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void includeFromAbove_doesNotCompile_data();
  void includeFromAbove_doesNotCompile();

 private:
  /// Is this one of the files that include several sources, `source` among them?
  static bool holds(const QString& together, const QString& source);
  /// What the compiler says about one include in the place of `source`; empty: it compiles.
  QString complaint(const QString& source, const QString& include) const;

  QJsonArray commands_;
  TemporaryFolder folder_;
};

void TestRooms::initTestCase() {
  QFile file(qEnvironmentVariable("BREAKAWAY_BIN_DIR") + "/../compile_commands.json");
  QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
  commands_ = QJsonDocument::fromJson(file.readAll()).array();
  QVERIFY(!commands_.isEmpty());
}

bool TestRooms::holds(const QString& together, const QString& source) {
  static const QRegularExpression included("^#include \"(.*)\"$", QRegularExpression::MultilineOption);
  if (!together.contains("/together/")) return false;
  QFile file(together);
  if (!file.open(QIODevice::ReadOnly)) return false;
  const QString text = file.readAll();
  for (auto each = included.globalMatch(text); each.hasNext();) {
    if (('/' + source).endsWith('/' + each.next().captured(1))) return true;
  }
  return false;
}

QString TestRooms::complaint(const QString& source, const QString& include) const {
  for (const auto& one : commands_) {
    const QString file = one.toObject()["file"].toString();
    if (!file.endsWith('/' + source) && !holds(file, source)) continue;
    QStringList words = QProcess::splitCommand(one.toObject()["command"].toString());
    const qsizetype output = words.indexOf("-o");
    words.remove(output, 2);
    words.removeAll("-c");
    words.removeAll(file);
    const auto planted = folder_.write("planted.cpp", "#include \"" + include.toStdString() + "\"\n");
    words << "-fsyntax-only" << QString::fromStdString(planted);
    QProcess compiler;
    compiler.setProcessChannelMode(QProcess::MergedChannels);
    compiler.setWorkingDirectory(one.toObject()["directory"].toString());
    const QString program = words.takeFirst();
    compiler.start(program, words);
    if (!compiler.waitForFinished(120000)) return "the compiler does not end";
    const QString said = compiler.readAll();
    return compiler.exitCode() == 0 ? QString() : said.isEmpty() ? "the compiler fails" : said;
  }
  return "the build has no such source";
}

void TestRooms::includeFromAbove_doesNotCompile_data() {
  QTest::addColumn<QString>("source");
  QTest::addColumn<QString>("seen");
  QTest::addColumn<QString>("above");
  const auto row = [](const char* source, const char* seen, const char* above) {
    QTest::newRow(qPrintable(QString("%1 %2").arg(source, above))) << source << seen << above;
  };
  row("core/base/result.cpp", "base/result.h", "friction/friction_map.h");
  row("core/friction/map_table.cpp", "base/estimate.h", "recording/recording.h");
  row("core/recording/recording.cpp", "base/result.h", "motor/bench.h");
  row("core/motor/bench.cpp", "recording/columns.h", "plant/rig.h");
  row("core/plant/rig.cpp", "motor/bench.h", "experiment/drive.h");
  row("core/stability/margins.cpp", "motor/bench.h", "experiment/drive.h");
  row("core/experiment/leg.cpp", "friction/friction_map.h", "plant/plant.h");
  row("core/experiment/leg.cpp", "motor/bench.h", "identify/zero_track.h");
  row("core/identify/zero_track.cpp", "experiment/drive.h", "commission/commission.h");
  row("core/commission/commission.cpp", "motor/bench.h", "report/commission_report.h");
  row("core/diagnose/model/model.cpp", "motor/bench.h", "diagnose/effects/catalogue.h");
  row("core/diagnose/effects/catalogue.cpp", "diagnose/model/effect.h", "diagnose/simulate/simulation.h");
  row("core/diagnose/simulate/track.cpp", "diagnose/model/effect.h", "diagnose/fit/window.h");
  row("core/diagnose/fit/window.cpp", "diagnose/simulate/track.h", "diagnose/screen/screen.h");
  row("core/diagnose/fit/window.cpp", "diagnose/model/model.h", "plant/plant.h");
  row("core/diagnose/screen/screen.cpp", "diagnose/fit/window.h", "diagnose/search/search.h");
  row("core/diagnose/search/search.cpp", "diagnose/fit/window.h", "diagnose/verdict/finding.h");
  row("core/diagnose/verdict/judge.cpp", "diagnose/fit/window.h", "diagnose/diagnosis.h");
  row("core/diagnose/diagnosis.cpp", "diagnose/fit/window.h", "trial/sealed_trial.h");
  row("core/trial/trial_rig.cpp", "recording/recording.h", "diagnose/model/model.h");
  row("tests/support/score/scoring.cpp", "base/result.h", "report/tuning_report.h");
  row("core/draw/svg_path.cpp", "base/result.h", "recording/recording.h");
  row("core/report/map_figures.cpp", "draw/svg_path.h", "figures/bench_figure.h");
  row("breakaway_wire_verify_interface_header_sets/firmware_link/wire/bytes.h.cxx", "firmware_link/wire/bytes.h",
      "control/turn.h");
  row("breakaway_board_verify_interface_header_sets/firmware_link/board/outbox.h.cxx", "control/turn.h",
      "base/result.h");
  row("firmware_link/wish.cpp", "experiment/drive.h", "diagnose/model/model.h");
  row("firmware_link/wish.cpp", "firmware_link/wire/bytes.h", "firmware_link/vesc/vesc_drive.h");
  row("app/cli/ports.cpp", "motor/bench.h", "session/session.h");
  row("app/session/recorder.cpp", "recording/recording.h", "widgets/look.h");
  row("app/session/recorder.cpp", "experiment/drive.h", "trial/sealed_trial.h");
  row("app/widgets/look.cpp", "session/recorder.h", "pages/home_page.h");
  row("firmware_link/vesc/vesc_line.cpp", "firmware_link/byte_stream.h", "firmware_link/transport/open_board.h");
}

void TestRooms::includeFromAbove_doesNotCompile() {
  QFETCH(QString, source);
  QFETCH(QString, seen);
  QFETCH(QString, above);
  QCOMPARE(complaint(source, seen), QString());
  const QString said = complaint(source, above);
  QVERIFY2(said.contains(above + ": No such file or directory"), qPrintable(said));
}

QTEST_APPLESS_MAIN(TestRooms)
#include "tst_rooms.moc"
