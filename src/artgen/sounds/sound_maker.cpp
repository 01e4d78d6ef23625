#include "artgen/sounds/sound_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "artgen/sounds/mastering.h"
#include "artgen/sounds/music/patch.h"
#include "artgen/sounds/signal.h"
#include "base/text.h"
#include "formats/sounds/wav.h"

namespace temblor::artgen {
namespace {

constexpr double kLongest_s = 60;  // as the mixer takes them

struct SoundPlan {
  std::string name;
  double length_s = 1, fade_s = 0.03, blend_s = 0.3, level_db = -14;
  std::optional<double> loop_s;
  bool half_rate = true;
};

// FOLDER/NAME in small letters, as game code names sounds.
bool is_sound_name(std::string_view name) {
  const std::size_t slash = name.find('/');
  const auto is_part = [](std::string_view part) {
    return !part.empty() && std::all_of(part.begin(), part.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
  };
  return slash != std::string_view::npos && is_part(name.substr(0, slash)) && is_part(name.substr(slash + 1));
}

base::Result<SoundPlan> read_plan(const ScriptLine& thing) {
  Arguments arguments(thing);
  SoundPlan plan;
  plan.name = arguments.text();
  plan.length_s = arguments.number("length", 1, 0.02, kLongest_s);
  plan.fade_s = arguments.number("fade", 0.03, 0.001, kLongest_s);
  plan.blend_s = arguments.number("blend", 0.3, 0.001, kLongest_s);
  if (!arguments.has("length")) arguments.complain("length= is missing, in seconds");
  const std::string kind = arguments.text("class", "impact");
  const SoundClass* known = find_sound_class(kind);
  if (known == nullptr)
    arguments.complain(fmt::format("class={} is none of {}", base::quotable(kind), sound_class_names()));
  plan.level_db = (known != nullptr ? known->loudest_db : 0) + arguments.number("louder", 0, -40, 12);
  const std::int32_t rate = arguments.integer("rate", 22050, 22050, 44100);
  if (rate != 22050 && rate != 44100) arguments.complain("rate= is neither 22050 nor 44100");
  plan.half_rate = rate == 22050;
  const double loop_s = arguments.number("loop", 0, 0, plan.length_s);
  if (arguments.has("loop")) plan.loop_s = loop_s;
  if (plan.loop_s && plan.length_s - *plan.loop_s < plan.blend_s)
    arguments.complain("the loop is shorter than what is blended (blend=)");
  if (!is_sound_name(plan.name)) arguments.complain("a sound is FOLDER/NAME, of small letters, digits and _");
  TRY_STATUS(arguments.finish());
  return plan;
}

// Even, so that half the rate has them all.
std::size_t even_frames(double seconds) {
  return frames_in(seconds, kSynthesisRate) / 2 * 2;
}

// A loop needs something before its start to blend its end into. Where the script has too little, the sound
// is made with that much in front, which is cut away.
base::Result<formats::Wav> make_wav(const ScriptLine& thing, const SoundPlan& plan) {
  const std::size_t blend = plan.loop_s ? even_frames(plan.blend_s) : 0;
  const std::size_t loop = plan.loop_s ? even_frames(*plan.loop_s) : 0;
  const std::size_t front = loop < blend ? blend : 0;
  const std::size_t length = even_frames(plan.length_s);
  const double total_s = static_cast<double>(front + length) / kSynthesisRate;
  const std::uint64_t seed = base::hash_of_bytes(base::as_bytes(plan.name));
  TRY(Signal signal, render_patch(thing.below, {kSynthesisRate, total_s, total_s, 1, seed}));
  signal.resize(front + length);
  remove_rumble(signal, kSynthesisRate);
  const std::size_t step = plan.half_rate ? 2 : 1;
  if (plan.half_rate) signal = halve_rate(signal);
  const double rate = kSynthesisRate / static_cast<double>(step);
  bring_to_level({&signal, 1}, plan.level_db, rate);  // last: filters let peaks grow
  formats::Wav wav;
  wav.bits = 16;
  wav.frames_per_second = static_cast<std::uint32_t>(rate);
  if (plan.loop_s) {
    blend_loop(signal, (front + loop) / step, signal.size(), blend / step);
    signal.erase(signal.begin(), signal.begin() + static_cast<std::ptrdiff_t>(front / step));
    if (loop > 0) soften_start(signal, rate);
    wav.loop = {static_cast<std::uint32_t>(loop / step), static_cast<std::uint32_t>(signal.size())};
  } else {
    soften_start(signal, rate);
    soften_end(signal, plan.fade_s, rate);
  }
  wav.samples = to_samples(signal);
  drop_hidden_bits(wav.samples);
  return wav;
}

}  // namespace

base::Result<std::vector<ArtPart>> make_sound_file(const ScriptLine& thing) {
  TRY(const SoundPlan plan, read_plan(thing));
  TRY(const formats::Wav wav, make_wav(thing, plan));
  std::vector<ArtPart> parts;
  parts.push_back({fmt::format("sound/{}.wav", plan.name), formats::write_wav(wav)});
  return parts;
}

}  // namespace temblor::artgen
