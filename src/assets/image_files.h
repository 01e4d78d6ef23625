// Pictures in TGA, PNG, and JPEG files, found by their names without extensions. The picture in the highest
// game folder wins; in one folder, .tga does, then .png, then .jpg.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "formats/images/image.h"
#include "vfs/file_system.h"

namespace temblor::assets {

// Finds STEM.tga, STEM.png, or STEM.jpg. Returns an empty name if there is none.
std::string find_image_file(const vfs::FileSystem& files, const std::string& stem);

// Whether the name has the extension of such a picture, in lower case.
bool is_image_file(std::string_view name);

// Reads one of these. Errors name the file.
base::Result<formats::Image> read_image_file(const vfs::FileSystem& files, std::string_view name);

}  // namespace temblor::assets
