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

struct VoiceTimes {
  double at_s = 0, for_s = 1, attack_s = 0, decay_s = 0, fade_s = 0;
  double every_s = 0, scatter = 0;
  std::int32_t times = 1;
  std::uint64_t seed = 0;
};

VoiceTimes read_times(Arguments& io_arguments, const PatchContext& context) {
  constexpr double kLongest_s = 600;
  VoiceTimes times;
  times.at_s = io_arguments.number("at", 0, 0, kLongest_s);
  const double rest_s = std::max(0.001, std::min(context.voice_s, context.length_s - times.at_s));
  times.for_s = io_arguments.number("for", rest_s, 0.001, kLongest_s);
  times.attack_s = io_arguments.number("attack", 0.001, 0, kLongest_s);
  times.decay_s = io_arguments.number("decay", 0, 0, kLongest_s);
  times.fade_s = io_arguments.number("fade", 0.01, 0, kLongest_s);
  times.times = io_arguments.integer("times", 1, 1, 200);
  times.every_s = io_arguments.number("every", 0.1, 0.001, kLongest_s);
  times.scatter = io_arguments.number("scatter", 0, 0, 1);
  times.seed = static_cast<std::uint64_t>(io_arguments.integer("seed", 0, 0, 1'000'000));
  return times;
}

double eased(double part) {
  return part >= 1 ? 1 : 0.5 - 0.5 * std::cos(3.14159265358979 * std::max(0.0, part));
}

void shape(Signal& io_samples, const VoiceTimes& times, const Curve& level, double rate) {
  const Signal levels = level.values(io_samples.size(), rate);
  const double end_s = static_cast<double>(io_samples.size()) / rate;
  for (std::size_t i = 0; i < io_samples.size(); ++i) {
    const double time_s = static_cast<double>(i) / rate;
    double factor = levels[i];
    if (time_s < times.attack_s) factor *= eased(time_s / times.attack_s);
    if (times.decay_s > 0 && time_s > times.attack_s)
      factor *= std::pow(10.0, -3 * (time_s - times.attack_s) / times.decay_s);
    if (end_s - time_s < times.fade_s) factor *= eased((end_s - time_s) / times.fade_s);
    io_samples[i] *= factor;
  }
}

// One repetition of a voice, laid over the others.
base::Status add_repetition(const ScriptLine& line, const VoiceWord& word, std::int32_t repetition,
                            const PatchContext& context, Signal& io_sum) {
  Arguments arguments(line);
  const VoiceTimes times = read_times(arguments, context);
  const std::uint64_t seed =
      base::hash_with(context.seed, times.seed * 1000 + static_cast<std::uint64_t>(repetition));
  Noise noise(base::hash_with(seed, 1));
  const double late_s = times.every_s * (repetition + times.scatter * 0.5 * noise.both());
  const double pitch = std::pow(2.0, times.scatter * 0.6 * noise.both());
  const double strength = 1 - 0.7 * times.scatter * noise.unit();
  const Curve level = curve_setting(arguments, "level", 1, {0, 10}, times.for_s);

  Signal own = word.make(
      arguments, {context.rate, times.for_s, repetition > 0 ? context.pitch * pitch : context.pitch, seed});
  TRY_STATUS(arguments.finish());
  shape(own, times, level, context.rate);
  const std::size_t start = repetition > 0 ? frames_in(std::max(0.0, late_s), context.rate) : 0;
  const double gain = repetition > 0 ? strength : 1;
  for (std::size_t i = 0; i < own.size() && start + i < io_sum.size(); ++i)
    io_sum[start + i] += gain * own[i];
  return base::Ok{};
}

const EffectWord* find_effect(const ScriptLine& line) {
  for (const EffectWord& known : effect_words())
    if (known.word == line.word) return &known;
  return nullptr;
}

const VoiceWord* find_voice(const ScriptLine& line) {
  for (const VoiceWord& known : voice_words())
    if (known.word == line.word) return &known;
  return nullptr;
}

base::Status apply_effect(const ScriptLine& line, const EffectContext& context, Signal& io_signal) {
  const EffectWord* effect = find_effect(line);
  if (effect == nullptr) {
    std::string known;
    for (const EffectWord& word : effect_words()) known.append(known.empty() ? "" : ", ").append(word.word);
    return script_error(line, fmt::format("nothing that changes a sound; there are {}", known));
  }
  if (!line.below.empty()) return script_error(line.below.front(), "nothing can stand under an effect");
  Arguments arguments(line);
  effect->apply(arguments, context, io_signal);
  return arguments.finish();
}

// A voice with its repetitions and effects, as long as the sound from where it begins.
base::Status add_voice(const ScriptLine& line, const VoiceWord& word, const PatchContext& context,
                       Signal& io_sum) {
  Arguments arguments(line);
  const VoiceTimes times = read_times(arguments, context);
  const std::size_t start = frames_in(times.at_s, context.rate);
  if (start >= io_sum.size()) return script_error(line, "it begins when the sound is over");
  Signal own(io_sum.size() - start, 0.0);
  for (std::int32_t i = 0; i < times.times; ++i) TRY_STATUS(add_repetition(line, word, i, context, own));
  const EffectContext effects{context.rate, times.for_s + times.every_s * (times.times - 1), context.seed};
  for (const ScriptLine& below : line.below) TRY_STATUS(apply_effect(below, effects, own));
  for (std::size_t i = 0; i < own.size(); ++i) io_sum[start + i] += own[i];
  return base::Ok{};
}

std::string known_words() {
  std::string known;
  for (const VoiceWord& word : voice_words()) known.append(word.word).append(", ");
  for (const EffectWord& word : effect_words())
    known.append(word.word).append(&word == &effect_words().back() ? "" : ", ");
  return known;
}

}  // namespace

base::Result<Signal> render_patch(const std::vector<ScriptLine>& lines, const PatchContext& context) {
  Signal sum(frames_in(context.length_s, context.rate), 0.0);
  std::uint64_t voice = 0;
  for (const ScriptLine& line : lines) {
    PatchContext own = context;
    own.seed = base::hash_with(context.seed, ++voice);
    if (const VoiceWord* word = find_voice(line)) {
      TRY_STATUS(add_voice(line, *word, own, sum));
    } else if (find_effect(line) != nullptr) {
      TRY_STATUS(apply_effect(line, {context.rate, context.length_s, own.seed}, sum));
    } else {
      return script_error(line, fmt::format("neither a voice nor an effect; there are {}", known_words()));
    }
  }
  return sum;
}

}  // namespace temblor::artgen
