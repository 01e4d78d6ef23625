// From the server's messages to the mixer's events; sounds come from a directory made for the test.
#include "client/view/audio_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "formats/sounds/wav.h"
#include "support/levels/drawable_level.h"
#include "support/programs/small_game.h"

namespace temblor::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

formats::Wav short_sound(bool loops = false) {
  formats::Wav wav{.frames_per_second = 48000, .channels = 1, .bits = 16, .samples = {}, .loop = {}};
  wav.samples.assign(1000, 5000);
  if (loops) wav.loop = formats::WavLoop{0, 1000};
  return wav;
}

class AudioSceneTest : public ::testing::Test {
 protected:
  AudioSceneTest() {
    for (const char* name : {"weapons/guncock", "misc/menu1", "weapons/r_exp3", "weapons/tink1",
                             "weapons/ric1", "weapons/ric2", "weapons/ric3", "wizard/hit", "ambience/wind2"})
      add(name, short_sound());
    add("ambience/hum", short_sound(true));
    folder().write("id1/sound/misc/bad.wav", "RIFF, but no more");
    game.sounds = {"", "weapons/guncock.wav", "ambience/hum.wav", "misc/bad.wav", "misc/none.wav"};
    game.view_entity = 1;
  }
  const test::TemporaryFolder& folder() const { return small_game.folder(); }
  void add(const std::string& name, const formats::Wav& wav) const {
    folder().write("id1/sound/" + name + ".wav", formats::write_wav(wav));
  }
  AudioScene& scene() {
    if (!audio) {
      library.emplace(vfs::FileSystem::open(small_game.path()).value());
      audio.emplace(*library);
      audio->begin_level(game);
    }
    return *audio;
  }
  // The mixer events that these events alone lead to.
  audio::SoundEvents heard(const Events& events) {
    scene().events().clear();
    scene().advance(game, events, entities, *level, view, {});
    return scene().events();
  }

  test::SmallGame small_game;
  Game game;
  std::vector<InterpolatedEntity> entities;
  PlayerView view;
  std::shared_ptr<const world::Level> level = test::small_level().level;
  std::optional<assets::Library> library;
  std::optional<AudioScene> audio;
};

TEST_F(AudioSceneTest, LevelsStartWithAmbientSoundsOnly) {
  const audio::SoundEvents& events = scene().events();
  EXPECT_TRUE(events.stops_all);
  EXPECT_TRUE(events.new_ambients);
  EXPECT_EQ(events.ambients[0], nullptr) << "the game has no ambience/water1.wav";
  ASSERT_NE(events.ambients[1], nullptr);
  EXPECT_TRUE(events.ambients[1]->loop) << "although the file has no loop";
}

TEST_F(AudioSceneTest, MissingAndDamagedSoundsAreReportedOnceWhenFirstHeard) {
  EXPECT_THAT(scene().take_notes(), ElementsAre(HasSubstr("sound/ambience/water1.wav")));
  Events events;
  for (int i = 0; i < 3; ++i) {
    events.sounds.push_back({.sound = 4});
    events.sounds.push_back({.sound = 3});
    EXPECT_EQ(heard(events).started.back().sound, nullptr);
  }
  const std::vector<std::string> notes = scene().take_notes();
  ASSERT_THAT(notes, SizeIs(2));
  EXPECT_THAT(notes[0], HasSubstr("sound/misc/none.wav: not in"));
  EXPECT_THAT(notes[1], HasSubstr("misc/bad.wav: not a WAV file"));
  for (const std::string& note : notes) EXPECT_THAT(note, HasSubstr("silent"));
  scene().begin_level(game);
  heard(events);
  EXPECT_THAT(scene().take_notes(), IsEmpty());
}

