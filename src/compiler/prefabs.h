// Maps inside maps: misc_external_map replaced by the brushes of the map that it names.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "base/function_ref.h"
#include "base/result.h"
#include "compiler/report.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

constexpr std::size_t kMaxPrefabDepth = 16;       // prefabs within prefabs
constexpr std::size_t kMaxPrefabs = 1 << 16;      // in a map, all depths together
constexpr std::size_t kMaxPrefabSides = 1 << 22;  // of brushes, likewise

// The text of the .map at a path; an error's file is filled in here.
using ReadMapText = base::FunctionRef<base::Result<std::string>(const std::filesystem::path& path)>;

// Each misc_external_map of `map` becomes a brush entity in its place:
//   _external_map            the file, seen from the folder of the map that names it (backslashes are
//   folders' too) _external_map_classname  or _classname: what the entity becomes; func_detail when missing.
//   worldspawn means
//                            func_group
//   _external_map_angles     "pitch yaw roll" in degrees, a negative pitch is down; or _external_map_angle or
//                            _angle: the yaw alone
//   _external_map_scale      or _scale: one number, or three; negative ones mirror
//   origin                   where the prefab's own origin comes to lie: after scaling, then turning
// Its other keys stay. Taken from the file are the brushes of worldspawn, func_group, func_detail and its
// kinds, and of prefabs that it names in turn; those of func_illusionary_visblocker become one behind the
// map's entities. That it has other entities is a warning. Textures stay where
// they were on the brushes. Lines of what came from a prefab are that of the entity in `map`.
//
// Errors name the entity and the line; in a prefab also its file; for files that name each other in a circle,
// all of them. kTooLarge above the limits here, and for a brush that comes to lie beyond kMapMaxCoordinate.
base::Result<formats::Map> expand_prefabs(formats::Map map, const std::filesystem::path& map_path,
                                          ReadMapText read_text, Warnings& io_warnings);

}  // namespace temblor::compiler
