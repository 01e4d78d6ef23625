// Method: depth-first. The chain of files that are being expanded finds maps that include each other; each
// file is read once, however often it is used. Transformations of nested prefabs are multiplied on the way
// down.
#include "compiler/prefabs.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/light/sources/keys.h"
#include "compiler/textures/texture_lock.h"
#include "math/angles.h"

namespace temblor::compiler {
namespace {

using base::ErrorCode;
using math::Vec3d;
namespace fs = std::filesystem;

constexpr std::string_view kPrefab = "misc_external_map";
constexpr std::string_view kVisBlocker = "func_illusionary_visblocker";

void omit_brushes(formats::Map& io_map) {
  for (formats::MapEntity& entity : io_map.entities)
    if (read_number_or(entity.fields, "omitbrushes", 0) > 0) entity.brushes.clear();
}

// The request of a misc_external_map.
struct PrefabUse {
  fs::path file;
  Placement placement;
};

// The entity that a message is about.
struct Site {
  std::string file;  // empty: the map itself
  std::size_t number;
  std::uint32_t line;

  template <typename... Args>
  base::Error fail(ErrorCode code, fmt::format_string<Args...> format, Args&&... args) const {
    return {code,
            fmt::format("entity {} ({}), line {}: {}", number, kPrefab, line,
                        fmt::format(format, std::forward<Args>(args)...)),
            file};
  }
};

using PrefabKeys = std::array<std::string_view, 2>;
constexpr PrefabKeys kClassnameKeys{"_external_map_classname", "_classname"};
constexpr PrefabKeys kAnglesKeys{"_external_map_angles", "_angles"};
constexpr PrefabKeys kAngleKeys{"_external_map_angle", "_angle"};
constexpr PrefabKeys kScaleKeys{"_external_map_scale", "_scale"};

// Returns the first of the keys that the entity has.
std::optional<std::string_view> find_key(const formats::Entity& fields, const PrefabKeys& keys) {
  const auto key = std::ranges::find_if(keys, [&](std::string_view k) { return fields.find(k).has_value(); });
  return key == keys.end() ? std::nullopt : std::optional(*key);
}

// Both keys may be there: the three angles win over the single one.
base::Result<Vec3d> read_angles(const formats::Entity& fields, const Site& site) {
  if (const auto key = find_key(fields, kAnglesKeys)) {
    if (const auto angles_deg = fields.find_vec3(*key)) return Vec3d(*angles_deg);
    return site.fail(ErrorCode::kMalformed, "{} must be three numbers: pitch yaw roll", *key);
  }
  if (const auto key = find_key(fields, kAngleKeys)) {
    if (const auto yaw_deg = fields.find_number(*key)) return Vec3d(0, *yaw_deg, 0);
    return site.fail(ErrorCode::kMalformed, "{} must be one number, the yaw", *key);
  }
  return Vec3d(0.0);
}

base::Result<Vec3d> read_scale(const formats::Entity& fields, const Site& site) {
  const auto key = find_key(fields, kScaleKeys);
  if (!key) return Vec3d(1.0);
  std::optional<Vec3d> scale;
  if (const auto number = fields.find_number(*key)) scale = Vec3d(*number);
  if (const auto numbers = fields.find_vec3(*key)) scale = Vec3d(*numbers);
  if (!scale || scale->x * scale->y * scale->z == 0)
    return site.fail(ErrorCode::kMalformed, "{} must be one number or three, and none may be 0", *key);
  return *scale;
}

base::Result<Vec3d> read_origin(const formats::Entity& fields, const Site& site) {
  if (!fields.find("origin")) return Vec3d(0.0);
  if (const auto origin = fields.find_vec3("origin")) return Vec3d(*origin);
  return site.fail(ErrorCode::kMalformed, "origin must be three numbers");
}

Placement make_placement(const Vec3d& angles_deg, const Vec3d& scale, const Vec3d& origin) {
  // Unlike angles in the game, a prefab's negative pitch looks down.
  const math::Basis basis = math::basis_from_angles(math::Vec3(-angles_deg.x, angles_deg.y, angles_deg.z));
  Placement placement{{basis.forward, -basis.right, basis.up}, origin};
  for (int axis = 0; axis < 3; ++axis) {
    Vec3d& column = placement.columns[static_cast<std::size_t>(axis)];
    // Quarter turns are exact, so that brushes on the grid stay on it.
    for (int i = 0; i < 3; ++i)
      if (constexpr double kRounding = 1e-9; std::abs(column[i] - std::round(column[i])) < kRounding)
        column[i] = std::round(column[i]);
    column *= scale[axis];
  }
  return placement;
}

base::Result<PrefabUse> read_use(const formats::Entity& fields, const fs::path& named_by, const Site& site) {
  std::string name(fields.find("_external_map").value_or(""));
  if (name.empty()) return site.fail(ErrorCode::kMalformed, "set _external_map to the file of the prefab");
  std::ranges::replace(name, '\\', '/');
  TRY(const Vec3d angles_deg, read_angles(fields, site));
  TRY(const Vec3d scale, read_scale(fields, site));
  TRY(const Vec3d origin, read_origin(fields, site));
  return PrefabUse{(named_by.parent_path() / name).lexically_normal(),
                   make_placement(angles_deg, scale, origin)};
}

bool is_prefab(const formats::MapEntity& entity) {
  return entity.fields.classname() == kPrefab;
}

// Whether its brushes become part of the entity that uses the prefab.
bool contributes_brushes(const formats::MapEntity& entity) {
  const std::string_view name = entity.fields.classname();
  return name == "worldspawn" || name == "func_group" || name.starts_with("func_detail");
}

// Whether its brushes keep their class, since they must not become solid.
bool keeps_classname(const formats::MapEntity& entity) {
  return entity.fields.classname() == kVisBlocker;
}

// The resulting entity's keys: the new classname, and all keys that were not used up.
formats::Entity make_result_fields(const formats::Entity& fields) {
  const auto key = find_key(fields, kClassnameKeys);
  std::string classname(key ? *fields.find(*key) : "func_detail");
  if (classname == "worldspawn") classname = "func_group";
  formats::Entity result{{{"classname", std::move(classname)}}};
  const auto is_answered = [](std::string_view name) {
    const auto is_among = [&](const PrefabKeys& keys) { return std::ranges::find(keys, name) != keys.end(); };
    return name == "classname" || name == "origin" || name == "_external_map" || is_among(kClassnameKeys) ||
           is_among(kAnglesKeys) || is_among(kAngleKeys) || is_among(kScaleKeys);
  };
  for (const auto& pair : fields.pairs)
    if (!is_answered(pair.first)) result.pairs.push_back(pair);
  return result;
}

bool is_in_range(const formats::MapSide& side) {
  return std::ranges::all_of(side.points_world, [](const Vec3d& point) {
    return std::abs(point.x) <= formats::kMapMaxCoordinate &&
           std::abs(point.y) <= formats::kMapMaxCoordinate && std::abs(point.z) <= formats::kMapMaxCoordinate;
  });
}

// Expands the prefabs of one map, one after another, and remembers the files it has read.
class PrefabExpander {
 public:
  PrefabExpander(const fs::path& map_path, ReadMapText read_text, Warnings& io_warnings)
      : read_text_(read_text), warnings_(io_warnings), chain_{map_path.lexically_normal()} {}

