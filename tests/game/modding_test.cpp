// The files of docs/modding.md, compiled and played.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "game/room_level.h"
#include "support/game_data.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;
namespace field = server::field;

const std::filesystem::path kSources = TEMBLOR_SOURCE_DIR;

// The page's first code block that starts with this line, without the line.
std::string block(std::string_view opening) {
  const base::ByteVector bytes = read_file(kSources / "docs/modding.md");
  const std::string_view page = base::as_text(bytes);
  const std::size_t begin = page.find(opening);
  CHECK(begin != std::string_view::npos, "{}", opening);
  const std::size_t text = page.find('\n', begin) + 1;
  return std::string(page.substr(text, page.find("```", text) - text));
}

TEST(ModdingPage, ItsWeaponAndRoomWork) {
  SKIP_WITHOUT_QUAKEC();
  const base::ByteVector map = read_file(kSources / "docs/examples/skipping_room.map");
  const RoomData data{std::string(base::as_text(map))};
  const std::filesystem::path mod = data.path() / "skipper";
  data.folder().write("skipper/skipper.qc", block("```c\n"));
  data.folder().write("skipper/progs.src", block("```\nprogs.dat\n"));
  std::filesystem::copy(kSources / "game/quakec", mod / "quakec", std::filesystem::copy_options::recursive);
  const std::string compile = fmt::format(
      "cd {} && fteqcc > compile.txt && tail -n 1 compile.txt | grep -qx '0 warnings'", mod.string());
  ASSERT_EQ(std::system(compile.c_str()), 0);

  PlayedLevel game(data.path(), "room", mod / "progs.dat");
  EXPECT_THAT(game.unknown_classes(), IsEmpty());
  game.join(0);
  game.run(1);
  game.player(0).set_flag(server::flag::kGodMode);
  game.player(0).set(field::kImpulse, 110);
  game.run(0.5);
  EXPECT_THAT(game.of_class("skipper"), IsEmpty());  // nobody has one yet
  game.put(game.player(0), {256, 192, 48});
  game.run(0.5);
  EXPECT_EQ(game.edict_number(1, "skippers"), 5);
  game.put(game.player(0), {128, 192, 25});
  game.player(0).set(field::kImpulse, 110);
  game.run(0.2);
  EXPECT_THAT(game.of_class("skipper"), SizeIs(1));
  EXPECT_EQ(game.edict_number(1, "skippers"), 4);
  std::size_t most_nails = 0;
  for (int i = 0; i < 144; ++i) {
    game.tick();
    most_nails = std::max(most_nails, game.of_class("nail").size());
  }
  EXPECT_EQ(most_nails, 16u);
  EXPECT_THAT(game.of_class("skipper"), IsEmpty());
  EXPECT_THAT(game.errors(), IsEmpty());
}

}  // namespace
}  // namespace temblor::test
