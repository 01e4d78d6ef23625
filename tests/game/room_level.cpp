#include "game/room_level.h"

#include "compiler/drafts.h"
#include "formats/levels/bsp.h"
#include "game/program_file.h"

namespace temblor::test {

RoomData::RoomData(const std::string& map_text, HasTremor has_tremor, LevelFor level_for) {
  const bool half_life = level_for == LevelFor::kHalfLife;
  compiler::DraftResult result = compile_draft(map_text, {.half_life = half_life});
  CHECK(!result.leak, "the room leaks");
  for (formats::BspMiptex& texture : result.draft.bsp.miptexes) texture.name.clear();
  const auto version = half_life ? formats::BspVersion::k30 : formats::BspVersion::k29;
  folder_.write("id1/maps/room.bsp", formats::write_bsp(result.draft.bsp, version).value());
  const ProgramFile game = read_program_file(std::filesystem::path(TEMBLOR_GAMES) / "id1/progs.dat");
  for (const std::string& name : game.strings) {
    const bool is_model = name.starts_with("progs/") && (name.ends_with(".mdl") || name.ends_with(".spr"));
    const bool is_left_out = name.find("tremor") != std::string::npos && has_tremor == HasTremor::kNo;
    if (is_model && !is_left_out) folder_.write("id1/" + name, "a server asks only whether it is there");
  }
}

std::string hall_text(const math::Vec3d& mins, const math::Vec3d& maxs, const std::string& brushes,
                      const std::string& entities) {
  const math::Vec3d start(mins.x + 64, (mins.y + maxs.y) / 2, maxs.z - 40),
      other(maxs.x - 64, start.y, start.z);
  return entity_text("worldspawn", "", walls_text(mins, maxs, "wall") + brushes) +
         point_text("info_player_start", start) + point_text("info_player_deathmatch", start) +
         point_text("info_player_deathmatch", other) + entities;
}

}  // namespace temblor::test
