// A recording (.dem) in the making, at either end of a connection: what one player is told.
#pragma once

#include "base/bytes.h"
#include "formats/game/dem.h"
#include "math/vec.h"

namespace temblor::net {

class DemoRecording {
 public:
  // It is held in memory until it is finished; what comes when it is full is left out.
  static constexpr std::size_t kMaxBytes = std::size_t{256} << 20;

  // Server messages that came together, and where the player looked then.
  void add(const math::Vec3& view_angles_deg, base::Bytes messages);
  bool is_full() const { return bytes_ >= kMaxBytes; }
  bool is_empty() const { return bytes_ == 0; }
  // The recording's bytes, with its end.
  base::ByteVector finish() &&;

 private:
  std::size_t bytes_ = 0;
  formats::DemWriter writer_;
};

}  // namespace temblor::net
