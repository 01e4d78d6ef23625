// Compares the signals of sound scripts with physics and arithmetic.
#include <gtest/gtest.h>
#include <sndfile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/scripts/script.h"
#include "artgen/sounds/curve.h"
#include "artgen/sounds/mastering.h"
#include "artgen/sounds/music/music_maker.h"
#include "artgen/sounds/music/patch.h"
#include "artgen/sounds/sound_maker.h"
#include "artgen/sounds/vorbis_file.h"
#include "formats/sounds/wav.h"
#include "support/programs/temporary_folder.h"
#include "support/random.h"

namespace temblor::artgen {
namespace {

std::vector<ScriptLine> parse_sound_lines(std::string_view text) {
  base::Result<std::vector<ScriptLine>> lines = read_script(text);
  EXPECT_TRUE(lines.ok());
  return lines.ok() ? std::move(lines).value() : std::vector<ScriptLine>();
}

Signal patch(std::string_view text, double seconds) {
  const base::Result<Signal> signal =
      render_patch(parse_sound_lines(text), {kSynthesisRate, seconds, seconds, 1, 7});
  EXPECT_TRUE(signal.ok()) << (signal.ok() ? "" : signal.error().message());
  return signal.ok() ? *signal : Signal();
}

std::string sound_error(std::string_view sound) {
  const base::Result<std::vector<ArtPart>> made = make_sound_file(parse_sound_lines(sound).front());
  return made.ok() ? "none" : made.error().message();
}

// The amplitude of a sine of this frequency in the signal, by a windowed Fourier sum.
double measure_sine(const Signal& signal, double hertz, double rate = kSynthesisRate, std::size_t from = 0,
                    std::size_t count = std::string::npos) {
  count = std::min(count, signal.size() - from);
  std::complex<double> sum = 0;
  double weights = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i);
    const double weight = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * t / static_cast<double>(count));
    sum += weight * signal[from + i] * std::polar(1.0, -2 * std::numbers::pi * hertz * t / rate);
    weights += weight;
  }
  return 2 * std::abs(sum) / weights;
}

double db(double ratio) {
  return 20 * std::log10(ratio);
}

TEST(SoundLanguage, CurvesGoThroughTheirPoints) {
  const std::vector<ScriptLine> lines =
      parse_sound_lines("x level=0..1@0.5..0 pitch=100..400 steady=3 even=0..1..0");
  Arguments arguments(lines.front());
  const Curve level = read_curve_setting(arguments, "level", 1, {0, 1}, 2);
  for (const auto& [time_s, value] :
       std::vector<std::pair<double, double>>{{0, 0}, {0.25, 0.5}, {0.5, 1}, {1.25, 0.5}, {2, 0}, {9, 0}})
    EXPECT_NEAR(level.at(time_s), value, 1e-12) << time_s;
  EXPECT_NEAR(read_curve_setting(arguments, "pitch", 1, kHertz, 2).at(1), 200, 1e-9);
  EXPECT_EQ(read_curve_setting(arguments, "steady", 1, {0, 5}, 2).at(1), 3);
  EXPECT_NEAR(read_curve_setting(arguments, "even", 1, {0, 1}, 3).at(1.5), 1, 1e-12);
  EXPECT_EQ(read_curve_setting(arguments, "missing", 0.25, {0, 1}, 3).at(1), 0.25);
  EXPECT_TRUE(arguments.finish().ok());
}

TEST(SoundLanguage, ASawHasTheHarmonicsOfItsSeries) {
  const Signal saw = patch("tone saw pitch=200 attack=0 fade=0", 1);
  for (int n = 1; n <= 12; ++n)
    EXPECT_NEAR(measure_sine(saw, 200.0 * n), 2 / (std::numbers::pi * n), 0.02) << n;
  // Harmonics above half the rate must not be mirrored into the audible range.
  const Signal high = patch("tone saw pitch=4100 attack=0 fade=0", 1);
  EXPECT_LT(db(measure_sine(high, kSynthesisRate - 6 * 4100.0) / measure_sine(high, 4100)), -25);
}

