// Music in a file of any kind that libsndfile knows (Ogg Vorbis, Opus, FLAC, MP3, WAV), decoded bit by bit
// from memory, over and over.
#pragma once

#include <memory>
#include <span>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::audio {

class MusicDecoder {
 public:
  // Fails on what is not music, or of an absurd rate or number of channels.
  static base::Result<MusicDecoder> open(base::ByteVector bytes);
  ~MusicDecoder();
  MusicDecoder(MusicDecoder&&) noexcept;
  MusicDecoder& operator=(MusicDecoder&&) noexcept;

  // The next frames, left and right in turn, at kFramesPerSecond. After the end it begins again; where
  // nothing more can be decoded, silence.
  void read(std::span<float> out_samples);
  // A damaged file: only silence comes.
  bool has_failed() const;

 private:
  struct State;
  explicit MusicDecoder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace temblor::audio
