// Results as batch writes them, as text.
#pragma once

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <string>

namespace breakaway::test {

inline QJsonObject withInterval(double value, double half) {
  return {{"value", value}, {"ci95", QJsonArray{value - half, value + half}}};
}

inline std::string lineOf(const QJsonObject& result) {
  return QJsonDocument(result).toJson(QJsonDocument::Compact).toStdString() + "\n";
}

/// A diagnosis of one base parameter, of nothing missing.
inline QJsonObject diagnosisOf(double coulomb_Nm, double half_Nm, const QString& at = "2026-03-02T09:14:07Z") {
  return {{"schema", "breakaway.diagnosis/1"},
          {"verdict", "nothing_missing"},
          {"findings", QJsonArray()},
          {"base", QJsonObject{{"coulomb_Nm", withInterval(coulomb_Nm, half_Nm)}}},
          {"wander", QJsonObject{{"rms_Nm", 1e-4}}},
          {"fit",
           QJsonObject{{"channel", "angle_rad"},
                       {"floor", 0.001},
                       {"heldout",
                        QJsonObject{{"before", 0.02}, {"after", 0.02}, {"improvement_ci95", QJsonArray{0.0, 0.0}}}}}},
          {"made", QJsonObject{{"at", at}}}};
}

inline QJsonObject resultOf(const QString& id, const QJsonObject& diagnosis) {
  return {{"id", id}, {"diagnosis", diagnosis}};
}

/// Entries around 0.02 Nm, and one of `coulomb_Nm` with half an interval of `half_Nm` in their midst.
inline std::string fleetWithOne(double coulomb_Nm, double half_Nm, int others = 20) {
  std::string text;
  for (int k = 0; k < others; ++k) {
    if (k == others / 2) text += lineOf(resultOf("odd", diagnosisOf(coulomb_Nm, half_Nm)));
    text += lineOf(resultOf("axis " + QString::number(k), diagnosisOf(0.02 + 2e-4 * (k % 5 - 2), 2e-4)));
  }
  return text;
}

}  // namespace breakaway::test
