#include "formats/levels/bsp/bspx.h"

namespace temblor::formats::bsp_file {
namespace {

constexpr std::string_view kMark = "BSPX";
constexpr std::size_t kLumpNameBytes = 24;
constexpr std::size_t kEntryBytes = kLumpNameBytes + 8;

}  // namespace

std::vector<BspxLump> read_bspx(base::Bytes file, std::size_t lumps_end) {
  base::ByteReader reader(file);
  reader.seek((lumps_end + 3) / 4 * 4);
  if (base::as_text(reader.take(kMark.size())) != kMark) return {};
  const std::uint32_t count = reader.u32();
  if (!reader.ok() || count > reader.remaining() / kEntryBytes) return {};

  std::vector<BspxLump> lumps;
  std::uint64_t total = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    std::string name = reader.fixed_text(kLumpNameBytes);
    const std::uint32_t offset = reader.u32(), size = reader.u32();
    const bool is_inside = std::uint64_t{offset} + size <= file.size();
    if (!is_inside || total + size > file.size()) continue;
    total += size;
    const base::Bytes data = size == 0 ? base::Bytes{} : file.subspan(offset, size);
    lumps.push_back({std::move(name), base::ByteVector(data.begin(), data.end())});
  }
  return lumps;
}

// Offsets are known before the data is written, because every lump is padded to 4 bytes.
base::Status write_bspx(base::ByteWriter& writer, const std::vector<BspxLump>& lumps) {
  if (lumps.empty()) return base::Ok{};
  writer.align(4);
  writer.bytes(base::as_bytes(kMark));
  writer.u32(static_cast<std::uint32_t>(lumps.size()));
  std::size_t offset = writer.size() + lumps.size() * kEntryBytes;
  for (const BspxLump& lump : lumps) {
    if (lump.name.size() > kLumpNameBytes)
      return error(base::ErrorCode::kTooLarge, "BSPX: the name \"{}\" is longer than {} characters",
                   lump.name, kLumpNameBytes);
    writer.fixed_text(lump.name, kLumpNameBytes);
    writer.u32(static_cast<std::uint32_t>(offset));
    writer.u32(static_cast<std::uint32_t>(lump.data.size()));
    offset += (lump.data.size() + 3) / 4 * 4;
  }
  for (const BspxLump& lump : lumps) {
    writer.bytes(lump.data);
    writer.align(4);
  }
  return base::Ok{};
}

}  // namespace temblor::formats::bsp_file
