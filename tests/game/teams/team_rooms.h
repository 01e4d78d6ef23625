// A hall with both flags and the starts of both teams, for tests of team games.
#pragma once

#include <string>

#include "game/room_level.h"

namespace temblor::test {

// Teams: the color of the pants plus one. The palettes of the shipped game and of stock data differ.
constexpr float kRed = 5, kBlue = 9, kStockBlue = 14;
constexpr std::uint32_t kTeamPlaces = 8;
inline const math::Vec3 kRedBase(100, 0, 24), kBlueBase(1500, 0, 24);

// A wall in the middle with a gap at each side separates the bases.
inline std::string team_hall_text() {
  std::string entities =
      point_text("item_flag_team1", {100, 0, 16}) + point_text("item_flag_team2", {1500, 0, 16});
  for (const double y : {-300.0, -200.0, 200.0, 300.0})
    entities += point_text("info_player_team1", {150, y, 32}) +
                point_text("info_player_team2", {1450, y, 32}) +
                point_text("info_player_deathmatch", {y + 700, y, 32});
  return hall_text({0, -400, 0}, {1600, 400, 256}, box_text({780, -250, 0}, {820, 250, 256}, "wall"),
                   entities);
}

inline PlayedLevel begin_team_game(const RoomData& data, const std::string& teamplay) {
  return PlayedLevel(
      data.path(), "room", kProgs,
      {.kind = server::GameKind::kDeathmatch, .players = kTeamPlaces, .rules = {{"teamplay", teamplay}}});
}

}  // namespace temblor::test
