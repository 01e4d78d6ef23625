// The skins of MD3 and MD5 models: pictures next to the model, by the names in its file. NN is the number of
// the skin and MM that of the picture in an animated skin, as the 2021 release names them:
//
//   NAME_NN_MM.tga, .png, .jpg, .lmp      skin NN, from 00_00 on as long as there are files
//   NAME.tga, .png, .jpg, .lmp            skin K, if the file has a name for skin K
//
// A NAME without a folder is in the folder of the model. So is a NAME with a folder that is not there, since
// modelers often leave the path on their own disk in the file. The picture in the highest game folder wins,
// then the order above. Pictures in color are matched to the palette without its full-bright colors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/models/posed_model.h"
#include "vfs/file_system.h"

namespace temblor::assets {

// Limits: the numbers in names have two digits.
constexpr std::size_t kMaxSkins = 100, kMaxSkinPictures = 100;

// Returns the skins of the model, at least one, each with a picture for each mesh and member. A mesh without
// a picture of its own for a skin shows that of its first. A mesh without any, or with a damaged one, gets a
// checkerboard, and a line in `io_problems` that names the file.
std::vector<formats::PosedSkin> load_skins(const vfs::FileSystem& files, std::string_view model_path,
                                           const std::vector<formats::PosedMesh>& meshes,
                                           std::vector<std::string>& io_problems);

}  // namespace temblor::assets
