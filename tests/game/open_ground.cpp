#include "game/open_ground.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace temblor::test {
namespace {

namespace field = server::field;

std::optional<float> open_direction(PlayedLevel& io_game) {
  const math::Vec3 above = io_game.player(0)[field::kOrigin] + math::Vec3(0, 0, 4);
  for (float yaw = 0; yaw < 360; yaw += 11.25f) {
    bool is_open = true;
    for (float way = 80; way <= kOpenGround + 40; way += 40)
      is_open = is_open && io_game.has_room(above + yaw_direction(yaw) * way, {-34, -34, -24}, {34, 34, 64});
    if (is_open) return yaw;
  }
  return std::nullopt;
}

}  // namespace

math::Vec3 yaw_direction(float yaw_deg) {
  const float angle = yaw_deg * std::numbers::pi_v<float> / 180;
  return {std::cos(angle), std::sin(angle), 0};
}

float take_a_stand(PlayedLevel& io_game) {
  for (const std::uint32_t start : io_game.of_class("info_player_deathmatch")) {
    io_game.put(io_game.player(0), io_game.edict(start)[field::kOrigin]);
    io_game.run(0.3);
    if (const auto yaw = open_direction(io_game)) return *yaw;
  }
  CHECK(false, "nowhere is there room");
}

}  // namespace temblor::test
