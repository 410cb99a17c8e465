// What the polar plot can show of a survey: views by name, each a set of curves with its unit.
#pragma once

#include <QString>
#include <vector>

#include "friction_survey.h"
#include "widgets/polar_plot.h"

namespace breakaway {

enum class PolarView { turns, staticMean, coulomb, viscous, total, positionTorque };

struct PolarPicture {
  std::vector<PolarCurve> curves;
  QString quantity;  ///< of the radius, with its unit
  QString unit;
};

QString nameOf(PolarView view);
/// Why the view has nothing to show yet; empty when it has.
QString obstacleTo(PolarView view, const FrictionSurvey& survey);
/// Torques in mNm, viscous friction in µNm s/rad.
PolarPicture pictureOf(PolarView view, const FrictionSurvey& survey);

}  // namespace breakaway
