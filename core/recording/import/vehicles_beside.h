// Which columns are a vehicle's or a robot's as a whole, beside those of the motors that move it.
#pragma once

#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Whether a brake, a gear, a state of charge or an odometer stands in the table.
bool isOfVehicle(const RawTable& table);

/// Whether it tells how far something went or where on earth it is.
bool tellsVehiclesWay(const RawTable& table);
/// A speed beside a motor's in such a table.
void setVehiclesSpeedAside(const RawTable& table, std::vector<Choice>& choices);
/// Linear speeds beside a rotary motion.
void setVehiclesAside(std::vector<Choice>& choices);
/// How far it went, beside wheels of either side.
void setVehiclesWayAside(const RawTable& table, std::vector<Choice>& choices);
/// Places in space and a steering, beside a motor's speed.
void setPlacesAside(const RawTable& table, std::vector<Choice>& choices);
/// How it turns and where it heads, beside its place.
void setTurningAside(const RawTable& table, std::vector<Choice>& choices);
/// Where a vehicle stands in a plane.
void setPlanesAside(const RawTable& table, std::vector<Choice>& choices);
/// A pendulum beside what moves it.
void setHangingAside(const RawTable& table, std::vector<Choice>& choices);
/// How far it leans, beside a gyro and an acceleration.
void setTiltAside(const RawTable& table, std::vector<Choice>& choices);
/// Quaternions, and directions in space.
void setVectorsAside(const RawTable& table, std::vector<Choice>& choices);
/// What says nothing of whose it is, beside a wheel's or a cart's own position and speed.
void preferWheelsAndCarts(const RawTable& table, std::vector<Choice>& choices);

}  // namespace breakaway
