// Places of a recording to go on from, so that any moment of it is near one.
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
  // The packet of a place is not acted on yet: what happened in it is among the state's events.
  struct Entry {
    DemoPlayer::Place place;
    double time_s = 0;  // of its packet, on the recording's clock
    bool begins_level = false;
    EffectCounts effects;                              // of all packets before it
    std::vector<net::SpawnStaticSound> static_sounds;  // of its level, from the packets before it
  };
  // However long the recording is, and whatever it shows: so many client states, and so much memory, but for
  // the first and the last of them. A real one has some kilobytes each; one made for it has 10 MB.
  static constexpr std::size_t kMaxEntries = 64, kMaxBytes = std::size_t{64} << 20;

  // Plays all of it, quickly. `io_player` has just been opened, and has played to its end afterwards. Fails
  // where there is not a single packet to show.
  static base::Result<DemoIndex> make(DemoPlayer& io_player);

  const DemoLength& length() const { return length_; }
  // On the recording's clock, never falling.
  const std::vector<double>& packet_times_s() const { return packet_times_s_; }
  // The last place that is `lead_s` or more before `time_s`, or later than that but the beginning of a level
  // before it; or else the first.
  const Entry& entry_before(double time_s, double lead_s) const;
  // Of the places.
  std::size_t memory_bytes() const { return bytes_; }
  // The beginning of the level that is shown at that time.
  const Entry& level_before(double time_s) const;

 private:
  void add(const DemoPlayer& player, const EffectCounts& effects,
           const std::vector<net::SpawnStaticSound>& static_sounds);
  void thin_out();
  static std::size_t bytes_of(const Entry& entry);

  DemoLength length_;
  std::vector<Entry> entries_;  // in order of time; the first is the first packet
  std::vector<double> packet_times_s_;
  std::size_t bytes_ = 0;  // of all entries
  double spacing_s_ = 4;
};

// The static sounds of a level as its packets name them, one after the other.
void collect_static_sounds(const Events& events, std::vector<net::SpawnStaticSound>& io_sounds);

}  // namespace temblor::client
