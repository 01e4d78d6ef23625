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
#include "formats/game/captions.h"
#include "formats/sounds/wav.h"

namespace temblor::artgen {
namespace {

// The longest sound that the engine's mixer accepts.
constexpr double kMaxLength_s = 60;

// The settings of a sound's first line.
struct SoundSettings {
  std::string name, caption;
  double length_s = 1, fade_s = 0.03, blend_s = 0.3, level_db = -14;
  std::optional<double> loop_s;
  bool half_rate = true;
};

// FOLDER/NAME in lower case, as game code refers to sounds.
bool is_sound_name(std::string_view name) {
  const std::size_t slash = name.find('/');
  const auto is_part = [](std::string_view part) {
    return !part.empty() && std::all_of(part.begin(), part.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
  };
  return slash != std::string_view::npos && is_part(name.substr(0, slash)) && is_part(name.substr(slash + 1));
}

base::Result<SoundSettings> read_sound_settings(const ScriptLine& asset) {
  Arguments arguments(asset);
  SoundSettings settings;
  settings.name = arguments.text();
  settings.length_s = arguments.number("length", 1, 0.02, kMaxLength_s);
  settings.fade_s = arguments.number("fade", 0.03, 0.001, kMaxLength_s);
  settings.blend_s = arguments.number("blend", 0.3, 0.001, kMaxLength_s);
  if (!arguments.has("length")) arguments.set_error("length= (seconds) is required");
  settings.caption = arguments.text("caption", "");
  if (settings.caption.size() > formats::kMaxCaptionChars)
    arguments.set_error(fmt::format("caption= has more than {} characters", formats::kMaxCaptionChars));
  const std::string kind = arguments.text("class", "impact");
  const SoundClass* known = find_sound_class(kind);
  if (known == nullptr)
    arguments.set_error(fmt::format("class={} is not one of {}", base::quotable(kind), sound_class_names()));
  settings.level_db = (known != nullptr ? known->loudest_db : 0) + arguments.number("louder", 0, -40, 12);
  const std::int32_t rate = arguments.integer("rate", 22050, 22050, 44100);
  if (rate != 22050 && rate != 44100) arguments.set_error("rate= must be 22050 or 44100");
  settings.half_rate = rate == 22050;
  const double loop_s = arguments.number("loop", 0, 0, settings.length_s);
  if (arguments.has("loop")) settings.loop_s = loop_s;
  if (settings.loop_s && settings.length_s - *settings.loop_s < settings.blend_s)
    arguments.set_error("the loop is shorter than blend=");
  if (!is_sound_name(settings.name))
    arguments.set_error("a sound's name is FOLDER/NAME, in lower case letters, digits and _");
  TRY_STATUS(arguments.finish());
  return settings;
}

// An even number, so that positions are whole at half the rate, too.
std::size_t count_even_frames(double seconds) {
  return count_frames(seconds, kSynthesisRate) / 2 * 2;
}

// The end of a loop is blended into the samples before its start. If there are too few of them, the sound is
// made with additional samples at its front, which are cut away afterwards.
base::Result<formats::Wav> make_wav(const ScriptLine& asset, const SoundSettings& settings) {
  const std::size_t blend = settings.loop_s ? count_even_frames(settings.blend_s) : 0;
  const std::size_t loop = settings.loop_s ? count_even_frames(*settings.loop_s) : 0;
  const std::size_t front = loop < blend ? blend : 0;
  const std::size_t length = count_even_frames(settings.length_s);
  const double total_s = static_cast<double>(front + length) / kSynthesisRate;
  const std::uint64_t seed = base::hash_bytes(base::as_bytes(settings.name));
  TRY(Signal signal, render_patch(asset.below, {kSynthesisRate, total_s, total_s, 1, seed}));
  signal.resize(front + length);
  remove_rumble(signal, kSynthesisRate);
  const std::size_t step = settings.half_rate ? 2 : 1;
  if (settings.half_rate) signal = halve_rate(signal);
  const double rate = kSynthesisRate / static_cast<double>(step);
  // After the filters, because those can raise peaks.
  normalize_loudness({&signal, 1}, settings.level_db, rate);
  formats::Wav wav;
  wav.bits = 16;
  wav.frames_per_second = static_cast<std::uint32_t>(rate);
  if (settings.loop_s) {
    crossfade_loop(signal, (front + loop) / step, signal.size(), blend / step);
    signal.erase(signal.begin(), signal.begin() + static_cast<std::ptrdiff_t>(front / step));
    if (loop > 0) fade_in(signal, rate);
    wav.loop = {static_cast<std::uint32_t>(loop / step), static_cast<std::uint32_t>(signal.size())};
  } else {
    fade_in(signal, rate);
    fade_out(signal, settings.fade_s, rate);
  }
  wav.samples = to_samples(signal);
  drop_masked_bits(wav.samples);
  return wav;
}

}  // namespace

base::Result<std::vector<ArtPart>> make_sound_file(const ScriptLine& asset) {
  TRY(const SoundSettings settings, read_sound_settings(asset));
  TRY(const formats::Wav wav, make_wav(asset, settings));
  std::vector<ArtPart> parts;
  const std::string file = settings.name + ".wav";
  parts.push_back({"sound/" + file, formats::write_wav(wav)});
  if (settings.caption.empty()) return parts;
  const std::string line =
      formats::format_caption_line(file, settings.caption == "-" ? "" : settings.caption);
  const base::Bytes bytes = base::as_bytes(line);
  parts.push_back({.path = "captions.txt", .bytes = {bytes.begin(), bytes.end()}, .lump = file});
  return parts;
}

}  // namespace temblor::artgen
