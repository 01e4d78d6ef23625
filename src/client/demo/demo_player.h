// A recording played back: records in, client state out.
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

// Of as much of a recording as can be played.
struct DemoLength {
  std::size_t packets = 0;                   // how often read_packet() gives one
  double first_time_s = 0, last_time_s = 0;  // for advance_to()
  std::vector<std::string> levels;           // "maps/e1m1.bsp", in the order that they are played
  bool cut_short = false;                    // see DemoPlayer::cut_short()
  std::optional<base::Error> damage;         // what ends it before its end, if anything does
};

// Two clocks: the server's, by which all of the client state goes, starts anew with every level, and may
// jump. The recording's own is the server's in its first level, but goes on through changes of level, over
// which no time passes, and counts no gap between two packets as more than 0.1 s: a recording never takes
// longer than it has packets for, whatever times they claim.
//
// What cannot be read is an error that names the offset in the file; it is returned once, all that came
// before it (even in the same record) holds, and the recording has ended. Warm, playing takes no memory but
// for text.
class DemoPlayer {
 public:
  // `name` is for messages. Fails on what is not a recording at all.
  static base::Result<DemoPlayer> open(base::ByteVector bytes, std::string name);
  // Plays all of it, quickly. Fails where there is not a single packet to show.
  static base::Result<DemoLength> scan(base::Bytes bytes, std::string name);
  // Plays on to the end in the same way, from where it is. `on_packet` is called for each packet; what
  // happened in it is forgotten afterwards.
  base::Result<DemoLength> play_out(base::FunctionRef<void()> on_packet);

  // Reads on until that time of the recording's clock is not past its last packet; through the beginning of a
  // level always until its first entities have come. Afterwards there is something to show, unless it returns
  // false: the recording has ended (and stays so). A time before the last packets' shows them at their
  // beginning; the way back is return_to().
  base::Result<bool> advance_to(double time_s);
  // Reads one record, whatever its time, as for measuring; through the beginning of a level as above.
  base::Result<bool> read_packet();

  // The same, but what it shows is the beginning of what was read: the moment at which advance_to() in small
  // steps would come to it.
  base::Result<bool> begin_packet();

  // The moment to show, on the server's clock: for state(), view angles, light styles and all the rest. It is
  // between the last two packets' times.
  double server_time_s() const { return now_.server_time_s; }
  // Of the last packet, on the recording's clock.
  double packet_time_s() const { return now_.packet_time_s; }

  ClientState& state() { return now_.state; }
  const ClientState& state() const { return now_.state; }
  // Where the player looked, on the server's clock: from record to record the short way, but at once where
  // the server turned or moved him. Not blended where settings.interpolate is off.
  math::Vec3 view_angles_at(double server_time_s, const ClientSettings& settings) const;

  // The recording ends in the middle of a record, which was left out.
  bool cut_short() const { return now_.demo.cut_short(); }

  // Where the playing is: with the state, all that what follows depends on.
  class Place {
   public:
    explicit Place(formats::DemReader reader) : demo(reader) {}
    // About what a copy of it takes.
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
    double server_ahead_s = 0;  // the server's clock less the recording's
    double server_time_s = 0;
    math::Vec3 previous_angles_deg{0.0f}, angles_deg{0.0f};  // of the last two packets
  };
  // To come back to; valid while this player (or what it was moved to) lives.
  const Place& place() const { return now_; }
  // `place` is one of this player's.
  void return_to(const Place& place) { now_ = place; }

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
