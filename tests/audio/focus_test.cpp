// The nearest threat is the clearest: which voices become softer, by how much, and how smoothly.
#include "audio/mixing/focus.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "audio/mixer.h"
#include "audio/signals.h"

namespace temblor::test {
namespace {

using audio::kMinFocus;

constexpr std::size_t kSettled_frames = kSecond;

class Focus : public ::testing::Test {
 protected:
  Focus() { mixer.set_scene(scene, 0); }

  // A voice straight ahead, of a constant level, so that the output is the sum of the gains.
  void shout(std::int32_t entity, float distance, float level, std::size_t frames = 10 * kSecond) {
    start({.sound = constant_sound(level, frames),
           .entity = entity,
           .channel = 2,
           .origin_world = {distance, 0, 0},
           .is_threat = true});
  }
  void start(const audio::StartedSound& sound) {
    audio::SoundEvents events;
    events.started.push_back(sound);
    mixer.handle_events(events);
  }
  float settled_level() { return rendered(mixer, kSettled_frames).left.back(); }

  audio::Scene scene = quiet_scene();
  audio::Mixer mixer;
};

TEST_F(Focus, LeavesOneVoiceAsInTheOriginal) {
  shout(7, 600, 0.5f);
  EXPECT_NEAR(settled_level(), 0.5f * 0.4f, 1e-6);
}

TEST_F(Focus, LeavesVoicesFromTheSameDistance) {
  for (int entity = 7; entity < 11; ++entity) shout(entity, 600, 0.5f);
  EXPECT_NEAR(settled_level(), 4 * 0.5f * 0.4f, 1e-5);
}

TEST_F(Focus, SoftensFartherVoicesByTheSquareOfTheirCloseness) {
  shout(7, 100, 0.2f);
  shout(8, 300, 0.2f);
  EXPECT_NEAR(settled_level(), 0.2f * 0.9f + 0.2f * 0.7f * (0.7f * 0.7f / 0.81f), 1e-5);
  shout(9, 800, 0.2f);
  EXPECT_NEAR(settled_level(), 0.2f * 0.9f + 0.2f * 0.7f * (0.7f * 0.7f / 0.81f) + 0.2f * 0.2f * kMinFocus,
              1e-5);
}

TEST_F(Focus, CanBeTurnedOff) {
  shout(7, 100, 0.2f);
  shout(8, 600, 0.2f);
  EXPECT_LT(settled_level(), 0.2f * 1.1f);
  scene.volumes.focus = false;
  mixer.set_scene(scene, 0);
  EXPECT_NEAR(settled_level(), 0.2f * 1.3f, 1e-5);
}

// A far voice is softer from its first frame while a near one sounds, and as loud as alone after its end.
TEST_F(Focus, LastsAsLongAsTheNearerVoice) {
  shout(7, 100, 0.2f, kSecond);
  shout(8, 600, 0.2f);
  const Stereo heard = rendered_from_start(mixer, 3 * kSecond);
  EXPECT_NEAR(heard.left[500], 0.2f * (0.9f + 0.4f * kMinFocus), 1e-4);
  EXPECT_NEAR(heard.left[kSecond - 500], 0.2f * (0.9f + 0.4f * kMinFocus), 1e-4);
  EXPECT_NEAR(heard.left.back(), 0.2f * 0.4f, 1e-5);
}

TEST_F(Focus, NeitherHearsNorChangesOtherSounds) {
  shout(7, 600, 0.1f);
  const audio::StartedSound near{
      .sound = constant_sound(0.1f, 10 * kSecond), .entity = 8, .channel = 2, .origin_world = {100, 0, 0}};
  audio::StartedSound own = near, hum = near, everywhere = near;
  own.entity = scene.listener.entity;
  hum.sound = looping(near.sound);
  everywhere.attenuation = 0;
  for (audio::StartedSound* sound : {&own, &hum, &everywhere}) sound->is_threat = true;
  own.channel = 3, hum.channel = 4, everywhere.channel = 5;
  for (const audio::StartedSound& sound : {near, own, hum, everywhere}) start(sound);
  EXPECT_NEAR(settled_level(), 0.1f * (0.4f + 0.9f + 1 + 0.9f + 1), 1e-5);
}

// A voice that cannot be heard, because it is too soft for its distance, takes nothing from the others.
TEST_F(Focus, IgnoresSilentVoices) {
  shout(7, 600, 0.2f);
  start({.sound = constant_sound(0.2f, kSecond),
         .entity = 8,
         .channel = 2,
         .origin_world = {400, 0, 0},
         .attenuation = 3,
         .is_threat = true});
  EXPECT_NEAR(settled_level(), 0.2f * 0.4f, 1e-5);
}

// The full change of 9 dB takes 40 ms down, and ten times as long up: steps stay far below those of a click.
TEST_F(Focus, ChangesSmoothly) {
  shout(7, 600, 0.5f);
  rendered(mixer, kSettled_frames);
  shout(8, 900, 0, kSecond / 2);
  shout(9, 100, 0, kSecond / 2);
  const Stereo heard = rendered(mixer, 2 * kSecond);
  EXPECT_NEAR(*std::min_element(heard.left.begin(), heard.left.end()), 0.5f * 0.4f * kMinFocus, 1e-4);
  EXPECT_LT(largest_step(heard.left), 0.5 * 0.4 / (0.06 * kSecond) + 1e-5);
  EXPECT_NEAR(heard.left.back(), 0.5f * 0.4f, 1e-4);
}

}  // namespace
}  // namespace temblor::test
