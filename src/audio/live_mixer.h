// The mixer between two threads: the game's tells it what is to be heard, the sound device's takes samples.
// The device's thread never waits, and asks the heap for nothing once warm.
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

  // From the game's thread. How things are now, and what has happened since the last time; taken up when the
  // device next asks, a few milliseconds later. Where it does not ask for long, what would have been over by
  // then is left out, so that no more than so much waits.
  void post(const Scene& scene, const SoundEvents& events);
  // As of MusicStream.
  void play_music(OpenMusic open) { music_.play(std::move(open)); }
  std::optional<base::Error> take_music_failure() { return music_.take_failure(); }
  void pause_music(bool paused) { music_.set_paused(paused); }
  // The file that is being played turned out to be damaged.
  bool music_has_failed() const { return music_.has_failed(); }

  // From the device's thread; as platform::AudioFill.
  void fill(std::span<float> out_samples);

 private:
  static constexpr std::size_t kMusicBlock_frames = 512;

  // What was posted since the last time the device asked.
  struct PendingEvents {
    std::optional<Scene> scene;
    std::vector<SoundEvents> events;  // the first `count`; the others only keep their memory
    std::size_t count = 0;
    std::vector<SoundPtr> done;  // on its way back, to be freed
    bool is_read = false;        // nothing in it is news
    void clear();
    void fold_all();
  };
  void take_mail();

  std::mutex mutex_;  // of `incoming_` alone, held for moments; the device's thread only tries
  PendingEvents incoming_;
  PendingEvents taken_;  // the device's thread's, as all below
  Mixer mixer_;
  std::vector<float> music_samples_;
  MusicStream music_;
};

}  // namespace temblor::audio
