#include "client/view/sound_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace temblor::client {
namespace {

constexpr double kTryAgain_s = 2, kTrySeldom_s = 60;
constexpr int kManyTries = 10;
constexpr double kMaxMixed_s = 0.1;

}  // namespace

SoundOutput::SoundOutput(OpenAudioDevice open) : open_(std::move(open)) {
  unheard_.resize(2 * static_cast<std::size_t>(kMaxMixed_s * audio::kFramesPerSecond));
}

void SoundOutput::look_after_device(double time_s) {
  if (device_ && device_->is_lost()) {
    notes_.push_back(fmt::format("the sound device has gone ({})", device_->describe()));
    device_.reset();
    is_missing_ = true;
    next_try_s_.reset();
  }
  if (device_ || (next_try_s_ && time_s < *next_try_s_)) return;
  base::Result<std::unique_ptr<platform::AudioDevice>> device =
      open_([this](std::span<float> samples) { mixer_.fill(samples); });
  // Each try takes the game's time: a machine without sound is not asked again and again.
  tries_ = device.ok() ? 0 : tries_ + 1;
  next_try_s_ = time_s + (tries_ <= kManyTries ? kTryAgain_s : kTrySeldom_s);
  if (device.ok()) {
    device_ = std::move(device).value();
    if (is_missing_) notes_.push_back(fmt::format("sound again: {}", device_->describe()));
  } else if (!is_missing_) {
    notes_.push_back(fmt::format("{}; going on without sound", device.error().message()));
  }
  is_missing_ = !device_;
}

// What would have been heard is thrown away.
void SoundOutput::pass_without_device(double time_s) {
  const double passed_s = std::clamp(time_s - time_s_, 0.0, kMaxMixed_s);
  const auto frames = static_cast<std::size_t>(passed_s * audio::kFramesPerSecond);
  mixer_.fill(std::span(unheard_).first(2 * frames));
}

void SoundOutput::advance(double time_s, const audio::Scene& scene, const audio::SoundEvents& events) {
  look_after_device(time_s);
  mixer_.post(scene, events);
  if (!device_) pass_without_device(time_s);
  time_s_ = time_s;
  if (const std::optional<base::Error> failure = mixer_.take_music_failure())
    notes_.push_back(fmt::format("{}; no music", failure->message()));
  if (mixer_.music_has_failed() && !has_noted_music_) {
    has_noted_music_ = true;
    notes_.push_back(fmt::format("the music of track {} is damaged; it stops there", track_));
  }
}

void SoundOutput::play_music(const assets::Library& library, int track) {
  if (track == track_) return;
  track_ = track;
  has_noted_music_ = false;
  base::Result<assets::MusicFile> file = library.music(track);
  // Most installations have no music, or not all of it.
  if (track == 0 || !file.ok()) return mixer_.play_music(nullptr);
  mixer_.play_music([file = std::move(file).value()]() -> base::Result<audio::MusicDecoder> {
    TRY(base::ByteVector bytes, file.read());
    return audio::MusicDecoder::open(std::move(bytes)).with_file(file.name);
  });
}

std::string SoundOutput::describe() const {
  return device_ ? device_->describe() : "no sound device";
}

}  // namespace temblor::client
