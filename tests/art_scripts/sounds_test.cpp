// Checks the shipped sounds and music by their signals: all sounds that game code plays exist, have the
// loudness and length of their kind, and have no clicks, seams, or constant offset.
#include <gtest/gtest.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <map>
#include <numbers>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "art_scripts/stock_data.h"
#include "artgen/art.h"
#include "artgen/sounds/signal.h"
#include "base/parallel_for.h"
#include "formats/game/captions.h"
#include "formats/sounds/wav.h"
#include "support/game_data.h"
#include "support/programs/temporary_folder.h"

namespace temblor::artgen {
namespace {

namespace fs = std::filesystem;

std::string read_source_text(const fs::path& path) {
  const base::ByteVector bytes = test::read_file(path);
  return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

std::vector<ScriptFile> read_scripts_with(std::string_view word) {
  std::vector<ScriptFile> scripts;
  for (const fs::directory_entry& entry : fs::directory_iterator(TEMBLOR_SOURCE_DIR "/game/art/sounds")) {
    base::Result<std::vector<ScriptLine>> things = read_script(read_source_text(entry.path()));
    EXPECT_TRUE(things.ok()) << entry.path();
    if (!things.ok()) continue;
    std::erase_if(*things, [&](const ScriptLine& thing) { return thing.keyword != word; });
    scripts.push_back({entry.path().string(), *std::move(things)});
  }
  return scripts;
}

std::vector<ArtFile> make(const std::vector<ScriptFile>& scripts) {
  base::Jobs jobs(2);
  base::Result<std::vector<ArtFile>> art = make_art(scripts, jobs);
  EXPECT_TRUE(art.ok()) << (art.ok() ? "" : art.error().message());
  return art.ok() ? *std::move(art) : std::vector<ArtFile>();
}

using Sounds = std::map<std::string, formats::Wav>;

const Sounds& shipped_sounds() {
  static const Sounds sounds = [] {
    Sounds made;
    for (const ArtFile& file : make(read_scripts_with("sound"))) {
      if (!file.path.ends_with(".wav")) continue;
      base::Result<formats::Wav> wav = formats::read_wav(file.bytes);
      EXPECT_TRUE(wav.ok()) << file.path;
      made.emplace(file.path.substr(6), *std::move(wav));
    }
    return made;
  }();
  return sounds;
}

std::string find_class_name(const std::string& name) {
  static const std::map<std::string, std::string> classes = [] {
    std::map<std::string, std::string> all;
    for (const ScriptFile& script : read_scripts_with("sound"))
      for (const ScriptLine& thing : script.assets)
        for (const auto& [setting, value] : thing.settings)
          if (setting == "class") all[thing.values.front() + ".wav"] = value;
    return all;
  }();
  const auto found = classes.find(name);
  return found != classes.end() ? found->second : "impact";
}

std::vector<double> to_doubles(const formats::Wav& wav) {
  std::vector<double> samples;
  for (const std::int16_t sample : wav.samples) samples.push_back(sample / 32768.0);
  return samples;
}

double measure_loudest_db(const std::vector<double>& samples, double rate) {
  const auto window = static_cast<std::size_t>(rate / 10);
  double best = 0;
  for (std::size_t start = 0; start < samples.size(); start += window / 8) {
    double sum = 0;
    for (std::size_t i = start; i < std::min(samples.size(), start + window); ++i)
      sum += samples[i] * samples[i];
    best = std::max(best, sum / static_cast<double>(window));
  }
  return 10 * std::log10(best + 1e-12);
}

// The power of one bin of the Fourier transform, with a Hann window, from its definition.
double measure_bin_power(const std::vector<double>& samples, std::size_t start, std::size_t window,
                         std::size_t bin) {
  const auto turn =
      std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(bin) / static_cast<double>(window));
  std::complex<double> sum = 0, place = 1;
  for (std::size_t i = 0; i < window; ++i, place *= turn)
    sum +=
        samples[start + i] *
        (0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(window))) *
        place;
  return std::norm(sum);
}

// The centroid of the power spectrum of the whole sound.
double measure_centroid_hz(const std::string& name) {
  const formats::Wav& wav = shipped_sounds().at(name);
  const std::vector<double> samples = to_doubles(wav);
  constexpr std::size_t kWindow = 1024;
  double weighted = 0, powers = 0;
  for (std::size_t start = 0; start + kWindow <= samples.size(); start += kWindow * 2) {
    for (std::size_t bin = 1; bin < kWindow / 2; bin += 2) {
      const double power = measure_bin_power(samples, start, kWindow, bin);
      weighted += power * static_cast<double>(bin) * wav.frames_per_second / kWindow;
      powers += power;
    }
  }
  return weighted / powers;
}

const std::string kNull = "misc/null.wav";  // silence

TEST(ShippedSounds, EverySoundThatTheGameNamesExists) {
  const std::regex name("\"([a-z0-9_]+/[a-z0-9_]+\\.wav)\"");
  std::set<std::string> named;
  for (const char* folder : {"game/quakec", "src/client", "src/server"}) {
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(TEMBLOR_SOURCE_DIR) / folder)) {
      if (!entry.is_regular_file() ||
          (entry.path().extension() != ".qc" && entry.path().extension() != ".cpp") ||
          test::needs_stock_data(entry.path()))
        continue;
      const std::string text = read_source_text(entry.path());
      for (std::sregex_iterator it(text.begin(), text.end(), name), end; it != end; ++it)
        named.insert((*it)[1]);
    }
  }
  EXPECT_GT(named.size(), 150u);
  EXPECT_TRUE(named.contains("misc/menu1.wav") && named.contains("ogre/ogwake.wav"));
  for (const std::string& sound : named) EXPECT_TRUE(shipped_sounds().contains(sound)) << sound;
}

