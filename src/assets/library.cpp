#include "assets/library.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "assets/image_files.h"
#include "assets/models/external_skins.h"
#include "base/text.h"

namespace temblor::assets {
namespace {

// Converts "maps/NAME.bsp" to "NAME"; returns nullopt for other paths.
std::optional<std::string_view> parse_map_name(std::string_view path) {
  constexpr std::string_view kFolder = "maps/", kSuffix = ".bsp";
  if (!path.starts_with(kFolder) || !path.ends_with(kSuffix)) return std::nullopt;
  path.remove_prefix(kFolder.size());
  path.remove_suffix(kSuffix.size());
  return path;
}

// Reads a file and parses it with `read`, whose errors do not name the file yet.
template <typename T>
base::Result<T> read_as(const vfs::FileSystem& files, std::string_view path,
                        base::Result<T> (*read)(base::Bytes)) {
  TRY(const base::ByteVector bytes, files.read(path));
  return read(bytes).with_file(files.describe(path));
}

// Reports a missing side as the .tga, the only format of older engines.
base::Result<formats::Image> read_side(const vfs::FileSystem& files, const std::string& stem) {
  const std::string found = find_image_file(files, stem);
  return read_image_file(files, found.empty() ? stem + ".tga" : found);
}

}  // namespace

// Splits the path, because load_level() also needs the name for the .lit file.
base::Result<LoadedLevel> Library::level(std::string_view path, const LevelOptions& options) const {
  const std::optional<std::string_view> name = parse_map_name(path);
  if (!name) {
    base::Error error =
        base::error(base::ErrorCode::kUsage, "not a level name; level names look like maps/NAME.bsp");
    error.file = path;
    return error;
  }
  return load_level(files_, *name, options);
}

base::Result<formats::Mdl> Library::alias_model(std::string_view path) const {
  return read_as(files_, path, formats::read_mdl);
}

base::Result<formats::Mdl> Library::alias_model_with_skins(std::string_view path,
                                                           std::vector<std::string>& io_notes) const {
  TRY(formats::Mdl mdl, alias_model(path));
  replace_skins(files_, path, mdl, io_notes);
  return mdl;
}

base::Result<formats::Spr> Library::sprite(std::string_view path) const {
  return read_as(files_, path, formats::read_spr);
}

base::Result<formats::Image> Library::image(std::string_view path) const {
  return read_as(files_, path, formats::read_png);
}

base::Result<formats::Wav> Library::sound(std::string_view name) const {
  return read_as(files_, fmt::format("sound/{}", name), formats::read_wav);
}

// The game folder takes precedence over the format, so that a mod's .mp3 replaces the .ogg of id1.
std::string Library::find_music(std::string_view stem) const {
  std::string best;
  for (const char* suffix : {".ogg", ".opus", ".flac", ".mp3", ".wav"}) {
    const std::string name = fmt::format("{}{}", stem, suffix);
    if (files_.contains(name) && (best.empty() || files_.find_game(name) > files_.find_game(best)))
      best = name;
  }
  return best;
}

base::Result<MusicFile> Library::music(int track) const {
  const std::string stem = fmt::format("music/track{:02}", track);
  const std::string name = find_music(stem);
  if (name.empty()) {
    base::Error error =
        base::error(base::ErrorCode::kNotFound, "no such file in music/ (.ogg, .opus, .flac, .mp3, or .wav)");
    error.file = stem;
    return error;
  }
  return MusicFile{files_.describe(name), files_.reader(name)};
}

std::optional<MusicFile> Library::combat_layer(int track) const {
  const std::string stem = fmt::format("music/track{:02}", track);
  const std::string piece = find_music(stem), layer = find_music(stem + "_combat");
  if (piece.empty() || layer.empty() || files_.find_game(piece) != files_.find_game(layer)) return {};
  return MusicFile{files_.describe(layer), files_.reader(layer)};
}

std::array<formats::Image, 6> Library::skybox(std::string_view name,
                                              std::vector<std::string>& io_notes) const {
  // In the order of the sides that the header documents.
  constexpr std::array<const char*, 6> kSuffixes = {"rt", "bk", "lf", "ft", "up", "dn"};
  std::array<formats::Image, 6> sides;
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    base::Result<formats::Image> side = read_side(files_, fmt::format("gfx/env/{}{}", name, kSuffixes[i]));
    if (side.ok())
      sides[i] = std::move(side).value();
    else
      notes.push_back(fmt::format("{}; this side of the sky is empty", side.error().message()));
  }
  if (notes.size() == sides.size())
    io_notes.push_back(fmt::format(
        "sky \"{0}\": there is no picture gfx/env/{0}rt.tga, or of another side; the level's own sky "
        "is drawn",
        base::printable(name)));
  else
    std::ranges::move(notes, std::back_inserter(io_notes));
  return sides;
}

}  // namespace temblor::assets
