#include "client/view/sound_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace temblor::client {
namespace {

// How long to wait before opening a device again: first often, after many failures seldom.
constexpr double kRetryInterval_s = 2, kSlowRetryInterval_s = 60;
constexpr int kFastRetries = 10;
// How much sound is mixed for one frame without a device; a hitch skips the rest.
constexpr double kMaxMixed_s = 0.1;

audio::OpenMusic open_later(assets::MusicFile file) {
  return [file = std::move(file)]() -> base::Result<audio::MusicDecoder> {
    TRY(base::ByteVector bytes, file.read());
    return audio::MusicDecoder::open(std::move(bytes)).with_file(file.name);
  };
}

}  // namespace

SoundOutput::SoundOutput(OpenAudioDevice open) : open_(std::move(open)) {
  discarded_.resize(2 * static_cast<std::size_t>(kMaxMixed_s * audio::kFramesPerSecond));
}

// Losing the device and finding another is reported once each.
void SoundOutput::maintain_device(double time_s) {
  if (device_ && device_->is_lost()) {
    notes_.push_back(fmt::format("Sound device lost ({})", device_->describe()));
    device_.reset();
    is_missing_ = true;
    next_try_s_.reset();
  }
  if (device_ || (next_try_s_ && time_s < *next_try_s_)) return;
  base::Result<std::unique_ptr<platform::AudioDevice>> device =
      open_([this](std::span<float> samples) { mixer_.fill(samples); });
  // Opening a device takes time, so the tries become rarer on a machine without sound.
  tries_ = device.ok() ? 0 : tries_ + 1;
  next_try_s_ = time_s + (tries_ <= kFastRetries ? kRetryInterval_s : kSlowRetryInterval_s);
  if (device.ok()) {
    device_ = std::move(device).value();
    if (is_missing_) notes_.push_back(fmt::format("Sound restored: {}", device_->describe()));
  } else if (!is_missing_) {
    notes_.push_back(fmt::format("{}. Continuing without sound", device.error().message()));
  }
  is_missing_ = !device_;
}

// Mixes sound and discards it, so that sounds and music advance in time without a device.
void SoundOutput::advance_unheard(double time_s) {
  const double elapsed_s = std::clamp(time_s - time_s_, 0.0, kMaxMixed_s);
  const auto frames = static_cast<std::size_t>(elapsed_s * audio::kFramesPerSecond);
  mixer_.fill(std::span(discarded_).first(2 * frames));
}

void SoundOutput::advance(double time_s, const audio::Scene& scene, const audio::SoundEvents& events) {
  maintain_device(time_s);
  mixer_.post(scene, events);
  if (!device_) advance_unheard(time_s);
  time_s_ = time_s;
  if (const std::optional<base::Error> failure = mixer_.take_music_failure())
    notes_.push_back(fmt::format("{}. No music will play", failure->message()));
  if (const std::optional<base::Error> failure = mixer_.take_combat_failure())
    notes_.push_back(fmt::format("{}. Music track {} plays without it", failure->message(), track_));
  if (mixer_.music_has_failed() && !has_noted_music_) {
    has_noted_music_ = true;
    notes_.push_back(fmt::format("Music track {} is damaged and stops early", track_));
  }
}

void SoundOutput::play_music(const assets::Library& library, int track) {
  if (track == track_) return;
  track_ = track;
  has_noted_music_ = false;
  base::Result<assets::MusicFile> file = library.music(track);
  // Most installations have no music, or only some of it, so missing files are not reported.
  if (track == 0 || !file.ok()) return mixer_.play_music(nullptr);
  const std::optional<assets::MusicFile> combat = library.combat_layer(track);
  mixer_.play_music(open_later(std::move(file).value()), combat ? open_later(*combat) : nullptr);
}

std::string SoundOutput::describe() const {
  return device_ ? device_->describe() : "no sound device";
}

}  // namespace temblor::client