TEST_F(AudioSceneTest, SoundMessagesBecomeMixerEvents) {
  Events events;
  events.sounds.push_back(
      {.volume = 51, .attenuation = 2, .entity = 9, .channel = 3, .sound = 1, .origin = {1, 2, 3}});
  events.sounds.push_back({.sound = 77});
  events.stopped_sounds.push_back({9, 3});
  const audio::SoundEvents got = heard(events);
  ASSERT_THAT(got.started, SizeIs(2));
  const audio::StartedSound& first = got.started[0];
  ASSERT_NE(first.sound, nullptr);
  EXPECT_EQ(first.sound->name, "weapons/guncock.wav");
  EXPECT_EQ(first.entity, 9);
  EXPECT_EQ(first.channel, 3);
  EXPECT_EQ(first.origin_world, math::Vec3(1, 2, 3));
  EXPECT_FLOAT_EQ(first.volume, 0.2f);
  EXPECT_EQ(first.attenuation, 2);
  EXPECT_EQ(got.started[1].sound, nullptr) << "a number past the list is silent";
  ASSERT_THAT(got.stopped, SizeIs(1));
  EXPECT_EQ(got.stopped[0].entity, 9);
  EXPECT_EQ(got.stopped[0].channel, 3);
}

TEST_F(AudioSceneTest, VoicesAndWeaponsOfCreaturesAreThreats) {
  game.models = {"", "maps/m.bsp", "*1", "progs/ogre.mdl"};
  entities = {{.number = 5, .model = 2}, {.number = 6, .model = 3}};
  const auto is_threat = [&](std::uint16_t entity, std::uint8_t channel) {
    Events events;
    events.sounds.push_back({.entity = entity, .channel = channel, .sound = 1});
    return heard(events).started.at(0).is_threat;
  };
  EXPECT_TRUE(is_threat(6, 1));
  EXPECT_TRUE(is_threat(6, 2));
  EXPECT_FALSE(is_threat(6, 0));
  EXPECT_FALSE(is_threat(6, 4)) << "footsteps";
  EXPECT_FALSE(is_threat(5, 2)) << "a door";
  EXPECT_TRUE(is_threat(7, 2)) << "out of view";
  EXPECT_FALSE(is_threat(0, 2)) << "the world";
}

TEST_F(AudioSceneTest, StaticSoundsMustLoop) {
  scene().take_notes();
  Events events;
  events.static_sounds.push_back({.origin = {5, 6, 7}, .sound = 2, .volume = 255, .attenuation = 3});
  for (int i = 0; i < 2; ++i) events.static_sounds.push_back({.origin = {0, 0, 0}, .sound = 1});
  const audio::SoundEvents got = heard(events);
  ASSERT_THAT(got.statics, SizeIs(1));
  EXPECT_EQ(got.statics[0].sound->name, "ambience/hum.wav");
  EXPECT_EQ(got.statics[0].origin_world, math::Vec3(5, 6, 7));
  EXPECT_EQ(got.statics[0].attenuation, 3);
  EXPECT_THAT(scene().take_notes(),
              ElementsAre(HasSubstr("guncock.wav: cannot be used as an ambient sound")));
}

TEST_F(AudioSceneTest, AfterASeekOnlyStaticSoundsContinue) {
  Events events;
  for (int i = 0; i < 3; ++i) events.static_sounds.push_back({.sound = 2});
  events.sounds.push_back({.sound = 1});
  heard(events);
  scene().resume(std::vector<net::SpawnStaticSound>{{.origin = {1, 2, 3}, .sound = 2}});
  const audio::SoundEvents& got = scene().events();
  EXPECT_TRUE(got.stops_all);
  ASSERT_THAT(got.statics, SizeIs(1));
  EXPECT_EQ(got.statics[0].origin_world, math::Vec3(1, 2, 3));
  EXPECT_THAT(got.started, IsEmpty());
}

