#include "assets/pictures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <span>
#include <utility>

#include "assets/images/external_pictures.h"
#include "assets/library.h"
#include "assets/stock/stock_pictures.h"
#include "base/text.h"
#include "formats/archives/wad.h"

namespace temblor::assets {
namespace {

constexpr std::string_view kWad = "gfx.wad", kCharacters = "conchars";
constexpr std::uint32_t kCharactersSide = 128;  // pixels

using PictureMap = std::map<std::string, formats::Picture, std::less<>>;

// Makes a checkerboard of the two ends of the palette's first row, in squares of 4 x 4 pixels.
formats::Picture make_checker(std::uint32_t width, std::uint32_t height) {
  constexpr std::uint8_t kDark = 0, kLight = 15;
  formats::Picture picture{width, height, {}};
  picture.pixels.reserve(std::size_t{width} * height);
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      picture.pixels.push_back((x / 4 + y / 4) % 2 == 0 ? kDark : kLight);
  return picture;
}

// Loads the pictures and the font of gfx.wad. Skips damaged pictures, and names them in `io_bad`. The font
// has no header. Other engines find pictures by name, so those of another type are loaded too; an unreadable
// lump of such a type is no picture.
void load_wad(const vfs::FileSystem& files, PictureMap& io_pictures,
              std::optional<formats::Picture>& out_characters, std::vector<std::string>& io_bad) {
  const base::Result<base::ByteVector> bytes = files.read(kWad);
  if (!bytes.ok()) return;  // no gfx.wad
  const base::Result<std::vector<formats::WadLump>> lumps = formats::read_wad(*bytes);
  if (!lumps.ok()) {
    io_bad.push_back(lumps.error().message());
    return;
  }
  for (const formats::WadLump& lump : *lumps) {
    const std::string name = base::to_lower(lump.name);
    const bool is_characters = name == kCharacters;
    base::Result<formats::Picture> picture =
        is_characters ? formats::read_conchars(lump.data) : formats::read_picture(lump.data);
    if (!picture.ok() && !is_characters && lump.type != formats::kWadPicture) continue;
    if (!picture.ok())
      io_bad.push_back(fmt::format("{}: {}", base::printable(name), picture.error().message()));
    else if (is_characters)
      out_characters = std::move(picture).value();
    else
      io_pictures.emplace(name, std::move(picture).value());  // the first with a name wins, as in find_lump()
  }
}

// These have the extension of pictures, but another layout: palette.h describes two of them, and the third is
// the mark of the registered game.
bool is_no_picture(std::string_view name) {
  return name == "gfx/palette.lmp" || name == "gfx/colormap.lmp" || name == kRegisteredMark;
}

// Loads the pictures that are separate files. Their names cannot collide with those of lumps, which have no
// folder.
void load_files(const vfs::FileSystem& files, PictureMap& io_pictures, std::vector<std::string>& io_bad) {
  for (const std::string& name : files.list("gfx/", ".lmp")) {
    if (is_no_picture(name)) continue;
    const base::Result<base::ByteVector> bytes = files.read(name);
    base::Result<formats::Picture> picture =
        bytes.ok() ? formats::read_picture(*bytes) : base::Result<formats::Picture>(bytes.error());
    if (picture.ok())
      io_pictures.emplace(name, std::move(picture).value());
    else
      io_bad.push_back(fmt::format("{}: {}", base::printable(name), picture.error().message()));
  }
}

// Adds a placeholder for each stock picture that was not loaded.
void add_placeholders(std::span<const StockPicture> stock, PictureMap& io_pictures,
                      std::vector<std::string>& io_missing) {
  for (const StockPicture& picture : stock)
    if (io_pictures.emplace(picture.name, formats::Picture{}).second) {
      io_pictures[picture.name] = make_checker(picture.width, picture.height);
      io_missing.push_back(picture.name);
    }
}

// Joins at most 8 names for a message, and says how many more there are.
std::string join_first_names(std::vector<std::string> names) {
  constexpr std::size_t kShown = 8;
  const std::size_t count = names.size();
  if (count > kShown) {
    names.resize(kShown);
    names.push_back(fmt::format("and {} more", count - kShown));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

// Damaged and missing pictures are noted in one line, because a game without gfx.wad
// would otherwise fill the console.
Pictures Pictures::load(const vfs::FileSystem& files, std::vector<std::string>& io_notes) {
  Pictures loaded;
  std::vector<std::string> bad, bad_details, missing;
  std::optional<formats::Picture> characters;
  load_wad(files, loaded.pictures_, characters, bad);
  load_files(files, loaded.pictures_, bad);
  if (!characters) missing.emplace_back(kCharacters);
  loaded.characters_ = characters ? std::move(*characters) : make_checker(kCharactersSide, kCharactersSide);
  add_placeholders(stock_wad_pictures(), loaded.pictures_, missing);
  add_placeholders(stock_picture_files(), loaded.pictures_, missing);
  for (const std::string& name : add_details(
           files, [&](std::string_view name) { return loaded.find_own(name); }, bad_details))
    std::erase(missing, name);
  loaded.placeholders_.insert(missing.begin(), missing.end());

  std::string note;
  if (!missing.empty())
    note = fmt::format("missing pictures, drawn as a checkerboard: {}", join_first_names(missing));
  if (!bad.empty())
    note += fmt::format("{}damaged: {}", note.empty() ? "pictures " : "; ", join_first_names(bad));
  if (!note.empty()) io_notes.push_back(fmt::format("{}: {}", files.describe(kWad), note));
  if (!bad_details.empty())
    io_notes.push_back(fmt::format("pictures damaged: {}", join_first_names(bad_details)));
  return loaded;
}

formats::Picture* Pictures::find_own(std::string_view name) {
  if (name == kCharacters) return &characters_;
  const auto found = pictures_.find(name);
  return found == pictures_.end() ? nullptr : &found->second;
}

const formats::Picture* Pictures::find(std::string_view name) const {
  const auto found = pictures_.find(name);
  if (found != pictures_.end()) return &found->second;
  const auto lower = pictures_.find(base::to_lower(name));
  return lower == pictures_.end() ? nullptr : &lower->second;
}

const formats::Picture* Pictures::find_real(std::string_view name) const {
  return placeholders_.contains(base::to_lower(name)) ? nullptr : find(name);
}

}  // namespace temblor::assets
