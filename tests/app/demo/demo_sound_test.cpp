// The sound of the generated demo (support/generated_demo.h), as `temblor render --demo` writes it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "app/program.h"
#include "audio/signals.h"
#include "formats/sounds/wav.h"
#include "support/game_data.h"
#include "support/generated_demo.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::size_t kSecond = 48000;
constexpr double kShot_hz = 600, kExplosion_hz = 900;

Stereo split_channels(const formats::Wav& wav) {
  Stereo stereo;
  for (std::size_t i = 0; i + 1 < wav.samples.size(); i += 2) {
    stereo.left.push_back(static_cast<float>(wav.samples[i]) / 32767);
    stereo.right.push_back(static_cast<float>(wav.samples[i + 1]) / 32767);
  }
  return stereo;
}

// A tenth of a second of sound from `first_s` on.
double tone_at(const std::vector<float>& samples, double first_s, double frequency_hz) {
  return measure_amplitude(
      std::span(samples).subspan(static_cast<std::size_t>(first_s * kSecond), kSecond / 10), frequency_hz);
}

bool have_ffmpeg() {
  return std::system("command -v ffmpeg >/dev/null 2>&1 && command -v ffprobe >/dev/null 2>&1") == 0;
}

class DemoSound : public ::testing::Test {
 protected:
  DemoSound() {
    game_.folder().write("id1/made.dem", make_recording({}).bytes);
    add("weapons/shot", sine_wav(kShot_hz, 0.5, 11025, 11025 * 2));
    add("weapons/r_exp3", sine_wav(kExplosion_hz, 0.5, 44100, 44100));
  }
  void add(const std::string& name, const formats::Wav& wav) const {
    game_.folder().write("id1/sound/" + name + ".wav", formats::write_wav(wav));
  }
  ProgramRun run(std::vector<std::string> words) const {
    words.insert(words.begin(), {"--basedir", game_.path().string(), "render", "--demo", "made"});
    return run_program(out_.path(), words);
  }
  formats::Wav read(const std::string& name) const {
    return formats::read_wav(read_file(out_.path() / name)).value();
  }
  formats::Wav sound(const std::vector<std::string>& words = {}) const {
    std::vector<std::string> all = {"-o", "x.wav"};
    all.insert(all.end(), words.begin(), words.end());
    const ProgramRun ran = run(all);
    EXPECT_EQ(ran.exit_status, 0) << ran.err;
    return read("x.wav");
  }

  MadeGame game_;
  TemporaryFolder out_;
};

TEST_F(DemoSound, EventsAreHeardAtTheirTime) {
  const formats::Wav wav = sound();
  EXPECT_EQ(wav.frames_per_second, kSecond);
  EXPECT_EQ(wav.channels, 2);
  EXPECT_EQ(wav.frame_count() % (kSecond / 30), 0u) << "a whole number of film frames";
  EXPECT_NEAR(static_cast<double>(wav.frame_count()) / kSecond, made_recording::kLength_s, 0.1);
  const Stereo heard = split_channels(wav);
  // Events of a packet happen at the time of the packet before it.
  const double early_s = made_recording::kPacket_s;
  const auto shot = static_cast<std::size_t>((1 - early_s) * kSecond);
  EXPECT_EQ(peak(std::span(heard.left).first(shot)), 0);
  EXPECT_GT(peak(std::span(heard.left).subspan(shot, 480)), 0.05) << "at once";
  EXPECT_NEAR(tone_at(heard.left, 1.1, kShot_hz), 0.5 * 0.7, 0.01)
      << "the player's own sounds have full volume";
  EXPECT_NEAR(tone_at(heard.right, 1.1, kShot_hz), 0.5 * 0.7, 0.01);
  EXPECT_LT(tone_at(heard.left, 1.5, kShot_hz), 1e-3) << "stopped";
  EXPECT_LT(tone_at(heard.left, 2.5, kExplosion_hz), 1e-3);
  // The rocket explodes ahead and to the right; the eye is 22 units above the player's origin.
  const math::Vec3 away = made_recording::kRocketTo - made_recording::kPlayer - math::Vec3(0, 0, 22);
  const double distance = static_cast<double>(glm::length(away)),
               side = static_cast<double>(-away.y) / distance;
  const double loudness = 0.5 * 0.7 * (1 - distance / 1000);
  EXPECT_NEAR(tone_at(heard.left, 3.1, kExplosion_hz), loudness * (1 - side), 0.003);
  EXPECT_NEAR(tone_at(heard.right, 3.1, kExplosion_hz), loudness * (1 + side), 0.003);
}

