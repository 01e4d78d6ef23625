// Sound through SDL2: whatever the system has (PulseAudio, PipeWire, ALSA; SDL_AUDIODRIVER names another, as
// "dummy" or "disk").
#pragma once

#include <memory>

#include "base/result.h"
#include "platform/audio_device.h"

namespace temblor::platform::sdl2 {

struct AudioOptions {
  // Of what `fill` makes, with two channels; SDL converts to what the device has.
  int frames_per_second = 48000;
  // Asked for at a time; a power of two. Less is heard sooner, more is safer on a busy machine.
  int frames_at_a_time = 512;
};

// The system's default device, playing from the start. kIo with SDL's reason where there is none.
base::Result<std::unique_ptr<AudioDevice>> open_audio(const AudioOptions& options, AudioFill fill);

}  // namespace temblor::platform::sdl2
