#include "lab/wire/snapshot_stream.h"

namespace temblor::lab::wire {

base::Bytes SnapshotStream::encode(const WorldTick& tick) {
  sent_.begin_snapshot() = tick.state;
  bytes_.truncate(0);
  sent_.write(bytes_);
  return bytes_.view();
}

void SnapshotStream::mark_sent() {
  sent_.mark_sent();
  ++next_;
}

}  // namespace temblor::lab::wire
