#include "lockstep/peers/client_input.h"

#include <array>
#include <cmath>

#include "lockstep/peers/text_field.h"

namespace temblor::lockstep {
namespace {

constexpr std::uint8_t kCountMask = 0x0f, kHasCommands = 0x10, kLeaves = 0x20, kHasNumber = 0x40,
                       kKnownFlags = kCountMask | kHasCommands | kLeaves | kHasNumber;
constexpr float kAngleSteps = 65536;

std::int16_t round_angle(float angle_deg) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(std::lround(angle_deg * kAngleSteps / 360)));
}

// A move as the numbers that are written: six of 16 bits, two of 8.
using Words = std::array<std::int16_t, 8>;
constexpr std::size_t kFirstByte = 6;

Words to_words(const net::Move& move) {
  return {round_angle(move.angles_deg.x),
          round_angle(move.angles_deg.y),
          round_angle(move.angles_deg.z),
          move.forward,
          move.side,
          move.up,
          move.buttons,
          move.impulse};
}

net::Move to_move(const Words& words) {
  constexpr float kStep_deg = 360 / kAngleSteps;
  return {.angles_deg = {words[0] * kStep_deg, words[1] * kStep_deg, words[2] * kStep_deg},
          .forward = words[3],
          .side = words[4],
          .up = words[5],
          .buttons = static_cast<std::uint8_t>(words[6]),
          .impulse = static_cast<std::uint8_t>(words[7])};
}

void write_move(const net::Move& move, const net::Move& previous, base::ByteWriter& io_writer) {
  const Words now = to_words(move), before = to_words(previous);
  std::uint8_t mask = 0;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i] != before[i]) mask = static_cast<std::uint8_t>(mask | 1u << i);
  io_writer.u8(mask);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if ((mask >> i & 1) == 0) continue;
    if (i < kFirstByte)
      io_writer.i16(now[i]);
    else
      io_writer.u8(static_cast<std::uint8_t>(now[i]));
  }
}

net::Move read_move(base::ByteReader& io_reader, const net::Move& previous) {
  Words words = to_words(previous);
  const std::uint8_t mask = io_reader.u8();
  for (std::size_t i = 0; i < words.size(); ++i)
    if (mask >> i & 1) words[i] = i < kFirstByte ? io_reader.i16() : std::int16_t{io_reader.u8()};
  return to_move(words);
}

// The number that the last move has if moves are counted on.
std::uint32_t count_on(const InputHistory& history, std::size_t moves) {
  return history.last_number == 0 ? 0 : history.last_number + static_cast<std::uint32_t>(moves);
}

}  // namespace

void write_input(const ClientInput& input, InputHistory& io_history, base::ByteWriter& io_writer) {
  CHECK(input.moves.size() <= kMaxMovesInTick && input.commands.size() <= kMaxCommandsInTick,
        "an input has {} moves and {} commands", input.moves.size(), input.commands.size());
  const bool has_number =
      !input.moves.empty() && input.last_number != count_on(io_history, input.moves.size());
  io_writer.u8(static_cast<std::uint8_t>(input.moves.size() | (input.commands.empty() ? 0u : kHasCommands) |
                                         (input.leaves ? kLeaves : 0u) | (has_number ? kHasNumber : 0u)));
  if (has_number) io_writer.u32(input.last_number);
  for (const net::Move& move : input.moves) {
    write_move(move, io_history.move, io_writer);
    io_history.move = move;
  }
  if (!input.moves.empty()) io_history.last_number = input.last_number;
  if (input.commands.empty()) return;
  io_writer.u8(static_cast<std::uint8_t>(input.commands.size()));
  for (const std::string& command : input.commands) {
    CHECK(command.size() < net::kMaxCommandBytes, "a command has {} bytes", command.size());
    write_text(command, io_writer);
  }
}

base::Result<ClientInput> read_input(base::ByteReader& io_reader, InputHistory& io_history) {
  ClientInput input;
  const std::uint8_t flags = io_reader.u8();
  if ((flags & ~kKnownFlags) != 0) return base::malformed("an input has unknown flags ({:#x})", flags);
  const std::size_t moves = flags & kCountMask;
  input.leaves = (flags & kLeaves) != 0;
  if (moves > 0)
    input.last_number = (flags & kHasNumber) != 0 ? io_reader.u32() : count_on(io_history, moves);
  for (std::size_t i = 0; i < moves; ++i) {
    input.moves.push_back(read_move(io_reader, io_history.move));
    io_history.move = input.moves.back();
  }
  if (moves > 0) io_history.last_number = input.last_number;
  const std::size_t commands = (flags & kHasCommands) != 0 ? io_reader.u8() : 0;
  if (commands > kMaxCommandsInTick) return base::malformed("an input has {} commands", commands);
  for (std::size_t i = 0; i < commands; ++i) {
    std::string text = read_text(io_reader);
    if (text.size() >= net::kMaxCommandBytes || text.find('\0') != std::string::npos)
      return base::malformed("command {} of an input is not a console line", i);
    input.commands.push_back(std::move(text));
  }
  if (!io_reader.ok()) return base::malformed("an input is cut short");
  return input;
}

}  // namespace temblor::lockstep
