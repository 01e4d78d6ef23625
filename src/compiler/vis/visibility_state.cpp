// Reading checks the hash first, then the fingerprint and the counts, so rows are read only if they belong to
// the portals of `begun`.
#include "compiler/vis/visibility_state.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/hash.h"

namespace temblor::compiler {

namespace {

constexpr std::uint32_t kStateFileMagic = 0x53495654;  // "TVIS"
constexpr std::uint32_t kStateFileVersion = 1;
constexpr std::size_t kHeaderBytes = 24, kHashBytes = 8;

base::Error make_other_level_error() {
  return base::error(
      base::ErrorCode::kUsage,
      "the saved visibility belongs to another level, or to this one before it was changed: delete "
      "it to start over");
}

bool same_shape(const VisibilityState& a, const VisibilityState& b) {
  return a.finished.size() == b.finished.size() && a.seen.columns() == b.seen.columns();
}

// Whether the bits beyond the last column are 0.
bool ends_clean(std::span<const BitMatrix::Word> row, std::size_t columns) {
  return columns % 64 == 0 || row.back() >> (columns % 64) == 0;
}

// Reads the rows of all finished portals.
base::Status read_rows(base::ByteReader& io_reader, VisibilityState& io_state) {
  for (std::size_t portal = 0; portal < io_state.finished.size(); ++portal) {
    if (io_state.finished[portal] == 0) continue;
    const auto row = io_state.seen.row(portal);
    for (BitMatrix::Word& word : row) word = io_reader.read<std::uint64_t>();
    if (!ends_clean(row, io_state.seen.columns()))
      return base::malformed("saved visibility: portal {} sees clusters that do not exist", portal);
  }
  return base::Ok{};
}

}  // namespace

base::ByteVector write_visibility_state(const VisibilityState& state) {
  base::ByteWriter writer;
  const std::array<std::uint32_t, 2> start{kStateFileMagic, kStateFileVersion};
  writer.bytes(std::as_bytes(std::span(start)));
  writer.write(state.fingerprint);
  writer.u32(static_cast<std::uint32_t>(state.finished.size()));
  writer.u32(static_cast<std::uint32_t>(state.seen.columns()));
  std::vector<std::uint8_t> flags((state.finished.size() + 7) / 8);
  for (std::size_t i = 0; i < state.finished.size(); ++i)
    flags[i / 8] = static_cast<std::uint8_t>(flags[i / 8] | state.finished[i] << (i % 8));
  writer.bytes(std::as_bytes(std::span(flags)));
  for (std::size_t i = 0; i < state.finished.size(); ++i)
    if (state.finished[i] != 0) writer.bytes(std::as_bytes(state.seen.row(i)));
  writer.write(base::hash_bytes(writer.view()));
  return std::move(writer).take();
}

base::Result<VisibilityState> read_visibility_state(base::Bytes bytes, const VisibilityState& begun) {
  if (bytes.size() < kHeaderBytes + kHashBytes)
    return base::malformed("saved visibility: {} bytes are too short", bytes.size());
  base::ByteReader reader(bytes);
  if (reader.u32() != kStateFileMagic)
    return base::malformed("saved visibility: it does not begin with TVIS");
  if (const std::uint32_t version = reader.u32(); version != kStateFileVersion)
    return base::error(base::ErrorCode::kUnsupported,
                       "saved visibility: version {} is not supported, only version {}", version,
                       kStateFileVersion);
  base::ByteReader end(bytes.last(kHashBytes));
  if (end.read<std::uint64_t>() != base::hash_bytes(bytes.first(bytes.size() - kHashBytes)))
    return base::malformed("saved visibility: it is damaged (wrong hash)");

  VisibilityState state;
  state.fingerprint = reader.read<std::uint64_t>();
  const std::uint32_t portal_count = reader.u32(), cluster_count = reader.u32();
  if (state.fingerprint != begun.fingerprint || portal_count != begun.finished.size() ||
      cluster_count != begun.seen.columns())
    return make_other_level_error();

  // The counts equal those of `begun`, which is in memory already, so damaged bytes cannot demand more.
  state.seen = BitMatrix(portal_count, cluster_count);
  state.finished.resize(portal_count);
  const base::Bytes flags = reader.take((std::size_t{portal_count} + 7) / 8);
  if (!reader.ok()) return base::malformed("saved visibility: it ends within the list of portals");
  for (std::size_t i = 0; i < portal_count; ++i)
    state.finished[i] = static_cast<std::uint8_t>(base::as_u8(flags)[i / 8] >> (i % 8) & 1u);
  TRY_STATUS(read_rows(reader, state));
  if (!reader.ok() || reader.remaining() != kHashBytes)
    return base::malformed("saved visibility: its {} bytes do not fit its portals", bytes.size());
  return state;
}

// Compares everything first, so that io_state is unchanged after an error.
base::Status merge_visibility_state(const VisibilityState& other, VisibilityState& io_state) {
  if (other.fingerprint != io_state.fingerprint || !same_shape(other, io_state))
    return make_other_level_error();
  for (std::size_t i = 0; i < other.finished.size(); ++i) {
    if (other.finished[i] == 0 || io_state.finished[i] == 0) continue;
    if (!std::ranges::equal(other.seen.row(i), io_state.seen.row(i)))
      return base::malformed("saved visibility: two shards have different results for portal {}", i);
  }
  for (std::size_t i = 0; i < other.finished.size(); ++i) {
    if (other.finished[i] == 0) continue;
    io_state.finished[i] = 1;
    std::ranges::copy(other.seen.row(i), io_state.seen.row(i).begin());
  }
  return base::Ok{};
}

}  // namespace temblor::compiler
