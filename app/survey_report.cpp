#include "survey_report.h"

#include <numbers>

#include "draw/html_report.h"
#include "widgets/axis_units.h"
#include "widgets/map_views.h"

namespace breakaway {

namespace {

std::string estimateText(const Estimate& estimate, double scale, const std::string& unit) {
  return numberText(scale * estimate.value) + " " + unit + ", 95 % interval " + numberText(scale * estimate.low95()) +
         " to " + numberText(scale * estimate.high95()) + " " + unit;
}

void addMotor(HtmlReport& report, const IdentifiedMotor& motor, Axis axis) {
  const AxisUnits units = unitsOf(axis);
  const bool linear = axis == Axis::linear;
  report.heading("The motor");
  report.facts(
      {{linear ? "Force constant" : "Torque constant",
        estimateText(motor.torqueConstant_Nm_per_A, 1.0, units.constant.toStdString()) +
            (motor.torqueConstantTrusted ? " (trusted, from the bench file)" : " (tied to the back-EMF constant)")},
       {"Back-EMF constant", estimateText(motor.backEmfConstant_V_s_per_rad, 1.0, units.backEmf.toStdString())},
       {"Resistance", estimateText(motor.resistance_ohm, 1.0, "ohm")},
       {"Inductance", estimateText(motor.inductance_H, 1e3, "mH")},
       {linear ? "Mass" : "Inertia",
        estimateText(motor.inertia_kg_m2, units.inertiaScale, units.inertia.toStdString())},
       {"Bridge's dead zone", estimateText(motor.deadZone_V, 1e3, "mV")}});
}

void addAverages(HtmlReport& report, const FrictionSurvey& survey) {
  const AxisUnits units = unitsOf(survey.axis);
  std::vector<std::pair<std::string, std::string>> rows;
  if (const auto coulomb = survey.coulombAverage_Nm())
    rows.emplace_back("Coulomb friction, mean of both ways",
                      estimateText(*coulomb, units.torqueScale, units.torque.toStdString()));
  if (const auto viscous = survey.viscousAverage_Nm_s_per_rad())
    rows.emplace_back("Viscous coefficient, mean of both ways",
                      estimateText(*viscous, units.viscousScale, units.viscous.toStdString()));
  if (survey.map && survey.map->turns > 1) {
    const std::string repeats = survey.axis == Axis::linear ? "Consecutive passes, " : "Consecutive turns, ";
    for (const Way way : {Way::ccw, Way::cw}) {
      const Repeatability& repeat = survey.map->repeatability[static_cast<size_t>(way)];
      rows.emplace_back(repeats + wayName(way, survey.axis).toStdString(),
                        "correlate by " + numberText(repeat.correlation, 3) + " and differ by " +
                            numberText(units.torqueScale * repeat.rmsDifference_Nm, 3) + " " +
                            units.torque.toStdString() + " rms");
    }
  }
  if (!rows.empty()) {
    report.heading("Averages");
    report.facts(rows);
  }
}

/// Around the rotor a closed curve, over a travel one with its band.
Curve drawnCurve(const MapCurve& curve, Axis axis) {
  Curve drawn;
  drawn.label = curve.name.toStdString();
  drawn.style = curve.dashed ? Curve::Style::dashed : Curve::Style::line;
  drawn.colour = curve.colour;
  for (const MapPoint& point : curve.points) {
    drawn.x.push_back(axis == Axis::linear ? 1e3 * point.at : point.at);
    drawn.y.push_back(point.value);
    if (axis != Axis::linear || !(point.standardError > 0.0)) continue;
    drawn.low.push_back(point.value - 1.96 * point.standardError);
    drawn.high.push_back(point.value + 1.96 * point.standardError);
  }
  if (drawn.low.size() != drawn.x.size()) drawn.low.clear(), drawn.high.clear();
  if (axis == Axis::rotary && curve.closed && !curve.points.empty()) {
    drawn.x.push_back(drawn.x.front() + 2.0 * std::numbers::pi);
    drawn.y.push_back(drawn.y.front());
  }
  return drawn;
}

void addPicture(HtmlReport& report, MapView view, const FrictionSurvey& survey) {
  if (!obstacleTo(view, survey).isEmpty()) return;
  const MapPicture picture = pictureOf(view, survey);
  Figure figure;
  figure.title = nameOf(view, survey.axis).toStdString();
  figure.yLabel = picture.quantity.toStdString();
  figure.polar = survey.axis == Axis::rotary;
  if (!figure.polar) figure.xLabel = "position from the index (mm)";
  for (const MapCurve& curve : picture.curves) figure.curves.push_back(drawnCurve(curve, survey.axis));
  if (figure.polar) {
    report.figure(figure, {}, 620, 560);
  } else {
    report.figure(figure);
  }
}

}  // namespace

Result<void> writeSurveyReport(const FrictionSurvey& survey, const Identity& identity, const std::string& path) {
  if (!survey.identification) return Error{path, "nothing was measured yet"};
  const bool linear = survey.axis == Axis::linear;
  HtmlReport report(linear ? "Friction over the travel" : "Friction around the rotor",
                    survey.rig + ", " + identity.device + ", firmware " + identity.firmware);
  if (identity.simulated) report.paragraph("The board and its motor were simulated.");
  addAverages(report, survey);
  report.heading(linear ? "Over the travel" : "Around the rotor");
  report.paragraph(
      linear ? "Positions count from the encoder's index, or from the lower end where there is none; forwards "
               "is growing position."
             : "Angles count from the encoder's index and grow counter-clockwise.");
  if (!survey.sweepComplete && !survey.events.empty()) {
    report.paragraph("The breakaway sweep was stopped before its end: " + std::to_string(survey.events.size()) +
                     " of " + std::to_string(2 * survey.bins * survey.turns) + " breakaways were measured.");
  }
  for (const MapView view :
       {MapView::turns, MapView::staticMean, MapView::coulomb, MapView::viscous, MapView::positionTorque}) {
    addPicture(report, view, survey);
  }
  addMotor(report, survey.identification->motor, survey.axis);
  return report.write(path);
}

}  // namespace breakaway
