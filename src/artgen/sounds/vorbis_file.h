// Encodes samples as an Ogg Vorbis file with libvorbisenc. The stream's serial number is fixed, so the same
// input makes the same bytes.
#pragma once

#include <span>

#include "artgen/sounds/signal.h"
#include "base/bytes.h"
#include "base/result.h"

namespace temblor::artgen {

// The parameters of the encoder.
struct VorbisSettings {
  long frames_per_second = 32000;
  // The encoder's quality, from -0.1 to 1. 0.2 is about 96 kbit/s at 44,100 Hz.
  float quality = 0.2F;
  // The serial number of the logical stream in the Ogg container.
  int serial = 1;
};

// Encodes one channel, or a left and a right one of the same length. Fails if the encoder does not support
// the settings.
base::Result<base::ByteVector> write_vorbis(std::span<const Signal> channels, const VorbisSettings& settings);

}  // namespace temblor::artgen