TEST(SoundLanguage, GlidesReachTheirPitch) {
  const Signal tone = patch("tone sine pitch=200..800 attack=0 fade=0", 1);
  const std::size_t window = 2048, end = tone.size() - window;
  EXPECT_GT(measure_sine(tone, 205, kSynthesisRate, 0, window), 0.8);
  EXPECT_GT(measure_sine(tone, 780, kSynthesisRate, end, window), 0.8);
  EXPECT_LT(measure_sine(tone, 780, kSynthesisRate, 0, window), 0.1);
}

TEST(SoundLanguage, FiltersAttenuateAsSpecified) {
  const auto through = [](const std::string& filter, double hertz) {
    return db(measure_sine(patch("tone sine pitch=" + std::to_string(hertz) + "\n  " + filter, 1), hertz));
  };
  EXPECT_NEAR(through("lowpass 500", 50), 0, 0.2);
  EXPECT_NEAR(through("lowpass 500", 4000), -36, 2);          // two poles, three octaves
  EXPECT_NEAR(through("lowpass 500 times=2", 4000), -72, 4);  // and twice
  EXPECT_NEAR(through("highpass 4000", 500), -36, 2);
  EXPECT_NEAR(through("bandpass 1000 q=10", 1000), 0, 0.2);
  EXPECT_LT(through("bandpass 1000 q=10", 2000), -20);
  EXPECT_NEAR(through("boost 1000 by=4 q=5", 1000), 12.04, 0.3);
}

TEST(SoundLanguage, StruckObjectsRingAsLongAsSpecified) {
  const Signal bar = patch("strike bar pitch=440 ring=1 hardness=0.6 fade=0", 1.2);
  const std::size_t window = 4096;
  const auto at = [&](double seconds) {
    return measure_sine(bar, 440, kSynthesisRate, count_frames(seconds, kSynthesisRate), window);
  };
  EXPECT_NEAR(db(at(0.6) / at(0.1)), -30, 1.5);  // 60 dB a second
  // The second mode of a free bar has 2.756 times the frequency of the first and fades earlier.
  const auto second = [&](double seconds) {
    return measure_sine(bar, 440 * 2.756, kSynthesisRate, count_frames(seconds, kSynthesisRate), window);
  };
  EXPECT_GT(second(0.0), 10 * measure_sine(bar, 440 * 2.0, kSynthesisRate, 0, window));
  EXPECT_LT(second(0.6) / second(0.1), at(0.6) / at(0.1));
}

TEST(SoundLanguage, AStringIsInTune) {
  for (const double hertz : {55.0, 110.0, 196.0, 440.0}) {
    const Signal string = patch("pluck ring=3 pitch=" + std::to_string(hertz), 1);
    const double own = measure_sine(string, hertz);
    EXPECT_GT(own, 3 * measure_sine(string, hertz * 1.03)) << hertz;
    EXPECT_GT(own, 3 * measure_sine(string, hertz * 0.97)) << hertz;
  }
}

TEST(SoundLanguage, VowelsHaveTheirResonances) {
  const auto near = [](const Signal& voice, double hertz) {
    double sum = 0;  // harmonics of 100 Hz within a band around it
    for (double f = std::round(hertz / 100) * 100 - 100; f < hertz + 150; f += 100)
      sum = std::max(sum, measure_sine(voice, f));
    return sum;
  };
  const Signal a = patch("throat a pitch=100 rough=0 breath=0", 1);
  const Signal i = patch("throat i pitch=100 rough=0 breath=0", 1);
  EXPECT_GT(db(near(a, 730) / near(a, 300)), 6);
  EXPECT_GT(db(near(i, 270) / near(i, 730)), 6);
  // A vocal tract that is twice as long has formants an octave lower.
  const Signal big = patch("throat a size=2 pitch=100 rough=0 breath=0", 1);
  EXPECT_GT(near(big, 365), 2 * near(big, 900));
}

