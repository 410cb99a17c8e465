#include <QRegularExpression>
#include <QTest>

#include "experiment/abilities.h"
#include "experiment/profile.h"
#include "firmware_link/simulated_board.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

std::unique_ptr<Drive> board(const char* uri = "simulated") {
  auto drive = openDrive(uri, 1);
  if (!drive) qFatal("%s", drive.error().message().c_str());
  return std::move(*drive);
}

FrictionCompensation table(size_t bins) {
  FrictionCompensation friction;
  for (size_t way = 0; way < 2; ++way) {
    for (size_t k = 0; k < bins; ++k) {
      friction.coulomb_Nm[way].push_back(0.01 + 0.001 * static_cast<double>(k + way));
      friction.viscous_Nm_s_per_rad[way].push_back(1e-5);
    }
  }
  friction.indexAngle_rad = 0.75;
  return friction;
}

const RestoredRow& rowOf(const std::vector<RestoredRow>& rows, const std::string& name) {
  for (const RestoredRow& one : rows) {
    if (one.name == name) return one;
  }
  qFatal("no row %s", name.c_str());
}

}  // namespace

class TestProfile : public QObject {
  Q_OBJECT
 private slots:
  void savedProfile_readsBackAsItWas();
  void comparison_namesWhatDiffers_andOnlyThat();
  void restore_givesBackEverything_andSaysWhatWasAccepted();
  void restore_ofNamedParameters_leavesTheRestAlone();
  void restore_toAnotherBoard_isRefusedUnlessSaidSo();
  void tableOfBins_needsTheIndex();
  void unknownName_isNamed_andNothingIsWritten();
  void limits_areTheBoards();
  void fileWithoutBandwidths_leavesTheBoardsAsTheyAre();
  void badFile_isOneLine_data();
  void badFile_isOneLine();
};

void TestProfile::savedProfile_readsBackAsItWas() {
  const TemporaryFolder folder;
  const auto drive = board();
  VERIFY_OK(drive->compensate(table(36)));
  const auto profile = profileOf(*drive);
  VERIFY_OK(profile);
  QCOMPARE(profile->device, drive->identity().device);
  QVERIFY(profile->settings == drive->settings() && profile->friction && profile->friction->coulomb_Nm[0].size() == 36);
  VERIFY_OK(writeProfile(*profile, folder.path("a.profile.json")));
  const auto again = readProfile(folder.path("a.profile.json"));
  VERIFY_OK(again);
  QVERIFY(*again == *profile);
  QCOMPARE(folder.names(), QStringList{"a.profile.json"});
}

void TestProfile::comparison_namesWhatDiffers_andOnlyThat() {
  const auto drive = board();
  const auto before = profileOf(*drive);
  VERIFY_OK(before);
  for (const ProfileRow& row : compareProfiles(*before, *before)) QVERIFY2(row.same, row.name.c_str());
  ControllerSettings other = before->settings;
  other.velocity_kp_A_s_per_rad *= 1.5;
  VERIFY_OK(drive->configure(other));
  VERIFY_OK(drive->compensate(table(1)));
  const auto after = profileOf(*drive);
  VERIFY_OK(after);
  QStringList differ;
  for (const ProfileRow& row : compareProfiles(*after, *before)) {
    if (!row.same) differ << QString::fromStdString(row.name);
  }
  QCOMPARE(differ, (QStringList{"velocity_kp_A_s_per_rad", "friction_table"}));
}

void TestProfile::restore_givesBackEverything_andSaysWhatWasAccepted() {
  const auto drive = board();
  VERIFY_OK(drive->compensate(table(1)));
  const auto saved = profileOf(*drive);
  VERIFY_OK(saved);
  ControllerSettings other = drive->settings();
  other.velocity_ki_A_per_rad = 0.0;
  other.current_limit_A = 1.0;
  VERIFY_OK(drive->configure(other));
  VERIFY_OK(drive->compensate({}));
  const auto rows = restoreProfile(*drive, *saved, {});
  VERIFY_OK(rows);
  QCOMPARE(rows->size(), profileParameters().size() + 1);
  for (const RestoredRow& row : *rows) QVERIFY2(row.same && row.wanted == row.accepted, row.name.c_str());
  const auto now = profileOf(*drive);
  VERIFY_OK(now);
  QVERIFY(*now == *saved);
}

void TestProfile::restore_ofNamedParameters_leavesTheRestAlone() {
  const auto drive = board();
  const auto saved = profileOf(*drive);
  VERIFY_OK(saved);
  ControllerSettings other = drive->settings();
  other.velocity_kp_A_s_per_rad *= 2.0;
  other.velocity_ki_A_per_rad *= 2.0;
  VERIFY_OK(drive->configure(other));
  const auto rows = restoreProfile(*drive, *saved, {{"velocity_kp_A_s_per_rad"}});
  VERIFY_OK(rows);
  QCOMPARE(rows->size(), size_t(1));
  other.velocity_kp_A_s_per_rad = saved->settings.velocity_kp_A_s_per_rad;
  QVERIFY(drive->settings() == other);
}

void TestProfile::restore_toAnotherBoard_isRefusedUnlessSaidSo() {
  const auto saved = profileOf(*board("simulated:geared"));
  VERIFY_OK(saved);
  const auto drive = board();
  const ControllerSettings before = drive->settings();
  VERIFY_ERROR(
      restoreProfile(*drive, *saved, {}),
      "profile: was saved from simulated board, rig geared, but this is simulated board, rig servo; say so if it "
      "shall be restored all the same");
  QVERIFY(drive->settings() == before);
  VERIFY_OK(restoreProfile(*drive, *saved, {{}, {}, true}));
  QVERIFY(!(drive->settings() == before));
}

