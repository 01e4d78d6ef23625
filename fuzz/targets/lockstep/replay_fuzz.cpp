// Replays. The input is the content of a file before it is packed, after a byte with the number of ticks.
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "fuzz/targets.h"
#include "lockstep/simulation/replay.h"

using namespace temblor;

namespace {

base::ByteVector pack_without_compression(base::Bytes bytes) {
  uLongf size = compressBound(bytes.size());
  base::ByteVector packed(size);
  const int result = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_NO_COMPRESSION);
  CHECK(result == Z_OK);
  packed.resize(size);
  return packed;
}

}  // namespace

int temblor::fuzz::fuzz_replay(const std::uint8_t* data, std::size_t size) {
  const base::Bytes bytes = std::as_bytes(std::span(data, size));
  static_cast<void>(lockstep::read_replay(bytes));
  if (bytes.empty()) return 0;
  base::ByteWriter file;
  file.bytes(base::as_bytes("TmRp"));
  file.u8(1);
  file.u32(static_cast<std::uint8_t>(bytes[0]));
  file.write(std::uint64_t{0});
  file.u32(static_cast<std::uint32_t>(bytes.size() - 1));
  file.bytes(pack_without_compression(bytes.subspan(1)));
  const base::Result<lockstep::Replay> replay = lockstep::read_replay(file.view());
  if (replay.ok()) CHECK(replay->ticks.size() == replay->hash_bytes.size());
  return 0;
}
