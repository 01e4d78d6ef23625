#include "app/demo/sound_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/files/atomic_write.h"
#include "formats/sounds/wav.h"

namespace temblor::app {
namespace {

// Sizes in a WAV file have 32 bits; leave some room for the header.
constexpr std::size_t kMaxSampleBytes = 0xffff0000u;

// Rounds to the nearest value. Louder samples are clipped.
std::int16_t to_int16(float sample) {
  return static_cast<std::int16_t>(std::lrint(std::clamp(sample, -1.0f, 1.0f) * 32767.0f));
}

}  // namespace

base::Error SoundFile::cannot_write() const {
  return make_write_error(path_, std::generic_category().message(errno), Remedy::kOtherOutput);
}

base::Status SoundFile::write_header() {
  const base::ByteVector header = formats::make_wav_header(static_cast<std::uint32_t>(frames_per_second_), 2,
                                                           static_cast<std::uint32_t>(sample_bytes_));
  stream_.write(reinterpret_cast<const char*>(header.data()), static_cast<std::streamsize>(header.size()));
  if (!stream_) return cannot_write();
  return base::Ok{};
}

// Writes a header for 0 samples, whose place finish() fills.
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
  std::transform(samples.begin(), samples.end(), piece_.begin(), to_int16);
  const std::size_t bytes = piece_.size() * sizeof(std::int16_t);
  if (sample_bytes_ + bytes > kMaxSampleBytes) {
    base::Error error = base::error(base::ErrorCode::kTooLarge,
                                    "a WAV file holds at most 6 hours of sound; choose a part with --frames");
    error.file = path_;
    return error;
  }
  sample_bytes_ += bytes;
  stream_.write(reinterpret_cast<const char*>(piece_.data()), static_cast<std::streamsize>(bytes));
  if (!stream_) return cannot_write();
  return base::Ok{};
}

// Rewrites the header, because the number of samples is known only now.
base::Status SoundFile::finish() {
  stream_.seekp(0);
  TRY_STATUS(write_header());
  stream_.close();
  if (!stream_) return cannot_write();
  return base::Ok{};
}

// mkstemps() replaces the six X by a unique name and creates the file, so no other program can take the name.
base::Result<TemporaryFile> TemporaryFile::make(const std::string& suffix) {
  std::error_code failure;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(failure);
  if (failure)
    return base::error(base::ErrorCode::kIo, "no folder for temporary files ({}); set TMPDIR",
                       failure.message());
  std::string path = (folder / "temblor-XXXXXX").string() + suffix;
  const int file = mkstemps(path.data(), static_cast<int>(suffix.size()));
  if (file < 0) {
    base::Error error =
        base::error(base::ErrorCode::kIo, "cannot write ({}); set TMPDIR to a writable folder",
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
