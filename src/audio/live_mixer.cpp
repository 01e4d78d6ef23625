#include "audio/live_mixer.h"

#include <algorithm>
#include <utility>

#include "audio/mixing/fold_events.h"

namespace temblor::audio {
namespace {

// Frames come unevenly, and the device asks unevenly: a movement takes about as long as both.
constexpr std::size_t kGlide_frames = kFramesPerSecond / 50;
// Devices ask 50 times a second at least: more are waiting only where one hangs.
constexpr std::size_t kMaxPosts = 256;

}  // namespace

LiveMixer::LiveMixer() : mixer_({.keep_done_sounds = true}), music_samples_(2 * kMusicBlock_frames) {
  for (PendingEvents* mail : {&incoming_, &taken_}) mail->done.reserve(Mixer::kMaxVoices);
}

void LiveMixer::PendingEvents::clear() {
  scene.reset();
  for (std::size_t i = 0; i < count; ++i) events[i].clear();
  count = 0;
  done.clear();
  is_read = false;
}

void LiveMixer::post(const Scene& scene, const SoundEvents& events) {
  const std::lock_guard lock(mutex_);
  if (incoming_.is_read) incoming_.clear();
  incoming_.scene = scene;
  if (events.empty()) return;
  // What a level began with before another one began is not news either.
  if (events.begins_anew) incoming_.fold_all();
  if (incoming_.count >= kMaxPosts || (events.begins_anew && incoming_.count > 0))
    return fold(events, incoming_.events[incoming_.count - 1]);
  if (incoming_.count == incoming_.events.size()) incoming_.events.emplace_back();
  incoming_.events[incoming_.count++] = events;
}

void LiveMixer::PendingEvents::fold_all() {
  for (std::size_t i = 1; i < count; ++i) {
    fold(events[i], events[0]);
    events[i].clear();
  }
  count = std::min(count, std::size_t{1});
}

// What was taken the last time goes back to be cleared by the thread that may free.
void LiveMixer::take_mail() {
  {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock.owns_lock() || incoming_.is_read || !incoming_.scene) return;
    std::swap(incoming_, taken_);
    incoming_.is_read = true;
  }
  mixer_.follow(*taken_.scene, kGlide_frames);
  for (std::size_t i = 0; i < taken_.count; ++i) mixer_.happen(taken_.events[i]);
  mixer_.move_done_to(taken_.done);
}

void LiveMixer::fill(std::span<float> out_samples) {
  take_mail();
  while (!out_samples.empty()) {
    const std::size_t size = std::min(out_samples.size(), 2 * kMusicBlock_frames);
    const std::span<float> music = std::span(music_samples_).first(size);
    music_.read(music);
    mixer_.render(out_samples.first(size), music);
    out_samples = out_samples.subspan(size);
  }
}

}  // namespace temblor::audio
