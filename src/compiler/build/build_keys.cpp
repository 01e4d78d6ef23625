// Keys of the BSP stage hash the map, not the file, so that comments, line numbers and the order of keys do
// not matter, while every number that geometry depends on does.
#include "compiler/build/build_keys.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

#include "base/hash.h"
#include "compiler/bsp/brushes/brush_class.h"
#include "compiler/bsp/brushes/level_entities.h"
#include "compiler/light/faces/light_hash.h"
#include "compiler/light/sources/entity_lights.h"

namespace temblor::compiler {
namespace {

// Raise these if the BSP stage or the light stage makes something else of the same input.
constexpr std::uint64_t kBrushesMethod = 3, kLightMethod = 4;

// Keys of brush entities that only the game reads.
constexpr std::array<std::string_view, 17> kGameKeys = {
    "angles",  "count", "delay", "dmg",    "event", "health", "height", "killtarget", "lip",
    "message", "noise", "sound", "sounds", "speed", "wait",   "map",    "worldtype"};

bool is_for_the_game_alone(std::string_view key) {
  return std::find(kGameKeys.begin(), kGameKeys.end(), key) != kGameKeys.end();
}

// Chains values into one hash. Texts are preceded by their length, so that no two sequences of fields look
// alike.
class Hasher {
 public:
  explicit Hasher(std::uint64_t start) : hash_(start) {}

  void add(std::uint64_t value) { hash_ = base::hash_with(hash_, value); }
  // Adding 0.0 makes -0.0 the same as 0.0.
  void add(double value) { add(std::bit_cast<std::uint64_t>(value + 0.0)); }
  void add(std::string_view text) {
    add(text.size());
    for (const char letter : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(letter)));
  }
  void add(const math::Vec2d& v) { add(v.x), add(v.y); }
  void add(const math::Vec3d& v) { add(v.x), add(v.y), add(v.z); }

  // Never 0, which means that there is no result.
  StageKey key() const { return hash_ == 0 ? 1 : hash_; }

 private:
  std::uint64_t hash_;
};

// Everything that the BSP stage reads of a side. The texture's pixels do not matter, but its size does.
void add_side(const formats::MapSide& side, TextureSize texture_size, Hasher& io_hash) {
  for (const math::Vec3d& point : side.points_world) io_hash.add(point);
  io_hash.add(std::string_view(side.texture));
  io_hash.add(texture_size(side.texture));
  const formats::MapTexturing& texturing = side.texturing;
  io_hash.add(static_cast<std::uint64_t>(texturing.alignment));
  io_hash.add(texturing.offset);
  io_hash.add(texturing.rotation_deg);
  io_hash.add(texturing.scale);
  io_hash.add(texturing.s_axis);
  io_hash.add(texturing.t_axis);
  for (const auto& row : texturing.matrix)
    for (const double number : row) io_hash.add(number);
  for (const std::int32_t flag : side.flags.value_or(formats::MapSideFlags{}))
    io_hash.add(static_cast<std::uint64_t>(static_cast<std::uint32_t>(flag)));
}

// Everything that the BSP stage reads of an entity with brushes.
void add_brush_keys(const formats::Entity& fields, Hasher& io_hash) {
  io_hash.add(fields.classname());
  const BrushClass found = find_brush_class(fields);
  for (const std::int32_t number :
       {found.is_world ? 1 : 0, static_cast<std::int32_t>(found.solid), found.is_detail ? 1 : 0,
        static_cast<std::int32_t>(found.hulls), found.chop_order, found.is_seen_from_inside ? 1 : 0,
        found.keeps_inner_faces ? 1 : 0})
    io_hash.add(static_cast<double>(number));
  const SurfaceKeys keys = read_surface_keys(fields);
  visit_fields(keys, [&](auto field) { io_hash.add(static_cast<double>(field)); });
}

constexpr std::int32_t kHullSolid = -2;
// Drawn, players, large monsters. Half-Life's ducking players (version 30) have the keys of players.
constexpr std::size_t kHulls = 3, kLowHull = 3;

// The contents at a point, in the drawn tree or in a clip hull.
std::int32_t find_contents(const formats::Bsp& bsp, std::size_t hull, const math::Vec3d& point_world) {
  // Readers take clip hulls without any nodes to be empty; ours are solid then.
  if (hull > 0 && bsp.clipnodes.empty()) return kHullSolid;
  std::int32_t child = bsp.models.front().head_nodes[hull];
  const auto find_child = [&](std::uint32_t plane_index) {
    const formats::BspPlane& plane = bsp.planes[plane_index];
    return glm::dot(math::Vec3d(plane.normal), point_world) >= double{plane.distance} ? 0 : 1;
  };
  while (child >= 0) {
    const auto node = static_cast<std::size_t>(child);
    child = hull == 0 ? bsp.nodes[node].children[find_child(bsp.nodes[node].plane)]
                      : bsp.clipnodes[node].children[find_child(bsp.clipnodes[node].plane)];
  }
  return hull == 0 ? bsp.leaves[static_cast<std::size_t>(-(child + 1))].contents : child;
}

// Whether the outside might reach places in this hull that it does not reach in the drawn one: only if a
// brush of the world, which may seal the level, is not in the hull. Otherwise the hull only has more solid.
bool may_be_more_open(const formats::Map& map, std::size_t hull) {
  return std::ranges::any_of(map.entities, [&](const formats::MapEntity& entity) {
    const BrushClass found = find_brush_class(entity.fields);
    return found.is_world && !entity.brushes.empty() &&
           (found.hulls & hull_bit(hull == kLowHull ? 1 : hull)) == 0;
  });
}

// Whether the entity shows a model of the level.
bool has_brushes(const formats::Entity& entity) {
  return entity.classname() == "worldspawn" || entity.find("model").value_or("").starts_with('*');
}

// The entities, and those of their keys, that light might read.
std::vector<formats::Entity> select_entities_for_light(const std::vector<formats::Entity>& entities) {
  std::vector<formats::Entity> selected;
  for (const formats::Entity& entity : entities) {
    // All keys of lights matter, even with brushes: light reads "wait" and "delay".
    if (is_light(entity)) {
      selected.push_back(entity);
    } else if (has_brushes(entity)) {
      formats::Entity& copy = selected.emplace_back();
      for (const auto& pair : entity.pairs)
        if (!is_for_the_game_alone(pair.first)) copy.pairs.push_back(pair);
    } else if (entity.find("targetname")) {
      selected.push_back(entity);
    }
  }
  return selected;
}

}  // namespace