// A caption that only names the file would not help.
TEST(ShippedSounds, HaveCaptions) {
  const std::vector<ScriptFile> scripts = read_scripts_with("sound");
  std::map<std::string, std::string> captions;
  for (const ScriptFile& script : scripts)
    for (const ScriptLine& sound : script.assets) {
      const auto caption = std::find_if(sound.settings.begin(), sound.settings.end(),
                                        [](const auto& setting) { return setting.first == "caption"; });
      ASSERT_NE(caption, sound.settings.end()) << sound.values.at(0) << " needs caption=";
      captions[sound.values.at(0) + ".wav"] = caption->second == "-" ? "" : caption->second;
    }
  for (const ArtFile& file : make(scripts)) {
    if (file.path != "captions.txt") continue;
    const formats::Captions written = formats::read_captions(base::as_text(file.bytes));
    EXPECT_EQ(std::vector(written.texts.begin(), written.texts.end()),
              (std::vector<std::pair<const std::string, std::string>>(captions.begin(), captions.end())));
    EXPECT_TRUE(written.bad_lines.empty());
    EXPECT_EQ(written.texts.at("misc/null.wav"), "");
    return;
  }
  FAIL() << "no captions.txt";
}

TEST(ShippedSounds, AreAsLoudAsTheirClass) {
  const std::map<std::string, std::pair<double, double>> bounds = {
      {"blast", {-13, -5}},   {"weapon", {-16, -6}},  {"impact", {-20, -7}},    {"voice", {-14, -7}},
      {"murmur", {-20, -11}}, {"player", {-17, -9}},  {"body", {-18, -9}},      {"item", {-17, -10}},
      {"signal", {-19, -9}},  {"machine", {-16, -9}}, {"ambience", {-22, -10}}, {"menu", {-19, -10}}};
  for (const auto& [name, wav] : shipped_sounds()) {
    if (name == kNull) continue;
    const auto& [low, high] = bounds.at(find_class_name(name));
    const double loud = measure_loudest_db(to_doubles(wav), wav.frames_per_second);
    EXPECT_GE(loud, low) << name;
    EXPECT_LE(loud, high) << name;
  }
}