TEST(SoundLanguage, RepetitionsAreOnTime) {
  const Signal clicks = patch("tone sine pitch=1000 for=0.01 times=3 every=0.2", 0.7);
  const auto power = [&](double from_s, double to_s) {
    double sum = 0;
    for (std::size_t i = count_frames(from_s, kSynthesisRate); i < count_frames(to_s, kSynthesisRate); ++i)
      sum += clicks[i] * clicks[i];
    return sum;
  };
  for (const double at : {0.0, 0.2, 0.4}) {
    EXPECT_GT(power(at, at + 0.012), 50) << at;
    EXPECT_LT(power(at + 0.02, at + 0.19), 1e-9) << at;
  }
}

TEST(SoundLanguage, HalfTheRateKeepsTheFrequenciesItCanRepresent) {
  const Signal low = halve_rate(patch("tone sine pitch=1000", 1));
  EXPECT_NEAR(db(measure_sine(low, 1000, kSynthesisRate / 2)), 0, 0.05);
  const Signal high = halve_rate(patch("tone sine pitch=15000", 1));
  EXPECT_LT(db(measure_sine(high, kSynthesisRate / 2 - 15000, kSynthesisRate / 2)), -60);
}

TEST(SoundLanguage, DroppedBitsAreFarBelowTheSignal) {
  test::Random random(1);
  for (const int loudest : {3, 127, 128, 1000, 20000, 31784}) {
    std::vector<std::int16_t> samples;
    for (int i = 0; i < 32; ++i)
      samples.push_back(static_cast<std::int16_t>(
          static_cast<int>(random.below(2 * static_cast<std::size_t>(loudest) + 1)) - loudest));
    samples[7] = static_cast<std::int16_t>(loudest % 2 == 0 ? loudest : -loudest);
    samples.insert(samples.end(), {1, -2, 3, -4});  // a shorter block
    std::vector<std::int16_t> kept = samples;
    drop_masked_bits(kept);
    for (std::size_t i = 0; i < 32; ++i) EXPECT_LE(std::abs(kept[i] - samples[i]) * 128, loudest);
    for (std::size_t i = 32; i < samples.size(); ++i) EXPECT_EQ(kept[i], samples[i]);
    const std::set<std::int16_t> values(kept.begin(), kept.begin() + 32);
    if (loudest > 127) {
      const int step = 1 << (static_cast<int>(std::log2(loudest)) - 6);
      for (const int value : values) EXPECT_EQ(value % step, 0) << loudest;
    } else {
      EXPECT_EQ(kept, samples);
    }
  }
  std::vector<std::int16_t> full = {32767, -32768, 32767, -32768};
  drop_masked_bits(full);
  EXPECT_EQ(full[0], 32256);  // the highest step that a sample can hold
  EXPECT_EQ(full[1], -32768);
}

TEST(SoundLanguage, ALoopContinuesAtItsStart) {
  const std::string text =
      "sound x/y length=1 loop=0.25 class=ambience blend=0.2\n"
      "  noise pink\n"
      "    lowpass 300\n";
  const base::Result<std::vector<ArtPart>> made = make_sound_file(parse_sound_lines(text).front());
  ASSERT_TRUE(made.ok());
  const base::Result<formats::Wav> wav = formats::read_wav(made->front().bytes);
  ASSERT_TRUE(wav.ok());
  ASSERT_TRUE(wav->loop.has_value());
  EXPECT_EQ(wav->loop->end, wav->frame_count());
  EXPECT_NEAR(wav->loop->start, 0.25 * 22050, 1);
  // The step from the last sample to the start of the loop is as small as the one before the loop's start.
  const int before = wav->samples[wav->loop->start - 1], last = wav->samples.back();
  EXPECT_LT(std::abs(before - last), 400);
}

