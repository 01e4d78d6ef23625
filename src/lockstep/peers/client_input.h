// The input of one player in one tick of a lockstep game: moves, and console lines for the server.
//
// Encoding (little endian): most ticks take two to six bytes, because a move is written as its differences to
// the one before.
//
//   u8   number of moves (low 4 bits), 0x10: commands follow, 0x20: the player leaves,
//        0x40: the number of the last move follows (else it counts on)
//   u32  number of the last move
//   each move:   u8 mask of the fields that follow: pitch, yaw, roll (u16, 65536ths of a turn), forward,
//   side,
//                up (i16), buttons, impulse (u8)
//   u8   number of commands; each: u16 size, text
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "net/protocol/client_message.h"

namespace temblor::lockstep {

constexpr std::size_t kMaxMovesInTick = 15;
constexpr std::size_t kMaxCommandsInTick = 16;
// The size of all commands together, unless there is only one.
constexpr std::size_t kMaxCommandBytesInTick = 512;

struct ClientInput {
  // The number of the last move (net/protocol/numbered_moves.h). 0: the moves have no numbers.
  std::uint32_t last_number = 0;
  std::vector<net::Move> moves{};       // without times; at most kMaxMovesInTick
  std::vector<std::string> commands{};  // at most kMaxCommandsInTick, each shorter than net::kMaxCommandBytes
  bool leaves = false;                  // this tick is the player's last
};

// The state that encoding and decoding of successive inputs share. Both begin with a new one.
struct InputHistory {
  net::Move move{};
  std::uint32_t last_number = 0;
};

// Angles are rounded to 65536ths of a turn.
void write_input(const ClientInput& input, InputHistory& io_history, base::ByteWriter& io_writer);
// kMalformed for bytes that write_input() cannot have written.
base::Result<ClientInput> read_input(base::ByteReader& io_reader, InputHistory& io_history);

}  // namespace temblor::lockstep
