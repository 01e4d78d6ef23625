#include "artgen/sounds/music/music_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

#include "artgen/sounds/mastering.h"
#include "artgen/sounds/music/patch.h"
#include "artgen/sounds/vorbis_file.h"

namespace temblor::artgen {
namespace {

// The loudness of all music, as in SoundClass.
constexpr double kMusicLoudest_db = -11;
// The loudness of combat layers, and the quality of their files: drums and basses hide an encoder's noise.
constexpr double kCombatLoudest_db = -13;
constexpr float kCombatQuality = 0.0F;
// The limit of the sum of a piece and its layer: -1.4 dB, so that the noise of the encoder stays below -0.3
// dB.
constexpr double kSumPeak = 0.85;

// Renders every combination of instrument, pitch, and length once.
class NoteCache {
 public:
  explicit NoteCache(const Score& score) : score_(score) {}

  // Returns the note, which stays valid as long as the cache.
  base::Result<const Signal*> find(std::size_t instrument, std::int32_t half_tones, double beats) {
    const auto [place, is_new] = made_.try_emplace(std::tuple(instrument, half_tones, beats));
    if (is_new) {
      const Instrument& player = score_.instruments[instrument];
      PatchContext context;
      context.rate = kMusicRate;
      context.length_s = context.voice_s = score_.seconds(beats) + player.tail_s;
      context.pitch = 440 * std::pow(2.0, half_tones / 12.0);
      context.seed = base::hash_with(instrument, static_cast<std::uint64_t>(half_tones + 1000));
      TRY(place->second, render_patch(player.line->below, context));
    }
    return &place->second;
  }

