// Decodes a music file from memory, piece by piece and in an endless loop. Reads every format that libsndfile
// knows (Ogg Vorbis, Opus, FLAC, MP3, WAV) and resamples to the mixer's rate with libsamplerate's windowed
// sinc. The original plays CD tracks instead.
//
//   bytes -> libsndfile -> stereo frames at the file's rate -> libsamplerate -> frames at kFramesPerSecond
//
// Not thread-safe. Decoding allocates memory, so an audio callback reads through mixing/music_stream.h.
#pragma once

#include <memory>
#include <span>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::audio {

class MusicDecoder {
 public:
  // Takes ownership of the file's bytes. Fails if libsndfile does not recognize them, if the file has more
  // than 8 channels, or if its rate is not from 4 to 384 kHz.
  static base::Result<MusicDecoder> open(base::ByteVector bytes);
  ~MusicDecoder();
  MusicDecoder(MusicDecoder&&) noexcept;
  MusicDecoder& operator=(MusicDecoder&&) noexcept;

  // Decodes the next frames, left and right interleaved, at kFramesPerSecond. A mono file plays on both
  // sides; channels after the second are ignored. Continues at the beginning after the end, and returns
  // silence if decoding fails. The number of samples must be even.
  void read(std::span<float> out_samples);
  // Whether the file is damaged or empty; read() then returns only silence.
  bool has_failed() const;

 private:
  struct State;
  explicit MusicDecoder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace temblor::audio
