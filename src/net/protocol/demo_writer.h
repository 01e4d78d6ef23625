// Records the server messages of one player as a demo (.dem), at either end of a connection. Holds the demo
// in memory; formats/game/dem.h describes the file.
#pragma once

#include "base/bytes.h"
#include "formats/game/dem.h"
#include "math/vec.h"

namespace temblor::net {

class DemoWriter {
 public:
  // A demo stops growing at this size; later messages are dropped.
  static constexpr std::size_t kMaxBytes = std::size_t{256} << 20;

  // Adds the messages of one packet, and the view angles of the player at that time. Ignores empty packets,
  // and packets longer than formats::kMaxStockDemMessage.
  void add(const math::Vec3& view_angles_deg, base::Bytes messages);
  bool is_full() const { return bytes_ >= kMaxBytes; }
  bool is_empty() const { return bytes_ == 0; }
  // Appends svc_disconnect, as the end of a demo, and returns the bytes of the file.
  base::ByteVector finish() &&;

 private:
  std::size_t bytes_ = 0;
  formats::DemWriter writer_;
};

}  // namespace temblor::net
