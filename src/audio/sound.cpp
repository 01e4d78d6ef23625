// Method: libsamplerate's windowed sinc, offline. A loop must have a whole number of samples after
// resampling, so the ratio is adjusted (by less than half a sample over the loop). At both ends of the loop
// the filter must see only samples of the loop, so the source's loop is repeated once and the result loops
// inside the repetition:
//
//   source  |-- beginning --|------ loop ------|---- loop again ----|
//   result  |-- beginning --+ reach |== result loop ==|               reach: see kFilterReach
#include "audio/sound.h"

#include <samplerate.h>

#include <algorithm>
#include <cmath>

namespace temblor::audio {
namespace {

// The fade at the end of a sound without a loop, and the longest blend of an end into a beginning.
constexpr double kFade_s = 0.001, kMaxBlended_s = 0.1;
// In samples of the lower rate. At least as long as the resampling filter reaches to either side.
constexpr double kFilterReach = 64;

struct Plan {
  std::vector<float> source;  // with the loop repeated once, if there is one
  double ratio = 1;           // output samples per input sample
  std::size_t length = 0;     // output samples wanted
  std::optional<SoundLoop> loop;
};

// Averages the channels and scales integers of 8 or 16 bits to the range -1 to 1.
std::vector<float> mix_to_mono(const formats::Wav& wav) {
  const float scale = 1.0f / (wav.bits == 8 ? 128.0f : 32768.0f) / static_cast<float>(wav.channels);
  std::vector<float> samples(wav.frame_count(), 0.0f);
  for (std::size_t i = 0; i < wav.samples.size(); ++i)
    samples[i / wav.channels] += scale * static_cast<float>(wav.samples[i]);
  return samples;
}

// Blends the beginning into the end and makes a loop that skips the beginning. The last sample then equals
// the one before the loop's start, so the jump continues the signal. Returns no loop for an empty sound.
std::optional<formats::WavLoop> close_loop(std::vector<float>& io_samples, std::uint32_t frames_per_second) {
  const std::size_t length = io_samples.size();
  const std::size_t blended =
      std::min(length / 4, static_cast<std::size_t>(kMaxBlended_s * frames_per_second));
  if (length == 0) return std::nullopt;
  for (std::size_t i = 0; i < blended; ++i) {
    const float share = static_cast<float>(i + 1) / static_cast<float>(blended);
    float& sample = io_samples[length - blended + i];
    sample += share * (io_samples[i] - sample);
  }
  return formats::WavLoop{static_cast<std::uint32_t>(blended), static_cast<std::uint32_t>(length)};
}

Plan plan_without_loop(std::vector<float> source, double ratio) {
  const auto length = static_cast<std::size_t>(std::llround(static_cast<double>(source.size()) * ratio));
  return {std::move(source), ratio, length, std::nullopt};
}

// Precondition: loop.start < loop.end <= source.size().
Plan plan_with_loop(std::vector<float> source, const formats::WavLoop& loop, double ratio) {
  const std::size_t once = loop.end - loop.start;
  const double repeats = std::ceil(static_cast<double>(kMinLoop) / (static_cast<double>(once) * ratio));
  const double frames = static_cast<double>(once) * std::max(repeats, 1.0);
  const auto loop_length = static_cast<std::size_t>(std::llround(frames * ratio));
  Plan plan;
  plan.ratio = static_cast<double>(loop_length) / frames;
  const double reach = std::ceil(kFilterReach * std::max(1.0, 1 / plan.ratio));
  plan.loop = SoundLoop{};
  plan.loop->start = static_cast<std::size_t>(std::ceil((loop.start + reach) * plan.ratio));
  plan.loop->end = plan.length = plan.loop->start + loop_length;
  const auto needed =
      static_cast<std::size_t>(std::ceil(static_cast<double>(plan.length) / plan.ratio + reach)) + 1;
  source.resize(loop.end);
  while (source.size() < needed) source.push_back(source[source.size() - once]);
  plan.source = std::move(source);
  return plan;
}

// At a ratio of exactly 1 the samples stay bit for bit the same.
base::Result<std::vector<float>> resample(const Plan& plan) {
  std::vector<float> samples(plan.length);
  if (plan.ratio == 1.0) {
    std::copy_n(plan.source.begin(), plan.length, samples.begin());
    return samples;
  }
  SRC_DATA job{};
  job.data_in = plan.source.data();
  job.data_out = samples.data();
  job.input_frames = static_cast<long>(plan.source.size());
  job.output_frames = static_cast<long>(samples.size());
  job.src_ratio = plan.ratio;
  if (const int failure = src_simple(&job, SRC_SINC_MEDIUM_QUALITY, 1); failure != 0)
    return base::error(base::ErrorCode::kUnsupported, "the sound cannot be resampled: {}",
                       src_strerror(failure));
  return samples;
}

void fade_end(std::vector<float>& io_samples) {
  const std::size_t count = std::min(io_samples.size(), static_cast<std::size_t>(kFade_s * kFramesPerSecond));
  float* const first = io_samples.data() + (io_samples.size() - count);
  for (std::size_t i = 0; i < count; ++i)
    first[i] *= static_cast<float>(count - 1 - i) / static_cast<float>(count);
}

}  // namespace

base::Result<SoundPtr> make_sound(const formats::Wav& wav, std::string name, Repeats repeats) {
  if (wav.frame_count() > std::size_t{kMaxSound_s} * wav.frames_per_second)
    return base::error(base::ErrorCode::kTooLarge,
                       "the sound lasts {} s; the limit is {} s (play it as music instead)",
                       wav.frame_count() / wav.frames_per_second, kMaxSound_s);
  const double ratio = static_cast<double>(kFramesPerSecond) / wav.frames_per_second;
  std::vector<float> source = mix_to_mono(wav);
  std::optional<formats::WavLoop> loop = wav.loop;
  if (!loop && repeats == Repeats::kAlways) loop = close_loop(source, wav.frames_per_second);
  const Plan plan =
      loop ? plan_with_loop(std::move(source), *loop, ratio) : plan_without_loop(std::move(source), ratio);
  Sound sound{std::move(name), {}, plan.loop};
  if (plan.length > 0) {
    TRY(sound.samples, resample(plan));
  }
  if (!sound.loop) fade_end(sound.samples);
  return std::make_shared<const Sound>(std::move(sound));
}

}  // namespace temblor::audio
