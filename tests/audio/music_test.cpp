// Tests music: all file formats, looping, damaged files, and the decoder thread.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>

#include <chrono>
#include <cmath>
#include <future>
#include <numbers>
#include <thread>

#include "audio/mixing/music_stream.h"
#include "audio/music_decoder.h"
#include "audio/signals.h"
#include "support/game_data.h"
#include "support/mutations.h"
#include "support/programs/temporary_folder.h"
#include "support/random.h"

// The leak sanitizer calls this. libsndfile 1.2 leaks memory of libvorbis if a file is damaged.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libvorbis";  // the module: its functions have no names without a symbolizer
}

namespace temblor::test {
namespace {

using audio::kFramesPerSecond;
using audio::MusicDecoder;

struct Kind {
  const char* name;
  int format, frames_per_second, channels;
};

// Two seconds: 440 Hz left, 1000 Hz right, at half of full scale, encoded by libsndfile.
base::ByteVector music_file(const Kind& kind) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "music").string();
  SF_INFO info{};
  info.samplerate = kind.frames_per_second;
  info.channels = kind.channels;
  info.format = kind.format;
  SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
  if (file == nullptr) return {};
  std::vector<float> samples;
  for (int i = 0; i < 2 * kind.frames_per_second; ++i)
    for (int channel = 0; channel < kind.channels; ++channel)
      samples.push_back(static_cast<float>(
          0.5 * std::sin(2 * std::numbers::pi * (channel == 0 ? 440 : 1000) * i / kind.frames_per_second)));
  sf_writef_float(file, samples.data(), 2 * kind.frames_per_second);
  sf_close(file);
  return read_file(path);
}

Stereo split(std::span<const float> samples) {
  Stereo stereo;
  for (std::size_t i = 0; i + 1 < samples.size(); i += 2) {
    stereo.left.push_back(samples[i]);
    stereo.right.push_back(samples[i + 1]);
  }
  return stereo;
}

class Music : public ::testing::TestWithParam<Kind> {};

TEST_P(Music, DecodesAtTheMixersRate) {
  const base::ByteVector bytes = music_file(GetParam());
  if (bytes.empty()) GTEST_SKIP() << "this libsndfile does not write " << GetParam().name;
  MusicDecoder music = MusicDecoder::open(bytes).value();
  std::vector<float> samples(2 * kFramesPerSecond);
  for (std::size_t at = 0; at < samples.size(); at += 1200) music.read(std::span(samples).subspan(at, 1200));
  const Stereo heard = split(std::span(samples).subspan(20000, 40000));
  const bool mono = GetParam().channels == 1;
  EXPECT_NEAR(to_db(measure_amplitude(heard.left, 440) / 0.5), 0, 0.3);
  EXPECT_NEAR(to_db(measure_amplitude(heard.right, mono ? 440 : 1000) / 0.5), 0, 0.3);
  EXPECT_LT(rest_db(heard.left, 440), -30) << "lossy codecs leave little else";
  EXPECT_FALSE(music.has_failed());
}

