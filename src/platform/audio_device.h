// The interface to a sound device, which pulls mixed sound from a callback. Implementation:
// platform/sdl2/audio.h.
#pragma once

#include <functional>
#include <span>
#include <string>

namespace temblor::platform {

// Fills `samples` with interleaved stereo frames (left, right, left, ...), each sample from -1 to 1. The
// device calls it on its own thread at regular intervals, so it must not wait for locks or files. It is not
// called after the device was destroyed.
using AudioFill = std::function<void(std::span<float> samples)>;

class AudioDevice {
 public:
  virtual ~AudioDevice() = default;
  // The rate at which the device asks for frames, in Hz.
  virtual int frames_per_second() const = 0;
  // The approximate delay from mixing a frame to hearing it.
  virtual int latency_frames() const = 0;
  // Whether the device is gone, for example unplugged. Destroy it then, and open another one.
  virtual bool is_lost() const = 0;
  // The driver and format, for a person.
  virtual std::string describe() const = 0;
};

}  // namespace temblor::platform
