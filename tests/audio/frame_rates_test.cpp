// A game sounds the same at 30, 72 or 1,000 frames per second: with the same events and the same path of the
// listener, only the number of scene updates differs.
#include <gtest/gtest.h>

#include <cmath>

#include "audio/mixer.h"
#include "audio/signals.h"

namespace temblor::test {
namespace {

constexpr double kLength_s = 6;

// The listener walks and turns; it passes water and dives.
audio::Scene make_moving_scene(double time_s) {
  audio::Scene scene = quiet_scene();
  scene.listener.origin_world = {static_cast<float>(320 * time_s), 50, 0};
  const double yaw = 2.5 * std::sin(1.3 * time_s);
  scene.listener.right = {static_cast<float>(std::sin(yaw)), static_cast<float>(-std::cos(yaw)), 0};
  scene.listener.underwater = time_s > 2 && time_s < 3;
  scene.volumes.muffled_underwater = 1;
  scene.ambient_levels = {static_cast<std::uint8_t>(time_s > 1 && time_s < 3 ? 200 : 30), 90, 0, 0};
  return scene;
}

// About ten shots per second, on every second packet.
audio::SoundEvents make_events(int packet) {
  static const audio::SoundPtr shot = sine_sound(700, 0.2, 6000), hum = looping(sine_sound(200, 0.1, 2400));
  audio::SoundEvents events;
  if (packet == 0) {
    events.new_ambients = true;
    events.ambients = {looping(sine_sound(500, 0.4, 4800)), looping(sine_sound(300, 0.4, 4800)), nullptr,
                       nullptr};
    for (int i = 0; i < 8; ++i)
      events.statics.push_back({hum, {static_cast<float>(300 * i), i % 2 == 0 ? 100.0f : -80.0f, 0}, 1, 3});
  }
  if (packet % 2 == 1)
    events.started.push_back({.sound = shot,
                              .entity = packet % 6,
                              .channel = 1,
                              .origin_world = {static_cast<float>(15 * packet), 200, 0}});
  return events;
}

Stereo play(double updates_per_second) {
  audio::Mixer mixer;
  Stereo heard;
  std::size_t mixed = 0;
  const auto render_until = [&](double time_s) {
    const auto frame = static_cast<std::size_t>(std::llround(time_s * static_cast<double>(kSecond)));
    mixer.set_scene(make_moving_scene(time_s), frame - mixed);
    const Stereo part = rendered(mixer, frame - mixed);
    heard.left.insert(heard.left.end(), part.left.begin(), part.left.end());
    heard.right.insert(heard.right.end(), part.right.begin(), part.right.end());
    mixed = frame;
  };
  mixer.set_scene(make_moving_scene(0), 0);
  mixer.handle_events(make_events(0));
  int packet = 1;
  for (int update = 1; update <= kLength_s * updates_per_second; ++update) {
    const double time_s = update / updates_per_second;
    for (; packet * 0.0487 <= time_s; ++packet) {
      render_until(packet * 0.0487);
      mixer.handle_events(make_events(packet));
    }
    render_until(time_s);
  }
  return heard;
}

double difference_db(std::span<const float> one, std::span<const float> other) {
  std::vector<float> difference(one.begin(), one.end());
  for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= other[i];
  return to_db(rms(difference) / rms(one));
}

TEST(FrameRates, SoundTheSame) {
  const Stereo expected = play(72);
  EXPECT_GT(rms(expected.left), 0.05);
  for (const double rate : {30.0, 1000.0}) {
    const Stereo other = play(rate);
    ASSERT_EQ(other.left.size(), expected.left.size());
    EXPECT_LT(difference_db(expected.left, other.left), -25) << rate;
    EXPECT_LT(difference_db(expected.right, other.right), -25) << rate;
    // The level of each tenth of a second differs by at most 1 dB, which is barely audible.
    constexpr std::size_t kPiece = kSecond / 10;
    for (std::size_t at = 0; at + kPiece <= expected.left.size(); at += kPiece) {
      const double level = to_db(rms(std::span(expected.left).subspan(at, kPiece)));
      EXPECT_NEAR(to_db(rms(std::span(other.left).subspan(at, kPiece))), level, 1.0) << rate << " Hz, " << at;
    }
  }
}

TEST(FrameRates, RepeatedRunsMatchBitForBit) {
  const Stereo one = play(72), other = play(72);
  EXPECT_EQ(one.left, other.left);
  EXPECT_EQ(one.right, other.right);
}

}  // namespace
}  // namespace temblor::test
