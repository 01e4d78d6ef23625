// What files hold: one function a format, each giving a JSON object whose keys are in the order to print
// them in. The key "problems" lists what is readable but wrong, a line each; an error is what a reader says
// of a file that it refuses.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/bytes.h"
#include "base/result.h"
#include "math/vec.h"

namespace temblor::app {

using Inspection = nlohmann::ordered_json;

base::Result<Inspection> inspect_bsp(base::Bytes bytes);
base::Result<Inspection> inspect_lit(base::Bytes bytes);
base::Result<Inspection> inspect_entities(base::Bytes bytes);
base::Result<Inspection> inspect_map(base::Bytes bytes);
// Reads the table only: a PAK may be larger than memory.
base::Result<Inspection> inspect_pak(const std::filesystem::path& path);
base::Result<Inspection> inspect_pk3(base::ByteVector bytes);
base::Result<Inspection> inspect_wad(base::Bytes bytes);
base::Result<Inspection> inspect_picture(base::Bytes bytes);
base::Result<Inspection> inspect_palette(base::Bytes bytes);
base::Result<Inspection> inspect_colormap(base::Bytes bytes);
base::Result<Inspection> inspect_dem(base::Bytes bytes);
base::Result<Inspection> inspect_mdl(base::Bytes bytes);
base::Result<Inspection> inspect_spr(base::Bytes bytes);
base::Result<Inspection> inspect_wav(base::Bytes bytes);
base::Result<Inspection> inspect_progs(base::Bytes bytes);

// Any of them: the format is found from the file's first bytes, and where they say nothing (pictures,
// palettes, entity text) from its name and size. kUnsupported for a file of no known format. The object
// starts with "file" and "format".
base::Result<Inspection> inspect_file(const std::filesystem::path& path);

// [x, y, z]
Inspection json_of(const math::Vec3& v);

// As lines of text: "key: value", lists with an entry a line.
std::string describe_inspection(const Inspection& inspection);

}  // namespace temblor::app
