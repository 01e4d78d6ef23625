// Saved places of a demo, so that seeking to any time replays only a few seconds.
//
//   packets  |----+----+----+----+----|      + an entry: a copy of the client state, every spacing_s_ seconds
//
// If there are too many entries, every second one is dropped and the spacing doubles.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/result.h"
#include "client/demo/demo_player.h"
#include "client/effects/effects.h"
#include "net/protocol/server_message.h"

namespace temblor::client {

class DemoIndex {
 public:
  // A saved place. Its packet is already applied to the client state, but the packet's events have not been
  // handled yet: they are still in the state.
  struct Entry {
    DemoPlayer::Place place;
    double time_s = 0;  // of its packet, on the demo's clock
    bool begins_level = false;
    EffectCounts effects;                              // from all packets before it
    std::vector<net::SpawnStaticSound> static_sounds;  // of its level, from the packets before it
  };
  // Bounds on the number and size of entries, whatever the demo contains; the first and the last entry may
  // exceed the size. Real demos take a few kilobytes per entry; a hostile one can take 10 MB.
  static constexpr std::size_t kMaxEntries = 64, kMaxBytes = std::size_t{64} << 20;

  // Plays the whole demo quickly. `io_player` must be newly opened and is at its end afterward. Fails if
  // there is not a single packet to show.
  static base::Result<DemoIndex> make(DemoPlayer& io_player);

  const DemoLength& length() const { return length_; }
  // On the demo's clock, never decreasing.
  const std::vector<double>& packet_times_s() const { return packet_times_s_; }
  // The entry to seek from: the last one that is at least `lead_s` before `time_s`. If a level starts between
  // that entry and `time_s`, the entry of the level's start. If neither exists, the first entry.
  const Entry& find_entry_before(double time_s, double lead_s) const;
  // The size of all entries.
  std::size_t memory_bytes() const { return bytes_; }
  // The start of the level that is shown at that time.
  const Entry& find_level_start(double time_s) const;
  // Whether the game has asked for marks in that level before that time.
  bool has_marks_before(double time_s) const;

 private:
  void add(const DemoPlayer& player, const EffectCounts& effects,
           const std::vector<net::SpawnStaticSound>& static_sounds);
  void drop_every_second();
  static std::size_t count_bytes(const Entry& entry);

  DemoLength length_;
  std::vector<Entry> entries_;  // sorted by time; the first is the first packet
  std::vector<double> packet_times_s_;
  std::vector<double> mark_times_s_;  // of the packets that ask for marks, never decreasing
  std::size_t bytes_ = 0;             // of all entries
  double spacing_s_ = 4;
};

// Appends the static sounds that a packet adds to its level, or starts over at a new level.
void append_static_sounds(const Events& events, std::vector<net::SpawnStaticSound>& io_sounds);

}  // namespace temblor::client
