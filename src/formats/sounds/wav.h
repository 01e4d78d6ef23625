// Sounds (.wav): PCM of 8 or 16 bits, with an optional loop. Quake marks the loop of ambient sounds with the
// cue points of sound editors:
//
//   "RIFF" | size u32 | "WAVE" | chunk | chunk | ...
//   chunk:   id char[4] | size u32 | data | a zero byte if the size is odd
//
//   "fmt "   0  format u16 (1: PCM)       "data"  frames: one sample for each channel;
//            2  channels u16                      8 bits unsigned or 16 bits signed
//            4  frames per second u32     "cue "  0 count u32, then points of 24 bytes:
//            8  bytes per second u32              0 number u32 | 4 other fields | 20 frame u32 (loop start)
//           12  bytes per frame u16       "LIST"  0 "adtl", then chunks; "ltxt":
//           14  bits per sample u16               0 cue number u32 | 4 frames u32 (loop length) | 8 "mark"
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

constexpr std::uint32_t kMinWavRate = 1000, kMaxWavRate = 192000;  // frames per second
constexpr std::uint16_t kMaxWavChannels = 8;

// The part that repeats, in frames: [start, end). The part before it plays once.
struct WavLoop {
  std::uint32_t start = 0, end = 0;  // start < end <= Wav::frame_count()
  bool operator==(const WavLoop&) const = default;
};

struct Wav {
  std::uint32_t frames_per_second = 11025;  // kMinWavRate to kMaxWavRate
  std::uint16_t channels = 1;               // 1 to kMaxWavChannels
  std::uint16_t bits = 8;                   // 8 or 16
  // Interleaved frames; -128 to 127 if `bits` is 8. A whole number of frames, at most 2^31 - 1 bytes in the
  // file.
  std::vector<std::int16_t> samples;
  std::optional<WavLoop> loop;

  std::size_t frame_count() const { return samples.size() / channels; }
  bool operator==(const Wav&) const = default;
};

// Reads a sound. The loop starts at the first point of the "cue " chunk, and ends where the `mark` for that
// point in a LIST chunk says, or else at the end of the sound. Ignores loops outside of the sound, other
// chunks, and missing bytes at the end.
base::Result<Wav> read_wav(base::Bytes bytes);
// Writes a sound with the rules above. CHECKs its values.
base::ByteVector write_wav(const Wav& wav);

// Makes the header of a 16-bit file without a loop, for callers that stream the samples after it.
base::ByteVector make_wav_header(std::uint32_t frames_per_second, std::uint16_t channels,
                                 std::uint32_t sample_bytes);

}  // namespace temblor::formats
