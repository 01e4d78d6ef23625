#include "assets/library.h"

#include <fmt/format.h>

namespace temblor::assets {
namespace {

// "maps/NAME.bsp" -> "NAME"; nothing for a path of another shape.
std::optional<std::string_view> map_name_of(std::string_view path) {
  constexpr std::string_view kFolder = "maps/", kSuffix = ".bsp";
  if (!path.starts_with(kFolder) || !path.ends_with(kSuffix)) return std::nullopt;
  path.remove_prefix(kFolder.size());
  path.remove_suffix(kSuffix.size());
  return path;
}

template <typename T>
base::Result<T> read_as(const vfs::FileSystem& files, std::string_view path,
                        base::Result<T> (*read)(base::Bytes)) {
  TRY(const base::ByteVector bytes, files.read(path));
  return read(bytes).with_file(files.describe(path));
}

// One side, in whichever format there is; TGA, which the game of the time knew, first.
base::Result<formats::Image> read_side(const vfs::FileSystem& files, const std::string& stem) {
  if (files.contains(stem + ".tga") || !files.contains(stem + ".png"))
    return read_as(files, stem + ".tga", formats::read_tga);
  return read_as(files, stem + ".png", formats::read_png);
}

}  // namespace

base::Result<LoadedLevel> Library::level(std::string_view path) const {
  const std::optional<std::string_view> name = map_name_of(path);
  if (!name) {
    base::Error error = base::error(base::ErrorCode::kUsage, "is not the name of a level, maps/NAME.bsp");
    error.file = path;
    return error;
  }
  return load_level(files_, *name);
}

base::Result<formats::Mdl> Library::alias_model(std::string_view path) const {
  return read_as(files_, path, formats::read_mdl);
}

base::Result<formats::Spr> Library::sprite(std::string_view path) const {
  return read_as(files_, path, formats::read_spr);
}

base::Result<formats::Wav> Library::sound(std::string_view name) const {
  return read_as(files_, fmt::format("sound/{}", name), formats::read_wav);
}

base::Result<MusicFile> Library::music(int track) const {
  const std::string stem = fmt::format("music/track{:02}", track);
  std::string best;
  for (const char* suffix : {".ogg", ".opus", ".flac", ".mp3", ".wav"}) {
    const std::string name = stem + suffix;
    if (files_.contains(name) && (best.empty() || files_.game_of(name) > files_.game_of(best))) best = name;
  }
  if (best.empty()) {
    base::Error error = base::error(base::ErrorCode::kNotFound, "there is no such file in music/");
    error.file = stem;
    return error;
  }
  return MusicFile{files_.describe(best), files_.reader(best)};
}

std::array<formats::Image, 6> Library::skybox(std::string_view name,
                                              std::vector<std::string>& io_notes) const {
  constexpr std::array<const char*, 6> kSuffixes = {"rt", "bk", "lf", "ft", "up", "dn"};
  std::array<formats::Image, 6> sides;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    base::Result<formats::Image> side = read_side(files_, fmt::format("gfx/env/{}{}", name, kSuffixes[i]));
    if (side.ok())
      sides[i] = std::move(side).value();
    else
      io_notes.push_back(fmt::format("{}; this side of the sky stays empty", side.error().message()));
  }
  return sides;
}

}  // namespace temblor::assets
