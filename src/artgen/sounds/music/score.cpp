#include "artgen/sounds/music/score.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>

#include "base/text.h"

namespace temblor::artgen {
namespace {

// "D3", "F#2", "Bb1" as semitones from A4; nothing for other texts.
std::optional<std::int32_t> parse_note_name(std::string_view name) {
  constexpr std::string_view kLetters = "CDEFGAB";
  constexpr std::array<std::int32_t, 7> kSteps = {0, 2, 4, 5, 7, 9, 11};
  constexpr std::int32_t kOctave = 12, kA4 = 4 * kOctave + 9;
  const std::size_t letter = name.empty() ? std::string_view::npos : kLetters.find(name.front());
  if (letter == std::string_view::npos) return {};
  name.remove_prefix(1);
  std::int32_t half_tones = kSteps[letter];
  if (name.starts_with('#') || name.starts_with('b')) {
    half_tones += name.front() == '#' ? 1 : -1;
    name.remove_prefix(1);
  }
  if (name.size() != 1 || name.front() < '0' || name.front() > '8') return {};
  return half_tones + kOctave * (name.front() - '0') - kA4;
}

// Appends "D3+A3:2" (notes joined by +, then the beats; 1 without a colon) or a rest "_:2". False if the text
// is invalid.
bool add_notes(std::string_view text, Pattern& io_pattern) {
  const std::size_t colon = text.find(':');
  double beats = 1;
  if (colon != std::string_view::npos) {
    const std::string_view number = text.substr(colon + 1);
    const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), beats);
    constexpr double kMaxBeats = 1000;
    if (failure != std::errc() || end != number.data() + number.size() || !(beats > 0 && beats <= kMaxBeats))
      return false;
  }
  std::string_view names = text.substr(0, colon);
  while (names != "_") {
    const std::size_t plus = names.find('+');
    const std::optional<std::int32_t> half_tones = parse_note_name(names.substr(0, plus));
    if (!half_tones) return false;
    io_pattern.notes.push_back({io_pattern.beats, beats, *half_tones});
    if (plus == std::string_view::npos) break;
    names.remove_prefix(plus + 1);
  }
  io_pattern.beats += beats;
  return true;
}

// The index of an element by its name.
template <typename Named>
std::optional<std::size_t> find_named(const std::vector<Named>& things, std::string_view name) {
  const auto found =
      std::find_if(things.begin(), things.end(), [&](const Named& thing) { return thing.name == name; });
  if (found == things.end()) return {};
  return static_cast<std::size_t>(found - things.begin());
}

base::Status read_instrument(const ScriptLine& line, Score& io_score) {
  Arguments arguments(line);
  Instrument instrument;
  instrument.line = &line;
  instrument.name = arguments.text();
  instrument.tail_s = arguments.number("tail", 0.5, 0, 60);
  instrument.level = arguments.number("level", 1, 0, 10);
  instrument.pan = arguments.number("pan", 0, -1, 1);
  instrument.room = arguments.number("room", 0.3, 0, 4);
  if (find_named(io_score.instruments, instrument.name)) arguments.set_error("this name is already in use");
  TRY_STATUS(arguments.finish());
  io_score.instruments.push_back(std::move(instrument));
  return base::Ok{};
}

base::Status read_pattern(const ScriptLine& line, Score& io_score) {
  Arguments arguments(line);
  Pattern pattern;
  pattern.name = arguments.text();
  const std::string player = arguments.text();
  const std::optional<std::size_t> instrument = find_named(io_score.instruments, player);
  if (!instrument)
    arguments.set_error(fmt::format("no instrument '{}' is defined above this line", base::quotable(player)));
  if (find_named(io_score.patterns, pattern.name)) arguments.set_error("this name is already in use");
  TRY_STATUS(arguments.finish());
  pattern.instrument = *instrument;
  for (const ScriptLine& row : line.below) {
    if (row.keyword != "notes") return script_error(row, "only 'notes' lines can be under a pattern");
    for (const std::string& word : row.values)
      if (!add_notes(word, pattern))
        return script_error(row,
                            fmt::format("'{}' is not a note such as D3, F#2:1.5 or A2+D3:4, or _ for a rest",
                                        base::quotable(word)));
  }
  if (pattern.beats == 0) return script_error(line, "the pattern has no notes");
  io_score.patterns.push_back(std::move(pattern));
  return base::Ok{};
}