TEST(ShippedSounds, NothingClipsOrHasAnOffset) {
  for (const auto& [name, wav] : shipped_sounds()) {
    EXPECT_EQ(wav.channels, 1) << name;
    EXPECT_EQ(wav.bits, 16) << name;
    const std::vector<double> samples = to_doubles(wav);
    double sum = 0, peak = 0;
    for (const double sample : samples) {
      sum += sample;
      peak = std::max(peak, std::abs(sample));
    }
    EXPECT_LT(peak, 0.999) << name;
    EXPECT_LT(std::abs(sum / static_cast<double>(samples.size())), 0.01) << name;
    EXPECT_GT(peak, name != kNull ? 0.1 : -1) << name;
  }
}

TEST(ShippedSounds, EndsAreQuietAndLoopsHaveNoSeam) {
  for (const auto& [name, wav] : shipped_sounds()) {
    const std::vector<double> samples = to_doubles(wav);
    if (!wav.loop) {
      EXPECT_LT(std::abs(samples.front()), 0.01) << name;
      EXPECT_LT(std::abs(samples.back()), 0.01) << name;
      continue;
    }
    ASSERT_EQ(wav.loop->end, samples.size()) << name;
    double steps = 0;  // in the 10 ms on either side
    const std::size_t reach = wav.frames_per_second / 100, start = wav.loop->start;
    for (std::size_t i = 1; i < reach; ++i) {
      steps = std::max(steps, std::abs(samples[start + i] - samples[start + i - 1]));
      steps = std::max(steps, std::abs(samples[samples.size() - i] - samples[samples.size() - i - 1]));
    }
    EXPECT_LE(std::abs(samples[start] - samples.back()), 1.2 * steps + 1e-3) << name;
  }
}

TEST(ShippedSounds, LastAsLongAsTheirKind) {
  const std::map<std::string, std::pair<double, double>> bounds = {
      {"blast", {1, 7}},      {"weapon", {0.3, 1.6}}, {"impact", {0.1, 1.6}},  {"voice", {0.4, 2.7}},
      {"murmur", {0.8, 2}},   {"player", {0.4, 2.3}}, {"body", {0.2, 0.9}},    {"item", {0.2, 1.2}},
      {"signal", {0.2, 2.2}}, {"machine", {0.4, 3}},  {"ambience", {1.5, 10}}, {"menu", {0.05, 0.5}}};
  for (const auto& [name, wav] : shipped_sounds()) {
    const auto& [low, high] = bounds.at(find_class_name(name));
    const double seconds = static_cast<double>(wav.frame_count()) / wav.frames_per_second;
    EXPECT_GE(seconds, low) << name;
    EXPECT_LE(seconds, high) << name;
  }
  // Continuous sounds of places and of movers must loop; a fan's wind and thunder need not.
  for (const char* name :
       {"ambience/water1.wav", "ambience/wind2.wav", "ambience/fire1.wav", "ambience/drip1.wav",
        "ambience/hum1.wav", "ambience/buzz1.wav", "ambience/comp1.wav", "ambience/suck1.wav",
        "ambience/drone6.wav", "ambience/swamp1.wav", "ambience/swamp2.wav", "ambience/fl_hum1.wav",
        "plats/train1.wav", "plats/plat1.wav", "plats/medplat1.wav", "doors/winch2.wav", "doors/stndr1.wav",
        "weapons/tremor2.wav"})
    EXPECT_TRUE(shipped_sounds().at(name).loop.has_value()) << name;
}

TEST(ShippedSounds, ShotsStartAtOnceAndDecay) {
  for (const char* name :
       {"weapons/shotgn2.wav", "weapons/rocket1i.wav", "weapons/spike2.wav", "weapons/grenade.wav",
        "weapons/r_exp3.wav", "soldier/sattck1.wav", "weapons/tremor.wav"}) {
    const formats::Wav& wav = shipped_sounds().at(name);
    const std::vector<double> samples = to_doubles(wav);
    const auto power = [&](double from, double to) {
      double sum = 0;
      const auto first = static_cast<std::size_t>(from * static_cast<double>(samples.size()));
      const auto last = static_cast<std::size_t>(to * static_cast<double>(samples.size()));
      for (std::size_t i = first; i < last; ++i) sum += samples[i] * samples[i];
      return sum / static_cast<double>(last - first);
    };
    EXPECT_GT(power(0, 0.2), 4 * power(0.3, 0.6)) << name;
    EXPECT_GT(power(0.3, 0.6), 2 * power(0.85, 1)) << name;
    const auto loudest = std::max_element(samples.begin(), samples.end(),
                                          [](double a, double b) { return std::abs(a) < std::abs(b); });
    EXPECT_LT(static_cast<double>(loudest - samples.begin()) / wav.frames_per_second, 0.15) << name;
  }
}

