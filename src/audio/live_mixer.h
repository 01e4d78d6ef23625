// Connects the mixer's two threads: the game thread posts scenes and events, the device thread takes samples.
//
// The device thread must never wait and must not allocate or free memory once warm. The threads therefore
// exchange whole PendingEvents under a mutex that the device thread only tries to lock; finished sounds
// travel back in the same object, and the game thread frees them.
//
//   game thread   --post()--> incoming_ --swap--> taken_ --> Mixer --fill()--> device thread
//   game thread   <-- finished sounds -- incoming_ <--swap-- taken_
//
// If the device thread finds the mutex locked, it renders on with the last scene and tries again at the next
// callback. A callback takes all posts at once, in order.
#pragma once

#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "audio/mixer.h"
#include "audio/mixing/music_stream.h"

namespace temblor::audio {

class LiveMixer {
 public:
  LiveMixer();

  // Game thread. Passes on the current scene and the events since the last call. They apply when the device
  // next asks for samples, a few milliseconds later. If the device hangs, events are folded
  // (mixing/fold_events.h), so the backlog stays bounded.
  void post(const Scene& scene, const SoundEvents& events);
  // Game thread. See MusicStream.
  void play_music(OpenMusic open, OpenMusic open_combat = nullptr) {
    music_.play(std::move(open), std::move(open_combat));
  }
  std::optional<base::Error> take_music_failure() { return music_.take_failure(); }
  std::optional<base::Error> take_combat_failure() { return music_.take_combat_failure(); }
  void set_combat(bool combat) { music_.set_combat(combat); }
  void pause_music(bool paused) { music_.set_paused(paused); }
  // Any thread. Whether the current music file is damaged.
  bool music_has_failed() const { return music_.has_failed(); }

  // Device thread. Fills the buffer, as platform::AudioFill requires.
  void fill(std::span<float> out_samples);

 private:
  static constexpr std::size_t kMusicBlock_frames = 512;

  // Everything posted since the last device callback.
  struct PendingEvents {
    std::optional<Scene> scene;
    // The first `count` entries are valid; the others keep their memory for later posts.
    std::vector<SoundEvents> events;
    std::size_t count = 0;
    // On the way back to the game thread, which frees them. Reserved once, so the device thread can append.
    std::vector<SoundPtr> finished;
    bool is_read = false;  // the device thread has applied it
    void clear();
    void fold_all();  // merges all events into the first entry
  };
  void take_pending_events();

  // Guards `incoming_` only. Held briefly, and the device thread only tries to lock it.
  std::mutex mutex_;
  PendingEvents incoming_;
  PendingEvents taken_;  // used by the device thread only, like everything below
  Mixer mixer_;
  std::vector<float> music_samples_;
  MusicStream music_;
};

}  // namespace temblor::audio
