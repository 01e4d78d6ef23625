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
constexpr std::uint32_t kStateFileVersion = 3;
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

// Writes which portals have a row, then these rows.
void write_rows(const std::vector<std::uint8_t>& has_row, const BitMatrix& rows,
                base::ByteWriter& io_writer) {
  std::vector<std::uint8_t> flags((has_row.size() + 7) / 8);
  for (std::size_t i = 0; i < has_row.size(); ++i)
    flags[i / 8] = static_cast<std::uint8_t>(flags[i / 8] | has_row[i] << (i % 8));
  io_writer.bytes(std::as_bytes(std::span(flags)));
  for (std::size_t i = 0; i < has_row.size(); ++i)
    if (has_row[i] != 0) io_writer.bytes(std::as_bytes(rows.row(i)));
}

base::Status read_row(base::ByteReader& io_reader, std::size_t portal, BitMatrix& out_rows) {
  const auto row = out_rows.row(portal);
  for (BitMatrix::Word& word : row) word = io_reader.read<std::uint64_t>();
  if (!ends_clean(row, out_rows.columns()))
    return base::malformed("saved visibility: portal {} sees clusters that do not exist", portal);
  return base::Ok{};
}

// The counterpart of write_rows(). Both outputs have the size of the level's portals.
base::Status read_rows(base::ByteReader& io_reader, std::vector<std::uint8_t>& out_has_row,
                       BitMatrix& out_rows) {
  const base::Bytes flags = io_reader.take((out_has_row.size() + 7) / 8);
  if (!io_reader.ok()) return base::malformed("saved visibility: it ends within the list of portals");
  for (std::size_t i = 0; i < out_has_row.size(); ++i)
    out_has_row[i] = static_cast<std::uint8_t>(base::as_u8(flags)[i / 8] >> (i % 8) & 1u);
  for (std::size_t portal = 0; portal < out_has_row.size(); ++portal)
    if (out_has_row[portal] != 0) TRY_STATUS(read_row(io_reader, portal, out_rows));
  return base::Ok{};
}

// Reads the rows of the sweeps, which may be missing.
base::Status read_swept(base::ByteReader& io_reader, const VisibilityState& begun, BitMatrix& out_swept) {
  const std::uint32_t rows = io_reader.u32();
  if (rows == 0) return base::Ok{};
  if (rows != begun.finished.size())
    return base::malformed("saved visibility: the sweeps have {} portals instead of {}", rows,
                           begun.finished.size());
  out_swept = BitMatrix(rows, begun.seen.columns());
  for (std::size_t portal = 0; portal < rows; ++portal) TRY_STATUS(read_row(io_reader, portal, out_swept));
  return base::Ok{};
}

// One of the two tables of rows in a state.
struct RowTable {
  std::vector<std::uint8_t> VisibilityState::*has_row;
  BitMatrix VisibilityState::*rows;
};
constexpr std::array<RowTable, 2> kTables{{{&VisibilityState::bounded, &VisibilityState::bound},
                                           {&VisibilityState::finished, &VisibilityState::seen}}};

}  // namespace

base::ByteVector write_visibility_state(const VisibilityState& state) {
  base::ByteWriter writer;
  const std::array<std::uint32_t, 2> start{kStateFileMagic, kStateFileVersion};
  writer.bytes(std::as_bytes(std::span(start)));
  writer.write(state.fingerprint);
  writer.u32(static_cast<std::uint32_t>(state.finished.size()));
  writer.u32(static_cast<std::uint32_t>(state.seen.columns()));
  for (const RowTable& table : kTables) write_rows(state.*table.has_row, state.*table.rows, writer);
  writer.u32(static_cast<std::uint32_t>(state.swept.rows()));
  for (std::size_t i = 0; i < state.swept.rows(); ++i) writer.bytes(std::as_bytes(state.swept.row(i)));
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
  for (const RowTable& table : kTables) {
    state.*table.rows = BitMatrix(portal_count, cluster_count);
    (state.*table.has_row).resize(portal_count);
    TRY_STATUS(read_rows(reader, state.*table.has_row, state.*table.rows));
  }
  TRY_STATUS(read_swept(reader, begun, state.swept));
  if (!reader.ok() || reader.remaining() != kHashBytes)
    return base::malformed("saved visibility: its {} bytes do not fit its portals", bytes.size());
  return state;
}

// Compares everything first, so that io_state is unchanged after an error.
base::Status merge_visibility_state(const VisibilityState& other, VisibilityState& io_state) {
  if (other.fingerprint != io_state.fingerprint || !same_shape(other, io_state))
    return make_other_level_error();
  for (const auto& [has_row, rows] : kTables)
    for (std::size_t i = 0; i < (other.*has_row).size(); ++i)
      if ((other.*has_row)[i] != 0 && (io_state.*has_row)[i] != 0 &&
          !std::ranges::equal((other.*rows).row(i), (io_state.*rows).row(i)))
        return base::malformed("saved visibility: two shards have different results for portal {}", i);
  const bool both_swept = other.swept.rows() != 0 && io_state.swept.rows() != 0;
  if (both_swept && other.swept != io_state.swept)
    return base::malformed("saved visibility: two shards have different sweeps");
  if (other.swept.rows() != 0) io_state.swept = other.swept;
  for (const auto& [has_row, rows] : kTables)
    for (std::size_t i = 0; i < (other.*has_row).size(); ++i) {
      if ((other.*has_row)[i] == 0) continue;
      (io_state.*has_row)[i] = 1;
      std::ranges::copy((other.*rows).row(i), (io_state.*rows).row(i).begin());
    }
  return base::Ok{};
}

}  // namespace temblor::compiler
