// Tests the mixer between two threads: posted sounds play, and the device thread neither allocates nor frees.
#include "audio/live_mixer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "audio/signals.h"
#include "support/allocation_counter.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using audio::LiveMixer;
using audio::SoundEvents;

std::vector<float> fill(LiveMixer& io_mixer, std::size_t frames = 1024) {
  std::vector<float> samples(2 * frames);
  io_mixer.fill(samples);
  return samples;
}

SoundEvents started(audio::SoundPtr sound, std::int32_t entity = 1, int channel = 1) {
  SoundEvents events;
  events.started.push_back({.sound = std::move(sound), .entity = entity, .channel = channel});
  return events;
}

TEST(LiveMixer, PlaysPostedSounds) {
  LiveMixer mixer;
  EXPECT_EQ(peak(fill(mixer)), 0);
  mixer.post(quiet_scene(), started(constant_sound(0.25f, 48000)));
  EXPECT_EQ(fill(mixer).back(), 0.25f);
}

TEST(LiveMixer, KeepsTheOrderOfSeveralPosts) {
  LiveMixer mixer;
  SoundEvents stop;
  stop.stopped.push_back({1, 1});
  mixer.post(quiet_scene(), started(constant_sound(0.125f, 48000)));
  mixer.post(quiet_scene(), stop);
  mixer.post(quiet_scene(), started(constant_sound(0.25f, 48000)));
  EXPECT_EQ(fill(mixer).back(), 0.25f);
  mixer.post(quiet_scene(), stop);
  EXPECT_EQ(fill(mixer).back(), 0);
}

TEST(LiveMixer, GameThreadFreesSounds) {
  LiveMixer mixer;
  std::weak_ptr<const audio::Sound> sound;
  {
    const audio::SoundPtr only = constant_sound(0.25f, 500);
    sound = only;
    mixer.post(quiet_scene(), started(only));
  }
  fill(mixer);
  EXPECT_FALSE(sound.expired()) << "the device thread must not free the sound";
  for (int i = 0; i < 3; ++i) {
    mixer.post(quiet_scene(), {});
    fill(mixer);
  }
  mixer.post(quiet_scene(), {});
  EXPECT_TRUE(sound.expired());
}

TEST(LiveMixer, DeviceThreadDoesNotAllocate) {
  LiveMixer mixer;
  std::vector<audio::SoundPtr> sounds;
  for (int i = 0; i < 50; ++i) sounds.push_back(sine_sound(100 + 50 * i, 0.2, 5000));
  std::vector<float> samples(2 * 512);
  Random random(1);
  for (int step = 0; step < 300; ++step) {
    for (std::size_t i = random.below(20); i > 0; --i)
      mixer.post(quiet_scene(), started(sounds[random.below(50)], static_cast<std::int32_t>(random.below(90)),
                                        static_cast<int>(random.below(8))));
    const std::size_t before = allocation_count();
    mixer.fill(samples);
    EXPECT_EQ(allocation_count() - before, 0u) << step;
  }
}

// --- A hung device.

constexpr int kManyPosts = 20000;
// More than the posts kept separately plus one folded entry.
constexpr long kMaxReferences = 3000;

TEST(LiveMixer, BacklogOfAHungDeviceIsBounded) {
  LiveMixer mixer;
  const audio::SoundPtr sound = constant_sound(0.01f, 100);
  for (int i = 0; i < kManyPosts; ++i) mixer.post(quiet_scene(), started(sound, i, i % 3));
  EXPECT_LT(sound.use_count(), kMaxReferences);
  SoundEvents all;
  all.statics.push_back({.sound = sound});
  all.stopped.push_back({1, 1});
  for (int i = 0; i < kManyPosts; ++i) mixer.post(quiet_scene(), all);
  EXPECT_LT(sound.use_count(), kMaxReferences);
  all.stops_all = true;
  mixer.post(quiet_scene(), all);
  EXPECT_LT(sound.use_count(), 5);
}

TEST(LiveMixer, CurrentSoundsPlayAfterTheDeviceRecovers) {
  LiveMixer mixer;
  SoundEvents level;
  level.stops_all = level.new_ambients = true;
  level.statics.push_back({.sound = looping(constant_sound(0.125f, 480)), .volume = 1, .attenuation = 0});
  mixer.post(quiet_scene(), level);
  for (int i = 0; i < kManyPosts; ++i)
    mixer.post(quiet_scene(), started(constant_sound(0.01f, 100), i % 50, 1));
  mixer.post(quiet_scene(), started(looping(constant_sound(0.25f, 480)), 7, 2));
  mixer.post(quiet_scene(), started(looping(constant_sound(0.5f, 480)), 8, 2));
  SoundEvents stop;
  stop.stopped.push_back({8, 2});
  mixer.post(quiet_scene(), stop);
  fill(mixer, 4096);
  EXPECT_NEAR(fill(mixer).back(), 0.375f, 1e-3);
}

TEST(LiveMixer, EarlierSoundsStopAfterTheDeviceRecovers) {
  LiveMixer mixer;
  mixer.post(quiet_scene(), started(looping(constant_sound(0.125f, 480)), 1, 1));
  mixer.post(quiet_scene(), started(looping(constant_sound(0.25f, 480)), 2, 1));
  EXPECT_EQ(fill(mixer).back(), 0.375f);
  for (int i = 0; i < kManyPosts; ++i) mixer.post(quiet_scene(), started(constant_sound(0.01f, 100), 3, 1));
  SoundEvents stop;
  stop.stopped = {{1, 1}, {2, 1}};
  mixer.post(quiet_scene(), stop);
  mixer.post(quiet_scene(), started(looping(constant_sound(0.0625f, 480)), 2, 1));
  fill(mixer, 4096);
  EXPECT_NEAR(fill(mixer).back(), 0.0625f, 1e-3);
}

TEST(LiveMixerThreads, PostAndFillConcurrently) {
  LiveMixer mixer;
  std::atomic<bool> ends{false};
  double loudest = 0;
  std::thread device([&] {
    std::vector<float> samples(2 * 256);
    while (!ends) {
      mixer.fill(samples);
      loudest = std::max(loudest, peak(samples));
    }
  });
  Random random(1);
  mixer.play_music(
      [] { return audio::MusicDecoder::open(formats::write_wav(sine_wav(440, 0.5, 44100, 44100))); });
  for (int step = 0; step < effort(3000, 500); ++step) {
    audio::Scene scene = quiet_scene();
    scene.listener.origin_world = random.in_cube(100);
    SoundEvents events =
        started(sine_sound(random.log_uniform(50, 5000), 0.5, 1 + random.below(20000)),
                static_cast<std::int32_t>(random.below(20)), static_cast<int>(random.below(8)));
    events.stops_all = random.chance(0.01);
    if (random.chance(0.3)) events.stopped.push_back({static_cast<std::int32_t>(random.below(20)), 1});
    mixer.post(scene, events);
    if (random.chance(0.02)) mixer.pause_music(random.chance(0.5));
    if (random.chance(0.3)) std::this_thread::yield();
  }
  ends = true;
  device.join();
  EXPECT_LE(loudest, 1);
  EXPECT_GT(loudest, 0);
}

}  // namespace
}  // namespace temblor::test
