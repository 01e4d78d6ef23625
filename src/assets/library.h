// Everything that a game's files hold, by name, loaded and checked. Errors name the file.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/assets.h"
#include "assets/pictures.h"
#include "base/result.h"
#include "formats/images/image.h"
#include "formats/models/mdl.h"
#include "formats/models/spr.h"
#include "formats/sounds/wav.h"
#include "vfs/file_system.h"

namespace temblor::assets {

struct MusicFile {
  std::string name;  // for messages: where it was found
  // Undecoded. Takes as long as the disk does; by any thread, even when the library is gone.
  std::function<base::Result<base::ByteVector>()> read;
};

class Library {
 public:
  explicit Library(vfs::FileSystem files) : files_(std::move(files)) {}

  // `path` as game code names it: "maps/start.bsp", "progs/ogre.mdl", "progs/s_explod.spr".
  base::Result<LoadedLevel> level(std::string_view path) const;
  base::Result<formats::Mdl> alias_model(std::string_view path) const;
  base::Result<formats::Spr> sprite(std::string_view path) const;
  // gfx/env/NAMErt.tga and so on, or .png: right, back, left, front, up, down; the names' right is +x. Sides
  // that are missing or damaged are empty, with a line in `io_notes` for each.
  std::array<formats::Image, 6> skybox(std::string_view name, std::vector<std::string>& io_notes) const;
  // `name` without its folder, as game code gives it: "weapons/rocket1i.wav" is sound/weapons/rocket1i.wav.
  base::Result<formats::Wav> sound(std::string_view name) const;
  // music/trackNN.ogg, or .opus, .flac, .mp3, .wav: the first there is, of the highest game folder. kNotFound
  // where there is none, which is common.
  base::Result<MusicFile> music(int track) const;
  base::Result<Look> look() const { return load_look(files_); }
  Pictures pictures(std::vector<std::string>& io_notes) const { return Pictures::load(files_, io_notes); }
  const vfs::FileSystem& files() const { return files_; }

 private:
  vfs::FileSystem files_;
};

}  // namespace temblor::assets
