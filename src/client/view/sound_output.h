// The sound device: keeps one open while there is one, feeds it from the mixer, and plays music. A device may
// vanish at any time (unplugged headphones); the game then continues in silence and opens the next one.
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

// Opens the default device, which calls `fill` from its own thread.
using OpenAudioDevice =
    std::function<base::Result<std::unique_ptr<platform::AudioDevice>>(platform::AudioFill fill)>;

// Owns mixer and device.
class SoundOutput {
 public:
  // `open` is called again whenever a device was lost or could not be opened.
  explicit SoundOutput(OpenAudioDevice open);

  // Updates what is audible; call once a frame. Without a device, time passes in silence, so that a device
  // that appears later joins in at the right place. `time_s`: a clock that never stops.
  void advance(double time_s, const audio::Scene& scene, const audio::SoundEvents& events);

  // Plays a track by its server number; 0 for none. Does nothing if that track is playing. The file is read
  // by another thread; problems are noted in a later advance().
  void play_music(const assets::Library& library, int track);
  // Whether the player fights, so that the track's combat layer is heard.
  void set_combat(bool combat) { mixer_.set_combat(combat); }
  void pause_music(bool paused) { mixer_.pause_music(paused); }

  bool has_device() const { return device_ != nullptr; }
  // The device's description, or "no sound device".
  std::string describe() const;
  // Changes and problems since the last call, a line each.
  std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

 private:
  void maintain_device(double time_s);
  void advance_unheard(double time_s);

  OpenAudioDevice open_;
  audio::LiveMixer mixer_;
  // Uses the mixer, so it is declared after it.
  std::unique_ptr<platform::AudioDevice> device_;
  // When to try again to open a device; nothing: at the next advance().
  std::optional<double> next_try_s_;
  double time_s_ = 0;
  // Failed tries in a row.
  int tries_ = 0;
  // There is no device, and the player knows it.
  bool is_missing_ = false;
  int track_ = 0;
  bool has_noted_music_ = false;
  // Scratch space of advance_unheard().
  std::vector<float> discarded_;
  std::vector<std::string> notes_;
};

}  // namespace temblor::client
