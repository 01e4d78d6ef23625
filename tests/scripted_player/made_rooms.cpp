#include "scripted_player/made_rooms.h"

#include "artgen/palette.h"
#include "compiler/build_file.h"
#include "compiler/compile_level.h"
#include "formats/images/palette.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"

namespace temblor::test {

MadeRooms::MadeRooms(const std::string& map_text, compiler::StagePolicy visibility) {
  base::Jobs jobs(1, base::JobBackend::kStdThread);
  compiler::CompileOptions options;
  options.light_policy = compiler::StagePolicy::kSkip;
  options.visibility_policy = visibility;
  compiler::CompileWatcher nobody;
  compiler::Warnings warnings;
  compiler::Build build;
  const compiler::CompileReport report =
      compiler::compile_level({parse_map(map_text), {}, artgen::make_palette()}, options,
                              {jobs, nobody, warnings}, build)
          .value();
  CHECK(!report.leak);
  folder_.write("id1/gfx/palette.lmp", formats::write_palette(artgen::make_palette()));
  folder_.write("id1/progs.dat", read_file(TEMBLOR_GAME_PROGRAM));
  folder_.write("id1/maps/rooms.bsp", formats::write_bsp(build.bsp, formats::BspVersion::k29).value());
}

player::RunSetup MadeRooms::setup() const {
  player::RunSetup setup;
  setup.session.base_folder = folder_.path();
  setup.session.map = "rooms";
  setup.limit_s = 120;
  return setup;
}

std::string exit_text(const math::Vec3& mins, const math::Vec3& maxs) {
  return entity_text("trigger_changelevel", "\"map\" \"elsewhere\"", box_text(mins, maxs, "trigger"));
}

}  // namespace temblor::test
