// Detects the format of a file, and prints an inspection as text.
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
  kWav,
  kVis,
  kMd5Model,
  kMd5Animation,
  kMd3,
  kLux,
  kRegisteredMark,
  kCharacters
};

constexpr std::array<const char*, 23> kFormatNames = {
    "level",
    "colored light",
    "entity text",
    "PAK",
    "PK3",
    "WAD2",
    "picture",
    "palette",
    "colormap",
    "model",
    "sprite",
    "demo",
    "WAD3",
    "map",
    "compiled QuakeC",
    "sound",
    "visibility patches",
    "MD5 model",
    "MD5 animation",
    "MD3 model",
    "light directions",
    "mark of the registered game, a picture without a header",
    "console characters, a picture without a header"};

// Detects formats that start with a magic number.
std::optional<Format> detect_format_by_content(base::Bytes bytes) {
  struct Start {
    std::string_view bytes;
    Format format;
  };
  constexpr std::array<Start, 15> kStarts = {{{{"\x1d\0\0\0", 4}, Format::kBsp},
                                              {"BSP2", Format::kBsp},
                                              {"2PSB", Format::kBsp},
                                              {"QLIT", Format::kLit},
                                              {"PACK", Format::kPak},
                                              {"PK\x03\x04", Format::kPk3},
                                              {"PK\x05\x06", Format::kPk3},  // an empty archive
                                              {"WAD2", Format::kWad},
                                              {"WAD3", Format::kWad3},
                                              {"IDPO", Format::kMdl},
                                              {"IDP3", Format::kMd3},
                                              {"IDSP", Format::kSpr},
                                              {"RIFF", Format::kWav},
                                              {{"\x06\0\0\0", 4}, Format::kProgs},
                                              {"{", Format::kEntities}}};
  const std::string_view text = base::as_text(bytes);
  for (const Start& start : kStarts)
    if (text.starts_with(start.bytes)) return start.format;
  return std::nullopt;
}

// Detects formats without a magic number by name, *.lmp also by size. Also detects damaged files of all
// formats, so that their readers can say what is wrong.
std::optional<Format> detect_format_by_name(const std::filesystem::path& path, std::size_t size) {
  const std::string name = base::to_lower(path.filename().string());
  const std::string extension = base::to_lower(path.extension().string());
  if (extension == ".lmp") {
    if (name == "pop.lmp") return Format::kRegisteredMark;
    if (name == "conchars.lmp") return Format::kCharacters;
    if (name == "palette.lmp" || size == 768) return Format::kPalette;
    if (name == "colormap.lmp" || size == 16384 || size == 16385) return Format::kColormap;
    return Format::kPicture;
  }
  struct Extension {
    std::string_view text;
    Format format;
  };
  constexpr std::array<Extension, 17> kExtensions = {{{".bsp", Format::kBsp},
                                                      {".lit", Format::kLit},
                                                      {".lux", Format::kLux},
                                                      {".vis", Format::kVis},
                                                      {".ent", Format::kEntities},
                                                      {".pak", Format::kPak},
                                                      {".pk3", Format::kPk3},
                                                      {".wad", Format::kWad},
                                                      {".mdl", Format::kMdl},
                                                      {".md3", Format::kMd3},
                                                      {".md5mesh", Format::kMd5Model},
                                                      {".md5anim", Format::kMd5Animation},
                                                      {".spr", Format::kSpr},
                                                      {".dem", Format::kDem},
                                                      {".map", Format::kMap},
                                                      {".dat", Format::kProgs},
                                                      {".wav", Format::kWav}}};
  for (const Extension& known : kExtensions)
    if (extension == known.text) return known.format;
  return std::nullopt;
}

