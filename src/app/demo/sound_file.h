// Writes mixed sound to a WAV file in pieces, as 16-bit stereo.
#pragma once

#include <cstddef>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"

namespace temblor::app {

// A WAV file being written. It is valid only after finish(). Errors name the file.
class SoundFile {
 public:
  static base::Result<SoundFile> open(std::string path, int frames_per_second);

  // Appends interleaved samples, left and right, from -1 to 1. kTooLarge beyond the format's 4 GiB.
  base::Status add(std::span<const float> samples);
  // Completes the header and closes the file.
  base::Status finish();

 private:
  SoundFile(std::string path, int frames_per_second)
      : path_(std::move(path)), frames_per_second_(frames_per_second) {}
  base::Status write_header();
  base::Error cannot_write() const;

  std::string path_;
  int frames_per_second_;
  std::ofstream stream_;
  std::size_t sample_bytes_ = 0;
  // The converted samples of the last add().
  std::vector<std::int16_t> piece_;
};

// An empty file with a unique name in the system's temporary folder; removed by the destructor.
class TemporaryFile {
 public:
  // `suffix` is the end of the name, such as ".wav".
  static base::Result<TemporaryFile> make(const std::string& suffix);
  ~TemporaryFile();
  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile& operator=(TemporaryFile&& other) noexcept;

  const std::string& path() const { return path_; }

 private:
  explicit TemporaryFile(std::string path) : path_(std::move(path)) {}
  std::string path_;
};

}  // namespace temblor::app