TEST_F(DemoSound, VolumeIsAVariable) {
  const Stereo heard = split_channels(sound({"--set", "volume=0.25"}));
  EXPECT_NEAR(tone_at(heard.left, 1.1, kShot_hz), 0.5 * 0.25, 0.01);
}

TEST_F(DemoSound, PartEqualsThatPartOfTheWhole) {
  const formats::Wav whole = sound(), part = sound({"--frames", "30:105"});
  ASSERT_EQ(part.frame_count(), 75 * kSecond / 30);
  const std::span<const std::int16_t> cut =
      std::span(whole.samples).subspan(2 * kSecond, part.samples.size());
  EXPECT_TRUE(std::equal(part.samples.begin(), part.samples.end(), cut.begin()));
}

TEST_F(DemoSound, DoesNotDependOnTheFrameRate) {
  const formats::Wav slow = sound({"--fps", "5"}), fast = sound({"--fps", "200"});
  const std::size_t count = std::min(slow.samples.size(), fast.samples.size());
  EXPECT_TRUE(std::equal(slow.samples.begin(), slow.samples.begin() + static_cast<std::ptrdiff_t>(count),
                         fast.samples.begin()));
}

TEST_F(DemoSound, ReportsEachMissingSoundOnce) {
  const ProgramRun ran = run({"-o", "x.wav"});
  const std::size_t first = ran.err.find("sound/wizard/hit.wav");
  ASSERT_NE(first, std::string::npos) << ran.err;
  EXPECT_EQ(ran.err.find("sound/wizard/hit.wav", first + 1), std::string::npos);
  EXPECT_THAT(ran.err, HasSubstr("silent"));
}

TEST_F(DemoSound, IsPartOfAFilm) {
  if (!have_ffmpeg()) GTEST_SKIP() << "no ffmpeg program";
  const ProgramRun ran = run({"--size", "64x48", "--fps", "10", "--frames", "0:40", "-o", "x.mp4"});
  ASSERT_EQ(ran.exit_status, 0) << ran.err;
  const std::string film = (out_.path() / "x.mp4").string(), decoded = (out_.path() / "decoded.wav").string();
  ASSERT_EQ(std::system(fmt::format("ffmpeg -loglevel error -i '{}' '{}'", film, decoded).c_str()), 0);
  const formats::Wav wav = read("decoded.wav");
  EXPECT_EQ(wav.frames_per_second, kSecond);
  EXPECT_NEAR(static_cast<double>(wav.frame_count()) / kSecond, 4, 0.05);
  const Stereo heard = split_channels(wav);
  EXPECT_LT(tone_at(heard.left, 0.5, kShot_hz), 1e-3);
  EXPECT_NEAR(tone_at(heard.left, 1.1, kShot_hz), 0.35, 0.03);
  EXPECT_LT(tone_at(heard.left, 1.6, kShot_hz), 1e-2);
}

TEST_F(DemoSound, NosoundMakesASilentFilm) {
  if (!have_ffmpeg()) GTEST_SKIP() << "no ffmpeg program";
  const ProgramRun ran =
      run({"--nosound", "--size", "64x48", "--fps", "10", "--frames", "0:5", "-o", "x.mp4"});
  ASSERT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_THAT(ran.err, Not(HasSubstr("sound/")));
  const std::string list = (out_.path() / "streams").string();
  ASSERT_EQ(
      std::system(fmt::format("ffprobe -v error -show_entries stream=codec_type -of csv=p=0 '{}' > '{}'",
                              (out_.path() / "x.mp4").string(), list)
                      .c_str()),
      0);
  EXPECT_EQ(read_text(list), "video\n");
}

TEST_F(DemoSound, InvalidOptionsAreErrors) {
  const ProgramRun silent = run({"--nosound", "-o", "x.wav"});
  EXPECT_EQ(silent.exit_status, 2);
  EXPECT_TRUE(is_one_error_line(silent.err)) << silent.err;
  const ProgramRun level = run_program(
      out_.path(), {"--basedir", game_.path().string(), "render", "--map", "small", "-o", "x.wav"});
  EXPECT_EQ(level.exit_status, 2);
  EXPECT_THAT(level.err, HasSubstr("--demo"));
  const ProgramRun nowhere = run({"-o", "none/x.wav"});
  EXPECT_EQ(nowhere.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(nowhere.err)) << nowhere.err;
}

}  // namespace
}  // namespace temblor::test
