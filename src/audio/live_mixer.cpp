#include "audio/live_mixer.h"

#include <algorithm>
#include <utility>

#include "audio/mixing/fold_events.h"

namespace temblor::audio {
namespace {

// Frames and device callbacks are both irregular, so a movement is spread over about one of each.
constexpr std::size_t kGlide_frames = kFramesPerSecond / 50;
// A working device calls back at least 50 times a second, so more posts than this wait only if it hangs.
constexpr std::size_t kMaxPosts = 256;

}  // namespace

LiveMixer::LiveMixer() : mixer_({.keep_finished_sounds = true}), music_samples_(2 * kMusicBlock_frames) {
  for (PendingEvents* pending : {&incoming_, &taken_}) pending->finished.reserve(Mixer::kMaxVoices);
}

void LiveMixer::PendingEvents::clear() {
  scene.reset();
  for (std::size_t i = 0; i < count; ++i) events[i].clear();
  count = 0;
  finished.clear();
  is_read = false;
}

void LiveMixer::post(const Scene& scene, const SoundEvents& events) {
  const std::lock_guard lock(mutex_);
  if (incoming_.is_read) incoming_.clear();
  incoming_.scene = scene;
  if (events.empty()) return;
  // Earlier events mostly cancel out when all sounds stop, so one merged entry is enough. From kMaxPosts on,
  // new events merge into the last entry, which bounds the memory while a device hangs.
  if (events.stops_all) incoming_.fold_all();
  if (incoming_.count >= kMaxPosts || (events.stops_all && incoming_.count > 0))
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

// Swaps the posted events with those of the previous call, which go back to the game thread because clearing
// them may free memory. Does nothing if the mutex is locked or nothing is new.
void LiveMixer::take_pending_events() {
  {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock.owns_lock() || incoming_.is_read || !incoming_.scene) return;
    std::swap(incoming_, taken_);
    incoming_.is_read = true;
  }
  mixer_.set_scene(*taken_.scene, kGlide_frames);
  for (std::size_t i = 0; i < taken_.count; ++i) mixer_.handle_events(taken_.events[i]);
  mixer_.move_finished_to(taken_.finished);
}

void LiveMixer::fill(std::span<float> out_samples) {
  take_pending_events();
  while (!out_samples.empty()) {
    const std::size_t size = std::min(out_samples.size(), 2 * kMusicBlock_frames);
    const std::span<float> music = std::span(music_samples_).first(size);
    music_.read(music);
    mixer_.render(out_samples.first(size), music);
    out_samples = out_samples.subspan(size);
  }
}

}  // namespace temblor::audio
