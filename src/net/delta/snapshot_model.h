// What the coder of differences has learnt of how words change (bit_coder.h). It belongs to a state: both
// ends that have the state have come to the same by it, whatever was lost in between.
#pragma once

#include <array>

#include "net/delta/bit_coder.h"
#include "net/delta/snapshot_state.h"

namespace temblor::net {

// Of numbers from -2^31 to 2^31 without 0: the sign, then the number of bits (a tree of five decisions).
struct NumberModel {
  BitModel negative;
  std::array<BitModel, 32> length;
};

// A word among its kind: whether it changes, if it changed the last time or not, and by how much.
struct WordModel {
  std::array<BitModel, 2> changes;
  NumberModel difference;
};

struct SnapshotModel {
  BitModel has_time, has_client_data, has_acknowledgement, has_once, has_events;
  WordModel time;
  std::array<WordModel, SnapshotState::kClientDataWords> client_data;
  BitModel acknowledgement_resizes;
  std::array<WordModel, kMaxAcknowledgementWords> acknowledgement;
  // Entities that the state before has: by whether they changed the last time.
  std::array<BitModel, 2> is_gone, changes;
  std::array<WordModel, SnapshotState::kEntityWords> entity;
  // Others, told against nothing.
  BitModel has_new;
  NumberModel new_number;
  std::array<WordModel, SnapshotState::kEntityWords> new_entity;
};

}  // namespace temblor::net
