// Mixed sound into a WAV file, piece by piece: two channels of 16 bits.
#pragma once

#include <cstddef>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"

namespace temblor::app {

// Only what finish() was called for is sure to be whole. Errors name the file.
class SoundFile {
 public:
  static base::Result<SoundFile> open(std::string path, int frames_per_second);

  // Left and right in turn, -1 to 1. kTooLarge when the format's 4 GiB are full.
  base::Status add(std::span<const float> samples);
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
  std::vector<std::int16_t> piece_;
};

// A name in the system's folder for such, for a file of this program alone; gone when the object is.
class TemporaryFile {
 public:
  // `suffix` as ".wav".
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
