#include "lockstep/simulation/replay.h"

#include <zlib.h>

namespace temblor::lockstep {
namespace {

constexpr std::uint32_t kReplayMagic = 0x70526d54;  // "TmRp"
constexpr std::uint8_t kReplayVersion = 1;
constexpr std::uint32_t kMaxTicks = 24 * 3600 * 72;
constexpr std::uint32_t kMaxUnpackedBytes = 256 << 20;

base::ByteVector pack(base::Bytes bytes) {
  uLongf size = compressBound(bytes.size());
  base::ByteVector packed(size);
  const int result =
      compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_BEST_COMPRESSION);
  CHECK(result == Z_OK, "zlib cannot pack {} bytes", bytes.size());
  packed.resize(size);
  return packed;
}

base::Result<base::ByteVector> unpack(base::Bytes packed, std::size_t bytes) {
  base::ByteVector unpacked(bytes);
  uLongf size = bytes;
  const int result = uncompress(reinterpret_cast<Bytef*>(unpacked.data()), &size,
                                reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  if (result != Z_OK || size != bytes) return base::malformed("the replay is damaged");
  return unpacked;
}

}  // namespace

ReplayWriter::ReplayWriter(const GameStart& start) {
  write_start(start, content_);
}

void ReplayWriter::add(std::span<const StampedInput> inputs, std::uint64_t hash) {
  for (std::size_t player = 0; player < inputs.size(); ++player)
    write_input(inputs[player].input, histories_[player], content_);
  hash_bytes_.push_back(static_cast<std::uint8_t>(hash));
  last_hash_ = hash;
}

base::ByteVector ReplayWriter::finish() const {
  base::ByteWriter content = content_;
  content.bytes(std::as_bytes(std::span(hash_bytes_)));
  base::ByteWriter file;
  file.u32(kReplayMagic);
  file.u8(kReplayVersion);
  file.u32(ticks());
  file.write(last_hash_);
  file.u32(static_cast<std::uint32_t>(content.size()));
  file.bytes(pack(content.view()));
  return file.view();
}

base::Result<Replay> read_replay(base::Bytes bytes) {
  base::ByteReader file(bytes);
  if (file.u32() != kReplayMagic) return base::malformed("this is not a replay");
  if (const std::uint8_t version = file.u8(); file.ok() && version != kReplayVersion)
    return base::error(base::ErrorCode::kUnsupported, "replay version {}; this program reads {}", version,
                       kReplayVersion);
  const std::uint32_t ticks = file.u32();
  Replay replay;
  replay.last_hash = file.read<std::uint64_t>();
  const std::uint32_t size = file.u32();
  if (!file.ok()) return base::malformed("the replay is cut short");
  if (ticks > kMaxTicks || size > kMaxUnpackedBytes)
    return base::error(base::ErrorCode::kTooLarge, "the replay has {} ticks and {} bytes", ticks, size);
  TRY(const base::ByteVector content, unpack(file.take(file.remaining()), size));
  base::ByteReader reader(content);
  TRY(replay.start, read_start(reader));
  std::array<InputHistory, kMaxPlayers> histories{};
  for (std::uint32_t tick = 0; tick < ticks; ++tick) {
    std::vector<ClientInput>& inputs = replay.ticks.emplace_back();
    for (std::size_t player = 0; player < replay.start.players; ++player) {
      TRY(ClientInput input, read_input(reader, histories[player]));
      inputs.push_back(std::move(input));
    }
  }
  for (const std::byte byte : reader.take(ticks))
    replay.hash_bytes.push_back(static_cast<std::uint8_t>(byte));
  if (!reader.ok() || reader.remaining() > 0) return base::malformed("the replay is damaged");
  return replay;
}

}  // namespace temblor::lockstep
