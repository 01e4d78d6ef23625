// Loads the assets of a game by the names that game code and servers use: levels, models, sprites, sky boxes,
// sounds, music, pictures.
//
// Each call reads and validates the file; nothing is cached, so callers keep what they need. Names may come
// from a server; vfs::FileSystem rejects names that leave the game folders. Errors name the file, or the
// archive and the file in it. Const functions are thread-safe.
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

// Only the registered version of Quake contains this file. Stock engines set the variable `registered` by it.
constexpr std::string_view kRegisteredMark = "gfx/pop.lmp";

// A track that is decoded while it plays, so its bytes are read later.
struct MusicFile {
  std::string name;  // source of the file, for messages
  // Reads the encoded file. Blocks on the disk; callable from any thread, even after the library is
  // destroyed.
  std::function<base::Result<base::ByteVector>()> read;
};

class Library {
 public:
  explicit Library(vfs::FileSystem files) : files_(std::move(files)) {}

  // `path`: as in QuakeC: "maps/start.bsp", "progs/ogre.mdl", "progs/s_explod.spr". Return kNotFound for a
  // missing file, kMalformed or kUnsupported for one that its reader rejects.
  base::Result<LoadedLevel> level(std::string_view path, const LevelOptions& options = {}) const;
  base::Result<formats::Mdl> alias_model(std::string_view path) const;
  // The same, with the pictures in color that replace skins (models/external_skins.h). A damaged one is
  // ignored, with a note.
  base::Result<formats::Mdl> alias_model_with_skins(std::string_view path,
                                                    std::vector<std::string>& io_notes) const;
  base::Result<formats::Spr> sprite(std::string_view path) const;
  // Loads gfx/env/NAMErt.tga and so on, or .png, or .jpg: right (+x), back, left, front, up, down. Missing
  // and damaged sides are empty images (0 x 0), with a line in `io_notes` for each, or one for all six.
  std::array<formats::Image, 6> skybox(std::string_view name, std::vector<std::string>& io_notes) const;
  // `path`: a PNG file, such as "gfx/marks/smile.png".
  base::Result<formats::Image> image(std::string_view path) const;
  // `name`: as in QuakeC, relative to sound/: "weapons/rocket1i.wav".
  base::Result<formats::Wav> sound(std::string_view name) const;
  // Finds music/trackNN with the extension .ogg, .opus, .flac, .mp3, or .wav (first match) in the highest
  // game folder. Returns kNotFound if there is none, which is common.
  base::Result<MusicFile> music(int track) const;
  // Finds music/trackNN_combat, which plays together with the track in combat. It must be in the same game
  // folder as the track, since a mod's music does not fit the layers of another game.
  std::optional<MusicFile> combat_layer(int track) const;
  base::Result<Look> look() const { return load_look(files_); }
  Pictures pictures(std::vector<std::string>& io_notes) const { return Pictures::load(files_, io_notes); }
  const vfs::FileSystem& files() const { return files_; }

 private:
  // `stem`: without the extension. Returns the file's name, or nothing if there is none.
  std::string find_music(std::string_view stem) const;

  vfs::FileSystem files_;
};

}  // namespace temblor::assets
