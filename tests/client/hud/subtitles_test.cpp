#include "client/hud/subtitles.h"

#include <gtest/gtest.h>

#include "support/programs/small_game.h"
#include "vfs/file_system.h"

namespace temblor::client {
namespace {

TEST(Subtitles, CaptionsAreTheWordsOfTheFile) {
  EXPECT_EQ(caption_of("soldier/sight1.wav"), "soldier sight");
  EXPECT_EQ(caption_of("doors/drclos4.wav"), "doors drclos");
  EXPECT_EQ(caption_of("misc/r_tele3.wav"), "misc r tele");
  EXPECT_EQ(caption_of("123.wav"), "");
  EXPECT_EQ(caption_of(""), "");
  EXPECT_LE(caption_of(std::string(5000, 'a')).size(), 32u);
}

// Looking along +x: left of it is +y.
TEST(Subtitles, SidesAreWhereToTurn) {
  render::Camera camera;
  EXPECT_EQ(side_of({100, 0, 0}, camera), SoundSide::kSeen);
  EXPECT_EQ(side_of({100, 99, 0}, camera), SoundSide::kSeen);
  EXPECT_EQ(side_of({100, 101, 0}, camera), SoundSide::kLeft);
  EXPECT_EQ(side_of({0, -50, 0}, camera), SoundSide::kRight);
  EXPECT_EQ(side_of({-100, 10, 0}, camera), SoundSide::kBehind);
  camera.angles_deg.y = 180;
  EXPECT_EQ(side_of({100, 0, 0}, camera), SoundSide::kBehind);
}

TEST(Subtitles, ShowWhatIsHeardAndNotSeenForTwoSeconds) {
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
  sound(5, 1, {200, 0, 0});    // seen
  sound(1, 2, {-10, 0, 0});    // his own
  sound(6, 1, {-2000, 0, 0});  // too far
  sound(7, 99, {-10, 0, 0});   // nothing of the list
  subtitles.advance(game, events, {}, 10);
  EXPECT_EQ(commands(), 0u);
  events.sounds.clear();
  sound(5, 1, {-200, 0, 0});
  sound(8, 1, {-200, 5, 0});  // the same words once
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