TEST(ShippedSounds, CreaturesDifferInTheirPitch) {
  const std::map<std::string, double> heights = {{"shambler", measure_centroid_hz("shambler/ssight.wav")},
                                                 {"ogre", measure_centroid_hz("ogre/ogwake.wav")},
                                                 {"hell knight", measure_centroid_hz("hknight/sight1.wav")},
                                                 {"knight", measure_centroid_hz("knight/ksight.wav")},
                                                 {"soldier", measure_centroid_hz("soldier/sight1.wav")},
                                                 {"dog", measure_centroid_hz("dog/dsight.wav")},
                                                 {"wizard", measure_centroid_hz("wizard/wsight.wav")}};
  EXPECT_LT(heights.at("shambler"), heights.at("knight"));
  EXPECT_LT(heights.at("ogre"), heights.at("knight"));
  EXPECT_LT(heights.at("hell knight"), heights.at("soldier"));
  EXPECT_LT(heights.at("knight"), heights.at("dog"));
  EXPECT_LT(heights.at("soldier"), heights.at("wizard"));
  EXPECT_LT(heights.at("shambler"), 500);
  EXPECT_GT(heights.at("wizard"), 900);
  EXPECT_GT(measure_centroid_hz("weapons/tink1.wav"), 2000);
  EXPECT_LT(measure_centroid_hz("doors/stndr2.wav"), 400);
  EXPECT_LT(measure_centroid_hz("weapons/r_exp3.wav"), 700);
}

// The timbre of a sound in the course of time: in each part, the share of each band of the ear in the power,
// in dB.
struct Timbre {
  std::vector<std::vector<double>> parts;
  double seconds = 0;
};

// Splits the sound, without its last quiet part, into equal parts.
Timbre measure_timbre(const std::string& name) {
  // The upper ends of critical bands (Eberhard Zwicker, "Subdivision of the audible frequency range into
  // critical bands", 1961).
  constexpr double kEnds_hz[] = {100,  200,  300,  400,  510,  630,  770,  920,  1080, 1270, 1480,
                                 1720, 2000, 2320, 2700, 3150, 3700, 4400, 5300, 6400, 7700, 1e9};
  constexpr std::size_t kParts = 8, kWindow = 1024;
  constexpr double kQuiet = 1e-3;
  const formats::Wav& wav = shipped_sounds().at(name);
  std::vector<double> samples = to_doubles(wav);
  double power = 0, sum = 0;
  for (const double sample : samples) power += sample * sample;
  std::size_t length = 0;
  while (length < samples.size() && sum < 0.98 * power) {
    sum += samples[length] * samples[length];
    ++length;
  }
  samples.resize(std::max(length, kWindow));
  Timbre timbre;
  timbre.seconds = static_cast<double>(length) / wav.frames_per_second;
  for (std::size_t part = 0; part < kParts; ++part) {
    const std::size_t start = std::min(part * (length / kParts), samples.size() - kWindow);
    std::vector<double> bands(std::size(kEnds_hz));
    double whole = 1e-12;
    for (std::size_t bin = 1; bin < kWindow / 2; ++bin) {
      const double hz = static_cast<double>(bin) * wav.frames_per_second / kWindow;
      const double in_bin = measure_bin_power(samples, start, kWindow, bin);
      bands[static_cast<std::size_t>(std::upper_bound(std::begin(kEnds_hz), std::end(kEnds_hz), hz) -
                                     kEnds_hz)] += in_bin;
      whole += in_bin;
    }
    for (double& band : bands) band = 10 * std::log10(band / whole + kQuiet);
    timbre.parts.push_back(bands);
  }
  return timbre;
}

