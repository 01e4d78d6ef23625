// Numbered moves: an extension for client-side prediction between a Temblor server and a Temblor client,
// inside the stock protocols (docs/network.md). All of it is text that stock peers ignore: the server stuffs
// console comments, and the client sends extra console commands only after the server has announced the
// extension.
//
//   server -> client   svc_stufftext "//temblor moves ENTITY TICK WORLD_TICK GRAVITY ...\n"   MoveParameters
//                      svc_stufftext "//temblor differences\n"                               offer of deltas
//                      svc_stufftext "//a BASE64URL\n" MoveAcknowledgment
//   client -> server   clc_stringcmd "tm LAST_MOVE [SNAPSHOT | -]", then clc_moves           NumberedPacket
//
// The client predicts its player with the parameters, and corrects the prediction with each acknowledgment.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/bytes.h"
#include "math/physics_settings.h"
#include "math/vec.h"

namespace temblor::net {

// How a server simulates numbered moves. It sends these when a client joins, and after each change.
struct MoveParameters {
  std::uint16_t entity = 1;        // the player's entity number
  double tick_s = 1.0 / 72;        // duration of a tick; one move per tick
  double world_tick_s = 1.0 / 72;  // game time that passes per tick
  math::PhysicsSettings physics{};
  bool operator==(const MoveParameters&) const = default;
};

// State of a player right after a tick: everything that the next moves depend on.
struct MoveAcknowledgment {
  std::uint32_t number = 0;  // of the last simulated move
  math::Vec3 origin{0.0f}, velocity{0.0f};
  math::Vec3 angles_deg{0.0f};  // of the player's model
  math::Vec3 punch_deg{0.0f};
  std::uint8_t move_type = 3;  // movetype, as QuakeC numbers it
  std::uint8_t water_level = 0;
  bool is_in_slime = false, is_in_lava = false;  // kind of liquid that water_level refers to
  bool is_alive = true, on_ground = false;
  bool is_jump_released = true, is_jumping_out_of_water = false;
  bool is_turned_by_game = false, is_crouching = false;
  math::Vec2 water_jump_velocity{0.0f};  // while jumping out of water
  float teleport_time_s = 0;             // remaining time until teleport_time; 0: none
  float own_gravity = 1;
  std::uint16_t ground = 0;  // entity that the player stands on, or stood on last
  // Motion of a moving ground: constant velocity for left_s, unknown afterwards.
  struct Ride {
    math::Vec3 origin{0.0f}, velocity{0.0f};
    float left_s = 0;
    bool operator==(const Ride&) const = default;
  };
  std::optional<Ride> ride{};  // if the ground is a brush model
  bool operator==(const MoveAcknowledgment&) const = default;
};

// Formats a line for svc_stufftext, with its line end.
std::string format_move_parameters(const MoveParameters& parameters);
// The same, but reuses the memory of `out_line`.
void write_acknowledgment(const MoveAcknowledgment& acknowledgment, std::string& out_line);
// Parse a line. Return nullopt for other lines, and for values out of range.
std::optional<MoveParameters> read_move_parameters(std::string_view line);
std::optional<MoveAcknowledgment> read_acknowledgment(std::string_view line);

// Decodes an acknowledgment line into 32-bit words for delta compression (net/delta/snapshot_state.h).
// Returns the number of words, at most kMaxAcknowledgmentWords; 0 if `line` is not an acknowledgment.
constexpr std::size_t kMaxAcknowledgmentWords = 32;
std::size_t read_acknowledgment_words(std::string_view line, std::span<std::uint32_t> out_words);
// The inverse, for any 1 to kMaxAcknowledgmentWords words.
void write_acknowledgment_words(std::span<const std::uint32_t> words, std::string& out_line);

// The console comment in which a server offers delta-compressed snapshots (net/delta/sent_snapshots.h) to a
// client that numbers its moves.
std::string format_delta_offer();
bool is_delta_offer(std::string_view line);

// Head of a client packet with numbered moves (clc_stringcmd, before the moves).
struct NumberedPacket {
  std::uint32_t last_move = 0;  // number of the last move in the packet; earlier ones count down
  bool accepts_deltas = false;  // the client accepted the server's offer
  std::optional<std::uint16_t> received_snapshot{};  // latest snapshot received; only with accepts_deltas
  bool operator==(const NumberedPacket&) const = default;
};
// Format and parse the command. read_numbered_packet() returns nullopt for other commands.
std::string format_numbered_packet(const NumberedPacket& packet);
std::optional<NumberedPacket> read_numbered_packet(std::string_view command);

// Limit of moves in a packet, and the number that our client sends: the newest move and three repeated ones,
// so that no move is lost unless four packets in a row are.
constexpr std::size_t kMaxMovesInPacket = 8, kMovesInPacket = 4;

}  // namespace temblor::net
