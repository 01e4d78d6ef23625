#include "app/files/sound_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "formats/sounds/wav.h"

namespace temblor::app {
namespace {

constexpr std::size_t kMaxSampleBytes = 0xffff0000u;

std::int16_t to_16_bits(float sample) {
  return static_cast<std::int16_t>(std::lrint(std::clamp(sample, -1.0f, 1.0f) * 32767.0f));
}

}  // namespace

base::Error SoundFile::cannot_write() const {
  base::Error error =
      base::error(base::ErrorCode::kIo, "cannot be written ({}): choose another place with -o",
                  std::generic_category().message(errno));
  error.file = path_;
  return error;
}

base::Status SoundFile::write_header() {
  const base::ByteVector header = formats::wav_header(static_cast<std::uint32_t>(frames_per_second_), 2,
                                                      static_cast<std::uint32_t>(sample_bytes_));
  stream_.write(reinterpret_cast<const char*>(header.data()), static_cast<std::streamsize>(header.size()));
  if (!stream_) return cannot_write();
  return base::Ok{};
}

base::Result<SoundFile> SoundFile::open(std::string path, int frames_per_second) {
  SoundFile file(std::move(path), frames_per_second);
  errno = 0;
  file.stream_.open(file.path_, std::ios::binary);
  if (!file.stream_) return file.cannot_write();
  TRY_STATUS(file.write_header());
  return file;
}

base::Status SoundFile::add(std::span<const float> samples) {
  piece_.resize(samples.size());
  std::transform(samples.begin(), samples.end(), piece_.begin(), to_16_bits);
  const std::size_t bytes = piece_.size() * sizeof(std::int16_t);
  if (sample_bytes_ + bytes > kMaxSampleBytes) {
    base::Error error = base::error(base::ErrorCode::kTooLarge,
                                    "WAV files hold 6 hours of sound; choose a part with --frames");
    error.file = path_;
    return error;
  }
  sample_bytes_ += bytes;
  stream_.write(reinterpret_cast<const char*>(piece_.data()), static_cast<std::streamsize>(bytes));
  if (!stream_) return cannot_write();
  return base::Ok{};
}

// Only now is it known how much there is.
base::Status SoundFile::finish() {
  stream_.seekp(0);
  TRY_STATUS(write_header());
  stream_.close();
  if (!stream_) return cannot_write();
  return base::Ok{};
}

base::Result<TemporaryFile> TemporaryFile::make(const std::string& suffix) {
  std::error_code failure;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(failure);
  if (failure)
    return base::error(base::ErrorCode::kIo, "no folder for temporary files ({}): set TMPDIR",
                       failure.message());
  std::string path = (folder / "temblor-XXXXXX").string() + suffix;
  const int file = mkstemps(path.data(), static_cast<int>(suffix.size()));
  if (file < 0) {
    base::Error error = base::error(base::ErrorCode::kIo, "cannot be written ({}): set TMPDIR",
                                    std::generic_category().message(errno));
    error.file = path;
    return error;
  }
  close(file);
  return TemporaryFile(std::move(path));
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove(path_, ignored);
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept : path_(std::exchange(other.path_, {})) {}

TemporaryFile& TemporaryFile::operator=(TemporaryFile&& other) noexcept {
  std::swap(path_, other.path_);
  return *this;
}

}  // namespace temblor::app
