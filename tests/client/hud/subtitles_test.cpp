#include "client/hud/subtitles.h"

#include <gtest/gtest.h>

#include "support/programs/small_game.h"
#include "vfs/file_system.h"

namespace temblor::client {
namespace {

TEST(Subtitles, CaptionsAreMadeFromFileNames) {
  EXPECT_EQ(make_caption("soldier/sight1.wav"), "soldier sight");
  EXPECT_EQ(make_caption("doors/drclos4.wav"), "doors drclos");
  EXPECT_EQ(make_caption("misc/r_tele3.wav"), "misc r tele");
  EXPECT_EQ(make_caption("123.wav"), "");
  EXPECT_EQ(make_caption(""), "");
  EXPECT_LE(make_caption(std::string(5000, 'a')).size(), 32u);
}

// The camera looks along +x; +y is to the left.
TEST(Subtitles, SidesSayWhereToTurn) {
  render::Camera camera;
  EXPECT_EQ(find_sound_side({100, 0, 0}, camera), SoundSide::kSeen);
  EXPECT_EQ(find_sound_side({100, 99, 0}, camera), SoundSide::kSeen);
  EXPECT_EQ(find_sound_side({100, 101, 0}, camera), SoundSide::kLeft);
  EXPECT_EQ(find_sound_side({0, -50, 0}, camera), SoundSide::kRight);
  EXPECT_EQ(find_sound_side({-100, 10, 0}, camera), SoundSide::kBehind);
  camera.angles_deg.y = 180;
  EXPECT_EQ(find_sound_side({100, 0, 0}, camera), SoundSide::kBehind);
}

TEST(Subtitles, ShowUnseenSoundsForTwoSeconds) {
  const test::SmallGame data;
  std::vector<std::string> notes;
  const auto pictures = assets::Pictures::load(vfs::FileSystem::open(data.path()).value(), notes);
  Game game;
  game.sounds = {"", "dog/dsight.wav", "player/pain1.wav"};
  game.view_entity = 1;
  Subtitles subtitles;
  const auto commands = [&] {
    render::DrawList list;
    subtitles.draw(pictures, 640, 480, 1, list);
    return list.commands.size();
  };
  Events events;
  const auto sound = [&](std::uint16_t entity, std::uint16_t number, const math::Vec3& place) {
    net::Sound what;
    what.entity = entity;
    what.sound = number;
    what.origin = place;
    events.sounds.push_back(what);
  };
  sound(5, 1, {200, 0, 0});    // in view
  sound(1, 2, {-10, 0, 0});    // the player's own
  sound(6, 1, {-2000, 0, 0});  // too far
  sound(7, 99, {-10, 0, 0});   // not in the list
  subtitles.advance(game, events, {}, 10);
  EXPECT_EQ(commands(), 0u);
  events.sounds.clear();
  sound(5, 1, {-200, 0, 0});
  sound(8, 1, {-200, 5, 0});  // the same caption is shown once
  subtitles.advance(game, events, {}, 10);
  EXPECT_EQ(commands(), 1 + std::string("vdogdsightv").size());
  events.sounds.clear();
  subtitles.advance(game, events, {}, 11.9);
  EXPECT_GT(commands(), 0u);
  subtitles.advance(game, events, {}, 12.1);
  EXPECT_EQ(commands(), 0u);
}

}  // namespace
}  // namespace temblor::client