// Counts each sound among so many events of one kind.
TEST_F(AudioSceneTest, TempEntitiesSoundAsInTheOriginal) {
  using Kind = net::TempEntityKind;
  const auto count = [&](Kind kind, int times) {
    Events events;
    for (int i = 0; i < times; ++i) events.temp_entities.push_back({.kind = kind, .origin = {1, 2, 3}});
    std::map<std::string, double> counts;
    for (const audio::StartedSound& sound : heard(events).started) {
      EXPECT_EQ(sound.entity, audio::kNoEntity);
      EXPECT_EQ(sound.channel, audio::kFreeChannel);
      EXPECT_EQ(sound.origin_world, math::Vec3(1, 2, 3));
      EXPECT_EQ(sound.volume, 1);
      EXPECT_EQ(sound.attenuation, 1);
      ++counts[sound.sound ? sound.sound->name : "none"];
    }
    return counts;
  };
  using Counts = std::map<std::string, double>;
  for (const Kind kind : {Kind::kExplosion, Kind::kTarExplosion, Kind::kExplosion2})
    EXPECT_EQ(count(kind, 2), (Counts{{"weapons/r_exp3.wav", 2}}));
  EXPECT_EQ(count(Kind::kWizSpike, 1), (Counts{{"wizard/hit.wav", 1}}));
  EXPECT_EQ(count(Kind::kKnightSpike, 1), (Counts{{"none", 1}})) << "this game has no hknight/hit.wav";
  for (const Kind kind : {Kind::kGunshot, Kind::kLightning1, Kind::kLavaSplash, Kind::kTeleport, Kind::kBeam})
    EXPECT_EQ(count(kind, 1), Counts{});
  for (const Kind kind : {Kind::kSpike, Kind::kSuperSpike}) {
    Counts counts = count(kind, 4000);
    EXPECT_NEAR(counts["weapons/tink1.wav"], 3200, 150);
    EXPECT_NEAR(counts["weapons/ric1.wav"], 200, 60);
    EXPECT_NEAR(counts["weapons/ric2.wav"], 200, 60);
    EXPECT_NEAR(counts["weapons/ric3.wav"], 400, 80);
  }
}

TEST_F(AudioSceneTest, ListenerIsWhereTheCameraIs) {
  view.camera.origin_world = {10, 20, 30};
  view.camera.angles_deg = {0, 90, 0};  // along +y: right is +x
  view.underwater = true;
  scene().advance(game, {}, {}, *level, view, {0.5f, 0.125f, 0.25f, 1});
  const audio::Scene& got = scene().scene();
  EXPECT_EQ(got.listener.origin_world, math::Vec3(10, 20, 30));
  EXPECT_NEAR(glm::distance(got.listener.right, math::Vec3(1, 0, 0)), 0, 1e-6);
  EXPECT_EQ(got.listener.entity, 1);
  EXPECT_TRUE(got.listener.underwater);
  EXPECT_EQ(got.volumes.sounds, 0.5f);
  EXPECT_EQ(got.volumes.ambient, 0.125f);
  EXPECT_EQ(got.volumes.music, 0.25f);
  EXPECT_EQ(got.volumes.muffled_underwater, 1);
}

TEST_F(AudioSceneTest, AmbientLevelsAreThoseOfTheLeaf) {
  world::Level copy = *level;
  copy.leaves[3].ambient = {1, 2, 3, 4};
  view.leaf = world::LeafIndex{3};
  scene().advance(game, {}, {}, copy, view, {});
  EXPECT_THAT(scene().scene().ambient_levels, ElementsAre(1, 2, 3, 4));
}

TEST_F(AudioSceneTest, LocalSoundsBelongToTheListener) {
  scene().advance(game, {}, {}, *level, view, {});
  scene().events().clear();
  scene().play_local("misc/menu1.wav");
  ASSERT_THAT(scene().events().started, SizeIs(1));
  EXPECT_EQ(scene().events().started[0].sound->name, "misc/menu1.wav");
  EXPECT_EQ(scene().events().started[0].entity, 1);
}

}  // namespace
}  // namespace temblor::client
