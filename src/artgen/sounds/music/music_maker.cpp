#include "artgen/sounds/music/music_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "artgen/sounds/mastering.h"
#include "artgen/sounds/music/patch.h"
#include "artgen/sounds/vorbis_file.h"

namespace temblor::artgen {
namespace {

// The loudness of all music, as in SoundClass.
constexpr double kMusicLoudest_db = -11;

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

base::Status mix_notes(const Score& score, Mix& io_mix) {
  NoteCache notes(score);
  for (const PatternPlay& play : score.pattern_plays) {
    const Pattern& pattern = score.patterns[play.pattern];
    const Instrument& instrument = score.instruments[pattern.instrument];
    for (std::int32_t time = 0; time < play.times; ++time) {
      for (const Note& note : pattern.notes) {
        TRY(const Signal* signal,
            notes.find(pattern.instrument, note.half_tones + play.half_tones, note.beats));
        const double beat = play.at_beat + play.every_beats * time + note.beat;
        mix_note(*signal, instrument, instrument.level * play.level,
                 count_frames(score.seconds(beat), kMusicRate), io_mix);
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

}  // namespace

base::Result<std::array<Signal, 2>> render_score(const Score& score) {
  const std::size_t length = count_frames(score.seconds(score.beats), kMusicRate);
  Mix mix{{Signal(length, 0.0), Signal(length, 0.0)}, Signal(length, 0.0)};
  TRY_STATUS(mix_notes(score, mix));
  add_room(score, mix);
  for (Signal& channel : mix.channels) remove_rumble_from_loop(channel, kMusicRate);
  normalize_loudness(mix.channels, kMusicLoudest_db + score.gain_db, kMusicRate);
  return std::move(mix.channels);
}

base::Result<std::vector<ArtPart>> make_music_file(const ScriptLine& asset) {
  TRY(const Score score, read_score(asset));
  TRY(const auto channels, render_score(score));
  VorbisSettings settings;
  settings.frames_per_second = static_cast<long>(kMusicRate);
  settings.quality = score.quality;
  TRY(base::ByteVector bytes, write_vorbis(channels, settings));
  std::vector<ArtPart> parts;
  parts.push_back({fmt::format("music/{}.ogg", score.name), std::move(bytes)});
  return parts;
}

}  // namespace temblor::artgen
