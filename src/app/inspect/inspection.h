// Inspects files: one function per format returns a JSON object with its keys in printing order. The
// functions only read with the formats library and count; they use nothing of the game.
//
//   file -> detect the format -> inspect_*() -> JSON object -> describe_inspection() -> text
//
// The key "problems" is a list of texts about faults that the game tolerates. A file that its reader rejects
// is an error. Scripts depend on the keys, so they are stable; the texts are for people.
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
base::Result<Inspection> inspect_lux(base::Bytes bytes);
base::Result<Inspection> inspect_vis(base::Bytes bytes);
base::Result<Inspection> inspect_entities(base::Bytes bytes);
base::Result<Inspection> inspect_map(base::Bytes bytes);
// Reads only the directory, because a PAK may be larger than memory.
base::Result<Inspection> inspect_pak(const std::filesystem::path& path);
base::Result<Inspection> inspect_pk3(base::ByteVector bytes);
base::Result<Inspection> inspect_wad(base::Bytes bytes);
base::Result<Inspection> inspect_picture(base::Bytes bytes);
base::Result<Inspection> inspect_raw_picture(base::Bytes bytes);
base::Result<Inspection> inspect_palette(base::Bytes bytes);
base::Result<Inspection> inspect_colormap(base::Bytes bytes);
base::Result<Inspection> inspect_dem(base::Bytes bytes);
base::Result<Inspection> inspect_mdl(base::Bytes bytes);
base::Result<Inspection> inspect_md3(base::Bytes bytes);
base::Result<Inspection> inspect_md5_model(base::Bytes bytes);
base::Result<Inspection> inspect_md5_animation(base::Bytes bytes);
base::Result<Inspection> inspect_spr(base::Bytes bytes);
base::Result<Inspection> inspect_wav(base::Bytes bytes);
base::Result<Inspection> inspect_progs(base::Bytes bytes);

// Inspects a file of any of these formats. The format is detected by the first bytes or, where they are not
// unique (pictures, palettes, entity text), by name and size. kUnsupported for an unknown format. The object
// starts with "file" and "format".
base::Result<Inspection> inspect_file(const std::filesystem::path& path);

// Returns [x, y, z].
Inspection make_json(const math::Vec3& v);

// Formats an inspection as text: "key: value" lines, and lists with one line per entry.
std::string describe_inspection(const Inspection& inspection);

}  // namespace temblor::app