// The mean over the parts of the root mean square over the bands, and 3 dB for each doubling of the length.
double measure_distance_db(const Timbre& a, const Timbre& b) {
  double distance = 0;
  for (std::size_t part = 0; part < a.parts.size(); ++part) {
    const std::vector<double>&in_a = a.parts[part], &in_b = b.parts[part];
    double sum = 0;
    for (std::size_t band = 0; band < in_a.size(); ++band)
      sum += (in_a[band] - in_b[band]) * (in_a[band] - in_b[band]);
    distance += std::sqrt(sum / static_cast<double>(in_a.size()));
  }
  return distance / static_cast<double>(a.parts.size()) + 3 * std::abs(std::log2(a.seconds / b.seconds));
}

// Players can tell monsters apart with their eyes closed, by each kind of sound. Two sounds of one monster on
// the same occasion, such as the four shouts of the enforcer, are not compared.
TEST(ShippedSounds, MonstersAreDistinguishableByEachKindOfSound) {
  const std::vector<std::string> kinds[] = {
      {"soldier/sight1", "dog/dsight", "knight/ksight", "ogre/ogwake", "wizard/wsight", "enforcer/sight1",
       "demon/sight2", "shambler/ssight", "zombie/z_idle", "hknight/sight1", "shalrath/sight", "blob/sight1",
       "fish/idle", "boss2/idle"},
      {"soldier/idle", "dog/idle", "knight/idle", "ogre/ogidle", "wizard/widle1", "enforcer/idle1",
       "demon/idle1", "shambler/sidle", "zombie/z_idle1", "hknight/idle", "shalrath/idle", "fish/idle"},
      {"soldier/pain1", "dog/dpain1", "knight/khurt", "ogre/ogpain1", "wizard/wpain", "enforcer/pain1",
       "demon/dpain1", "shambler/shurt2", "zombie/z_pain", "hknight/pain1", "shalrath/pain"},
      {"soldier/death1", "dog/ddeath", "knight/kdeath", "ogre/ogdth", "wizard/wdeath", "enforcer/death1",
       "demon/ddeath", "shambler/sdeath", "zombie/z_gib", "hknight/death1", "shalrath/death", "blob/death1",
       "fish/death", "boss2/death"},
      {"soldier/sattck1", "dog/dattack1", "knight/sword1", "ogre/ogsawatk1", "wizard/wattack",
       "enforcer/enfire", "demon/djump", "shambler/sattck1", "zombie/z_shot1", "hknight/attack1",
       "shalrath/attack", "blob/hit1", "fish/bite"}};
  for (const std::vector<std::string>& kind : kinds) {
    std::vector<Timbre> timbres;
    for (const std::string& name : kind) timbres.push_back(measure_timbre(name + ".wav"));
    for (std::size_t a = 0; a < kind.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        EXPECT_GE(measure_distance_db(timbres[a], timbres[b]), 5.8) << kind[a] << " and " << kind[b];
  }
}

TEST(ShippedSounds, AreTheSameBytesEveryTime) {
  const std::vector<ScriptFile> scripts = read_scripts_with("sound");
  const std::vector<ArtFile> first = make(scripts), second = make(scripts);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].bytes, second[i].bytes) << first[i].path;
}

// A decoded music file.
struct Recording {
  std::size_t bytes = 0;
  int rate = 0;
  std::vector<Signal> channels;
};

Recording decode(const ArtFile& file) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("piece.ogg", file.bytes).string();
  SF_INFO info{};
  SNDFILE* const sound = sf_open(path.c_str(), SFM_READ, &info);
  if (sound == nullptr) return {};
  const auto count = static_cast<std::size_t>(info.channels);
  std::vector<double> frames(static_cast<std::size_t>(info.frames) * count);
  EXPECT_EQ(sf_readf_double(sound, frames.data(), info.frames), info.frames) << file.path;
  sf_close(sound);
  Recording recording{file.bytes.size(), info.samplerate, std::vector<Signal>(count)};
  for (std::size_t i = 0; i < frames.size(); ++i) recording.channels[i % count].push_back(frames[i]);
  return recording;
}

