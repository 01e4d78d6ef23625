// The state of the visibility stage as bytes: for continuing after a stop, and for merging the work of
// several processes.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "compiler/vis/visibility.h"

namespace temblor::compiler {

// Returns the same bytes for equal states. Little-endian:
//   u32 "TVIS", u32 version, u64 fingerprint, u32 portals P, u32 clusters C
//   twice, first for the bounds of crowded portals, then for results:
//     (P + 7) / 8 bytes: bit i % 8 of byte i / 8 says that portal i has one
//     for each portal that has one (C + 63) / 64 times u64: the clusters seen through it
//   u32 R: 0, or P if rows of the sweeps follow; R rows of (C + 63) / 64 times u64
//   u64 hash of all bytes before
base::ByteVector write_visibility_state(const VisibilityState& state);

// Reads a state. `begun` is that of begin_visibility() for the current level. Fails with kUsage if the bytes
// belong to another level (or another version of this one, or another method), with kUnsupported for another
// version of the format, and with kMalformed if they are damaged. The contents are trusted: a forged state
// gives wrong visibility, but does no other harm.
base::Result<VisibilityState> read_visibility_state(base::Bytes bytes, const VisibilityState& begun);

// Adds what `other` has finished. Fails with kUsage if it belongs to another level, and with kMalformed if
// both have different results for one portal; io_state is then unchanged.
base::Status merge_visibility_state(const VisibilityState& other, VisibilityState& io_state);

}  // namespace temblor::compiler
