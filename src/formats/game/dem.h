// Recorded games (.dem): server messages as they came, each with where the player looked.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

constexpr std::size_t kMaxDemMessage = 64000;  // bytes

struct DemMessage {
  math::Vec3 view_angles_deg{0.0f};
  base::Bytes message;     // not owned
  std::size_t offset = 0;  // of the message's first byte in the file
};

// Reads a recording message by message. `bytes` must outlive it.
class DemReader {
 public:
  // Fails when the first line is not a track number.
  static base::Result<DemReader> open(base::Bytes bytes);

  // -1: none was forced.
  int forced_track() const { return forced_track_; }
  // The next message, or nothing at the end. A recording that was cut off (its last message is not all there)
  // ends before it, with cut_short(). A length out of range is an error that names the offset.
  base::Result<std::optional<DemMessage>> next();
  bool cut_short() const { return cut_short_; }
  // For progress: bytes read, of how many.
  std::size_t offset() const { return reader_.offset(); }
  std::size_t size() const { return size_; }

 private:
  DemReader(base::Bytes bytes) : reader_(bytes), size_(bytes.size()) {}
  base::ByteReader reader_;
  std::size_t size_;
  int forced_track_ = -1;
  bool cut_short_ = false;
};

class DemWriter {
 public:
  explicit DemWriter(int forced_track = -1);
  // CHECKs the message's length.
  void add(const math::Vec3& view_angles_deg, base::Bytes message);
  base::ByteVector take() && { return std::move(writer_).take(); }

 private:
  base::ByteWriter writer_;
};

}  // namespace temblor::formats