 private:
  const Score& score_;
  std::map<std::tuple<std::size_t, std::int32_t, double>, Signal> made_;
};

// The stereo mix and the mono input of the reverberation.
struct Mix {
  std::array<Signal, 2> channels;
  Signal reverb_send;
};

// The length of a bar, rounded up, so that a layer repeats in step with its piece to the sample.
std::size_t count_bar_frames(const Score& score) {
  return static_cast<std::size_t>(std::ceil(score.seconds(score.beats_per_bar) * kMusicRate));
}

// Adds a note from sample `start` on; it wraps around at the end of the piece. Panning keeps the power
// constant.
void mix_note(const Signal& note, const Instrument& instrument, double level, std::size_t start,
              Mix& io_mix) {
  const double angle = (instrument.pan + 1) * std::numbers::pi / 4;
  const double left = std::cos(angle) * level, right = std::sin(angle) * level;
  const std::size_t length = io_mix.reverb_send.size();
  std::size_t at = start % length;
  for (const double sample : note) {
    io_mix.channels[0][at] += left * sample;
    io_mix.channels[1][at] += right * sample;
    io_mix.reverb_send[at] += instrument.room * level * sample;
    if (++at == length) at = 0;
  }
}

base::Status mix_notes(const Score& score, const std::vector<PatternPlay>& plays, Mix& io_mix) {
  NoteCache notes(score);
  for (const PatternPlay& play : plays) {
    const Pattern& pattern = score.patterns[play.pattern];
    const Instrument& instrument = score.instruments[pattern.instrument];
    for (std::int32_t time = 0; time < play.times; ++time) {
      for (const Note& note : pattern.notes) {
        TRY(const Signal* signal,
            notes.find(pattern.instrument, note.half_tones + play.half_tones, note.beats));
        const double beat = play.at_beat + play.every_beats * time + note.beat;
        mix_note(*signal, instrument, instrument.level * play.level,
                 count_frames(beat / score.beats_per_bar, static_cast<double>(count_bar_frames(score))),
                 io_mix);
      }
    }
  }
  return base::Ok{};
}

// Runs the reverberation over the piece twice. In the second pass, the echoes of the end are present at the
// start.
void add_room(const Score& score, Mix& io_mix) {
  Reverb room(score.room, kMusicRate);
  for (const double sample : io_mix.reverb_send) room.step(sample);
  for (std::size_t i = 0; i < io_mix.reverb_send.size(); ++i) {
    const Reverb::Echoes echoes = room.step(io_mix.reverb_send[i]);
    io_mix.channels[0][i] += echoes.left;
    io_mix.channels[1][i] += echoes.right;
  }
}

// Renders a loop of `bars` bars.
base::Result<std::array<Signal, 2>> render_plays(const Score& score, const std::vector<PatternPlay>& plays,
                                                 std::int32_t bars) {
  const std::size_t length = static_cast<std::size_t>(bars) * count_bar_frames(score);
  Mix mix{{Signal(length, 0.0), Signal(length, 0.0)}, Signal(length, 0.0)};
  TRY_STATUS(mix_notes(score, plays, mix));
  add_room(score, mix);
  for (Signal& channel : mix.channels) remove_rumble_from_loop(channel, kMusicRate);
  return std::move(mix.channels);
}

// For each sample of the layer, the largest gain up to 1 at which it can be added to the piece wherever the
// layer repeats, without a sum beyond kSumPeak.
Signal find_safe_gains(const std::array<Signal, 2>& piece, const Signal& layer) {
  Signal gains(layer.size(), 1.0);
  for (const Signal& channel : piece) {
    for (std::size_t i = 0; i < channel.size(); ++i) {
      const double sample = layer[i % layer.size()];
      double& gain = gains[i % layer.size()];
      const double room = kSumPeak - std::copysign(1.0, sample) * channel[i];
      if (gain * std::abs(sample) > room) gain = std::max(0.0, room / std::abs(sample));
    }
  }
  return gains;
}

// Makes gains change slowly without raising any: the lowest gain within `reach`, then the mean within
// `reach`.
Signal smooth_gains(const Signal& gains, std::size_t reach) {
  const std::size_t count = gains.size();
  const auto neighbor = [&](std::size_t i, std::size_t step) { return (i + count - reach + step) % count; };
  Signal lowest = gains, smooth(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (gains[i] == 1) continue;
    for (std::size_t step = 0; step <= 2 * reach; ++step)
      lowest[neighbor(i, step)] = std::min(lowest[neighbor(i, step)], gains[i]);
  }
  double sum = 0;
  for (std::size_t step = 0; step < 2 * reach; ++step) sum += lowest[neighbor(0, step)];
  for (std::size_t i = 0; i < count; ++i) {
    sum += lowest[neighbor(i, 2 * reach)];
    smooth[i] = sum / static_cast<double>(2 * reach + 1);
    sum -= lowest[neighbor(i, 0)];
  }
  return smooth;
}

base::Result<ArtPart> make_music_part(const std::string& name, std::span<const Signal> channels,
                                      float quality) {
  VorbisSettings settings;
  settings.frames_per_second = static_cast<long>(kMusicRate);
  settings.quality = quality;
  TRY(base::ByteVector bytes, write_vorbis(channels, settings));
  return ArtPart{fmt::format("music/{}.ogg", name), std::move(bytes)};
}

}  // namespace

base::Result<std::array<Signal, 2>> render_score(const Score& score) {
  TRY(auto channels, render_plays(score, score.pattern_plays, score.bars));
  normalize_loudness(channels, kMusicLoudest_db + score.gain_db, kMusicRate);
  return channels;
}

base::Result<Signal> render_combat_layer(const Score& score, const std::array<Signal, 2>& piece) {
  constexpr double kReach_s = 0.02;
  TRY(auto channels, render_plays(score, score.combat_plays, score.combat_bars));
  Signal& layer = channels[0];
  for (std::size_t i = 0; i < layer.size(); ++i) layer[i] += channels[1][i];
  normalize_loudness(std::span(&layer, 1), kCombatLoudest_db + score.gain_db, kMusicRate);
  const std::size_t reach = std::min(count_frames(kReach_s, kMusicRate), layer.size() / 2);
  const Signal gains = smooth_gains(find_safe_gains(piece, layer), reach);
  for (std::size_t i = 0; i < layer.size(); ++i) layer[i] *= gains[i];
  return std::move(layer);
}

base::Result<std::vector<ArtPart>> make_music_file(const ScriptLine& asset) {
  TRY(const Score score, read_score(asset));
  TRY(const auto piece, render_score(score));
  std::vector<ArtPart> parts;
  TRY(ArtPart part, make_music_part(score.name, piece, score.quality));
  parts.push_back(std::move(part));
  if (score.combat_plays.empty()) return parts;
  TRY(const Signal layer, render_combat_layer(score, piece));
  TRY(ArtPart combat, make_music_part(score.name + "_combat", std::span(&layer, 1), kCombatQuality));
  parts.push_back(std::move(combat));
  return parts;
}

}  // namespace temblor::artgen
