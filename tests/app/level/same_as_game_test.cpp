// `temblor render --map --entities` shows the level as the game does, to the pixel.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/program.h"
#include "client_server/served_game.h"
#include "formats/images/png.h"
#include "formats/levels/entities.h"
#include "host/headless_host.h"
#include "host/session/session.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

constexpr std::string_view kWallsAndProps = R"(
void() func_wall = { self.solid = 4; self.movetype = 7; setmodel(self, self.model); };
void() prop = { setmodel(self, "progs/player.mdl"); };
)";

// A start in the court with its sky and pool, and entities of several games, in translucent water and fog.
formats::Bsp make_court() {
  formats::Bsp bsp = artgen::make_small_level({.colored_light = true});
  std::vector<formats::Entity> entities = formats::read_entities(bsp.entities).value();
  std::erase_if(entities,
                [](const formats::Entity& entity) { return entity.classname() == "info_player_start"; });
  entities[0].pairs.insert(entities[0].pairs.end(), {{"fog", "0.05 0.5 0.25 0.125"}, {"wateralpha", "0.5"}});
  const auto add = [&](std::vector<std::pair<std::string, std::string>> keys) {
    entities.push_back({std::move(keys)});
  };
  add({{"classname", "info_player_start"}, {"origin", "1000 560 -90"}, {"angle", "315"}});
  add({{"classname", "func_wall"}, {"model", "*1"}, {"origin", "500 0 -128"}});
  add({{"classname", "func_wall"}, {"model", "*1"}, {"origin", "400 0 -128"}, {"spawnflags", "1792"}});
  add({{"classname", "prop"}, {"origin", "1300 300 -250"}});
  add({{"classname", "prop"}, {"origin", "1300 100 -150"}, {"spawnflags", "512"}});
  bsp.entities = formats::write_entities(entities);
  return bsp;
}

TEST(SameAsGame, ToThePixel) {
  SKIP_WITHOUT_QUAKEC();
  constexpr platform::PixelSize size{320, 200};
  HeadlessHost game({"viewsize 120; r_drawviewmodel 0; crosshair 0; con_notifytime 0"}, size);
  game.folder().write("id1/progs.dat", compile_quakec(small_program(kWallsAndProps)));
  game.folder().write("id1/maps/small.bsp",
                      formats::write_bsp(make_court(), formats::BspVersion::k29).value());
  game.command("map small");
  ASSERT_TRUE(game.run_until_playing());
  game.run(2);

  // The same moment, for liquids, sky, and flickering light.
  const std::string time = fmt::format("{}", game.session().time_s());
  const std::vector<std::string> words = {
      "render", "--map", "small", "--entities", "--size", fmt::format("{}x{}", size.width, size.height),
      "--time", time,    "-o",    "x.png"};
  const ProgramRun drawn = run_program(game.folder().path(), words);
  ASSERT_EQ(drawn.exit_status, 0) << drawn.err;
  const Png picture = read_png(game.folder().path() / "x.png");
  EXPECT_GT(count_colors(picture), 1000u);

  Png shown = picture;
  shown.rgb.clear();
  for (const std::uint32_t pixel : game.window().shown())
    for (const int shift : {16, 8, 0}) shown.rgb.push_back(static_cast<std::uint8_t>(pixel >> shift));
  EXPECT_EQ(shown, picture);
}

}  // namespace
}  // namespace temblor::test
