// Decodes a music file from memory, piece by piece and in an endless loop. Reads every format that libsndfile
// knows (Ogg Vorbis, Opus, FLAC, MP3, WAV) and resamples to the mixer's rate.
#pragma once

#include <memory>
#include <span>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::audio {

class MusicDecoder {
 public:
  // Takes the file's bytes. Fails if they are not music, or have an unsupported rate or number of channels.
  static base::Result<MusicDecoder> open(base::ByteVector bytes);
  ~MusicDecoder();
  MusicDecoder(MusicDecoder&&) noexcept;
  MusicDecoder& operator=(MusicDecoder&&) noexcept;

  // Decodes the next frames, left and right interleaved, at kFramesPerSecond. Starts again after the end;
  // returns silence if decoding fails.
  void read(std::span<float> out_samples);
  // Whether the file is damaged: from here on, read() returns silence.
  bool has_failed() const;

 private:
  struct State;
  explicit MusicDecoder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace temblor::audio
