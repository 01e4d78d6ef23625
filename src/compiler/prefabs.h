// Prefabs: maps inside maps. Replaces each misc_external_map by the brushes of the map that it names. The
// entity and its keys are those of ericw-tools.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "base/function_ref.h"
#include "base/result.h"
#include "compiler/report.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

constexpr std::size_t kMaxPrefabDepth = 16;       // of prefabs within prefabs
constexpr std::size_t kMaxPrefabs = 1 << 16;      // in a map, at all depths together
constexpr std::size_t kMaxPrefabSides = 1 << 22;  // of the brushes of all prefabs together

// Returns the text of the .map at a path. expand_prefabs() fills in an error's file.
using ReadMapText = base::FunctionRef<base::Result<std::string>(const std::filesystem::path& path)>;

// Each misc_external_map of `map` becomes a brush entity:
//
//   _external_map            the file, relative to the folder of the map that names it (/ or \)
//   _external_map_classname  or _classname: the class that the entity gets. Missing: func_detail;
//                            worldspawn: func_group
//   _external_map_angles     "pitch yaw roll" in degrees, negative pitch is down; or only the yaw, as
//                            _external_map_angle or _angle
//   _external_map_scale      or _scale: one number or three; negative ones mirror
//   origin                   where the prefab's origin goes, after scaling and turning
//
// Its other keys stay. The file contributes the brushes of its worldspawn, func_group and func_detail
// entities and of its own prefabs. Brushes of func_illusionary_visblocker become one more such entity after
// the map's entities. Any other entities cause a warning. Textures stay in place on the brushes. Everything
// that comes from a prefab gets the line of the entity in `map`.
//
// Entities with "_omitbrushes" 1 lose their own brushes, in `map` and in prefabs: guides for the mapper, or
// parts that are not to be compiled now.
//
// Errors name the entity and its line, and inside a prefab the file; for maps that include each other, all of
// them. Fails with kTooLarge above the limits and for brushes beyond kMapMaxCoordinate.
base::Result<formats::Map> expand_prefabs(formats::Map map, const std::filesystem::path& map_path,
                                          ReadMapText read_text, Warnings& io_warnings);

}  // namespace temblor::compiler
