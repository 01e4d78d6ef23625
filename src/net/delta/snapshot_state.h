// A snapshot: the unreliable server messages of one tick for one client, parsed into 32-bit words for delta
// compression. SnapshotWriter restores exactly the same bytes. Every possible field of a message has a fixed
// index among the words, and is 0 if the message omits it; so an optional field never shifts the others.
//
//   messages:  | svc_time | once | svc_clientdata | svc_stufftext "//a ..." | entity updates ... | events |
//   words:       time       raw    21 words         1 to 32 words             15 words each        raw
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

// The messages of a snapshot without its entity updates; each part may be empty. Borrowed.
struct SnapshotParts {
  base::Bytes time{};
  base::Bytes once{};  // messages of this tick only, such as svc_damage; any bytes
  base::Bytes client_data{};
  base::Bytes acknowledgment{};  // svc_stufftext with a MoveAcknowledgment line
  base::Bytes events{};          // messages after the entities; any bytes
};

struct SnapshotState {
  static constexpr std::size_t kEntityWords = 15, kClientDataWords = 21;
  // Words that are predicted by extrapolation: kMoving words of an entity from kFirstMoving (origin and
  // angles), and the first kMovingAcknowledgment words of an acknowledgment (move number, origin, velocity,
  // ...).
  static constexpr std::size_t kFirstMoving = 6, kMoving = 6, kMovingAcknowledgment = 12;
  static constexpr std::size_t kMaxEntities = 1024;    // more never fit into a datagram
  static constexpr std::size_t kMaxPlainBytes = 2047;  // of `once`, and of `events`

  struct Entity {
    std::uint16_t number = 0;
    std::uint16_t changed = 0;                        // mask, see below
    std::array<std::uint32_t, kEntityWords> words{};  // flags, then fields (snapshot_fields.h)
    std::array<std::int32_t, kMoving> rates{};        // see below
  };

  // True for entities that move in steps; extrapolation cannot predict those.
  static bool is_stepping(const Entity& entity);

  bool has_time = false, has_client_data = false;
  std::uint32_t time = 0;
  std::array<std::uint32_t, kClientDataWords> client_data{};
  std::size_t acknowledgment_words = 0;  // 0: no acknowledgment
  std::array<std::uint32_t, kMaxAcknowledgmentWords> acknowledgment{};
  base::ByteWriter once, events;
  std::vector<Entity> entities;  // sorted by number, without duplicates
  // Written by write_delta() and read_delta(), as context for later snapshots. Masks of the words that
  // differed from their prediction; those are likely to differ again.
  std::uint32_t client_data_changed = 0, acknowledgment_changed = 0;
  // Speed of words since the reference, in 16ths per snapshot.
  std::int32_t time_rate = 0;
  std::array<std::int32_t, kMovingAcknowledgment> acknowledgment_rates{};

  // Empties the snapshot and keeps its memory.
  void clear();
};

// Parse messages into words. `out_state` must be empty: `once` and `events` are appended. Return false if
// SnapshotWriter could not restore exactly these bytes; the output is unspecified then, and the messages must
// be sent uncompressed.
bool parse_snapshot(const SnapshotParts& parts, const Dialect& dialect, SnapshotState& out_state);
bool parse_entity_update(base::Bytes entity_update, const Dialect& dialect,
                         SnapshotState::Entity& out_entity);

// Restores the messages of a snapshot and appends them. Accepts any words. Keeps scratch memory.
class SnapshotWriter {
 public:
  void write(const SnapshotState& state, const Dialect& dialect, base::ByteWriter& io_writer);

 private:
  std::string line_;
};

}  // namespace temblor::net
