// The word `music`, as text says it: instruments, patterns of notes, and when they are played.
//
//   music track02 bpm=46 bars=28 beats=4
//     instrument bell tail=6 level=0.7 pan=0.3 room=0.6
//       strike bell pitch=1                 pitch=1 is the note's
//     pattern toll bell
//       notes D3:4 _:2 A2+D3:2              a note and its beats, a rest, two at once
//     play toll at=1 times=4 every=2 level=0.8 transpose=0
//     room size=1 ring=5 dull=2500          around all that instruments send into it
//
// Bars count from 1. What rings on past the last bar is heard in the first one: the piece goes round.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artgen/scripts/script.h"
#include "artgen/sounds/reverb.h"
#include "base/result.h"

namespace temblor::artgen {

struct Instrument {
  std::string name;
  const ScriptLine* line = nullptr;  // what is under it is a patch
  double tail_s = 0;                 // that notes last beyond their beats
  double level = 1, pan = 0, room = 0.3;
};

struct Note {
  double beat = 0, beats = 1;   // from the pattern's beginning
  std::int32_t half_tones = 0;  // from A4, 440 Hz
};

struct Pattern {
  std::string name;
  std::size_t instrument = 0;
  double beats = 0;
  std::vector<Note> notes;
};

struct Playing {
  std::size_t pattern = 0;
  double at_beat = 0, every_beats = 0, level = 1;
  std::int32_t times = 1, half_tones = 0;
};

struct Score {
  std::string name;
  double beats_per_minute = 60;
  double beats = 4;  // of all of it
  float quality = 0.3F;
  double louder_db = 0;
  Reverb::Settings room;
  std::vector<Instrument> instruments;
  std::vector<Pattern> patterns;
  std::vector<Playing> playings;

  double seconds(double beat) const { return beat * 60 / beats_per_minute; }
};

// `thing` must outlive it.
base::Result<Score> read_score(const ScriptLine& thing);

}  // namespace temblor::artgen
