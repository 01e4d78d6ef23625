#include "client/hud/connection_warning.h"

#include <gtest/gtest.h>

#include "client/hud/panel.h"
#include "formats/archives/wad.h"
#include "support/programs/small_game.h"
#include "vfs/file_system.h"

namespace temblor::client {
namespace {

base::ByteVector make_wad_with_icon() {
  const base::ByteVector icon =
      formats::write_picture({32, 32, std::vector<std::uint8_t>(32 * 32, std::uint8_t{9})});
  const std::vector<formats::WadLump> lumps = {{"net", formats::kWadPicture, icon}};
  return formats::write_wad(lumps).value();
}

class ConnectionWarning : public ::testing::Test {
 protected:
  // The number of pictures and letters that are drawn.
  std::size_t draw(const net::ServerSilence& silence) {
    render::DrawList list;
    draw_connection_warning(pictures_, silence, {}, 640, 480, list);
    return list.commands.size();
  }

  test::SmallGame data_;
  std::vector<std::string> notes_;
  assets::Pictures pictures_ = assets::Pictures::load(vfs::FileSystem::open(data_.path()).value(), notes_);
};

TEST_F(ConnectionWarning, IsNotShownInANormalGame) {
  for (const double lasts_s : {0.0, 0.1, 0.29}) EXPECT_EQ(draw({lasts_s, 300 - lasts_s}), 0u);
}

// The small game has no icon, so only the text shows.
TEST_F(ConnectionWarning, CountsDownAfterTwoSeconds) {
  EXPECT_EQ(draw({1.9, 298.1}), 0u);
  render::DrawList expected;
  const Panel panel(pictures_, expected, 640, 480, 1);
  panel.draw_text("No word from the server for 3 s", 0, 0);
  panel.draw_text("Leaving the game in 297 s", 0, 0);
  EXPECT_EQ(draw({3, 297}), expected.commands.size());
}

TEST_F(ConnectionWarning, ShowsTheIconOfTheGame) {
  data_.folder().write("id1/gfx.wad", make_wad_with_icon());
  pictures_ = assets::Pictures::load(vfs::FileSystem::open(data_.path()).value(), notes_);
  EXPECT_EQ(draw({0.2, 299.8}), 0u);
  EXPECT_EQ(draw({0.4, 299.6}), 1u);
}

}  // namespace
}  // namespace temblor::client
