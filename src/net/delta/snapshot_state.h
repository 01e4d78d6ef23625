// A datagram of the game's state, taken apart into numbers ("words") that can be compared with those of
// another one, and put together again to the same bytes. Every field of a message has its place among the
// words whether the message holds it or not (0 where it does not): so a field that comes or goes moves no
// other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "net/protocol/numbered_moves.h"
#include "net/protocol/protocol.h"

namespace temblor::net {

// The messages of a datagram, in this order. Any but the events may be empty; entity updates are apart.
struct UpdateParts {
  base::Bytes time{};
  base::Bytes once{};  // told in no other datagram, as damage: any bytes
  base::Bytes client_data{};
  base::Bytes acknowledgement{};  // the stuffed text with a line of MoveAcknowledgement
  base::Bytes events{};           // behind the entities; any bytes
};

struct SnapshotState {
  static constexpr std::size_t kEntityWords = 15, kClientDataWords = 21;
  // Words that go on as they went, from kFirstMoving: places and angles; of acknowledgements the number of
  // the move, and the like.
  static constexpr std::size_t kFirstMoving = 6, kMoving = 6, kMovingAcknowledgement = 12;
  static constexpr std::size_t kMaxEntities = 1024;    // no datagram has room for more
  static constexpr std::size_t kMaxPlainBytes = 2047;  // of `once`, and of `events`

  struct Entity {
    std::uint16_t number = 0;
    std::uint16_t changed = 0;                        // as below
    std::array<std::uint32_t, kEntityWords> words{};  // flags, then fields (wire/snapshot_fields.h)
    std::array<std::int32_t, kMoving> rates{};        // as below
  };

  // Moves by steps, from which nothing follows.
  static bool is_stepping(const Entity& entity);

  bool has_time = false, has_client_data = false;
  std::uint32_t time = 0;
  std::array<std::uint32_t, kClientDataWords> client_data{};
  std::size_t acknowledgement_words = 0;  // 0: there is none
  std::array<std::uint32_t, kMaxAcknowledgementWords> acknowledgement{};
  base::ByteWriter once, events;
  std::vector<Entity> entities;  // in order of number, each once
  // Set where differences are written and read. Which words, a bit each, were not as the state that this one
  // was told against had led to expect: they go on to be not.
  std::uint32_t client_data_changed = 0, acknowledgement_changed = 0;
  // How far words have come since that state, in 16ths an update.
  std::int32_t time_rate = 0;
  std::array<std::int32_t, kMovingAcknowledgement> acknowledgement_rates{};

  // Keeps memory.
  void clear();
};

// False where there is something that would not become the same bytes again: words are of no use then.
bool take_apart(const UpdateParts& parts, const Dialect& dialect, SnapshotState& out_state);
bool take_apart(base::Bytes entity_update, const Dialect& dialect, SnapshotState::Entity& out_entity);

// The datagram's bytes, appended; of any words.
class UpdateWriter {
 public:
  void write(const SnapshotState& state, const Dialect& dialect, base::ByteWriter& io_writer);

 private:
  std::string line_;
};

}  // namespace temblor::net
