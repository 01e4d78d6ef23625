// Finds the leaves that a player can see: the PVS of all leaves near its eye. The margin makes sure that a
// client that predicts or interpolates positions never misses something at the edge of a leaf.
#pragma once

#include <cstdint>
#include <vector>

#include "server/game/edicts.h"
#include "world/level.h"

namespace temblor::server {

class Sight {
 public:
  // Collects what is visible from each leaf within kFat_units of the eye. From outside the level everything
  // is visible.
  static constexpr double kFat_units = 8;
  void update(const world::Level& level, const math::Vec3& eye);

  bool sees(const EdictState& state) const;
  // A place inside something solid counts as visible.
  bool sees(const world::Level& level, const math::Vec3& place) const;

 private:
  // One bit per leaf: the union of the PVS, and the PVS of one leaf while it is computed.
  std::vector<std::uint8_t> row_, one_;
  std::vector<world::Child> to_visit_;
};

}  // namespace temblor::server