// `bars`: the length of the part in which it plays.
base::Status read_play(const ScriptLine& line, const Score& score, std::int32_t bars,
                       std::vector<PatternPlay>& io_plays) {
  Arguments arguments(line);
  PatternPlay play;
  const std::string name = arguments.text();
  const std::optional<std::size_t> pattern = find_named(score.patterns, name);
  if (!pattern)
    arguments.set_error(fmt::format("no pattern '{}' is defined above this line", base::quotable(name)));
  play.pattern = pattern.value_or(0);
  // Bars count from 1, beats from 0.
  play.at_beat = (arguments.number("at", 1, 1, bars + 1) - 1) * score.beats_per_bar;
  play.times = arguments.integer("times", 1, 1, 1000);
  // Without every=, repetitions follow one another at the next bar.
  const double own_bars = pattern ? std::ceil(score.patterns[*pattern].beats / score.beats_per_bar) : 1;
  play.every_beats = arguments.number("every", own_bars, 0.01, bars) * score.beats_per_bar;
  play.level = arguments.number("level", 1, 0, 10);
  play.half_tones = arguments.integer("transpose", 0, -48, 48);
  if (play.at_beat + play.every_beats * (play.times - 1) >= bars * score.beats_per_bar)
    arguments.set_error("it plays after the end of the piece");
  TRY_STATUS(arguments.finish());
  io_plays.push_back(play);
  return base::Ok{};
}

base::Status read_room(const ScriptLine& line, Score& io_score) {
  Arguments arguments(line);
  io_score.room.size = arguments.number("size", 0.8, 0, 1);
  io_score.room.ring_s = arguments.number("ring", 3, 0.05, 20);
  io_score.room.damping_hz = arguments.number("dull", 3000, 20, 16000);
  return arguments.finish();
}

}  // namespace

base::Result<Score> read_score(const ScriptLine& asset) {
  Arguments arguments(asset);
  Score score;
  score.name = arguments.text();
  score.beats_per_minute = arguments.number("bpm", 60, 10, 400);
  score.beats_per_bar = arguments.number("beats", 4, 1, 64);
  score.bars = arguments.integer("bars", 16, 1, 1000);
  score.combat_bars = arguments.integer("fight_bars", score.bars, 1, score.bars);
  score.quality = static_cast<float>(arguments.number("quality", 0.3, -0.1, 1));
  score.gain_db = arguments.number("louder", 0, -40, 12);
  constexpr double kMaxLength_s = 600;
  if (score.seconds(score.bars * score.beats_per_bar) > kMaxLength_s)
    arguments.set_error("the piece lasts longer than ten minutes");
  if (score.bars % score.combat_bars != 0) arguments.set_error("fight_bars= must divide bars=");
  const bool is_name = score.name.size() == 7 && score.name.starts_with("track") &&
                       score.name.find_first_not_of("0123456789", 5) == std::string::npos;
  if (!is_name) arguments.set_error("the name must be track02 to track99");
  TRY_STATUS(arguments.finish());
  for (const ScriptLine& line : asset.below) {
    if (line.keyword == "instrument")
      TRY_STATUS(read_instrument(line, score));
    else if (line.keyword == "pattern")
      TRY_STATUS(read_pattern(line, score));
    else if (line.keyword == "play")
      TRY_STATUS(read_play(line, score, score.bars, score.pattern_plays));
    else if (line.keyword == "fight")
      TRY_STATUS(read_play(line, score, score.combat_bars, score.combat_plays));
    else if (line.keyword == "room")
      TRY_STATUS(read_room(line, score));
    else
      return script_error(line, "expected instrument, pattern, play, fight, or room");
  }
  return score;
}

}  // namespace temblor::artgen