TEST(SoundLanguage, ErrorsNameTheLine) {
  EXPECT_NE(sound_error("sound x/y length=1\n  hum pitch=3")
                .find("line 2: hum: expected a voice or an effect: tone"),
            std::string::npos);
  EXPECT_NE(sound_error("sound x/y length=1\n  tone saw pitch=high")
                .find("line 2: tone: pitch=high must be a number"),
            std::string::npos);
  EXPECT_NE(sound_error("sound x/y length=1\n  tone round").find("'round' is not one of sine, triangle"),
            std::string::npos);
  EXPECT_NE(sound_error("sound x/y length=1\n  strike cheese").find("'cheese' is not one of bar, bell"),
            std::string::npos);
  EXPECT_NE(sound_error("sound x/y length=1\n  throat x").find("'x' is not a vowel sequence"),
            std::string::npos);
  EXPECT_NE(sound_error("sound x/y length=1\n  tone sine loud=3").find("unknown setting 'loud'"),
            std::string::npos);
  EXPECT_NE(sound_error("sound x/y length=1\n  tone sine at=2").find("begins after the end of the sound"),
            std::string::npos);
  EXPECT_NE(sound_error("sound x/y\n  tone sine").find("length= (seconds) is required"), std::string::npos);
  EXPECT_NE(sound_error("sound ../y length=1\n  tone sine").find("FOLDER/NAME"), std::string::npos);
  EXPECT_NE(sound_error("sound x/y length=1 class=loud\n  tone sine").find("not one of blast, weapon"),
            std::string::npos);
}

TEST(SoundLanguage, NotesHaveTheirPitchAndWrapAround) {
  const std::vector<ScriptLine> lines = parse_sound_lines(
      "music track09 bpm=60 bars=2 beats=4\n"
      "  instrument flute tail=1 room=0\n"
      "    tone sine pitch=1 attack=0.01 fade=0.01\n"
      "  pattern one flute\n"
      "    notes A4:1 _:2 C5:1\n"
      "  play one at=1\n"
      "  play one at=2 transpose=12\n");
  const base::Result<Score> score = read_score(lines.front());
  ASSERT_TRUE(score.ok()) << score.error().message();
  const auto channels = render_score(*score);
  ASSERT_TRUE(channels.ok());
  const Signal& left = (*channels)[0];
  ASSERT_EQ(left.size(), count_frames(8, kMusicRate));
  const auto heard = [&](double seconds, double hertz) {
    return measure_sine(left, hertz, kMusicRate, count_frames(seconds, kMusicRate),
                        count_frames(0.8, kMusicRate));
  };
  EXPECT_GT(heard(1.1, 440), 0.05);  // the second beat is the tail
  EXPECT_LT(heard(2.1, 440), 0.001);
  EXPECT_GT(heard(3.1, 523.25), 0.05);  // C5
  EXPECT_GT(heard(7.1, 1046.5), 0.05);  // an octave higher, in the last beat
  EXPECT_GT(heard(0.1, 1046.5), 0.05);  // its tail wraps around
}

