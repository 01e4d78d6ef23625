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

#include "compiler/textures/texture_lock.h"
#include "math/angles.h"

namespace temblor::compiler {
namespace {

using base::ErrorCode;
using math::Vec3d;
namespace fs = std::filesystem;

constexpr std::string_view kPrefab = "misc_external_map";
constexpr std::string_view kVisBlocker = "func_illusionary_visblocker";

// What an entity asks for.
struct PrefabUse {
  fs::path file;
  Placement placement;
};

// The entity that a message is about.
struct Site {
  std::string file;  // empty: the map that is compiled
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

using Keys = std::array<std::string_view, 2>;
constexpr Keys kClassnameKeys{"_external_map_classname", "_classname"};
constexpr Keys kAnglesKeys{"_external_map_angles", "_angles"};
constexpr Keys kAngleKeys{"_external_map_angle", "_angle"};
constexpr Keys kScaleKeys{"_external_map_scale", "_scale"};

// The first of the keys that is there; nothing when none is.
std::optional<std::string_view> find_key(const formats::Entity& fields, const Keys& keys) {
  const auto key = std::ranges::find_if(keys, [&](std::string_view k) { return fields.find(k).has_value(); });
  return key == keys.end() ? std::nullopt : std::optional(*key);
}

base::Result<Vec3d> read_angles(const formats::Entity& fields, const Site& site) {
  if (const auto key = find_key(fields, kAnglesKeys)) {
    if (const auto angles_deg = fields.find_vec3(*key)) return Vec3d(*angles_deg);
    return site.fail(ErrorCode::kMalformed, "{} should be three numbers: pitch yaw roll", *key);
  }
  if (const auto key = find_key(fields, kAngleKeys)) {
    if (const auto yaw_deg = fields.find_number(*key)) return Vec3d(0, *yaw_deg, 0);
    return site.fail(ErrorCode::kMalformed, "{} should be one number: the yaw", *key);
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
    return site.fail(ErrorCode::kMalformed, "{} should be one number or three, none of them 0", *key);
  return *scale;
}

base::Result<Vec3d> read_origin(const formats::Entity& fields, const Site& site) {
  if (!fields.find("origin")) return Vec3d(0.0);
  if (const auto origin = fields.find_vec3("origin")) return Vec3d(*origin);
  return site.fail(ErrorCode::kMalformed, "origin should be three numbers");
}

Placement make_placement(const Vec3d& angles_deg, const Vec3d& scale, const Vec3d& origin) {
  // Unlike in the game, prefabs look down where the pitch is negative.
  const math::Basis basis = math::basis_from_angles(math::Vec3(-angles_deg.x, angles_deg.y, angles_deg.z));
  Placement placement{{basis.forward, -basis.right, basis.up}, origin};
  for (int axis = 0; axis < 3; ++axis) {
    Vec3d& column = placement.columns[static_cast<std::size_t>(axis)];
    // Quarter turns are exact, so that what lay on the grid stays on it.
    for (int i = 0; i < 3; ++i)
      if (constexpr double kRounding = 1e-9; std::abs(column[i] - std::round(column[i])) < kRounding)
        column[i] = std::round(column[i]);
    column *= scale[axis];
  }
  return placement;
}

base::Result<PrefabUse> read_use(const formats::Entity& fields, const fs::path& named_by, const Site& site) {
  std::string name(fields.find("_external_map").value_or(""));
  if (name.empty()) return site.fail(ErrorCode::kMalformed, "no key _external_map names a file");
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

// Its brushes become those of the entity that takes the prefab in.
bool gives_brushes(const formats::MapEntity& entity) {
  const std::string_view name = entity.fields.classname();
  return name == "worldspawn" || name == "func_group" || name.starts_with("func_detail");
}

// Its brushes cannot be solid, so they stay what they are.
bool stays_as_it_is(const formats::MapEntity& entity) {
  return entity.fields.classname() == kVisBlocker;
}

// The entity without the keys that are answered, as what it is to be.
formats::Entity fields_of_result(const formats::Entity& fields) {
  const auto key = find_key(fields, kClassnameKeys);
  std::string classname(key ? *fields.find(*key) : "func_detail");
  if (classname == "worldspawn") classname = "func_group";
  formats::Entity result{{{"classname", std::move(classname)}}};
  const auto is_answered = [](std::string_view name) {
    const auto is_among = [&](const Keys& keys) { return std::ranges::find(keys, name) != keys.end(); };
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

class PrefabExpander {
 public:
  PrefabExpander(const fs::path& map_path, ReadMapText read_text, Warnings& io_warnings)
      : read_text_(read_text), warnings_(io_warnings), chain_{map_path.lexically_normal()} {}

  base::Status expand(formats::MapEntity& io_entity, std::size_t number) {
    line_ = io_entity.line;
    const Site site{"", number, io_entity.line};
    TRY(const PrefabUse use, read_use(io_entity.fields, chain_.front(), site));
    Taken taken;
    TRY_STATUS(take_brushes(use, site, taken));
    io_entity.fields = fields_of_result(io_entity.fields);
    std::ranges::move(taken.brushes, std::back_inserter(io_entity.brushes));
    if (!taken.vis_blockers.empty()) {
      formats::MapEntity& blocker = vis_blockers_.emplace_back();
      blocker.fields.pairs = {{"classname", std::string(kVisBlocker)}};
      blocker.brushes = std::move(taken.vis_blockers);
      blocker.line = line_;
    }
    return base::Ok{};
  }

  // What belongs behind the map's own entities.
  std::vector<formats::MapEntity> take_vis_blockers() { return std::move(vis_blockers_); }

 private:
  struct Taken {
    std::vector<formats::MapBrush> brushes, vis_blockers;
  };

  base::Status take_brushes(const PrefabUse& use, const Site& site, Taken& io_taken) {
    TRY_STATUS(enter(use.file, site));
    TRY(const formats::Map* const map, load(use.file, site));
    for (std::size_t i = 0; i < map->entities.size(); ++i) {
      const formats::MapEntity& entity = map->entities[i];
      if (is_prefab(entity)) {
        const Site inner_site{use.file.string(), i, entity.line};
        TRY(PrefabUse inner, read_use(entity.fields, use.file, inner_site));
        inner.placement = combined(use.placement, inner.placement);
        TRY_STATUS(take_brushes(inner, inner_site, io_taken));
      } else if (gives_brushes(entity) || stays_as_it_is(entity)) {
        auto& io_brushes = stays_as_it_is(entity) ? io_taken.vis_blockers : io_taken.brushes;
        for (const formats::MapBrush& brush : entity.brushes)
          TRY_STATUS(take_brush(brush, use.placement, site, io_brushes));
      }
    }
    chain_.pop_back();
    return base::Ok{};
  }

  // Notes that `file` is being taken in.
  base::Status enter(const fs::path& file, const Site& site) {
    chain_.push_back(file);
    if (std::ranges::count(chain_, file) > 1) {
      std::vector<std::string> names;
      for (const fs::path& path : chain_) names.push_back(path.string());
      return site.fail(ErrorCode::kMalformed, "maps name each other in a circle: {}",
                       fmt::join(names, " -> "));
    }
    if (chain_.size() > kMaxPrefabDepth + 1)
      return site.fail(ErrorCode::kTooLarge, "prefabs within prefabs go at most {} deep", kMaxPrefabDepth);
    if (++prefabs_ > kMaxPrefabs)
      return site.fail(ErrorCode::kTooLarge, "a map takes in at most {} prefabs", kMaxPrefabs);
    return base::Ok{};
  }

  base::Status take_brush(const formats::MapBrush& brush, const Placement& placement, const Site& site,
                          std::vector<formats::MapBrush>& io_brushes) {
    sides_ += brush.sides.size();
    if (sides_ > kMaxPrefabSides)
      return site.fail(ErrorCode::kTooLarge, "the brushes of all prefabs have at most {} sides",
                       kMaxPrefabSides);
    formats::MapBrush& result = io_brushes.emplace_back();
    result.line = line_;
    result.sides.reserve(brush.sides.size());
    for (const formats::MapSide& side : brush.sides) {
      result.sides.push_back(placed(side, placement));
      result.sides.back().line = line_;
      if (!is_in_range(result.sides.back()))
        return site.fail(ErrorCode::kTooLarge, "the brush from line {} of {} comes to lie beyond +-{}",
                         brush.line, chain_.back().string(), formats::kMapMaxCoordinate);
    }
    return base::Ok{};
  }

  // Owned here; valid as long as this is.
  base::Result<const formats::Map*> load(const fs::path& file, const Site& site) {
    if (const auto found = files_.find(file); found != files_.end()) return &found->second;
    const auto text = read_text_(file);
    if (!text.ok()) return site.fail(text.error().code, "prefab {}: {}", file.string(), text.error().what);
    TRY(formats::Map map, formats::read_map(*text).with_file(file.string()));
    const auto left_out =
        static_cast<std::size_t>(std::ranges::count_if(map.entities, [](const auto& entity) {
          return !is_prefab(entity) && !gives_brushes(entity) && !stays_as_it_is(entity);
        }));
    if (left_out != 0)
      warnings_.push_back({"entities of a prefab left out",
                           fmt::format("{}: {} of {} entities are neither world, group, detail nor prefab",
                                       file.string(), left_out, map.entities.size())});
    return &files_.emplace(file, std::move(map)).first->second;
  }

  ReadMapText read_text_;
  Warnings& warnings_;
  std::map<fs::path, formats::Map> files_;
  std::vector<formats::MapEntity> vis_blockers_;  // one for each use of a prefab that has any
  std::vector<fs::path> chain_;  // the map, and the prefabs within one another that are being taken in
  std::size_t prefabs_ = 0, sides_ = 0;
  std::uint32_t line_ = 0;  // of the entity in the map
};

}  // namespace

base::Result<formats::Map> expand_prefabs(formats::Map map, const fs::path& map_path, ReadMapText read_text,
                                          Warnings& io_warnings) {
  PrefabExpander expander(map_path, read_text, io_warnings);
  for (std::size_t i = 0; i < map.entities.size(); ++i)
    if (is_prefab(map.entities[i])) TRY_STATUS(expander.expand(map.entities[i], i));
  std::ranges::move(expander.take_vis_blockers(), std::back_inserter(map.entities));
  return map;
}

}  // namespace temblor::compiler
