// Sound output through SDL2, which uses PulseAudio, PipeWire or ALSA. The environment variable
// SDL_AUDIODRIVER chooses another driver, such as "dummy" or "disk".
#pragma once

#include <memory>

#include "base/result.h"
#include "platform/audio_device.h"

namespace temblor::platform::sdl2 {

struct AudioOptions {
  // The rate of the frames that `fill` makes. SDL converts them to the device's format.
  int frames_per_second = 48000;
  // The number of frames in one call of `fill`, a power of two. Fewer frames lower the latency; more frames
  // are safer on a busy machine.
  int frames_at_a_time = 512;
};

// Opens the system's default device, which starts to play at once. Fails with kIo and SDL's reason.
base::Result<std::unique_ptr<AudioDevice>> open_audio(const AudioOptions& options, AudioFill fill);

}  // namespace temblor::platform::sdl2
