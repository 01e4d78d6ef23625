#include "lockstep/peers/packets.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lockstep/peers/text_field.h"

namespace temblor::lockstep {
namespace {

constexpr std::uint32_t kPacketMagic = 0x6b4c6d54;  // "TmLk"
constexpr std::uint8_t kPacketVersion = 1;
constexpr std::size_t kMaxTicksInPacket = 200;

void write_stamped(const StampedInput& stamped, InputHistory& io_history, base::ByteWriter& io_writer) {
  io_writer.u32(stamped.hash);
  write_input(stamped.input, io_history, io_writer);
}

std::optional<StampedInput> read_stamped(base::ByteReader& io_reader, InputHistory& io_history) {
  const std::uint32_t hash = io_reader.u32();
  base::Result<ClientInput> input = read_input(io_reader, io_history);
  if (!input.ok()) return std::nullopt;
  return StampedInput{std::move(*input), hash};
}

void write(const Join& join, base::ByteWriter& io_writer) {
  io_writer.write(join.id);
  write_text(join.program_version, io_writer);
}
void write(const Waiting& waiting, base::ByteWriter& io_writer) {
  io_writer.u8(waiting.joined);
  io_writer.u8(waiting.players);
}
void write(const Refused& refused, base::ByteWriter& io_writer) {
  write_text(refused.reason, io_writer);
}
void write(const Start& start, base::ByteWriter& io_writer) {
  io_writer.u8(start.player);
  write_start(start.start, io_writer);
}

// Each packet can be read alone, so its histories are new. The number of ticks precedes them, and is filled
// in last.
void write(const Inputs& inputs, base::ByteWriter& io_writer) {
  io_writer.u32(inputs.next_tick);
  io_writer.u32(inputs.first_tick);
  const std::size_t count_at = io_writer.size();
  io_writer.u8(0);
  InputHistory history;
  std::uint8_t count = 0;
  for (const StampedInput& input : inputs.inputs) {
    if (io_writer.size() >= kMaxPacketBytes || count == kMaxTicksInPacket) break;
    write_stamped(input, history, io_writer);
    ++count;
  }
  io_writer.patch(count_at, count);
}
void write(const Ticks& ticks, base::ByteWriter& io_writer) {
  io_writer.u32(ticks.next_input);
  io_writer.u32(ticks.first_tick);
  const std::size_t count_at = io_writer.size();
  io_writer.u8(0);
  std::array<InputHistory, kMaxPlayers> histories{};
  std::uint8_t count = 0;
  for (const std::vector<StampedInput>& tick : ticks.ticks) {
    if (io_writer.size() >= kMaxPacketBytes || count == kMaxTicksInPacket) break;
    for (std::size_t player = 0; player < tick.size(); ++player)
      write_stamped(tick[player], histories[player], io_writer);
    ++count;
  }
  io_writer.patch(count_at, count);
}
void write(const EntityHashes& hashes, base::ByteWriter& io_writer) {
  io_writer.u32(hashes.tick);
  io_writer.u32(hashes.first);
  io_writer.u32(hashes.count);
  io_writer.u16(static_cast<std::uint16_t>(hashes.hashes.size()));
  for (const std::uint32_t hash : hashes.hashes) io_writer.u32(hash);
}
void write(const Leave& leave, base::ByteWriter& io_writer) {
  write_text(leave.reason, io_writer);
}

std::optional<Packet> read_inputs(base::ByteReader& io_reader) {
  Inputs inputs{.next_tick = io_reader.u32(), .first_tick = io_reader.u32()};
  InputHistory history;
  for (int left = io_reader.u8(); left > 0; --left) {
    std::optional<StampedInput> input = read_stamped(io_reader, history);
    if (!input) return std::nullopt;
    inputs.inputs.push_back(std::move(*input));
  }
  return inputs;
}

std::optional<Packet> read_ticks(base::ByteReader& io_reader, std::size_t players) {
  Ticks ticks{.next_input = io_reader.u32(), .first_tick = io_reader.u32()};
  std::array<InputHistory, kMaxPlayers> histories{};
  for (int left = io_reader.u8(); left > 0; --left) {
    std::vector<StampedInput>& tick = ticks.ticks.emplace_back();
    for (std::size_t player = 0; player < std::min(players, kMaxPlayers); ++player) {
      std::optional<StampedInput> input = read_stamped(io_reader, histories[player]);
      if (!input) return std::nullopt;
      tick.push_back(std::move(*input));
    }
  }
  return ticks;
}

std::optional<Packet> read_hashes(base::ByteReader& io_reader) {
  EntityHashes hashes{.tick = io_reader.u32(), .first = io_reader.u32(), .count = io_reader.u32()};
  const std::size_t count = io_reader.u16();
  if (count > kMaxHashesInPacket) return std::nullopt;
  for (std::size_t i = 0; i < count; ++i) hashes.hashes.push_back(io_reader.u32());
  return hashes;
}

std::optional<Packet> read_start_packet(base::ByteReader& io_reader) {
  const std::uint8_t player = io_reader.u8();
  base::Result<GameStart> start = read_start(io_reader);
  if (!start.ok() || player >= start->players) return std::nullopt;
  return Start{player, std::move(*start)};
}

std::optional<Packet> read_content(std::size_t kind, base::ByteReader& io_reader, std::size_t players) {
  switch (kind) {
    case 0: {
      const auto id = io_reader.read<std::uint64_t>();
      return Join{id, read_text(io_reader)};
    }
    case 1: {
      const std::uint8_t joined = io_reader.u8();
      return Waiting{joined, io_reader.u8()};
    }
    case 2:
      return Refused{read_text(io_reader)};
    case 3:
      return read_start_packet(io_reader);
    case 4:
      return read_inputs(io_reader);
    case 5:
      return read_ticks(io_reader, players);
    case 6:
      return read_hashes(io_reader);
    case 7:
      return Leave{read_text(io_reader)};
    default:
      return std::nullopt;
  }
}

}  // namespace

base::ByteVector make_packet(const Packet& packet) {
  base::ByteWriter writer;
  writer.u32(kPacketMagic);
  writer.u8(kPacketVersion);
  writer.u8(static_cast<std::uint8_t>(packet.index()));
  std::visit([&](const auto& content) { write(content, writer); }, packet);
  return writer.view();
}

std::optional<Packet> read_packet(base::Bytes bytes, std::size_t players) {
  base::ByteReader reader(bytes);
  if (reader.u32() != kPacketMagic || reader.u8() != kPacketVersion) return std::nullopt;
  const std::uint8_t kind = reader.u8();
  std::optional<Packet> packet = read_content(kind, reader, players);
  if (!reader.ok() || reader.remaining() > 0) return std::nullopt;
  return packet;
}

}  // namespace temblor::lockstep