StageKey make_brushes_key(const formats::Map& map, TextureSize texture_size, const DraftOptions& options) {
  Hasher hash(kBrushesMethod);
  hash.add(std::uint64_t{options.water_is_transparent});
  hash.add(options.subdivide_texels);
  hash.add(std::uint64_t{options.fill_outside});
  hash.add(std::uint64_t{options.clip_hulls});
  if (options.brush_list) hash.add(std::string_view("brush list"));
  // A map that does not begin with worldspawn is an error.
  hash.add(map.entities.empty() ? std::string_view{} : map.entities.front().fields.classname());
  for (const formats::MapEntity& entity : map.entities) {
    if (is_point_entity(entity)) continue;
    add_brush_keys(entity.fields, hash);
    for (const formats::MapBrush& brush : entity.brushes) {
      hash.add(brush.sides.size());
      for (const formats::MapSide& side : brush.sides) add_side(side, texture_size, hash);
    }
    hash.add(entity.brushes.size());
  }
  return hash.key();
}

// Adds the origins in the order of the map. Hulls without any candidate for a new leak are skipped.
StageKey make_solid_occupants_key(const formats::Map& map, const formats::Bsp& bsp) {
  Hasher hash(0);
  const std::size_t hulls = kHulls + (bsp.version == formats::BspVersion::k30 ? 1 : 0);
  for (std::size_t hull = 0; hull < hulls; ++hull) {
    if (hull > 0 && !may_be_more_open(map, hull)) continue;
    hash.add(std::uint64_t{hull});
    for (const formats::MapEntity& entity : map.entities) {
      if (!is_point_entity(entity)) continue;
      const auto origin = entity.fields.find_vec3("origin");
      if (origin && find_contents(bsp, hull, math::Vec3d(*origin)) == kHullSolid)
        hash.add(math::Vec3d(*origin));
    }
  }
  return hash.key();
}

StageKey make_light_key(const formats::Bsp& bsp, const std::vector<formats::Entity>& entities,
                        const FaceKeys& face_keys, const LightOptions& options) {
  formats::Bsp asked = strip_light(bsp);
  asked.entities = formats::write_entities(select_entities_for_light(entities));
  Hasher hash(kLightMethod);
  hash.add(hash_light_input(asked, face_keys, options));
  return hash.key();
}

}  // namespace temblor::compiler
