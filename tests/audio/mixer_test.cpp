// Tests the mixer's output: levels by distance and side, and which sounds replace others.
#include "audio/mixer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "audio/signals.h"

namespace temblor::test {
namespace {

using audio::Mixer;
using audio::SoundEvents;
using audio::StartedSound;

constexpr std::int32_t kSelf = 1, kOther = 7;

// Each sound is a different constant, so the output level shows which sounds play.
class MixerTest : public ::testing::Test {
 protected:
  MixerTest() { mixer.set_scene(quiet_scene(), 0); }

  void start(float value, std::int32_t entity, int channel, std::size_t frames = 10 * kSecond) {
    SoundEvents events;
    // Straight ahead without attenuation: equally loud in both ears.
    events.started.push_back({.sound = constant_sound(value, frames),
                              .entity = entity,
                              .channel = channel,
                              .origin_world = {10, 0, 0},
                              .attenuation = 0});
    mixer.handle_events(events);
  }
  // The level after all fades have ended.
  float level() { return rendered(mixer, kSecond / 10).left.back(); }

  Mixer mixer;
};

TEST_F(MixerTest, IsSilentWithoutSounds) {
  EXPECT_EQ(peak(rendered(mixer, 1000).left), 0);
}

struct Place {
  const char* name;
  math::Vec3 origin;
  float volume, attenuation;
  double left, right;
};

TEST_F(MixerTest, LevelsDependOnDistanceAndSide) {
  const double diagonal = std::sqrt(0.5);
  for (const Place& place : {
           Place{"ahead", {250, 0, 0}, 1, 1, 0.75, 0.75},
           Place{"behind", {-250, 0, 0}, 1, 1, 0.75, 0.75},
           Place{"above", {0, 0, 250}, 1, 1, 0.75, 0.75},
           Place{"right", {0, -100, 0}, 1, 1, 0, 1.8},
           Place{"left", {0, 100, 0}, 1, 1, 1.8, 0},
           Place{"half right",
                 {100, -100, 0},
                 1,
                 1,
                 (1 - diagonal * 0.2) * (1 - diagonal),
                 (1 - diagonal * 0.2) * (1 + diagonal)},
           Place{"in the head", {0, 0, 0}, 1, 1, 1, 1},
           Place{"softer", {250, 0, 0}, 0.5f, 1, 0.375, 0.375},
           Place{"attenuation 2", {250, 0, 0}, 1, 2, 0.5, 0.5},
           Place{"attenuation 3", {250, 0, 0}, 1, 3, 0.25, 0.25},
           Place{"everywhere", {4000, 0, 0}, 1, 0, 1, 1},
           Place{"just in reach", {999, 0, 0}, 1, 1, 0.001, 0.001},
           Place{"out of reach", {1001, 0, 0}, 1, 1, 0, 0},
           Place{"far out of reach", {0, 1e6f, 0}, 1, 1, 0, 0},
           Place{"no place at all", {NAN, 0, 0}, 1, 1, 0, 0},
       }) {
    Mixer one;
    one.set_scene(quiet_scene(), 0);
    SoundEvents events;
    events.started.push_back({.sound = constant_sound(0.25f, kSecond),
                              .entity = kOther,
                              .origin_world = place.origin,
                              .volume = place.volume,
                              .attenuation = place.attenuation});
    one.handle_events(events);
    const Stereo heard = rendered(one, 2000);
    EXPECT_NEAR(heard.left.back(), 0.25 * place.left, 2e-5) << place.name;
    EXPECT_NEAR(heard.right.back(), 0.25 * place.right, 2e-5) << place.name;
  }
}

TEST_F(MixerTest, OwnSoundsPlayAtFullVolumeAnywhere) {
  SoundEvents events;
  events.started.push_back(
      {.sound = constant_sound(0.25f, kSecond), .entity = kSelf, .origin_world = {0, 5000, 0}});
  mixer.handle_events(events);
  const Stereo heard = rendered(mixer, 2000);
  EXPECT_EQ(heard.left.back(), 0.25f);
  EXPECT_EQ(heard.right.back(), 0.25f);
}

TEST_F(MixerTest, SoundVolumeDoesNotAffectMusic) {
  audio::Scene scene = quiet_scene();
  scene.volumes = {.sounds = 0.5f, .music = 0.25f};
  mixer.set_scene(scene, 0);
  start(0.4f, kSelf, 0);
  std::vector<float> out(20000);
  mixer.render(out, std::vector<float>(out.size(), 0.8f));
  EXPECT_NEAR(out.back(), 0.4 * 0.5 + 0.8 * 0.25, 1e-6);
}

TEST_F(MixerTest, SameEntityAndChannelIsReplaced) {
  start(0.1f, kOther, 2);
  EXPECT_FLOAT_EQ(level(), 0.1f);
  start(0.2f, kOther, 2);
  EXPECT_FLOAT_EQ(level(), 0.2f);
}

TEST_F(MixerTest, OtherEntityOrChannelIsNotReplaced) {
  start(0.1f, kOther, 2);
  start(0.2f, kOther, 3);
  start(0.4f, kOther + 1, 2);
  EXPECT_NEAR(level(), 0.7f, 1e-6);
}

TEST_F(MixerTest, FreeChannelNeitherReplacesNorIsReplaced) {
  start(0.1f, kOther, 0);
  start(0.2f, kOther, 0);
  start(0.4f, kOther, 2);
  EXPECT_NEAR(level(), 0.7f, 1e-6);
}

TEST_F(MixerTest, AnyChannelReplacesTheOldestSoundOfItsEntity) {
  start(0.1f, kOther + 1, 1);
  start(0.2f, kOther, 0);
  start(0.4f, kOther, 3);
  start(0.05f, kOther, audio::kAnyChannel);
  EXPECT_NEAR(level(), 0.1 + 0.4 + 0.05, 1e-6);
}

TEST_F(MixerTest, StopEndsOnlyMatchingSounds) {
  start(0.1f, kOther, 1);
  start(0.2f, kOther, 2);
  start(0.4f, kOther + 1, 1);
  SoundEvents events;
  events.stopped.push_back({kOther, 1});
  mixer.handle_events(events);
  EXPECT_NEAR(level(), 0.6, 1e-6);
}

TEST_F(MixerTest, MissingSoundStillReplaces) {
  start(0.1f, kOther, 1);
  SoundEvents events;
  events.started.push_back({.sound = nullptr, .entity = kOther, .channel = 1});
  mixer.handle_events(events);
  EXPECT_EQ(level(), 0);
}

TEST_F(MixerTest, FinishedSoundFreesItsVoice) {
  start(0.1f, kOther, 1, 1000);
  EXPECT_EQ(mixer.stats().voices, 1u);
  rendered(mixer, 999);
  EXPECT_EQ(mixer.stats().voices, 1u);
  rendered(mixer, 1);
  EXPECT_EQ(mixer.stats().voices, 0u);
}

TEST_F(MixerTest, StaticSoundsLoopAndEndWithTheLevel) {
  SoundEvents events;
  events.statics.push_back({looping(constant_sound(0.1f, 777)), {500, 0, 0}, 1, 1});
  mixer.handle_events(events);
  EXPECT_FLOAT_EQ(rendered(mixer, 5 * kSecond).left.back(), 0.05f);
  SoundEvents restart;
  restart.stops_all = true;
  mixer.handle_events(restart);
  EXPECT_EQ(level(), 0);
  EXPECT_EQ(mixer.stats().voices, 0u);
}

TEST_F(MixerTest, HundredsOfVoicesPlayAtOnce) {
  for (int i = 0; i < 900; ++i) start(0.001f, i + 10, 1, kSecond);
  EXPECT_NEAR(level(), 0.9, 1e-4);
  EXPECT_EQ(mixer.stats().left_out, 0u);
}

TEST_F(MixerTest, FullMixerEndsTheVoiceWithTheLeastTimeLeft) {
  start(0.5f, kSelf, 1, kSecond / 2);
  SoundEvents events;
  events.statics.push_back({looping(constant_sound(0.1f, 10)), {0, 0, 0}, 1, 0});
  mixer.handle_events(events);
  start(0.05f, kOther, 0, kSecond / 2);
  for (std::size_t i = 3; i < Mixer::kMaxVoices; ++i) start(0, kOther, 0, kSecond);
  EXPECT_NEAR(level(), 0.65, 1e-5);
  start(0.2f, kOther, 0);
  EXPECT_NEAR(level(), 0.8, 1e-5) << "replaces the voice with 0.05";
}

TEST_F(MixerTest, NewSoundIsLeftOutIfNoVoiceMayEnd) {
  for (std::size_t i = 0; i < Mixer::kMaxVoices; ++i) start(0, kSelf, 0, kSecond);
  EXPECT_EQ(mixer.stats().left_out, 0u);
  start(0.2f, kOther, 0);
  EXPECT_EQ(mixer.stats().left_out, 1u);
  EXPECT_EQ(level(), 0);
}

// A click at a known position shows how much of a sound was skipped.
TEST_F(MixerTest, SimultaneousDuplicatesSkipTheirBeginning) {
  audio::Sound ticks{"ticks", std::vector<float>(kSecond, 0.0f), std::nullopt};
  ticks.samples[kSecond / 2] = 0.1f;
  const audio::SoundPtr sound = std::make_shared<const audio::Sound>(ticks);
  SoundEvents events;
  for (int i = 0; i < 3; ++i) events.started.push_back({.sound = sound, .entity = kSelf});
  mixer.handle_events(events);
  const Stereo heard = rendered_from_start(mixer, kSecond);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < heard.left.size(); ++i)
    if (heard.left[i] > 0.05f) places.push_back(i);
  ASSERT_EQ(places.size(), 3u) << "each copy at a different offset";
  EXPECT_EQ(places.back(), kSecond / 2) << "the first copy skips nothing";
  EXPECT_GE(places.front(), kSecond / 2 - kSecond / 10);
}

TEST_F(MixerTest, LaterDuplicatePlaysFromTheBeginning) {
  audio::Sound ticks{"ticks", std::vector<float>(kSecond, 0.0f), std::nullopt};
  ticks.samples[kSecond / 2] = 0.1f;
  const audio::SoundPtr sound = std::make_shared<const audio::Sound>(ticks);
  SoundEvents events;
  events.started.push_back({.sound = sound, .entity = kSelf});
  mixer.handle_events(events);
  rendered(mixer, 100);
  mixer.handle_events(events);
  const Stereo heard = rendered_from_start(mixer, kSecond);
  EXPECT_EQ(heard.left[kSecond / 2], 0.1f);
}

class Ambients : public MixerTest {
 protected:
  Ambients() {
    SoundEvents events;
    events.new_ambients = true;
    events.ambients = {looping(constant_sound(0.5f, 1000)), looping(constant_sound(0.25f, 1000)), nullptr,
                       nullptr};
    mixer.handle_events(events);
  }
  void set(std::uint8_t water, std::uint8_t sky) {
    audio::Scene scene = quiet_scene();
    scene.ambient_levels = {water, sky, 255, 255};
    mixer.set_scene(scene, 0);
  }
};

TEST_F(Ambients, FadeBy100LevelsPerSecond) {
  set(200, 0);  // 60 of 255
  Stereo heard = rendered_from_start(mixer, kSecond);
  for (const double time_s : {0.1, 0.3, 0.59, 0.7})
    EXPECT_NEAR(heard.left[static_cast<std::size_t>(time_s * static_cast<double>(kSecond))],
                0.5 * std::min(100 * time_s, 60.0) / 255, 1e-4);
  EXPECT_EQ(heard.left, heard.right);
  set(0, 0);
  heard = rendered(mixer, kSecond);
  EXPECT_NEAR(heard.left[kSecond / 2], 0.5 * 10 / 255, 1e-3);
  EXPECT_EQ(heard.left.back(), 0);
}

TEST_F(Ambients, LevelsBelow8AreSilent) {
  set(26, 0);  // 7.8
  EXPECT_EQ(peak(rendered(mixer, kSecond).left), 0);
  set(27, 0);  // 8.1
  EXPECT_NEAR(rendered(mixer, kSecond).left.back(), 0.5 * 8.1 / 255, 1e-5);
}

TEST_F(Ambients, KindsAddUpAndMissingSoundsAreSilent) {
  set(100, 255);
  EXPECT_NEAR(rendered(mixer, 2 * kSecond).left.back(), (0.5 * 30 + 0.25 * 76.5) / 255, 1e-5);
}

TEST_F(MixerTest, BlockSizeDoesNotChangeTheSound) {
  const auto play = [](std::size_t piece) {
    Mixer one;
    audio::Scene scene = quiet_scene();
    scene.volumes.muffled_underwater = 1;
    scene.listener.underwater = true;
    one.set_scene(scene, 0);
    SoundEvents events;
    events.started.push_back({.sound = sine_sound(440, 0.9, 9000), .entity = kSelf});
    events.started.push_back(
        {.sound = looping(sine_sound(1000, 0.9, 960)), .entity = kOther, .attenuation = 0});
    one.handle_events(events);
    std::vector<float> heard;
    while (heard.size() < 24000) {
      const Stereo part = rendered(one, piece);
      heard.insert(heard.end(), part.left.begin(), part.left.end());
    }
    heard.resize(24000);
    return heard;
  };
  const std::vector<float> whole = play(24000);
  EXPECT_GT(peak(whole), 0.5);
  for (const std::size_t piece : {1u, 7u, 256u, 1000u}) {
    const std::vector<float> in_pieces = play(piece);
    for (std::size_t i = 0; i < whole.size(); ++i)
      ASSERT_NEAR(in_pieces[i], whole[i], 1e-4) << piece << ", " << i;
  }
}

TEST_F(MixerTest, MufflingWeakensHighFrequenciesUnderWater) {
  const auto measure_level = [](double frequency_hz, float muffled, bool underwater) {
    Mixer one;
    audio::Scene scene = quiet_scene();
    scene.volumes.muffled_underwater = muffled;
    scene.listener.underwater = underwater;
    one.set_scene(scene, 0);
    SoundEvents events;
    events.started.push_back({.sound = sine_sound(frequency_hz, 0.5, 2 * kSecond), .entity = kSelf});
    one.handle_events(events);
    const Stereo heard = rendered(one, kSecond);
    return to_db(measure_amplitude(std::span(heard.left).last(kSecond / 2), frequency_hz) / 0.5);
  };
  EXPECT_NEAR(measure_level(100, 1, true), 0, 0.5);
  EXPECT_NEAR(measure_level(450, 1, true), -3, 0.5) << "at the cutoff frequency";
  EXPECT_LT(measure_level(4000, 1, true), -35);
  EXPECT_GT(measure_level(4000, 0.3f, true), -6);
  EXPECT_NEAR(measure_level(4000, 0, true), 0, 0.01);
  EXPECT_NEAR(measure_level(4000, 1, false), 0, 0.01);
}

}  // namespace
}  // namespace temblor::test
