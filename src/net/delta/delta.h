// Delta compression of snapshots: encodes a SnapshotState as its differences from a reference snapshot that
// the receiver has too. Words that move (origins, angles, time) are predicted from the reference by linear
// extrapolation; each word then costs a fraction of a bit if the prediction holds, and otherwise the sign,
// length, and bits of the difference. All of this goes through the arithmetic coder (bit_coder.h) with
// adaptive models.
//
// The models are part of the reference snapshot (snapshot_model.h). So both ends agree on them whatever
// packets were lost.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "net/delta/snapshot_model.h"
#include "net/delta/snapshot_state.h"

namespace temblor::net {

// A snapshot with everything that is needed to encode another one against it.
struct ReferenceSnapshot {
  SnapshotState state;
  SnapshotModel model;  // after coding this state
};

// Encodes io_now.state against `reference` and appends the bytes; sets io_now.model, and the rates and change
// masks of io_now.state. `reference`: null for none; `back`: its age in snapshots, at least 1. CHECKs the
// limits kMaxEntities and kMaxPlainBytes.
void write_delta(const ReferenceSnapshot* reference, int back, ReferenceSnapshot& io_now,
                 base::ByteWriter& io_writer);

// Decodes bytes of write_delta() with the same `reference` and `back` into out_now. Accepts any bytes;
// returns kMalformed for an impossible state, and leaves out_now unspecified then.
base::Status read_delta(base::Bytes bytes, const ReferenceSnapshot* reference, int back,
                        ReferenceSnapshot& out_now);

}  // namespace temblor::net