TEST_P(Music, LoopsAtTheEnd) {
  const base::ByteVector bytes = music_file(GetParam());
  if (bytes.empty()) GTEST_SKIP() << "this libsndfile does not write " << GetParam().name;
  MusicDecoder music = MusicDecoder::open(bytes).value();
  std::vector<float> samples(2 * 7 * kFramesPerSecond);
  music.read(samples);
  EXPECT_FALSE(music.has_failed());
  for (const std::size_t second : {0u, 3u, 6u}) {
    const Stereo heard = split(std::span(samples).subspan(second * 96000 + 24000, 48000));
    EXPECT_NEAR(to_db(measure_amplitude(heard.left, 440) / 0.5), 0, 0.3) << second;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Music,
                         ::testing::Values(Kind{"vorbis", SF_FORMAT_OGG | SF_FORMAT_VORBIS, 44100, 2},
                                           Kind{"opus", SF_FORMAT_OGG | SF_FORMAT_OPUS, 48000, 2},
                                           Kind{"flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 44100, 2},
                                           Kind{"mp3", SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III, 44100, 2},
                                           Kind{"wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 22050, 2},
                                           Kind{"float", SF_FORMAT_WAV | SF_FORMAT_FLOAT, 48000, 2},
                                           Kind{"mono", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 32000, 1},
                                           Kind{"four_channels", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 48000, 4}),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

TEST(DamagedMusic, FailsOrDecodesWithoutACrash) {
  EXPECT_FALSE(MusicDecoder::open({}).ok());
  EXPECT_FALSE(MusicDecoder::open(to_bytes("this is no music, it only pretends to be some")).ok());
  for (const Kind& kind : {Kind{"vorbis", SF_FORMAT_OGG | SF_FORMAT_VORBIS, 44100, 2},
                           Kind{"flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 44100, 2},
                           Kind{"wav", SF_FORMAT_WAV | SF_FORMAT_FLOAT, 44100, 2}}) {
    const base::ByteVector whole = music_file(kind);
    if (whole.empty()) continue;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      Random random(seed);
      base::ByteVector bytes = with_flipped_bits(whole, random);
      if (seed % 3 == 0) bytes.resize(random.below(bytes.size()));
      base::Result<MusicDecoder> music = MusicDecoder::open(bytes);
      if (!music.ok()) continue;
      std::vector<float> samples(2 * kFramesPerSecond, 99.0f);
      music->read(samples);
      EXPECT_LE(peak(samples), 8) << kind.name << ", seed " << seed;
    }
  }
}

TEST(DamagedMusic, EmptyFileIsSilence) {
  formats::Wav wav{.frames_per_second = 44100, .channels = 2, .bits = 16, .samples = {}, .loop = {}};
  base::Result<MusicDecoder> music = MusicDecoder::open(formats::write_wav(wav));
  if (!music.ok()) return;
  std::vector<float> samples(1000, 99.0f);
  music->read(samples);
  EXPECT_EQ(peak(samples), 0);
  EXPECT_TRUE(music->has_failed());
}

TEST(StockMusic, Plays) {
  DATA_FOLDER_OR_SKIP(data);
  MusicDecoder music = MusicDecoder::open(read_file(data / "id1/music/track02.ogg")).value();
  std::vector<float> samples(20 * kFramesPerSecond);
  music.read(samples);
  EXPECT_GT(rms(samples), 0.005);
}

audio::OpenMusic tone(double frequency_hz) {
  return [frequency_hz] {
    return MusicDecoder::open(formats::write_wav(sine_wav(frequency_hz, 0.5, 48000, 48000)));
  };
}

void wait_until_ready(const audio::MusicStream& stream) {
  for (int i = 0; i < 5000 && stream.frames_ready() < 20000; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ASSERT_GE(stream.frames_ready(), 20000u);
}

TEST(MusicStreamThreads, PlaysSilenceThenDecodedMusic) {
  audio::MusicStream stream;
  std::vector<float> samples(2 * 16000, 99.0f);
  stream.read(samples);
  EXPECT_EQ(peak(samples), 0);
  stream.play(tone(440));
  wait_until_ready(stream);
  stream.read(samples);
  EXPECT_NEAR(measure_amplitude(split(samples).left, 440), 0.5, 1e-3);
}

TEST(MusicStreamThreads, TrackChangePauseAndStopDoNotClick) {
  audio::MusicStream stream;
  stream.play(tone(440));
  wait_until_ready(stream);
  std::vector<float> heard;
  const auto listen = [&](std::size_t frames) {
    std::vector<float> samples(2 * frames);
    stream.read(samples);
    const Stereo stereo = split(samples);
    heard.insert(heard.end(), stereo.left.begin(), stereo.left.end());
    return measure_amplitude(std::span(stereo.left).last(frames / 2), 440);
  };
  EXPECT_NEAR(listen(4817), 0.5, 0.01);
  stream.set_paused(true);
  EXPECT_LT(listen(4817), 1e-3);
  stream.set_paused(false);
  EXPECT_NEAR(listen(4817), 0.5, 0.01);
  stream.play(tone(880));
  // The new track starts as soon as the decoder thread has opened it.
  for (int i = 0; i < 3000 && listen(960) > 0.1; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_LT(listen(960), 0.1);
  stream.play(nullptr);
  for (int i = 0; i < 3000 && stream.frames_ready() > 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  listen(4800);
  EXPECT_EQ(heard.back(), 0);
  // Allows 2 % of the largest possible step, plus the natural step of the 880 Hz tone.
  EXPECT_LT(largest_step(heard), 0.02 + 0.5 * 2 * std::numbers::pi * 880 / kFramesPerSecond + 0.01);
}

// Requests another track while a slow disk still opens the first one.
TEST(MusicStreamThreads, PlayDoesNotWaitForAFile) {
  audio::MusicStream stream;
  stream.play(tone(440));
  wait_until_ready(stream);
  std::promise<void> disk;
  const std::shared_future<void> disk_is_done = disk.get_future().share();
  stream.play([disk_is_done]() -> base::Result<MusicDecoder> {
    disk_is_done.wait();
    return base::malformed("no music");
  });
  // The decoder thread drops the old music when it starts to open the new track.
  for (int i = 0; i < 5000 && stream.frames_ready() > 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(stream.frames_ready(), 0u);
  stream.play(tone(880));
  std::vector<float> silence(2 * 4800, 99.0f);
  stream.read(silence);
  EXPECT_EQ(silence.back(), 0) << "the slow open is still in progress";
  disk.set_value();
  wait_until_ready(stream);
  EXPECT_FALSE(stream.take_failure()) << "newer music hides the failure";
  std::vector<float> samples(2 * 16000);
  stream.read(samples);
  const std::vector<float> left = split(samples).left;
  EXPECT_NEAR(measure_amplitude(std::span(left).last(8000), 880), 0.5, 1e-2);
}

// A track of 440 Hz with a combat layer.
class CombatLayer : public ::testing::Test {
 protected:
  void start(audio::OpenMusic layer) {
    stream.play(tone(440), std::move(layer));
    wait_until_ready(stream);
  }
  // Returns `frames` frames of the left channel.
  std::vector<float> listen(std::size_t frames) {
    std::vector<float> heard;
    while (heard.size() < frames) {
      std::vector<float> samples(2 * std::min<std::size_t>(4800, frames - heard.size()));
      while (stream.frames_ready() < samples.size() / 2)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      stream.read(samples);
      const Stereo stereo = split(samples);
      heard.insert(heard.end(), stereo.left.begin(), stereo.left.end());
    }
    return heard;
  }
  // Listens for whole periods of both tones, so that the track does not spill into the layer's measurement.
  double layer_level() { return measure_amplitude(listen(kLevel_frames), 880); }

  // The layer is the negative of the track, but lasts only a quarter of a second, so the sum is silence as
  // long as both repeat in step.
  void expect_silence_with_negative_layer(std::uint32_t rate) {
    const auto open = [rate](std::size_t frames, double level) -> audio::OpenMusic {
      return [=] { return MusicDecoder::open(formats::write_wav(sine_wav(440, level, rate, frames))); };
    };
    stream.set_combat(true);
    stream.play(open(rate, 0.5), open(rate / 4, -0.5));
    wait_until_ready(stream);
    listen(kFramesPerSecond + 4800);
    EXPECT_LT(peak(listen(5 * kFramesPerSecond)), 1e-6f);
  }

  static constexpr std::size_t kLevel_frames = kFramesPerSecond / 20;  // 22 and 44 periods

  audio::MusicStream stream;
};

TEST_F(CombatLayer, RisesInOneSecondAndFallsInSix) {
  start(tone(880));
  EXPECT_LT(layer_level(), 1e-3);
  stream.set_combat(true);
  listen(kFramesPerSecond / 2 - kLevel_frames / 2);
  EXPECT_NEAR(layer_level(), 0.25, 0.01);
  listen(kFramesPerSecond / 2);
  EXPECT_NEAR(layer_level(), 0.5, 0.01);
  stream.set_combat(false);
  listen(3 * kFramesPerSecond - kLevel_frames / 2);
  EXPECT_NEAR(layer_level(), 0.25, 0.01);
  listen(3 * kFramesPerSecond);
  EXPECT_LT(layer_level(), 1e-3);
}

TEST_F(CombatLayer, StaysWithTheTrackToTheSample) {
  expect_silence_with_negative_layer(48000);
}

TEST_F(CombatLayer, StaysWithTheTrackToTheSampleIfResampled) {
  expect_silence_with_negative_layer(32000);
}

TEST_F(CombatLayer, IsReportedOnceIfDamaged) {
  start([] { return MusicDecoder::open(to_bytes("this is no music")); });
  stream.set_combat(true);
  const std::optional<base::Error> failure = stream.take_combat_failure();
  ASSERT_TRUE(failure);
  EXPECT_THAT(failure->message(), testing::HasSubstr("not a playable music file"));
  EXPECT_FALSE(stream.take_combat_failure());
  EXPECT_FALSE(stream.take_failure());
  EXPECT_NEAR(measure_amplitude(listen(4800), 440), 0.5, 1e-2) << "the track plays alone";
}

TEST(MusicStreamThreads, UnreadableMusicIsReportedOnce) {
  audio::MusicStream stream;
  stream.play([] { return MusicDecoder::open(to_bytes("this is no music")); });
  std::optional<base::Error> failure;
  for (int i = 0; i < 5000 && !failure; ++i) {
    failure = stream.take_failure();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_TRUE(failure);
  EXPECT_THAT(failure->message(), testing::HasSubstr("not a playable music file"));
  EXPECT_FALSE(stream.take_failure());
}

}  // namespace
}  // namespace temblor::test
