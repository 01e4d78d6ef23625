// Which format a file has, and a format's object as text.
#include "app/inspect/inspection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "base/text.h"
#include "vfs/file_system.h"

namespace temblor::app {
namespace {

using base::ErrorCode;

enum class Format {
  kBsp,
  kLit,
  kEntities,
  kPak,
  kPk3,
  kWad,
  kPicture,
  kPalette,
  kColormap,
  kMdl,
  kSpr,
  kDem,
  kWad3,
  kMap,
  kProgs,
  kWav
};

constexpr std::array<const char*, 16> kFormatNames = {
    "level",    "colored light", "entity text", "PAK",       "PK3",  "WAD2", "picture",         "palette",
    "colormap", "model",         "sprite",      "recording", "WAD3", "map",  "compiled QuakeC", "sound"};

// The formats whose files start with something of their own.
std::optional<Format> format_of_start(base::Bytes bytes) {
  struct Start {
    std::string_view bytes;
    Format format;
  };
  constexpr std::array<Start, 14> kStarts = {{{{"\x1d\0\0\0", 4}, Format::kBsp},
                                              {"BSP2", Format::kBsp},
                                              {"2PSB", Format::kBsp},
                                              {"QLIT", Format::kLit},
                                              {"PACK", Format::kPak},
                                              {"PK\x03\x04", Format::kPk3},
                                              {"PK\x05\x06", Format::kPk3},  // an empty one
                                              {"WAD2", Format::kWad},
                                              {"WAD3", Format::kWad3},
                                              {"IDPO", Format::kMdl},
                                              {"IDSP", Format::kSpr},
                                              {"RIFF", Format::kWav},
                                              {{"\x06\0\0\0", 4}, Format::kProgs},
                                              {"{", Format::kEntities}}};
  const std::string_view text = base::as_text(bytes);
  for (const Start& start : kStarts)
    if (text.starts_with(start.bytes)) return start.format;
  return std::nullopt;
}

// The formats that only their name, and for *.lmp their size, tells; and damaged files of the others.
std::optional<Format> format_of_name(const std::filesystem::path& path, std::size_t size) {
  const std::string name = base::to_lower(path.filename().string());
  const std::string extension = base::to_lower(path.extension().string());
  if (extension == ".lmp") {
    if (name == "palette.lmp" || size == 768) return Format::kPalette;
    if (name == "colormap.lmp" || size == 16384 || size == 16385) return Format::kColormap;
    return Format::kPicture;
  }
  struct Extension {
    std::string_view text;
    Format format;
  };
  constexpr std::array<Extension, 12> kExtensions = {{{".bsp", Format::kBsp},
                                                      {".lit", Format::kLit},
                                                      {".ent", Format::kEntities},
                                                      {".pak", Format::kPak},
                                                      {".pk3", Format::kPk3},
                                                      {".wad", Format::kWad},
                                                      {".mdl", Format::kMdl},
                                                      {".spr", Format::kSpr},
                                                      {".dem", Format::kDem},
                                                      {".map", Format::kMap},
                                                      {".dat", Format::kProgs},
                                                      {".wav", Format::kWav}}};
  for (const Extension& known : kExtensions)
    if (extension == known.text) return known.format;
  return std::nullopt;
}

base::Result<Inspection> inspect_bytes(Format format, base::ByteVector bytes) {
  switch (format) {
    case Format::kBsp:
      return inspect_bsp(bytes);
    case Format::kLit:
      return inspect_lit(bytes);
    case Format::kEntities:
      return inspect_entities(bytes);
    case Format::kMap:
      return inspect_map(bytes);
    case Format::kPk3:
      return inspect_pk3(std::move(bytes));
    case Format::kWad:
    case Format::kWad3:
      return inspect_wad(bytes);
    case Format::kPicture:
      return inspect_picture(bytes);
    case Format::kPalette:
      return inspect_palette(bytes);
    case Format::kColormap:
      return inspect_colormap(bytes);
    case Format::kDem:
      return inspect_dem(bytes);
    case Format::kMdl:
      return inspect_mdl(bytes);
    case Format::kSpr:
      return inspect_spr(bytes);
    case Format::kProgs:
      return inspect_progs(bytes);
    case Format::kWav:
      return inspect_wav(bytes);
    case Format::kPak:
      break;
  }
  CHECK(false, "PAKs are inspected by path");
}

// The first bytes of a file, as far as it has them; none when it cannot be read.
base::ByteVector read_start(const std::filesystem::path& path) {
  constexpr std::streamsize kStartBytes = 4;
  base::ByteVector start(kStartBytes);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(start.data()), kStartBytes);
  start.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return start;
}

base::Result<Inspection> inspect_content(const std::filesystem::path& path, Inspection& io_header) {
  // Pictures go by their name first: one that is 29 pixels wide starts like a level.
  // Lumps start with anything, and maps as entity text does.
  const std::string extension = base::to_lower(path.extension().string());
  const bool goes_by_name = extension == ".lmp" || extension == ".map";
  std::optional<Format> format = goes_by_name ? std::nullopt : format_of_start(read_start(path));
  base::ByteVector bytes;
  if (format != Format::kPak) {  // a PAK may be larger than memory
    TRY(bytes, vfs::read_disk_file(path));
    if (!format) format = format_of_name(path, bytes.size());
  }
  if (!format)
    return base::error(ErrorCode::kUnsupported,
                       "is of no known format; known are levels (.bsp), .map, .lit, .ent, .pak, .pk3, .wad, "
                       ".mdl, .spr, .dem, .dat, .wav and "
                       "pictures, palettes and colormaps (.lmp)");
  io_header["format"] = kFormatNames[static_cast<std::size_t>(*format)];
  return *format == Format::kPak ? inspect_pak(path) : inspect_bytes(*format, std::move(bytes));
}

std::string text_of(const Inspection& value) {
  return base::printable(value.is_string() ? value.get<std::string>() : value.dump());
}

// "name: x  bytes: 12", or the value itself when it is no object.
std::string one_line(const Inspection& value) {
  if (!value.is_object()) return text_of(value);
  std::string line;
  for (const auto& [key, part] : value.items())
    line += fmt::format("{}{}: {}", line.empty() ? "" : "  ", key, text_of(part));
  return line;
}

}  // namespace

base::Result<Inspection> inspect_file(const std::filesystem::path& path) {
  Inspection result = {{"file", path.string()}};
  TRY(const Inspection content, inspect_content(path, result).with_file(path.string()));
  for (const auto& [key, value] : content.items()) result[key] = value;
  return result;
}

Inspection json_of(const math::Vec3& v) {
  return Inspection::array({v.x, v.y, v.z});
}

std::string describe_inspection(const Inspection& inspection) {
  std::string text;
  for (const auto& [key, value] : inspection.items()) {
    const bool is_list = value.is_array() && std::any_of(value.begin(), value.end(), [](const Inspection& v) {
                           return v.is_object() || v.is_string();
                         });
    if (value.is_object()) {
      text += key + ":\n";
      for (const auto& [name, part] : value.items())
        text += fmt::format("  {}: {}\n", base::printable(name), text_of(part));
    } else if (is_list) {
      text += key + ":\n";
      for (const Inspection& entry : value) text += fmt::format("  {}\n", one_line(entry));
    } else {
      text += fmt::format("{}: {}\n", key, value.is_array() && value.empty() ? "none" : text_of(value));
    }
  }
  return text;
}

}  // namespace temblor::app
