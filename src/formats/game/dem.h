// Demos (.dem): the messages that a server sent to one client, packet by packet, with the view angles of the
// player. A demo has no clock of its own: the messages contain the server's time, and playback reads the next
// record when the client's time has passed that of the last one. There is no index, so the reader can only go
// forward.
//
//   file:    "2\n"                 forced CD track as text; -1: none
//            record, record, ...
//   record:   0  size i32           bytes of the messages
//             4  pitch f32          view angles in degrees, which the server does not send
//             8  yaw f32
//            12  roll f32
//            16  messages           as in one packet of the server (src/net)
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

// Bytes of messages in a record. Protocol 15 allows 8000; QuakeSpasm plays 64000, and DarkPlaces 65536.
constexpr std::size_t kMaxDemMessage = 65536, kMaxStockDemMessage = 64000;

// A record. `message` may contain several messages, or none.
struct DemMessage {
  math::Vec3 view_angles_deg{0.0f};
  base::Bytes message;     // borrowed from the file
  std::size_t offset = 0;  // of `message` in the file
};

// Reads a demo record by record. `bytes` must outlive the reader and its messages.
class DemReader {
 public:
  // Returns kMalformed if the first line is not text. If the text is not a number, the track is -1.
  static base::Result<DemReader> open(base::Bytes bytes);

  // The CD track to play instead of the server's; -1: none.
  int forced_track() const { return forced_track_; }
  // Returns the next record, or nullopt at the end. If the last record is incomplete, ends before it and sets
  // is_truncated(). A view angle that is not finite becomes 0. Returns kMalformed with the offset for a size
  // out of range.
  base::Result<std::optional<DemMessage>> next();
  bool is_truncated() const { return is_truncated_; }
  // Bytes read, and total bytes; for progress displays.
  std::size_t offset() const { return reader_.offset(); }
  std::size_t size() const { return size_; }

 private:
  DemReader(base::Bytes bytes) : reader_(bytes), size_(bytes.size()) {}
  base::ByteReader reader_;
  std::size_t size_;
  int forced_track_ = -1;
  bool is_truncated_ = false;
};

// Writes a demo in memory.
class DemWriter {
 public:
  explicit DemWriter(int forced_track = -1);
  // CHECKs that the message has at most kMaxDemMessage bytes.
  void add(const math::Vec3& view_angles_deg, base::Bytes message);
  base::ByteVector take() && { return std::move(writer_).take(); }

 private:
  base::ByteWriter writer_;
};

}  // namespace temblor::formats
