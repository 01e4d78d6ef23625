#include "app/compile/compile_program.h"

#include <random>

#include "app/program.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"

namespace temblor::test {

std::string lit_room() {
  return entity_text("worldspawn", "\"message\" \"A room\"",
                     walls_text({-128, -128, 0}, {128, 128, 128}, "wall")) +
         point_text("info_player_start", {0, 0, 32}) +
         entity_text("light", "\"origin\" \"64 64 96\"\n\"_color\" \"1 0.5 0.25\"");
}

std::string hall_of_pillars(int side) {
  const double width = side * 64;
  std::string brushes = walls_text({0, 0, 0}, {width, width, 128}, "wall");
  std::mt19937 random(1);
  const auto shift = [&] { return static_cast<double>(random() % 16); };
  for (int i = 0; i < side * side; ++i) {
    const math::Vec3d at(i % side * 64 + 16 + shift(), i / side * 64 + 16 + shift(), 0);
    brushes += box_text(at, at + math::Vec3d(16, 16, 128), "pillar");
  }
  return entity_text("worldspawn", "", brushes) + point_text("info_player_start", {8, 8, 40});
}

formats::Bsp CompileProgram::read_level(const std::string& name) {
  const base::ByteVector bytes = read_file(folder_.path() / name);
  return formats::read_bsp(bytes).value();
}

}  // namespace temblor::test
