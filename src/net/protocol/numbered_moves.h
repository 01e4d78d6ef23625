// Numbered moves: how a server of ours and a client of ours agree on which moves were played and what came of
// them, within the stock protocols (docs/network.md). All of it is text that stock peers pass over: lines of
// comment that the server stuffs into the client's console, and a word before the moves that only a client
// sends which was asked to.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/bytes.h"
#include "math/vec.h"

namespace temblor::net {

// What a server that takes numbered moves says of how it plays them; again when something of it changes.
struct MoveParameters {
  std::uint16_t entity = 1;        // the player's own
  double tick_s = 1.0 / 72;        // of the clock: a move each
  double world_tick_s = 1.0 / 72;  // that each moves the world on
  // As movement::Settings.
  float gravity = 800, max_velocity = 2000;
  float friction = 4, edge_friction = 2, stop_speed = 100, accelerate = 10, max_speed = 320;
  bool no_step = false;
  bool operator==(const MoveParameters&) const = default;
};

// A player right after a tick: all that his next moves depend on.
struct MoveAcknowledgement {
  std::uint32_t number = 0;  // of the last move that was played
  math::Vec3 origin{0.0f}, velocity{0.0f};
  math::Vec3 angles_deg{0.0f};  // of his model
  math::Vec3 punch_deg{0.0f};
  std::uint8_t move_type = 3;  // movetype, as programs number them
  std::uint8_t water_level = 0;
  bool is_in_slime = false, is_in_lava = false;  // what water_level is of
  bool is_alive = true, on_ground = false;
  bool is_jump_released = true, is_jumping_out_of_water = false;
  bool is_turned_by_game = false;
  math::Vec2 water_jump_velocity{0.0f};  // while he does
  float teleport_time_s = 0;             // until teleport_time; 0: past
  float own_gravity = 1;
  std::uint16_t ground = 0;  // what he stands on, or stood on last: an entity
  // How the ground moves: with that velocity for so long, then it is not known.
  struct Ride {
    math::Vec3 origin{0.0f}, velocity{0.0f};
    float left_s = 0;
    bool operator==(const Ride&) const = default;
  };
  std::optional<Ride> ride{};  // where the ground is a brush model
  bool operator==(const MoveAcknowledgement&) const = default;
};

// Whole lines, with their ends, for svc_stufftext.
std::string line_of(const MoveParameters& terms);
// Into `out_line`, which keeps its memory.
void write_line(const MoveAcknowledgement& acknowledgement, std::string& out_line);
// Nothing for any other line, and for one with values that make no sense.
std::optional<MoveParameters> read_move_parameters(std::string_view line);
std::optional<MoveAcknowledgement> read_acknowledgement(std::string_view line);

// An acknowledgement's line as numbers that can be compared with another's (net/delta/snapshot_state.h). How
// many there are, at most kMaxAcknowledgementWords; 0 for any other line.
constexpr std::size_t kMaxAcknowledgementWords = 32;
std::size_t read_words(std::string_view line, std::span<std::uint32_t> out_words);
// The line of 1 to kMaxAcknowledgementWords words, whatever they are.
void write_line(std::span<const std::uint32_t> words, std::string& out_line);

// What a server says, also in a line of comment, to a client that numbers its moves: that it would tell
// updates as differences (net/delta/sent_snapshots.h), once that client knows of it.
std::string format_delta_offer();
bool is_delta_offer(std::string_view line);

// What a client says before the moves of a packet (clc_stringcmd).
struct NumberedPacket {
  std::uint32_t last_move = 0;  // those before it count down
  bool accepts_deltas = false;
  std::optional<std::uint16_t> received_snapshot{};  // the last that it has: only with accepts_deltas
  bool operator==(const NumberedPacket&) const = default;
};
std::string command_of(const NumberedPacket& packet);
std::optional<NumberedPacket> read_numbered_packet(std::string_view command);

// Moves that a packet may hold, and those that a client of ours puts there: three packets in a row that
// get lost take no move with them.
constexpr std::size_t kMaxMovesInPacket = 8, kMovesInPacket = 4;

}  // namespace temblor::net
