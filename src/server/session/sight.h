// What can be seen from a player's eye: the PVS, made wide enough that a client that predicts or blends never
// misses something at an edge.
#pragma once

#include <cstdint>
#include <vector>

#include "server/game/edicts.h"
#include "world/level.h"

namespace temblor::server {

class Sight {
 public:
  // Of every leaf within kFat units of the eye, all that it sees; everything from an eye outside of the
  // level. Keeps its memory.
  static constexpr double kFat_units = 8;
  void look(const world::Level& level, const math::Vec3& eye);

  bool sees(const EdictState& state) const;
  // A place inside of something solid is taken for seen.
  bool sees(const world::Level& level, const math::Vec3& place) const;

 private:
  std::vector<std::uint8_t> row_, one_;
  std::vector<world::Child> to_visit_;
};

}  // namespace temblor::server
