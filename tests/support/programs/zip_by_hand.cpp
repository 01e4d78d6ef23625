#include "support/programs/zip_by_hand.h"

#include <string_view>
#include <vector>

namespace temblor::test {
namespace {

// CRC-32 of ISO 3309, bit by bit.
std::uint32_t crc32(std::string_view data) {
  std::uint32_t crc = 0xffffffffu;
  for (const char c : data) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

// Writes the fields that the local header and the directory record share.
void write_common_fields(base::ByteWriter& io_writer, const ZipByHand& entry) {
  const auto size = static_cast<std::uint32_t>(entry.data.size());
  io_writer.u16(20);  // version needed
  io_writer.u16(entry.flags);
  io_writer.u16(entry.method);
  io_writer.u16(0);             // time
  io_writer.u16((1 << 5) | 1);  // 1980-01-01
  io_writer.u32(entry.claimed_crc.value_or(crc32(entry.data)));
  io_writer.u32(entry.claimed_packed_size.value_or(size));
  io_writer.u32(entry.claimed_size.value_or(size));
  io_writer.u16(static_cast<std::uint16_t>(entry.name.size()));
  io_writer.u16(0);  // extra field
}

}  // namespace

base::ByteVector make_zip(std::span<const ZipByHand> entries) {
  base::ByteWriter writer;
  std::vector<std::size_t> offsets;
  for (const ZipByHand& entry : entries) {
    offsets.push_back(writer.size());
    writer.u32(0x04034b50);
    write_common_fields(writer, entry);
    writer.bytes(base::as_bytes(entry.name));
    writer.bytes(base::as_bytes(entry.data));
  }
  const std::size_t directory = writer.size();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    writer.u32(0x02014b50);
    writer.u16(20);  // version made by
    write_common_fields(writer, entries[i]);
    writer.u16(0);  // comment
    writer.u16(0);  // disk
    writer.u16(0);  // internal attributes
    writer.u32(0);  // external attributes
    writer.u32(static_cast<std::uint32_t>(offsets[i]));
    writer.bytes(base::as_bytes(entries[i].name));
  }
  const std::size_t directory_bytes = writer.size() - directory;
  writer.u32(0x06054b50);
  writer.u32(0);  // disks
  writer.u16(static_cast<std::uint16_t>(entries.size()));
  writer.u16(static_cast<std::uint16_t>(entries.size()));
  writer.u32(static_cast<std::uint32_t>(directory_bytes));
  writer.u32(static_cast<std::uint32_t>(directory));
  writer.u16(0);  // comment
  return std::move(writer).take();
}

}  // namespace temblor::test