// Inspects a file that has been read into memory, which every format except PAK can be.
base::Result<Inspection> inspect_bytes(Format format, base::ByteVector bytes) {
  switch (format) {
    case Format::kBsp:
      return inspect_bsp(bytes);
    case Format::kLit:
      return inspect_lit(bytes);
    case Format::kLux:
      return inspect_lux(bytes);
    case Format::kVis:
      return inspect_vis(bytes);
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
    case Format::kRegisteredMark:
    case Format::kCharacters:
      return inspect_raw_picture(bytes);
    case Format::kPalette:
      return inspect_palette(bytes);
    case Format::kColormap:
      return inspect_colormap(bytes);
    case Format::kDem:
      return inspect_dem(bytes);
    case Format::kMdl:
      return inspect_mdl(bytes);
    case Format::kMd3:
      return inspect_md3(bytes);
    case Format::kMd5Model:
      return inspect_md5_model(bytes);
    case Format::kMd5Animation:
      return inspect_md5_animation(bytes);
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

// Reads up to four bytes; none if the file cannot be read.
base::ByteVector read_start(const std::filesystem::path& path) {
  constexpr std::streamsize kStartBytes = 4;
  base::ByteVector start(kStartBytes);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(start.data()), kStartBytes);
  start.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return start;
}

base::Result<Inspection> inspect_content(const std::filesystem::path& path, Inspection& io_header) {
  // Only the name decides about pictures, maps, and directions of light: a picture that is 29 pixels wide
  // starts like a level of version 29, a map like entity text, and directions like colored light.
  const std::string extension = base::to_lower(path.extension().string());
  const bool goes_by_name = extension == ".lmp" || extension == ".map" || extension == ".lux";
  std::optional<Format> format = goes_by_name ? std::nullopt : detect_format_by_content(read_start(path));
  base::ByteVector bytes;
  // A PAK may be larger than memory, so it is not read here.
  if (format != Format::kPak) {
    TRY(bytes, vfs::read_disk_file(path));
    if (!format) format = detect_format_by_name(path, bytes.size());
  }
  if (!format)
    return base::error(
        ErrorCode::kUnsupported,
        "unknown format; known are .bsp, .map, .lit, .lux, .vis, .ent, .pak, .pk3, .wad, .lmp, "
        ".mdl, .md3, .md5mesh, .md5anim, .spr, .dem, "
        ".dat, and .wav");
  io_header["format"] = kFormatNames[static_cast<std::size_t>(*format)];
  return *format == Format::kPak ? inspect_pak(path) : inspect_bytes(*format, std::move(bytes));
}

// Formats a text without quotes, any other value as JSON.
std::string format_value(const Inspection& value) {
  return base::printable(value.is_string() ? value.get<std::string>() : value.dump());
}

// Formats an object as "name: x  bytes: 12", any other value as itself.
std::string format_line(const Inspection& value) {
  if (!value.is_object()) return format_value(value);
  std::string line;
  for (const auto& [key, part] : value.items())
    line += fmt::format("{}{}: {}", line.empty() ? "" : "  ", key, format_value(part));
  return line;
}

}  // namespace

base::Result<Inspection> inspect_file(const std::filesystem::path& path) {
  Inspection result = {{"file", path.string()}};
  TRY(const Inspection content, inspect_content(path, result).with_file(path.string()));
  for (const auto& [key, value] : content.items()) result[key] = value;
  return result;
}

Inspection make_json(const math::Vec3& v) {
  return Inspection::array({v.x, v.y, v.z});
}

// Lists of numbers stay on one line; lists of texts and objects get one line per entry.
std::string describe_inspection(const Inspection& inspection) {
  std::string text;
  for (const auto& [key, value] : inspection.items()) {
    const bool is_list = value.is_array() && std::any_of(value.begin(), value.end(), [](const Inspection& v) {
                           return v.is_object() || v.is_string();
                         });
    if (value.is_object()) {
      text += key + ":\n";
      for (const auto& [name, part] : value.items())
        text += fmt::format("  {}: {}\n", base::printable(name), format_value(part));
    } else if (is_list) {
      text += key + ":\n";
      for (const Inspection& entry : value) text += fmt::format("  {}\n", format_line(entry));
    } else {
      text += fmt::format("{}: {}\n", key, value.is_array() && value.empty() ? "none" : format_value(value));
    }
  }
  return text;
}

}  // namespace temblor::app