void TestProfile::tableOfBins_needsTheIndex() {
  const auto drive = board();
  auto saved = profileOf(*drive);
  VERIFY_OK(saved);
  saved->friction = table(36);
  const auto refused = restoreProfile(*drive, *saved, {});
  QVERIFY(!refused);
  QVERIFY(refused.error().message().starts_with("friction_table: belongs to angles from the index"));
  VERIFY_OK(restoreProfile(*drive, *saved, {{}, 2.5}));
  QCOMPARE(drive->compensation()->indexAngle_rad, 2.5);
  QCOMPARE(drive->compensation()->coulomb_Nm[1].size(), size_t(36));
}

void TestProfile::unknownName_isNamed_andNothingIsWritten() {
  const auto drive = board();
  auto saved = profileOf(*drive);
  VERIFY_OK(saved);
  saved->settings.velocity_kp_A_s_per_rad *= 3.0;
  const ControllerSettings before = drive->settings();
  VERIFY_ERROR(restoreProfile(*drive, *saved, {{"velocity_kp_A_s_per_rad", "velocity_ki_A_per_rat"}}),
               "--only: \"velocity_ki_A_per_rat\" is no parameter, did you mean velocity_ki_A_per_rad?");
  QVERIFY(drive->settings() == before);
}

void TestProfile::limits_areTheBoards() {
  const auto drive = board();
  auto saved = profileOf(*drive);
  VERIFY_OK(saved);
  saved->settings.current_limit_A = 500.0;
  const auto rows = restoreProfile(*drive, *saved, {});
  VERIFY_OK(rows);
  const RestoredRow& row = rowOf(*rows, "current_limit_A");
  QVERIFY(!row.same);
  QCOMPARE(row.wanted, std::string("500"));
  QVERIFY(std::abs(std::stod(row.accepted) - drive->settings().current_limit_A) < 1e-6);
  QVERIFY(drive->settings().current_limit_A < 50.0);
}

/// As files were before boards had these two settings.
void TestProfile::fileWithoutBandwidths_leavesTheBoardsAsTheyAre() {
  const auto drive = board();
  const auto saved = profileOf(*drive);
  VERIFY_OK(saved);
  QString text = QString::fromStdString(profileText(*saved));
  text.replace(QRegularExpression(R"re(,\s*"(velocity|current)_bandwidth_rad_per_s": [0-9.]+)re"), "");
  QVERIFY(!text.contains("bandwidth"));
  const auto old = readProfileText(text.toStdString(), "p.json");
  VERIFY_OK(old);
  QCOMPARE(old->settings.current_bandwidth_rad_per_s, 0.0);
  QVERIFY(profileText(*old).find("bandwidth") == std::string::npos);
  ControllerSettings other = drive->settings();
  other.current_bandwidth_rad_per_s = 700.0;
  VERIFY_OK(drive->configure(other));
  const auto now = profileOf(*drive);
  VERIFY_OK(now);
  for (const ProfileRow& row : compareProfiles(*now, *old)) QVERIFY2(row.same, row.name.c_str());
  const auto rows = restoreProfile(*drive, *old, {});
  VERIFY_OK(rows);
  QCOMPARE(rows->size(), profileParameters().size() - 1);
  QCOMPARE(drive->settings().current_bandwidth_rad_per_s, 700.0);
}

void TestProfile::badFile_isOneLine_data() {
  QTest::addColumn<QString>("from");
  QTest::addColumn<QString>("to");
  QTest::addColumn<QString>("line");
  QTest::newRow("schema") << "profile/1"
                          << "profile/9"
                          << "p.json, field schema: is \"breakaway.profile/9\", expected \"breakaway.profile/1\"";
  QTest::newRow("negative") << "\"current_limit_A\": "
                            << "\"current_limit_A\": -"
                            << "current_limit_A";
  QTest::newRow("unknown") << "\"velocity_ki_A_per_rad\""
                           << "\"velocity_ki_A_per_rat\""
                           << "velocity_ki_A_per_ra";
  QTest::newRow("uneven") << "\"coulomb_ccw_Nm\": ["
                          << "\"coulomb_ccw_Nm\": [ 1.0,"
                          << "coulomb_ccw_Nm: has 3 numbers, expected 2 as in coulomb_cw_Nm";
  QTest::newRow("no JSON") << "{"
                           << "("
                           << "p.json";
}

void TestProfile::badFile_isOneLine() {
  QFETCH(QString, from);
  QFETCH(QString, to);
  QFETCH(QString, line);
  const auto drive = board();
  VERIFY_OK(drive->compensate(table(2)));
  const auto profile = profileOf(*drive);
  VERIFY_OK(profile);
  QString text = QString::fromStdString(profileText(*profile));
  QVERIFY(text.contains(from));
  VERIFY_OK(readProfileText(text.toStdString(), "p.json"));
  text.replace(text.indexOf(from), from.size(), to);
  const auto read = readProfileText(text.toStdString(), "p.json");
  QVERIFY(!read);
  const QString said = QString::fromStdString(read.error().message());
  QVERIFY2(said.contains(line) && !said.contains('\n'), qPrintable(said));
}

QTEST_APPLESS_MAIN(TestProfile)
#include "tst_profile.moc"