TEST(SoundLanguage, CombatLayerFitsOnTopOfThePiece) {
  // A bar lasts 106,666.7 frames, so the rounding matters.
  const std::vector<ScriptLine> lines = parse_sound_lines(
      "music track09 bpm=72 bars=8 beats=4 fight_bars=2\n"
      "  instrument horn tail=0.1 room=0\n"
      "    tone square pitch=1 attack=0.01 fade=0.01\n"
      "  pattern one horn\n"
      "    notes A4:4\n"
      "  play one at=1 times=8\n"
      "  fight one at=2\n");
  const base::Result<Score> score = read_score(lines.front());
  ASSERT_TRUE(score.ok()) << score.error().message();
  EXPECT_EQ(score->pattern_plays.size(), 1u);
  const auto piece = render_score(*score);
  const auto layer = render_combat_layer(*score, *piece);
  ASSERT_TRUE(layer.ok());
  const Signal& left = (*piece)[0];
  ASSERT_EQ(layer->size() * 4, left.size());
  double peak = 0, layer_peak = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const double sample = (*layer)[i % layer->size()];
    layer_peak = std::max(layer_peak, std::abs(sample));
    peak = std::max(peak, std::abs(left[i] + sample));
  }
  EXPECT_LE(peak, std::pow(10.0, -1.0 / 20));
  EXPECT_GT(layer_peak, 0.1);
  const auto parts = make_music_file(lines.front());
  ASSERT_TRUE(parts.ok());
  ASSERT_EQ(parts->size(), 2u);
  EXPECT_EQ((*parts)[1].path, "music/track09_combat.ogg");
}

TEST(SoundLanguage, MusicErrorsNameTheProblem) {
  const auto error = [](const std::string& below) {
    const std::vector<ScriptLine> lines = parse_sound_lines("music track02 bars=2\n" + below);
    const base::Result<Score> score = read_score(lines.front());
    return score.ok() ? "none" : score.error().message();
  };
  EXPECT_NE(error("  pattern p lute").find("no instrument 'lute' is defined above this line"),
            std::string::npos);
  EXPECT_NE(error("  instrument a\n  pattern p a\n    notes H4").find("'H4' is not a note"),
            std::string::npos);
  EXPECT_NE(error("  instrument a\n  pattern p a\n    notes A4:0").find("'A4:0' is not a note"),
            std::string::npos);
  EXPECT_NE(
      error("  instrument a\n  pattern p a\n    notes A4\n  play p at=3").find("after the end of the piece"),
      std::string::npos);
  EXPECT_NE(error("  instrument a\n  pattern p a\n    notes A4\n  fight p at=3").find("after the end"),
            std::string::npos);
  const std::vector<ScriptLine> uneven = parse_sound_lines("music track02 bars=5 fight_bars=2\n");
  EXPECT_NE(read_score(uneven.front()).error().message().find("fight_bars= must divide bars="),
            std::string::npos);
  EXPECT_NE(error("  dance").find("expected instrument, pattern, play, fight, or room"), std::string::npos);
}

TEST(SoundLanguage, VorbisIsReadByAnotherLibraryAndReproducible) {
  std::array<Signal, 2> channels = {patch("tone sine pitch=440 level=0.5", 1),
                                    patch("tone sine pitch=660 level=0.25", 1)};
  VorbisSettings settings;
  settings.frames_per_second = static_cast<long>(kSynthesisRate);
  settings.quality = 0.5F;
  const base::Result<base::ByteVector> bytes = write_vorbis(channels, settings);
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(*bytes, *write_vorbis(channels, settings));
  const test::TemporaryFolder folder;
  const std::string path = folder.write("x.ogg", *bytes).string();
  SF_INFO info{};
  SNDFILE* const file = sf_open(path.c_str(), SFM_READ, &info);
  ASSERT_NE(file, nullptr);
  std::vector<double> both(static_cast<std::size_t>(info.frames) * 2);
  EXPECT_EQ(sf_readf_double(file, both.data(), info.frames), info.frames);
  sf_close(file);
  ASSERT_EQ(info.channels, 2);
  ASSERT_EQ(static_cast<std::size_t>(info.frames), channels[0].size());
  std::array<Signal, 2> read;
  for (std::size_t i = 0; i < both.size(); ++i) read[i % 2].push_back(both[i]);
  EXPECT_NEAR(measure_sine(read[0], 440), 0.5, 0.02);
  EXPECT_NEAR(measure_sine(read[1], 660), 0.25, 0.02);
  settings.frames_per_second = 1'000'000;
  EXPECT_FALSE(write_vorbis(channels, settings).ok());
}

}  // namespace
}  // namespace temblor::artgen