// The pieces and their combat layers, by the name without the extension.
const std::map<std::string, Recording>& shipped_music() {
  static const std::map<std::string, Recording> music = [] {
    std::map<std::string, Recording> made;
    for (const ArtFile& file : make(read_scripts_with("music")))
      if (file.path.starts_with("music/"))
        made.emplace(file.path.substr(6, file.path.size() - 10), decode(file));
    return made;
  }();
  return music;
}

bool is_layer(const std::string& name) {
  return name.ends_with("_combat");
}

TEST(ShippedMusic, LoopsWithoutAGapAndIsSmall) {
  std::size_t bytes = 0, layer_bytes = 0, pieces = 0;
  for (const auto& [name, recording] : shipped_music()) {
    (is_layer(name) ? layer_bytes : bytes) += recording.bytes;
    pieces += is_layer(name) ? 0 : 1;
    ASSERT_EQ(recording.channels.size(), is_layer(name) ? 1u : 2u) << name;
    const Signal& left = recording.channels[0];

    const double seconds = static_cast<double>(left.size()) / recording.rate;
    EXPECT_GE(seconds, is_layer(name) ? 10 : 90) << name;
    EXPECT_LE(seconds, is_layer(name) ? 30 : 185) << name;
    const double loud = measure_loudest_db(left, recording.rate);
    EXPECT_GT(loud, -18) << name;
    EXPECT_LT(loud, -6) << name;
    EXPECT_LT(*std::max_element(left.begin(), left.end()), 1.0) << name;
    EXPECT_GT(*std::min_element(left.begin(), left.end()), -1.0) << name;
    // No second is silent, not even at the loop point, where the last and the first second belong together.
    const auto second = static_cast<std::size_t>(recording.rate);
    for (std::size_t start = 0; start + second <= left.size(); start += second)
      EXPECT_GT(measure_loudest_db({left.begin() + static_cast<std::ptrdiff_t>(start),
                                    left.begin() + static_cast<std::ptrdiff_t>(start + second)},
                                   recording.rate),
                -50)
          << name << " " << start / second;
    double steps = 0;
    for (std::size_t i = 1; i < second / 20; ++i)
      steps = std::max({steps, std::abs(left[i] - left[i - 1]),
                        std::abs(left[left.size() - i] - left[left.size() - i - 1])});
    EXPECT_LE(std::abs(left.front() - left.back()), 2 * steps + 2e-3) << name;
  }
  EXPECT_EQ(pieces, 3u);
  EXPECT_LT(bytes, 6u * 1024 * 1024);
  EXPECT_LT(layer_bytes, 300'000u);
}

// The sums of the decoded files leave 0.3 dB of headroom, and the layers fit into the pieces a whole number
// of times.
TEST(ShippedMusic, CombatLayersDivideTheirPiecesAndDoNotClip) {
  const double most = std::pow(10.0, -0.3 / 20);
  std::size_t layers = 0;
  for (const auto& [name, piece] : shipped_music()) {
    if (is_layer(name)) continue;
    const auto found = shipped_music().find(name + "_combat");
    ASSERT_NE(found, shipped_music().end()) << name;
    ++layers;
    const Signal& layer = found->second.channels[0];
    EXPECT_EQ(found->second.rate, piece.rate) << name;
    EXPECT_EQ(piece.channels[0].size() % layer.size(), 0u) << name;
    double peak = 0;
    for (const Signal& channel : piece.channels)
      for (std::size_t i = 0; i < channel.size(); ++i)
        peak = std::max(peak, std::abs(channel[i] + layer[i % layer.size()]));
    EXPECT_LE(peak, most) << name;
  }
  EXPECT_EQ(layers, 3u);
}

}  // namespace
}  // namespace temblor::artgen
