// A piece of music as a script describes it: instruments, patterns of notes, and when they are played.
//
//   music track02 bpm=46 bars=28 beats=4
//     instrument bell tail=6 level=0.7 pan=0.3 room=0.6
//       strike bell pitch=1                 a patch; pitch=1 is the note
//     pattern toll bell
//       notes D3:4 _:2 A2+D3:2              a note with its beats, a rest, a chord
//     play toll at=1 times=4 every=2 level=0.8 transpose=0
//     fight toll at=1                       the same, in the combat layer, which is fight_bars= long
//     room size=1 ring=5 dull=2500          reverberation for what instruments send into it
//
// Bars count from 1. The piece loops, and so does its layer: sounds that ring after the last bar are heard in
// the first one. A layer is a loop of a few bars, because it must be small.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artgen/scripts/script.h"
#include "artgen/sounds/reverb.h"
#include "base/result.h"

namespace temblor::artgen {

// A patch and how it is mixed.
struct Instrument {
  std::string name;
  // The patch is under this line. Points into the script.
  const ScriptLine* line = nullptr;
  // How long notes ring after their beats.
  double tail_s = 0;
  // Gain; -1 is left and 1 right; the gain into the reverberation.
  double level = 1, pan = 0, room = 0.3;
};

// A note of a pattern.
struct Note {
  // Its start, from the pattern's start, and its length.
  double beat = 0, beats = 1;
  // Semitones from A4 (440 Hz).
  std::int32_t half_tones = 0;
};

// A sequence of notes for one instrument. `beats` is the length with all rests.
struct Pattern {
  std::string name;
  std::size_t instrument = 0;
  double beats = 0;
  std::vector<Note> notes;
};

// A `play` or `fight` line: a pattern that is repeated `times` times from `at_beat` on.
struct PatternPlay {
  std::size_t pattern = 0;
  double at_beat = 0, every_beats = 0, level = 1;
  std::int32_t times = 1, half_tones = 0;
};

// A whole piece.
struct Score {
  std::string name;
  double beats_per_minute = 60;
  double beats_per_bar = 4;
  // The length of the piece, and of its combat layer, which divides it.
  std::int32_t bars = 16, combat_bars = 16;
  // The quality setting of the Vorbis encoder.
  float quality = 0.3F;
  // Added to the loudness that all music has.
  double gain_db = 0;
  Reverb::Settings room;
  std::vector<Instrument> instruments;
  std::vector<Pattern> patterns;
  std::vector<PatternPlay> pattern_plays;
  // The layer that is added in combat; empty if the piece has none.
  std::vector<PatternPlay> combat_plays;

  // The time of a beat.
  double seconds(double beat) const { return beat * 60 / beats_per_minute; }
};

// Reads a `music` line and everything under it, which must outlive the score. Instruments and patterns must
// be defined above the lines that use them.
base::Result<Score> read_score(const ScriptLine& asset);

}  // namespace temblor::artgen
