#include "survey_report.h"

#include <numbers>

#include "polar_views.h"
#include "report/html_report.h"

namespace breakaway {

namespace {

std::string estimateText(const Estimate& estimate, double scale, const std::string& unit) {
  return numberText(scale * estimate.value) + " " + unit + ", 95 % interval " + numberText(scale * estimate.low95()) +
         " to " + numberText(scale * estimate.high95()) + " " + unit;
}

void addMotor(HtmlReport& report, const IdentifiedMotor& motor) {
  report.heading("The motor");
  report.facts({{"Torque constant", estimateText(motor.torqueConstant_Nm_per_A, 1.0, "Nm/A") +
                                        (motor.torqueConstantTrusted ? " (trusted, from the bench file)"
                                                                     : " (tied to the back-EMF constant)")},
                {"Back-EMF constant", estimateText(motor.backEmfConstant_V_s_per_rad, 1.0, "V s/rad")},
                {"Resistance", estimateText(motor.resistance_ohm, 1.0, "ohm")},
                {"Inductance", estimateText(motor.inductance_H, 1e3, "mH")},
                {"Inertia", estimateText(motor.inertia_kg_m2, 1e7, "g cm²")},
                {"Bridge's dead zone", estimateText(motor.deadZone_V, 1e3, "mV")}});
}

void addAverages(HtmlReport& report, const FrictionSurvey& survey) {
  std::vector<std::pair<std::string, std::string>> rows;
  if (const auto coulomb = survey.coulombAverage_Nm())
    rows.emplace_back("Coulomb friction, mean of both ways", estimateText(*coulomb, 1e3, "mNm"));
  if (const auto viscous = survey.viscousAverage_Nm_s_per_rad()) {
    rows.emplace_back("Viscous coefficient, mean of both ways", estimateText(*viscous, 1e6, "µNm s/rad"));
  }
  if (survey.map && survey.map->turns > 1) {
    for (const auto& [way, name] : {std::pair{Way::ccw, "counter-clockwise"}, std::pair{Way::cw, "clockwise"}}) {
      const Repeatability& repeat = survey.map->repeatability[static_cast<size_t>(way)];
      rows.emplace_back(std::string("Consecutive turns, ") + name,
                        "correlate by " + numberText(repeat.correlation, 3) + " and differ by " +
                            numberText(1e3 * repeat.rmsDifference_Nm, 3) + " mNm rms");
    }
  }
  if (!rows.empty()) {
    report.heading("Averages");
    report.facts(rows);
  }
}

void addPicture(HtmlReport& report, PolarView view, const FrictionSurvey& survey) {
  if (!obstacleTo(view, survey).isEmpty()) return;
  const PolarPicture picture = pictureOf(view, survey);
  Figure figure;
  figure.title = nameOf(view).toStdString();
  figure.yLabel = picture.quantity.toStdString();
  figure.polar = true;
  for (const PolarCurve& curve : picture.curves) {
    Curve drawn;
    drawn.label = curve.name.toStdString();
    drawn.style = curve.dashed ? Curve::Style::dashed : Curve::Style::line;
    drawn.colour = curve.colour;
    for (const PolarPoint& point : curve.points) {
      drawn.x.push_back(point.angle_rad);
      drawn.y.push_back(point.value);
    }
    if (curve.closed && !curve.points.empty()) {
      drawn.x.push_back(drawn.x.front() + 2.0 * std::numbers::pi);
      drawn.y.push_back(drawn.y.front());
    }
    figure.curves.push_back(std::move(drawn));
  }
  report.figure(figure, {}, 620, 560);
}

}  // namespace

Result<void> writeSurveyReport(const FrictionSurvey& survey, const Identity& identity, const std::string& path) {
  if (!survey.identification) return Error{path, "nothing was measured yet"};
  HtmlReport report("Friction around the rotor",
                    survey.rig + ", " + identity.device + ", firmware " + identity.firmware);
  if (identity.simulated) report.paragraph("The board and its motor were simulated.");
  addAverages(report, survey);
  report.heading("Around the rotor");
  report.paragraph("Angles count from the encoder's index and grow counter-clockwise.");
  if (!survey.sweepComplete && !survey.events.empty()) {
    report.paragraph("The breakaway sweep was stopped before its end: " + std::to_string(survey.events.size()) +
                     " of " + std::to_string(2 * survey.bins * survey.turns) + " breakaways were measured.");
  }
  for (const PolarView view :
       {PolarView::turns, PolarView::staticMean, PolarView::coulomb, PolarView::viscous, PolarView::positionTorque}) {
    addPicture(report, view, survey);
  }
  addMotor(report, survey.identification->motor);
  return report.write(path);
}

}  // namespace breakaway
