#include "artgen/sounds/music/patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "artgen/sounds/curve.h"
#include "artgen/sounds/effects.h"
#include "artgen/sounds/music/voices.h"

namespace temblor::artgen {
namespace {

// The settings that all voices accept, except for the level.
struct VoiceTimes {
  double at_s = 0, for_s = 1, attack_s = 0, decay_s = 0, fade_s = 0;
  double every_s = 0, scatter = 0;
  std::int32_t times = 1;
  std::uint64_t seed = 0;
};

// A voice without for= lasts context.voice_s, but not beyond the end of the patch.
VoiceTimes read_times(Arguments& io_arguments, const PatchContext& context) {
  constexpr double kMaxLength_s = 600;
  VoiceTimes times;
  times.at_s = io_arguments.number("at", 0, 0, kMaxLength_s);
  const double rest_s = std::max(0.001, std::min(context.voice_s, context.length_s - times.at_s));
  times.for_s = io_arguments.number("for", rest_s, 0.001, kMaxLength_s);
  times.attack_s = io_arguments.number("attack", 0.001, 0, kMaxLength_s);
  times.decay_s = io_arguments.number("decay", 0, 0, kMaxLength_s);
  times.fade_s = io_arguments.number("fade", 0.01, 0, kMaxLength_s);
  times.times = io_arguments.integer("times", 1, 1, 200);
  times.every_s = io_arguments.number("every", 0.1, 0.001, kMaxLength_s);
  times.scatter = io_arguments.number("scatter", 0, 0, 1);
  times.seed = static_cast<std::uint64_t>(io_arguments.integer("seed", 0, 0, 1'000'000));
  return times;
}

// Half a cosine from 0 to 1.
double ease_in(double part) {
  return part >= 1 ? 1 : 0.5 - 0.5 * std::cos(3.14159265358979 * std::max(0.0, part));
}

// Level curve, attack, exponential decay after the attack, and fade at the end, multiplied.
void apply_envelope(Signal& io_samples, const VoiceTimes& times, const Curve& level, double rate) {
  const Signal levels = level.values(io_samples.size(), rate);
  const double end_s = static_cast<double>(io_samples.size()) / rate;
  for (std::size_t i = 0; i < io_samples.size(); ++i) {
    const double time_s = static_cast<double>(i) / rate;
    double factor = levels[i];
    if (time_s < times.attack_s) factor *= ease_in(time_s / times.attack_s);
    if (times.decay_s > 0 && time_s > times.attack_s)
      factor *= std::pow(10.0, -3 * (time_s - times.attack_s) / times.decay_s);
    if (end_s - time_s < times.fade_s) factor *= ease_in((end_s - time_s) / times.fade_s);
    io_samples[i] *= factor;
  }
}

// Renders one repetition of a voice and adds it. Each repetition reads the line again, with another seed.
// `scatter` varies its start, pitch, and strength; the first repetition is never varied.
base::Status add_repetition(const ScriptLine& line, const VoiceKeyword& word, std::int32_t repetition,
                            const PatchContext& context, Signal& io_sum) {
  Arguments arguments(line);
  const VoiceTimes times = read_times(arguments, context);
  const std::uint64_t seed =
      base::hash_with(context.seed, times.seed * 1000 + static_cast<std::uint64_t>(repetition));
  Noise noise(base::hash_with(seed, 1));
  const double late_s = times.every_s * (repetition + times.scatter * 0.5 * noise.bipolar());
  const double pitch = std::pow(2.0, times.scatter * 0.6 * noise.bipolar());
  const double strength = 1 - 0.7 * times.scatter * noise.unit();
  const Curve level = read_curve_setting(arguments, "level", 1, {0, 10}, times.for_s);

  Signal own = word.make(
      arguments, {context.rate, times.for_s, repetition > 0 ? context.pitch * pitch : context.pitch, seed});
  TRY_STATUS(arguments.finish());
  apply_envelope(own, times, level, context.rate);
  const std::size_t start = repetition > 0 ? count_frames(std::max(0.0, late_s), context.rate) : 0;
  const double gain = repetition > 0 ? strength : 1;
  for (std::size_t i = 0; i < own.size() && start + i < io_sum.size(); ++i)
    io_sum[start + i] += gain * own[i];
  return base::Ok{};
}

// Null if the line is not an effect.
const EffectKeyword* find_effect(const ScriptLine& line) {
  for (const EffectKeyword& known : effect_keywords())
    if (known.keyword == line.keyword) return &known;
  return nullptr;
}

// Null if the line is not a voice.
const VoiceKeyword* find_voice(const ScriptLine& line) {
  for (const VoiceKeyword& known : voice_keywords())
    if (known.keyword == line.keyword) return &known;
  return nullptr;
}

base::Status apply_effect(const ScriptLine& line, const EffectContext& context, Signal& io_signal) {
  const EffectKeyword* effect = find_effect(line);
  if (effect == nullptr) {
    std::string known;
    for (const EffectKeyword& word : effect_keywords())
      known.append(known.empty() ? "" : ", ").append(word.keyword);
    return script_error(line, fmt::format("expected an effect: {}", known));
  }
  if (!line.below.empty()) return script_error(line.below.front(), "no line can be under an effect");
  Arguments arguments(line);
  effect->apply(arguments, context, io_signal);
  return arguments.finish();
}

// Renders all repetitions of a voice, applies the effects under it, and adds the result from at= on. Effects
// run to the end of the sound, so that echoes can fade after the voice.
base::Status add_voice(const ScriptLine& line, const VoiceKeyword& word, const PatchContext& context,
                       Signal& io_sum) {
  Arguments arguments(line);
  const VoiceTimes times = read_times(arguments, context);
  const std::size_t start = count_frames(times.at_s, context.rate);
  if (start >= io_sum.size()) return script_error(line, "it begins after the end of the sound");
  Signal own(io_sum.size() - start, 0.0);
  for (std::int32_t i = 0; i < times.times; ++i) TRY_STATUS(add_repetition(line, word, i, context, own));
  const EffectContext effects{context.rate, times.for_s + times.every_s * (times.times - 1), context.seed};
  for (const ScriptLine& below : line.below) TRY_STATUS(apply_effect(below, effects, own));
  for (std::size_t i = 0; i < own.size(); ++i) io_sum[start + i] += own[i];
  return base::Ok{};
}

// For error messages.
std::string list_keywords() {
  std::string known;
  for (const VoiceKeyword& word : voice_keywords()) known.append(word.keyword).append(", ");
  for (const EffectKeyword& word : effect_keywords())
    known.append(word.keyword).append(&word == &effect_keywords().back() ? "" : ", ");
  return known;
}

}  // namespace

base::Result<Signal> render_patch(const std::vector<ScriptLine>& lines, const PatchContext& context) {
  Signal sum(count_frames(context.length_s, context.rate), 0.0);
  std::uint64_t voice = 0;
  for (const ScriptLine& line : lines) {
    // Each line has its own seed, so that equal voices do not make equal noise.
    PatchContext own = context;
    own.seed = base::hash_with(context.seed, ++voice);
    if (const VoiceKeyword* word = find_voice(line)) {
      TRY_STATUS(add_voice(line, *word, own, sum));
    } else if (find_effect(line) != nullptr) {
      TRY_STATUS(apply_effect(line, {context.rate, context.length_s, own.seed}, sum));
    } else {
      return script_error(line, fmt::format("expected a voice or an effect: {}", list_keywords()));
    }
  }
  return sum;
}

}  // namespace temblor::artgen
