#include "client/subtitles/subtitles.h"

#include <gtest/gtest.h>

#include "assets/captions.h"
#include "client/subtitles/stock_captions.h"
#include "support/game_data.h"
#include "support/programs/small_game.h"
#include "vfs/file_system.h"

namespace temblor::client {
namespace {

TEST(Subtitles, UnknownSoundsAreCalledByTheirFileNames) {
  EXPECT_EQ(make_caption({}, "gug/roar2.wav"), "gug roar");
  EXPECT_EQ(make_caption({}, "Mod/Big_Bell3.wav"), "mod big bell");
  EXPECT_EQ(make_caption({}, "123.wav"), "");
  EXPECT_EQ(make_caption({}, ""), "");
  EXPECT_LE(make_caption({}, std::string(5000, 'a')).size(), 32u);
}

TEST(Subtitles, StockSoundsAreDescribed) {
  EXPECT_EQ(make_caption({}, "dog/dattack1.wav"), "dog snarls");
  EXPECT_EQ(make_caption({}, "DOG/Dattack1.wav"), "dog snarls");
  EXPECT_EQ(make_caption({}, "weapons/sgun1.wav"), "rocket launcher fires");
  EXPECT_EQ(make_caption({}, "player/land.wav"), "player lands");
  EXPECT_EQ(make_caption({}, "player/land2.wav"), "player lands hard");
  EXPECT_EQ(make_caption({}, "misc/null.wav"), "") << "silence";
}

TEST(Subtitles, CaptionsOfTheGameComeFirst) {
  const formats::Captions captions{{{"dog/dattack1.wav", "hound snaps"}, {"dog/idle.wav", ""}}, {}};
  EXPECT_EQ(make_caption(captions, "dog/dattack1.wav"), "hound snaps");
  EXPECT_EQ(make_caption(captions, "dog/idle.wav"), "");
  EXPECT_EQ(make_caption(captions, "dog/ddeath.wav"), "dog dies");
}

TEST(Subtitles, GameDirectoriesAddTheirCaptions) {
  const test::SmallGame data;
  data.folder().write("id1/captions.txt", "a.wav one\nb.wav two\n");
  data.folder().write("mod/captions.txt", "b.wav three\nnonsense\n");
  std::vector<std::string> notes;
  const std::vector<std::string> games = {"mod"};
  const formats::Captions captions =
      assets::load_captions(vfs::FileSystem::open(data.path(), games).value(), notes);
  EXPECT_EQ(make_caption(captions, "a.wav"), "one");
  EXPECT_EQ(make_caption(captions, "b.wav"), "three");
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("captions.txt:2"), std::string::npos) << notes[0];
}

// An independent list: the sounds of a game that replaces all stock ones.
TEST(Subtitles, EveryStockSoundHasACaption) {
  DATA_FOLDER_OR_SKIP(base);
  const auto files = vfs::FileSystem::open(base).value();
  std::size_t described = 0;
  for (const std::string& file : files.list("sound/", ".wav")) {
    const std::string_view sound = std::string_view(file).substr(std::string_view("sound/").size());
    EXPECT_NE(find_stock_caption(sound), std::nullopt) << sound;
    ++described;
  }
  EXPECT_GT(described, 100u);
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
  game.sounds = {"", "dog/dsight.wav", "player/pain1.wav", "misc/null.wav"};
  game.view_entity = 1;
  Subtitles subtitles({{{"dog/dsight.wav", "dog growls"}, {"misc/null.wav", ""}}, {}});
  const auto commands = [&] {
    render::DrawList list;
    subtitles.draw(pictures, 640, 480, {}, 0, list);
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
  sound(7, 3, {-10, 0, 0});    // silence
  subtitles.advance(game, events, {}, 10);
  EXPECT_EQ(commands(), 0u);
  events.sounds.clear();
  sound(5, 1, {-200, 0, 0});
  sound(8, 1, {-200, 5, 0});  // the same caption is shown once
  subtitles.advance(game, events, {}, 10);
  EXPECT_EQ(commands(), 1 + std::string("vdoggrowlsv").size());
  render::DrawList above;
  subtitles.draw(pictures, 640, 480, {}, 200, above);
  for (const render::DrawCommand& command : above.commands)
    EXPECT_LE(command.area.y + command.area.height, 480 - 200) << "covered by the weapon list";
  events.sounds.clear();
  subtitles.advance(game, events, {}, 11.9);
  EXPECT_GT(commands(), 0u);
  subtitles.advance(game, events, {}, 12.1);
  EXPECT_EQ(commands(), 0u);
}

}  // namespace
}  // namespace temblor::client
