// Archives (.pak, .pk3, .wad): their entries, and whether those can be read.
#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "app/inspect/inspection.h"
#include "base/text.h"
#include "formats/archives/pak.h"
#include "formats/archives/pk3.h"
#include "formats/archives/wad.h"
#include "formats/images/wad_texture.h"

namespace temblor::app {
namespace {

using base::ErrorCode;

// Reads `count` bytes of the file at `offset`.
base::Result<base::ByteVector> read_part(const std::filesystem::path& path, std::uint64_t offset,
                                         std::uint64_t count) {
  std::ifstream file(path, std::ios::binary);
  base::ByteVector bytes(count);
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count));
  if (!file) return base::error(ErrorCode::kIo, "cannot read {} bytes at offset {}", count, offset);
  return bytes;
}

// `texture_type` is the lump type of textures; WAD2 and WAD3 number it differently.
Inspection inspect_lump(const formats::WadLump& lump, std::uint8_t texture_type, Inspection& io_problems) {
  Inspection entry = {{"name", lump.name}, {"type", lump.type}, {"bytes", lump.data.size()}};
  // The console characters in gfx.wad have the type of a texture, but no header.
  if (lump.type != texture_type || base::equal_ignoring_case(lump.name, "conchars")) return entry;
  const base::Result<formats::WadTexture> texture = formats::read_wad_texture(lump.data);
  if (texture.ok()) {
    entry["width"] = texture->width;
    entry["height"] = texture->height;
  } else {
    io_problems.push_back(fmt::format("texture \"{}\": {}", lump.name, texture.error().what));
  }
  return entry;
}

}  // namespace

// A PAK consists of a header, the files, and a directory, which the header locates. Only header and directory
// are read.
base::Result<Inspection> inspect_pak(const std::filesystem::path& path) {
  std::error_code failure;
  const std::uint64_t archive_bytes = std::filesystem::file_size(path, failure);
  if (failure) return base::error(ErrorCode::kIo, "{}", failure.message());
  TRY(const base::ByteVector header_bytes,
      read_part(path, 0, std::min<std::uint64_t>(archive_bytes, formats::kPakHeaderBytes)));
  TRY(const formats::PakHeader header, formats::read_pak_header(header_bytes, archive_bytes));
  TRY(const base::ByteVector directory, read_part(path, header.directory_offset, header.directory_bytes));
  const std::vector<formats::PakEntry> entries = formats::read_pak_directory(directory, archive_bytes);
  Inspection files = Inspection::array();
  for (const formats::PakEntry& entry : entries)
    files.push_back({{"name", entry.name}, {"bytes", entry.size}});
  return Inspection{{"count", entries.size()}, {"files", files}, {"problems", Inspection::array()}};
}

// A PK3 is a ZIP archive. Every file is unpacked to find damage.
base::Result<Inspection> inspect_pk3(base::ByteVector bytes) {
  TRY(const formats::Pk3 pk3, formats::read_pk3(std::move(bytes)));
  Inspection files = Inspection::array();
  Inspection problems(std::vector<std::string>(pk3.left_out().begin(), pk3.left_out().end()));
  for (std::size_t i = 0; i < pk3.entries().size(); ++i) {
    const formats::ZipRecord& entry = pk3.entries()[i];
    files.push_back({{"name", entry.name}, {"bytes", entry.size}});
    const auto unpacked = pk3.read(i, formats::Pk3::Checksum::kVerify);
    if (!unpacked.ok()) problems.push_back(unpacked.error().message());
  }
  return Inspection{{"count", pk3.entries().size()}, {"files", files}, {"problems", problems}};
}

base::Result<Inspection> inspect_wad(base::Bytes bytes) {
  TRY(const std::vector<formats::WadLump> lumps, formats::read_wad(bytes));
  Inspection entries = Inspection::array();
  Inspection problems = Inspection::array();
  const std::uint8_t texture_type = formats::is_wad3(bytes) ? formats::kWad3Texture : formats::kWadTexture;
  for (const formats::WadLump& lump : lumps) entries.push_back(inspect_lump(lump, texture_type, problems));
  return Inspection{{"count", lumps.size()}, {"lumps", entries}, {"problems", problems}};
}

}  // namespace temblor::app
