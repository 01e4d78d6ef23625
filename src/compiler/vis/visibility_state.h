// The state of visibility as bytes: to go on after a stop, and to join what several processes worked out.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "compiler/vis/visibility.h"

namespace temblor::compiler {

// The same bytes for equal states. Little-endian:
//   u32 "TVIS", u32 version, u64 fingerprint, u32 portals P, u32 clusters C
//   (P + 7) / 8 bytes: bit i % 8 of byte i / 8 says that portal i is finished
//   for each finished portal (C + 63) / 64 times u64: the clusters seen through it
//   u64 hash of all bytes before
base::ByteVector write_visibility_state(const VisibilityState& state);

// `begun` is begin_visibility's of the level at hand. kUsage when the bytes are the state of another level
// (or of another version of this one, or of another way to work it out); kUnsupported when their version is
// not ours; kMalformed when they are damaged. What is read is taken on trust: a state made up with the right
// hash gives a wrong result, though nothing worse.
base::Result<VisibilityState> read_visibility_state(base::Bytes bytes, const VisibilityState& begun);

// Adds what `other` has finished. kUsage when it is the state of another level; kMalformed when the two have
// different results for one portal; io_state is then as it was.
base::Status merge_visibility_state(const VisibilityState& other, VisibilityState& io_state);

}  // namespace temblor::compiler