  base::Status expand(formats::MapEntity& io_entity, std::size_t number) {
    line_ = io_entity.line;
    const Site site{"", number, io_entity.line};
    TRY(const PrefabUse use, read_use(io_entity.fields, chain_.front(), site));
    Taken taken;
    TRY_STATUS(add_brushes_of_prefab(use, site, taken));
    io_entity.fields = make_result_fields(io_entity.fields);
    std::ranges::move(taken.brushes, std::back_inserter(io_entity.brushes));
    if (!taken.vis_blockers.empty()) {
      formats::MapEntity& blocker = vis_blockers_.emplace_back();
      blocker.fields.pairs = {{"classname", std::string(kVisBlocker)}};
      blocker.brushes = std::move(taken.vis_blockers);
      blocker.line = line_;
    }
    return base::Ok{};
  }

  // Entities to be added after the map's own.
  std::vector<formats::MapEntity> release_vis_blockers() { return std::move(vis_blockers_); }

 private:
  // The contribution of a prefab to the entity that uses it.
  struct Taken {
    std::vector<formats::MapBrush> brushes, vis_blockers;
  };

  // Adds the transformed brushes of a prefab and of those that it uses.
  base::Status add_brushes_of_prefab(const PrefabUse& use, const Site& site, Taken& io_taken) {
    TRY_STATUS(enter(use.file, site));
    TRY(const formats::Map* const map, load(use.file, site));
    for (std::size_t i = 0; i < map->entities.size(); ++i) {
      const formats::MapEntity& entity = map->entities[i];
      if (is_prefab(entity)) {
        const Site inner_site{use.file.string(), i, entity.line};
        TRY(PrefabUse inner, read_use(entity.fields, use.file, inner_site));
        inner.placement = combine(use.placement, inner.placement);
        TRY_STATUS(add_brushes_of_prefab(inner, inner_site, io_taken));
      } else if (contributes_brushes(entity) || keeps_classname(entity)) {
        auto& io_brushes = keeps_classname(entity) ? io_taken.vis_blockers : io_taken.brushes;
        for (const formats::MapBrush& brush : entity.brushes)
          TRY_STATUS(add_brush(brush, use.placement, site, io_brushes));
      }
    }
    chain_.pop_back();
    return base::Ok{};
  }

