// Tests that no start, stop, movement or volume change clicks: neighboring samples differ hardly more than in
// the sounds themselves. A ten-minute battle must stay within full scale.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "audio/mixer.h"
#include "audio/signals.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using audio::Mixer;
using audio::SoundEvents;

constexpr double kTone_hz = 100;
constexpr double kNaturalStep =
    0.5 * 2 * std::numbers::pi * kTone_hz / static_cast<double>(kSecond);  // 0.0065

class Smooth : public ::testing::Test {
 protected:
  Smooth() : scene(quiet_scene()) { mixer.set_scene(scene, 0); }

  // Starts at the peak of its wave, so without a fade the output would jump by half of full scale.
  static audio::SoundPtr tone() {
    audio::Sound sound{"tone", {}, audio::SoundLoop{0, kSecond}};
    for (std::size_t i = 0; i < kSecond; ++i)
      sound.samples.push_back(
          static_cast<float>(0.5 * std::cos(2 * std::numbers::pi * kTone_hz * static_cast<double>(i) /
                                            static_cast<double>(kSecond))));
    return std::make_shared<const audio::Sound>(sound);
  }
  void start(std::int32_t entity, int channel, const math::Vec3& origin = math::Vec3(0.0f)) {
    SoundEvents events;
    events.started.push_back({.sound = tone(), .entity = entity, .channel = channel, .origin_world = origin});
    mixer.handle_events(events);
  }
  double measure_max_step(std::size_t frames) {
    const Stereo heard = rendered(mixer, frames);
    return std::max(largest_step(heard.left), largest_step(heard.right));
  }

  audio::Scene scene;
  Mixer mixer;
};

TEST_F(Smooth, Start) {
  start(1, 0);
  EXPECT_LT(measure_max_step(4800), kNaturalStep + 0.5 / 96 + 1e-3) << "within 2 ms";
}

TEST_F(Smooth, StopAndReplacement) {
  start(1, 1);
  rendered(mixer, 4800);
  SoundEvents events;
  events.stopped.push_back({1, 1});
  mixer.handle_events(events);
  EXPECT_LT(measure_max_step(4800), kNaturalStep + 0.5 / 240 + 1e-3);
  start(1, 1);
  rendered(mixer, 4800);
  start(1, 1);
  EXPECT_LT(measure_max_step(4800), 2 * kNaturalStep + 0.5 / 96 + 0.5 / 240 + 1e-3);
  SoundEvents restart;
  restart.stops_all = true;
  mixer.handle_events(restart);
  EXPECT_LT(measure_max_step(4800), kNaturalStep + 0.5 / 240 + 1e-3);
}

TEST_F(Smooth, SuddenTurnOrTeleportOfTheListener) {
  start(2, 0, {0, -100, 0});
  rendered(mixer, 4800);
  scene.listener.right = {0, 1, 0};
  mixer.set_scene(scene, 1);
  // The gains of the ears, 1.8 and 0, are swapped over 5 ms.
  EXPECT_LT(measure_max_step(4800), 1.8 * (kNaturalStep + 0.5 / 240) + 1e-3);
  scene.listener.origin_world = {0, 5000, 0};
  mixer.set_scene(scene, 1);
  EXPECT_LT(measure_max_step(4800), 1.8 * (kNaturalStep + 0.5 / 240) + 1e-3);
}

TEST_F(Smooth, SuddenVolumeChange) {
  start(1, 0);
  rendered(mixer, 4800);
  scene.volumes.sounds = 0;
  mixer.set_scene(scene, 1);
  EXPECT_LT(measure_max_step(4800), kNaturalStep + 0.5 / 240 + 1e-3);
}

TEST_F(Smooth, Diving) {
  start(1, 0);
  rendered(mixer, 4800);
  scene.volumes.muffled_underwater = 1;
  for (const bool underwater : {true, false}) {
    scene.listener.underwater = underwater;
    mixer.set_scene(scene, 1);
    EXPECT_LT(measure_max_step(kSecond / 2), 1.2 * kNaturalStep) << underwater;
  }
}

TEST_F(Smooth, AmbientSoundChange) {
  scene.ambient_levels = {255, 0, 0, 0};
  mixer.set_scene(scene, 1);
  SoundEvents events;
  events.new_ambients = true;
  for (int i = 0; i < 3; ++i) {
    events.ambients[0] = tone();
    mixer.handle_events(events);
    EXPECT_LT(measure_max_step(kSecond), 0.3 * (kNaturalStep + 0.5 / 240) + 1e-3) << i;
  }
}

// Random events of every kind, far too loud.
TEST(Battle, StaysWithinFullScaleForTenMinutes) {
  Random random(1);
  std::vector<audio::SoundPtr> sounds;
  for (int i = 0; i < 20; ++i) {
    sounds.push_back(sine_sound(random.log_uniform(50, 8000), 1, kSecond / 10 + random.below(2 * kSecond)));
    if (i % 4 == 0) sounds.back() = looping(sounds.back());
  }
  audio::Sound noise{"noise", {}, std::nullopt};
  for (std::size_t i = 0; i < kSecond; ++i) noise.samples.push_back(random.chance(0.5) ? 1.0f : -1.0f);
  sounds.push_back(std::make_shared<const audio::Sound>(noise));

  Mixer mixer;
  audio::Scene scene = quiet_scene();
  const int seconds = effort(600, 20);
  double loudest = 0;
  std::size_t max_voices = 0;
  std::vector<float> out(2 * kSecond / 50);
  for (int step = 0; step < seconds * 50; ++step) {
    scene.listener.origin_world = random.in_cube(300);
    const double yaw = random.uniform(0, 6.28);
    scene.listener.right = {static_cast<float>(std::cos(yaw)), static_cast<float>(std::sin(yaw)), 0};
    scene.listener.underwater = random.chance(0.1);
    scene.volumes = {1, 1, 1, 1};
    for (std::uint8_t& level : scene.ambient_levels) level = static_cast<std::uint8_t>(random.below(256));
    mixer.set_scene(scene, out.size() / 2);
    SoundEvents events;
    events.stops_all = random.chance(0.001);
    for (std::size_t i = random.below(3); i > 0; --i)
      events.started.push_back({.sound = sounds[random.below(sounds.size())],
                                .entity = static_cast<std::int32_t>(random.below(40)),
                                .channel = static_cast<int>(random.below(9)) - 1,
                                .origin_world = random.in_cube(500)});
    if (random.chance(0.3))
      events.stopped.push_back(
          {static_cast<std::int32_t>(random.below(40)), static_cast<int>(random.below(8))});
    if (random.chance(0.002)) events.statics.push_back({sounds[0], random.in_cube(500), 1, 1});
    mixer.handle_events(events);
    mixer.render(out);
    loudest = std::max(loudest, peak(out));
    max_voices = std::max(max_voices, mixer.stats().voices);
  }
  EXPECT_LE(loudest, 1.0);
  EXPECT_GT(loudest, 0.98) << "the battle must be loud";
  EXPECT_GT(max_voices, 30u);
}

}  // namespace
}  // namespace temblor::test
