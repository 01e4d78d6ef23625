// The adaptive probabilities of delta.cpp, one BitModel for each kind of decision. A model belongs to a
// snapshot: it is the reference's model, updated while coding the snapshot. So both ends that have a snapshot
// have the same model, whatever packets were lost.
#pragma once

#include <array>

#include "net/delta/bit_coder.h"
#include "net/delta/snapshot_state.h"

namespace temblor::net {

// A nonzero 32-bit difference: the sign, then the bit length (1 to 32) as a binary tree of five decisions,
// indexed by the path from the root (1). The bits below the highest one are raw.
struct NumberModel {
  BitModel negative;
  std::array<BitModel, 32> length;
};

// One word: whether it differs from the prediction, given whether it did the last time; and the difference.
struct WordModel {
  std::array<BitModel, 2> changes;
  NumberModel difference;
};

struct SnapshotModel {
  BitModel has_time, has_client_data, has_acknowledgment, has_once, has_events;
  WordModel time;
  std::array<WordModel, SnapshotState::kClientDataWords> client_data;
  BitModel acknowledgment_resizes;
  std::array<WordModel, kMaxAcknowledgmentWords> acknowledgment;
  // Entities of the reference; index: whether the entity changed the last time.
  std::array<BitModel, 2> is_gone, changes;
  std::array<WordModel, SnapshotState::kEntityWords> entity;
  // New entities, coded without a reference.
  BitModel has_new;
  NumberModel new_number;
  std::array<WordModel, SnapshotState::kEntityWords> new_entity;
};

}  // namespace temblor::net