  // Records that `file` is being expanded.
  base::Status enter(const fs::path& file, const Site& site) {
    chain_.push_back(file);
    if (std::ranges::count(chain_, file) > 1) {
      std::vector<std::string> names;
      for (const fs::path& path : chain_) names.push_back(path.string());
      return site.fail(ErrorCode::kMalformed, "the maps include each other: {}", fmt::join(names, " -> "));
    }
    if (chain_.size() > kMaxPrefabDepth + 1)
      return site.fail(ErrorCode::kTooLarge, "prefabs may be nested at most {} deep", kMaxPrefabDepth);
    if (++prefabs_ > kMaxPrefabs)
      return site.fail(ErrorCode::kTooLarge, "a map may use at most {} prefabs", kMaxPrefabs);
    return base::Ok{};
  }

  base::Status add_brush(const formats::MapBrush& brush, const Placement& placement, const Site& site,
                         std::vector<formats::MapBrush>& io_brushes) {
    sides_ += brush.sides.size();
    if (sides_ > kMaxPrefabSides)
      return site.fail(ErrorCode::kTooLarge, "the brushes of all prefabs together may have at most {} sides",
                       kMaxPrefabSides);
    formats::MapBrush& result = io_brushes.emplace_back();
    result.line = line_;
    result.sides.reserve(brush.sides.size());
    for (const formats::MapSide& side : brush.sides) {
      result.sides.push_back(place_side(side, placement));
      result.sides.back().line = line_;
      if (!is_in_range(result.sides.back()))
        return site.fail(ErrorCode::kTooLarge,
                         "the brush on line {} of {} would be beyond +-{} units: move or scale the prefab",
                         brush.line, chain_.back().string(), formats::kMapMaxCoordinate);
    }
    return base::Ok{};
  }

  // Reads a map once. The result stays valid as long as this object.
  base::Result<const formats::Map*> load(const fs::path& file, const Site& site) {
    if (const auto found = files_.find(file); found != files_.end()) return &found->second;
    const auto text = read_text_(file);
    if (!text.ok()) return site.fail(text.error().code, "prefab {}: {}", file.string(), text.error().what);
    TRY(formats::Map map, formats::read_map(*text).with_file(file.string()));
    omit_brushes(map);
    const auto left_out =
        static_cast<std::size_t>(std::ranges::count_if(map.entities, [](const auto& entity) {
          return !is_prefab(entity) && !contributes_brushes(entity) && !keeps_classname(entity);
        }));
    if (left_out != 0)
      warnings_.push_back(
          {"entities of a prefab ignored", fmt::format("{}: {} of {} entities; only worldspawn, func_group, "
                                                       "func_detail and misc_external_map are used",
                                                       file.string(), left_out, map.entities.size())});
    return &files_.emplace(file, std::move(map)).first->second;
  }

  ReadMapText read_text_;
  Warnings& warnings_;
  std::map<fs::path, formats::Map> files_;
  std::vector<formats::MapEntity> vis_blockers_;  // one for each use of a prefab that contains any
  std::vector<fs::path> chain_;                   // the map, then the nested prefabs being expanded
  std::size_t prefabs_ = 0, sides_ = 0;
  std::uint32_t line_ = 0;  // of the map's entity that is being expanded
};

}  // namespace

base::Result<formats::Map> expand_prefabs(formats::Map map, const fs::path& map_path, ReadMapText read_text,
                                          Warnings& io_warnings) {
  omit_brushes(map);
  PrefabExpander expander(map_path, read_text, io_warnings);
  for (std::size_t i = 0; i < map.entities.size(); ++i)
    if (is_prefab(map.entities[i])) TRY_STATUS(expander.expand(map.entities[i], i));
  std::ranges::move(expander.release_vis_blockers(), std::back_inserter(map.entities));
  return map;
}

}  // namespace temblor::compiler
