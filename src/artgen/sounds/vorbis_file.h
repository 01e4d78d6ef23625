// Samples to an Ogg Vorbis file: the same bytes every time.
#pragma once

#include <array>

#include "artgen/sounds/signal.h"
#include "base/bytes.h"
#include "base/result.h"

namespace temblor::artgen {

struct VorbisSettings {
  long frames_per_second = 32000;
  float quality = 0.2F;  // -0.1 to 1, as the encoder counts: 0.2 is about 96 kbit a second at 44,100
  int serial = 1;        // of the stream in its container
};

// Left and right, as long as one another. An error is one of settings that the encoder does not take.
base::Result<base::ByteVector> write_vorbis(const std::array<Signal, 2>& channels,
                                            const VorbisSettings& settings);

}  // namespace temblor::artgen
