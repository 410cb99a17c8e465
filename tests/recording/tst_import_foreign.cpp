#include <QTest>
#include <cmath>

#include "recording/import/column_name.h"
#include "recording/import/import.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

/// Names of columns in other languages than English and German.
class TestImportForeign : public QObject {
  Q_OBJECT
 private slots:
  void name_isUnderstood_data();
  void name_isUnderstood();
  void unknownNames_areTakenByTheirOnlyUnit();
  void twoWithOneUnit_areKept();
  void englishNames_areNotTakenByTheirUnit();

 private:
  Result<Imported> waves(const QStringList& names) {
    QString text = "time_s;\"" + names.join("\";\"") + "\"\n";
    for (int k = 0; k < 80; ++k) {
      text += QString::number(0.01 * k);
      for (int c = 0; c < names.size(); ++c) text += QString(";%1").arg((1.0 + 0.1 * c) * std::sin(0.1 * k + c));
      text += "\n";
    }
    return importRecording(folder_.write("log.csv", text.toStdString()));
  }
  static std::string meaning(const Imported& log, const QString& name) {
    for (const ColumnFate& fate : log.columns) {
      if (fate.from == name.toStdString()) return fate.kind == ColumnFate::Kind::used ? fate.to : std::string();
    }
    return "not there";
  }
  TemporaryFolder folder_;
};

void TestImportForeign::name_isUnderstood_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("to");
  const auto row = [](const char* name, const char* to) { QTest::newRow(name) << QString::fromUtf8(name) << to; };
  row("Ángulo del eje (°)", "angle_rad");
  row("Corriente del motor (A)", "current_A");
  row("Tensión de alimentación (V)", "supply_V");
  row("Par (N·m)", "torque_Nm");
  row("Intensité (A)", "current_A");
  row("coppia motrice[Nm]", "torque_Nm");
  row("corrente di quadratura[A]", "current_A");
  row("Velocidade (graus/s)", "velocity_rad_per_s");
  row("Corrente de armadura (A)", "current_A");
  row("占空比", "duty");
  row("ШИМ", "duty");
  row("задание_об_мин", "velocity_reference_rad_per_s");
  row("Угол поворота вала, град", "angle_rad");
  row("Положение, рад", "angle_rad");
  row("Położenie [deg]", "angle_rad");
  row("Prąd twornika [A]", "current_A");
  row("Napięcie zasilania [V]", "supply_V");
  row("Motor Açısı (derece)", "angle_rad");
  row("목표 각도(deg)", "angle_reference_rad");
  row("sudut_deg", "angle_rad");
  row("arus_mA", "current_A");
  row("Góc (độ)", "angle_rad");
  row("Tốc độ (vòng/phút)", "velocity_rad_per_s");
  row("Dòng điện (A)", "current_A");
  row("Curent [A]", "current_A");
  row("Γωνία (deg)", "angle_rad");
  row("ΤΑΧΥΤΗΤΑ (rpm)", "velocity_rad_per_s");
  row("Кут, град", "angle_rad");
  row("Швидкість, об/хв", "velocity_rad_per_s");
  row("Drehzahl_Ist_Upm", "velocity_rad_per_s");
  row("de la", "");
}

void TestImportForeign::name_isUnderstood() {
  QFETCH(QString, name);
  QFETCH(QString, to);
  QCOMPARE(understandName(name.toStdString()).to, to.toStdString());
}

void TestImportForeign::unknownNames_areTakenByTheirOnlyUnit() {
  const auto log = waves({"Poloha hřídele [deg]", "Zatížení vinutí [A]", "Rychlost otáčení [rpm]"});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "Zatížení vinutí [A]"), "current_A");
  for (const ColumnFate& fate : log->columns)
    QVERIFY(fate.from != QString("Zatížení vinutí [A]").toStdString() || fate.guessed);
}

void TestImportForeign::twoWithOneUnit_areKept() {
  const auto log = waves({"Rychlost otáčení [rpm]", "Zatížení vinutí [A]", "Zatížení brzdění [A]"});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "Zatížení vinutí [A]"), "");
  QCOMPARE(meaning(*log, "Zatížení brzdění [A]"), "");
}

void TestImportForeign::englishNames_areNotTakenByTheirUnit() {
  const auto log = waves({"speed [rpm]", "muscle [mV]", "leak [A]"});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "muscle [mV]"), "");
  QCOMPARE(meaning(*log, "leak [A]"), "");
}

QTEST_APPLESS_MAIN(TestImportForeign)
#include "tst_import_foreign.moc"
