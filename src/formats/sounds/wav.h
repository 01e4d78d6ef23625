// Sounds (.wav): PCM of 8 or 16 bits, and where they loop.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

constexpr std::uint32_t kMinWavRate = 1000, kMaxWavRate = 192000;  // frames a second
constexpr std::uint16_t kMaxWavChannels = 8;

// A part that is played over and over, in frames: from `start` up to but not including `end`.
struct WavLoop {
  std::uint32_t start = 0, end = 0;  // start < end <= Wav::frame_count()
  bool operator==(const WavLoop&) const = default;
};

struct Wav {
  std::uint32_t frames_per_second = 11025;  // kMinWavRate to kMaxWavRate
  std::uint16_t channels = 1;               // 1 to kMaxWavChannels
  std::uint16_t bits = 8;                   // 8 or 16
  // Frame by frame, channel by channel; -128 to 127 where bits is 8. A whole number of frames, at most
  // 2^31 - 1 bytes in the file.
  std::vector<std::int16_t> samples;
  std::optional<WavLoop> loop;

  std::size_t frame_count() const { return samples.size() / channels; }
  bool operator==(const Wav&) const = default;
};

// The loop begins at the first point of the `cue ` chunk. It ends where a `mark` of a LIST chunk, as editors
// write it for that point, says, else with the sound. One that lies outside the sound is left out. Other
// chunks, and what follows the last whole one, are passed over.
base::Result<Wav> read_wav(base::Bytes bytes);
base::ByteVector write_wav(const Wav& wav);

// The first bytes of a file without a loop that this many bytes of samples follow (16 bits), for who does not
// hold them all at once.
base::ByteVector wav_header(std::uint32_t frames_per_second, std::uint16_t channels,
                            std::uint32_t sample_bytes);

}  // namespace temblor::formats
