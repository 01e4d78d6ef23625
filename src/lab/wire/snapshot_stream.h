// The engine's encoder of deltas, with numbers that the caller sees.
#pragma once

#include <cstdint>

#include "lab/wire.h"
#include "net/delta/sent_snapshots.h"

namespace temblor::lab::wire {

class SnapshotStream {
 public:
  // Encodes a tick against the last acknowledged state, or whole if there is none. The bytes are valid until
  // the next call. Call mark_sent() if they are sent.
  base::Bytes encode(const WorldTick& tick);
  void mark_sent();
  // The next delta refers to the state that was sent last: it cannot get lost.
  void rely_on_last() { acknowledge(static_cast<std::uint16_t>(next_ - 1)); }
  void acknowledge(std::uint16_t number) {
    sent_.acknowledge(number);
    has_reference_ = true;
  }
  bool has_reference() const { return has_reference_; }

 private:
  net::SentSnapshots sent_;
  base::ByteWriter bytes_;
  std::uint32_t next_ = 0;
  bool has_reference_ = false;
};

}  // namespace temblor::lab::wire
