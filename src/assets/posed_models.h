// Loads MD3 and MD5 models with their skins, which are files of their own.
//
//   progs/ogre.md5mesh + progs/ogre.md5anim -> formats::pose_md5() --+
//                                                                    +--> formats::PosedModel
//   models/gem.md3 -----------------------> formats::pose_md3() -----+
//   progs/SHADER_00_00.lmp and so on (models/skins.h) ---------------+
//
// The 2021 release has an MD5 model for each MDL file, and its server still loads the MDL file: the frame
// numbers of game code, frame groups, and effects come from there.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/models/posed_model.h"
#include "vfs/file_system.h"

namespace temblor::assets {

// Whether game code that precaches this name means an MD3 or MD5 model: it ends with .md3 or .md5mesh.
bool is_posed_model(std::string_view path);

// Loads "models/gem.md3" or "progs/ogre.md5mesh". Missing and damaged skins are checkerboards, with a line in
// `io_notes` for each. Errors name the file.
base::Result<formats::PosedModel> load_posed_model(const vfs::FileSystem& files, std::string_view path,
                                                   std::vector<std::string>& io_notes);

// Loads the MD5 model that replaces the MDL file `path`, "progs/ogre.mdl", with its frames and effects.
// Returns nullopt if there is none, or only that of a lower game: a mod's model must not become an older
// game's. Fails for a missing or damaged skin too. Errors name the file.
base::Result<std::optional<formats::PosedModel>> load_md5_replacement(const vfs::FileSystem& files,
                                                                      std::string_view path,
                                                                      const formats::Mdl& mdl);

// Returns the box of an MD3 or MD5 model in all of its frames, without loading skins. For servers.
base::Result<math::Bounds> measure_posed_model(const vfs::FileSystem& files, std::string_view path);

}  // namespace temblor::assets
