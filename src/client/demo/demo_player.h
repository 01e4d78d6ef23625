// Plays a demo: .dem records in, client state out.
//
// .dem: | "2\n" | record | record | ...      record: | length | view angles | server messages |
//
// The messages are those that the server sent to the recording client, so playback is the same path as a
// network game: MessageReader and ClientState (client/session). The view angles are stored because only the
// client knew them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/function_ref.h"
#include "base/result.h"
#include "client/session/client_state.h"
#include "formats/game/dem.h"
#include "math/vec.h"
#include "net/protocol/message_reader.h"

namespace temblor::client {

// The length of the playable part of a demo.
struct DemoLength {
  std::size_t packets = 0;                   // how many packets read_packet() returns
  double first_time_s = 0, last_time_s = 0;  // on the clock of advance_to()
  std::vector<std::string> levels;           // "maps/e1m1.bsp", in order of play
  bool is_truncated = false;                 // see DemoPlayer::is_truncated()
  std::optional<base::Error> damage;         // the error that ends it early, if any
};

// There are two clocks. The server's clock drives the client state; it restarts with every level and may
// jump. The demo's clock starts as the server's in the first level, continues through level changes, which
// take no time, and counts no gap between packets as more than 0.1 s. So a demo never takes longer than its
// number of packets allows, whatever times they claim.
//
//   server's clock   5.0 5.1 5.2 | 1.0 1.1 1.2 ... 90.0      a new level, later a jump
//   demo's clock     5.0 5.1 5.2 | 5.2 5.3 5.4 ...  5.5
//
// Damage is an error that names the offset in the file. It is returned once; everything before it, even in
// the same record, stays valid, and the demo ends there. Playing allocates nothing in the steady state,
// except for texts.
class DemoPlayer {
 public:
  // `name` is for error messages. Fails if the data is not a demo.
  static base::Result<DemoPlayer> open(base::ByteVector bytes, std::string name);
  // Plays the whole demo quickly and returns its length. Fails if there is not a single packet to show.
  static base::Result<DemoLength> scan(base::Bytes bytes, std::string name);
  // Plays from the current place to the end in the same way. Calls `on_packet` for each packet, then drops
  // its events.
  base::Result<DemoLength> play_to_end(base::FunctionRef<void()> on_packet);

  // Reads until `time_s`, on the demo's clock, is not past the last packet; always reads through the start of
  // a level until its first entities arrive. Afterward there is something to show. Returns false if the demo
  // has ended, now or before. A time before the last packets shows them at their start; restore() goes back.
  base::Result<bool> advance_to(double time_s);
  // Reads one record regardless of its time, as benchmarks do; reads through the start of a level as above.
  base::Result<bool> read_packet();

  // Like read_packet(), but shows the start of the packet's interval: the time at which advance_to() in small
  // steps would reach it.
  base::Result<bool> begin_packet();

  // The time to show, on the server's clock: for state(), view angles, light styles and everything else. It
  // is between the times of the last two packets.
  double server_time_s() const { return now_.server_time_s; }
  // The time of the last packet on the demo's clock.
  double packet_time_s() const { return now_.packet_time_s; }

  ClientState& state() { return now_.state; }
  const ClientState& state() const { return now_.state; }
  // The player's view angles, on the server's clock: interpolated between records, except where the server
  // turned or moved the player, and not if settings.interpolate is off.
  math::Vec3 view_angles_at(double server_time_s, const ClientSettings& settings) const;

  // Whether the file ends in the middle of a record, which was dropped.
  bool is_truncated() const { return now_.demo.is_truncated(); }

  // The complete playback state. Copying it saves a place; its size is mostly that of the client state.
  class Place {
   public:
    explicit Place(formats::DemReader reader) : demo(reader) {}
    // The approximate size of a copy.
    std::size_t memory_bytes() const { return sizeof(Place) + state.memory_bytes(); }

   private:
    friend class DemoPlayer;
    formats::DemReader demo;
    net::MessageReader messages;
    ClientState state;
    bool has_ended = false;
    bool level_begins = false;  // no packet since the last serverinfo
    bool clock_runs = false;    // there has been a packet
    double packet_time_s = 0;
    double server_ahead_s = 0;  // the server's clock minus the demo's
    double server_time_s = 0;
    math::Vec3 previous_angles_deg{0.0f}, angles_deg{0.0f};  // from the last two packets
  };
  // A place to return to; valid while this player (or the one it is moved to) lives.
  const Place& place() const { return now_; }
  // `place` must come from this player.
  void restore(const Place& place) { now_ = place; }

 private:
  DemoPlayer(base::ByteVector bytes, formats::DemReader demo, std::string name)
      : bytes_(std::move(bytes)), name_(std::move(name)), now_(demo) {}

  struct Record;
  base::Result<bool> read_record();
  base::Result<bool> play_record();
  base::Status apply_messages(const formats::DemMessage& packet, Record& out_record);
  void run_clock(double previous_time_s);
  bool is_playing() const { return now_.state.game().signon == kPlaying; }

  base::ByteVector bytes_;
  std::string name_;
  Place now_;
};

}  // namespace temblor::client
