// How clearly the nearest creature is heard among others, measured with the shipped voices in our mixer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "artgen/art.h"
#include "audio/mixer.h"
#include "audio/signals.h"
#include "base/parallel_for.h"
#include "formats/sounds/wav.h"
#include "support/game_data.h"

namespace temblor::artgen {
namespace {

constexpr float kNear_units = 150, kFar_units = 600;

const std::vector<std::string>& voice_names() {
  static const std::vector<std::string> names{"ogre/ogwake",     "soldier/sight1", "dog/dattack1",
                                              "knight/ksight",   "demon/sight2",   "zombie/z_idle",
                                              "enforcer/sight1", "shambler/ssight"};
  return names;
}

std::vector<audio::SoundPtr> make_voices() {
  const std::string path = TEMBLOR_SOURCE_DIR "/game/art/sounds/creatures.art";
  const base::ByteVector bytes = test::read_file(path);
  std::vector<ScriptLine> lines =
      read_script(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size())).value();
  const std::vector<std::string>& names = voice_names();
  std::erase_if(lines, [&](const ScriptLine& line) {
    return line.keyword != "sound" ||
           std::find(names.begin(), names.end(), line.values.front()) == names.end();
  });
  base::Jobs jobs(2);
  const std::vector<ArtFile> files = make_art(std::vector<ScriptFile>{{path, lines}}, jobs).value();
  std::map<std::string, audio::SoundPtr> sounds;
  for (const ArtFile& file : files)
    if (file.path.ends_with(".wav"))
      sounds[file.path] = audio::make_sound(formats::read_wav(file.bytes).value(), file.path).value();
  std::vector<audio::SoundPtr> voices;
  for (const std::string& name : names) voices.push_back(sounds.at("sound/" + name + ".wav"));
  return voices;
}

// The first voice comes from nearby, straight ahead; `far_count` others surround the listener.
std::vector<float> mix(const std::vector<audio::SoundPtr>& voices, bool near, std::size_t far_count,
                       bool focus) {
  audio::Mixer mixer;
  audio::Scene scene = test::quiet_scene();
  scene.volumes.sounds = 0.2f;  // below the limiter
  scene.volumes.focus = focus;
  mixer.set_scene(scene, 0);
  audio::SoundEvents events;
  const auto add = [&](std::size_t voice, const math::Vec3& origin) {
    events.started.push_back({.sound = voices[voice],
                              .entity = static_cast<std::int32_t>(voice) + 10,
                              .channel = 2,
                              .origin_world = origin,
                              .is_threat = true});
  };
  if (near) add(0, {kNear_units, 0, 0});
  for (std::size_t i = 1; i <= far_count; ++i) {
    const float turn = 0.8f * static_cast<float>(i);
    add(i, {kFar_units * std::cos(turn), kFar_units * std::sin(turn), 0});
  }
  mixer.handle_events(events);
  const test::Stereo heard = test::rendered_from_start(mixer, voices[0]->samples.size());
  std::vector<float> both = heard.left;
  both.insert(both.end(), heard.right.begin(), heard.right.end());
  return both;
}

// The level of the nearest voice above that of the sum of the others, in dB.
double measure_lead_db(const std::vector<audio::SoundPtr>& voices, std::size_t count, bool focus) {
  const std::vector<float> near = mix(voices, true, 0, focus);
  std::vector<float> others = mix(voices, true, count - 1, focus);
  for (std::size_t i = 0; i < others.size(); ++i) others[i] -= near[i];
  return test::to_db(test::rms(near) / test::rms(others));
}

TEST(Threats, TheNearestIsClearest) {
  const std::vector<audio::SoundPtr> voices = make_voices();
  for (const std::size_t count : {2u, 4u, 8u}) {
    const double before = measure_lead_db(voices, count, false);
    const double after = measure_lead_db(voices, count, true);
    ::testing::Test::RecordProperty("lead_db_" + std::to_string(count),
                                    std::to_string(before) + " -> " + std::to_string(after));
    EXPECT_NEAR(after - before, 9, 0.5) << count << " voices";
    EXPECT_GT(after, 6) << count << " voices: " << before << " dB before";
  }
  EXPECT_EQ(mix(voices, true, 0, true), mix(voices, true, 0, false)) << "one voice is as in the original";
  EXPECT_EQ(mix(voices, false, 7, true), mix(voices, false, 7, false)) << "voices from one distance too";
}

}  // namespace
}  // namespace temblor::artgen
