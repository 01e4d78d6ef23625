// One state of the game told as what differs from another that the reader has too.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "net/delta/snapshot_model.h"
#include "net/delta/snapshot_state.h"

namespace temblor::net {

struct ReferenceSnapshot {
  SnapshotState state;
  SnapshotModel model;  // as after this state
};

// Appends bytes that, with the same `before` and `back`, make read_delta() give io_now; learns.
// `before`: null for none; `back`: how many updates ago it was, from 1. CHECKs that there are no more than
// kMaxEntities and kMaxPlainBytes.
void write_delta(const ReferenceSnapshot* before, int back, ReferenceSnapshot& io_now,
                 base::ByteWriter& io_writer);

// Any bytes: kMalformed, and out_now of no use, for those that hold what no state can.
base::Status read_delta(base::Bytes bytes, const ReferenceSnapshot* before, int back,
                        ReferenceSnapshot& out_now);

}  // namespace temblor::net
