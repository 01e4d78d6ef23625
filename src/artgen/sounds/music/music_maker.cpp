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

constexpr double kMusicLoudest_db = -11;

// Every note of an instrument by its pitch and length: made once, however often it is played.
class Notes {
 public:
  explicit Notes(const Score& score) : score_(score) {}

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

struct Mix {
  std::array<Signal, 2> channels;
  Signal into_room;
};

void lay(const Signal& note, const Instrument& player, double level, std::size_t start, Mix& io_mix) {
  const double angle = (player.pan + 1) * std::numbers::pi / 4;
  const double left = std::cos(angle) * level, right = std::sin(angle) * level;
  const std::size_t length = io_mix.into_room.size();
  std::size_t at = start % length;
  for (const double sample : note) {
    io_mix.channels[0][at] += left * sample;
    io_mix.channels[1][at] += right * sample;
    io_mix.into_room[at] += player.room * level * sample;
    if (++at == length) at = 0;
  }
}

base::Status lay_notes(const Score& score, Mix& io_mix) {
  Notes notes(score);
  for (const Playing& playing : score.playings) {
    const Pattern& pattern = score.patterns[playing.pattern];
    const Instrument& player = score.instruments[pattern.instrument];
    for (std::int32_t time = 0; time < playing.times; ++time) {
      for (const Note& note : pattern.notes) {
        TRY(const Signal* signal,
            notes.find(pattern.instrument, note.half_tones + playing.half_tones, note.beats));
        const double beat = playing.at_beat + playing.every_beats * time + note.beat;
        lay(*signal, player, player.level * playing.level, frames_in(score.seconds(beat), kMusicRate),
            io_mix);
      }
    }
  }
  return base::Ok{};
}

// Twice round: the second time, the echoes of the end are there at the beginning.
void add_room(const Score& score, Mix& io_mix) {
  Reverb room(score.room, kMusicRate);
  for (const double sample : io_mix.into_room) room.step(sample);
  for (std::size_t i = 0; i < io_mix.into_room.size(); ++i) {
    const Reverb::Echoes echoes = room.step(io_mix.into_room[i]);
    io_mix.channels[0][i] += echoes.left;
    io_mix.channels[1][i] += echoes.right;
  }
}

}  // namespace

base::Result<std::array<Signal, 2>> perform(const Score& score) {
  const std::size_t length = frames_in(score.seconds(score.beats), kMusicRate);
  Mix mix{{Signal(length, 0.0), Signal(length, 0.0)}, Signal(length, 0.0)};
  TRY_STATUS(lay_notes(score, mix));
  add_room(score, mix);
  for (Signal& channel : mix.channels) remove_rumble_around(channel, kMusicRate);
  bring_to_level(mix.channels, kMusicLoudest_db + score.louder_db, kMusicRate);
  return std::move(mix.channels);
}

base::Result<std::vector<ArtPart>> make_music_file(const ScriptLine& thing) {
  TRY(const Score score, read_score(thing));
  TRY(const auto channels, perform(score));
  VorbisSettings settings;
  settings.frames_per_second = static_cast<long>(kMusicRate);
  settings.quality = score.quality;
  TRY(base::ByteVector bytes, write_vorbis(channels, settings));
  std::vector<ArtPart> parts;
  parts.push_back({fmt::format("music/{}.ogg", score.name), std::move(bytes)});
  return parts;
}

}  // namespace temblor::artgen
