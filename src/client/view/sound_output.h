// From the audio scene to the sound device: keeps a device open while there is one, and music playing.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assets/library.h"
#include "audio/live_mixer.h"
#include "base/result.h"
#include "platform/audio_device.h"

namespace temblor::client {

using OpenAudioDevice =
    std::function<base::Result<std::unique_ptr<platform::AudioDevice>>(platform::AudioFill fill)>;

class SoundOutput {
 public:
  // `open` may be called again whenever a device was lost or could not be had.
  explicit SoundOutput(OpenAudioDevice open);

  // Once a frame: what is to be heard from now on. Without a device time passes all the same, so that one
  // that comes later plays what goes on by then. `time_s`: a clock that never stands still.
  void advance(double time_s, const audio::Scene& scene, const audio::SoundEvents& events);

  // The number of the track, as servers tell it; 0: none. Another call for what is playing changes nothing.
  // The file is read elsewhere: what is wrong with it is noted by a later advance().
  void play_music(const assets::Library& library, int track);
  void pause_music(bool paused) { mixer_.pause_music(paused); }

  bool has_device() const { return device_ != nullptr; }
  // Of the device; "no sound device" without.
  std::string describe() const;
  // What changed, a line each, since the last time it was asked for.
  std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

 private:
  void look_after_device(double time_s);
  void pass_without_device(double time_s);

  OpenAudioDevice open_;
  audio::LiveMixer mixer_;
  std::unique_ptr<platform::AudioDevice> device_;  // uses the mixer
  std::optional<double> next_try_s_;               // nothing: at once
  double time_s_ = 0;
  int tries_ = 0;            // without a device, one after another
  bool is_missing_ = false;  // and that was said
  int track_ = 0;
  bool has_noted_music_ = false;
  std::vector<float> unheard_;
  std::vector<std::string> notes_;
};

}  // namespace temblor::client
