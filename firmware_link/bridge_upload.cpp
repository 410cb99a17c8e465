#include "firmware_link/bridge_upload.h"

#include <string>

namespace breakaway {

Result<void> uploadBridge(BoardLink& link, const DutyCurve& curve) {
  constexpr std::size_t most = wire::BridgeCurve::mostPoints;
  if (curve.points.size() > most)
    return Error{"bridge's curve", message("has {} points, the board holds at most {}", curve.points.size(), most)};
  if (!curve.rises()) return Error{"bridge's curve", message("doesn't rise, expected a strictly rising one")};
  wire::BridgeCurve wanted;
  for (const DutyPoint& point : curve.points)
    wanted.point[wanted.count++] = {static_cast<float>(point.input), static_cast<float>(point.output.value)};
  if (auto taken = link.ask<wire::BridgeCurve>(wire::Type::writeBridge, wanted); !taken) return taken.error();
  const auto back = link.ask<wire::BridgeCurve>(wire::Type::readBridge);
  if (!back) return back.error();
  if (bodyOf(*back) != bodyOf(wanted))
    return Error{link.place(), message("holds another curve of its bridge than was written")};
  return {};
}

}  // namespace breakaway
