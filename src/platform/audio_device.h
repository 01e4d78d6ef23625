// Where mixed sound goes.
#pragma once

#include <functional>
#include <span>
#include <string>

namespace temblor::platform {

// Fills frames of two channels, left and right in turn, -1 to 1. Called on a thread of the device's own, at
// even steps; never after the device was destroyed.
using AudioFill = std::function<void(std::span<float> samples)>;

class AudioDevice {
 public:
  virtual ~AudioDevice() = default;
  virtual int frames_per_second() const = 0;
  // Frames between what is mixed now and what is heard, about.
  virtual int latency_frames() const = 0;
  // It has gone (unplugged); open another one.
  virtual bool is_lost() const = 0;
  virtual std::string describe() const = 0;
};

}  // namespace temblor::platform
