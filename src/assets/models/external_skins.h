// Pictures in color that replace the skins of an MDL model. In the order of precedence:
//
//   progs/NAME.mdl_N     skin N of progs/NAME.mdl, from 0 on
//   progs/NAME_N
//
// assets/image_files.h lists the extensions. A picture in a lower game folder than the model's is ignored.
// The picture of an animated skin replaces all of its pictures.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/models/mdl.h"
#include "vfs/file_system.h"

namespace temblor::assets {

// Matches the pictures to the palette without its full-bright colors. If they have more texels than the
// skins, all skins are enlarged, by a whole factor of at most 8. A damaged picture is ignored, with a note.
void replace_skins(const vfs::FileSystem& files, std::string_view model_path, formats::Mdl& io_mdl,
                   std::vector<std::string>& io_notes);

}  // namespace temblor::assets
