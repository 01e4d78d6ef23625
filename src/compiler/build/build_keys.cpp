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

// To be raised when the BSP stage, or light, makes something else of the same input.
constexpr std::uint64_t kBrushesMethod = 2, kLightMethod = 2;

// Keys of entities with brushes that only the game reads.
constexpr std::array<std::string_view, 17> kGameKeys = {
    "angles",  "count", "delay", "dmg",    "event", "health", "height", "killtarget", "lip",
    "message", "noise", "sound", "sounds", "speed", "wait",   "map",    "worldtype"};

bool is_for_the_game_alone(std::string_view key) {
  return std::find(kGameKeys.begin(), kGameKeys.end(), key) != kGameKeys.end();
}

class Hasher {
 public:
  explicit Hasher(std::uint64_t start) : hash_(start) {}

  void add(std::uint64_t value) { hash_ = base::hash_with(hash_, value); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value + 0.0)); }
  void add(std::string_view text) {
    add(text.size());
    for (const char letter : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(letter)));
  }
  void add(const math::Vec2d& v) { add(v.x), add(v.y); }
  void add(const math::Vec3d& v) { add(v.x), add(v.y), add(v.z); }

  // Never 0, which stands for no result.
  StageKey key() const { return hash_ == 0 ? 1 : hash_; }

 private:
  std::uint64_t hash_;
};

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

// All that the BSP stage reads of an entity with brushes.
void add_brush_keys(const formats::Entity& fields, Hasher& io_hash) {
  io_hash.add(fields.classname());
  const BrushClass of = brush_class_of(fields);
  for (const std::int32_t number : {of.is_world ? 1 : 0, static_cast<std::int32_t>(of.solid),
                                    of.is_detail ? 1 : 0, static_cast<std::int32_t>(of.hulls), of.chop_order,
                                    of.is_seen_from_inside ? 1 : 0, of.keeps_inner_faces ? 1 : 0})
    io_hash.add(static_cast<double>(number));
  const SurfaceKeys keys = surface_keys_of(fields);
  visit_fields(keys, [&](auto field) { io_hash.add(static_cast<double>(field)); });
}

constexpr std::int32_t kSolidContents = -2;
constexpr std::size_t kHulls = 3;  // that levels are compiled for

// In the tree of what is drawn, or in that of a hull of boxes.
std::int32_t contents_at(const formats::Bsp& bsp, std::size_t hull, const math::Vec3d& point_world) {
  // Readers take hulls for empty where no hull has a node; those of ours are solid then.
  if (hull > 0 && bsp.clipnodes.empty()) return kSolidContents;
  std::int32_t child = bsp.models.front().head_nodes[hull];
  const auto side_of = [&](std::uint32_t plane_index) {
    const formats::BspPlane& plane = bsp.planes[plane_index];
    return glm::dot(math::Vec3d(plane.normal), point_world) >= double{plane.distance} ? 0 : 1;
  };
  while (child >= 0) {
    const auto node = static_cast<std::size_t>(child);
    child = hull == 0 ? bsp.nodes[node].children[side_of(bsp.nodes[node].plane)]
                      : bsp.clipnodes[node].children[side_of(bsp.clipnodes[node].plane)];
  }
  return hull == 0 ? bsp.leaves[static_cast<std::size_t>(-(child + 1))].contents : child;
}

// Whether the outside might reach places in this hull that it does not reach in what is drawn: where a brush
// of the world, which may be what seals it, is not in the hull. Else there is only more in it.
bool may_be_more_open(const formats::Map& map, std::size_t hull) {
  return std::ranges::any_of(map.entities, [&](const formats::MapEntity& entity) {
    const BrushClass of = brush_class_of(entity.fields);
    return of.is_world && !entity.brushes.empty() && (of.hulls & hull_bit(hull)) == 0;
  });
}

bool has_brushes(const formats::Entity& entity) {
  return entity.classname() == "worldspawn" || entity.find("model").value_or("").starts_with('*');
}

// What light might read of the level's entities.
std::vector<formats::Entity> entities_for_light(const std::vector<formats::Entity>& entities) {
  std::vector<formats::Entity> concerned;
  for (const formats::Entity& entity : entities) {
    // Of lights all keys count, also of those with brushes: light reads "wait" and "delay".
    if (is_light(entity)) {
      concerned.push_back(entity);
    } else if (has_brushes(entity)) {
      formats::Entity& copy = concerned.emplace_back();
      for (const auto& pair : entity.pairs)
        if (!is_for_the_game_alone(pair.first)) copy.pairs.push_back(pair);
    } else if (entity.find("targetname")) {
      concerned.push_back(entity);
    }
  }
  return concerned;
}

}  // namespace

StageKey key_of_brushes(const formats::Map& map, TextureSize texture_size, const DraftOptions& options) {
  Hasher hash(kBrushesMethod);
  hash.add(std::uint64_t{options.water_is_transparent});
  hash.add(options.subdivide_texels);
  hash.add(std::uint64_t{options.fill_outside});
  // A map that does not begin with worldspawn is refused.
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

StageKey key_of_solid_occupants(const formats::Map& map, const formats::Bsp& bsp) {
  Hasher hash(0);
  for (std::size_t hull = 0; hull < kHulls; ++hull) {
    if (hull > 0 && !may_be_more_open(map, hull)) continue;
    hash.add(std::uint64_t{hull});
    for (const formats::MapEntity& entity : map.entities) {
      if (!is_point_entity(entity)) continue;
      const auto origin = entity.fields.find_vec3("origin");
      if (origin && contents_at(bsp, hull, math::Vec3d(*origin)) == kSolidContents)
        hash.add(math::Vec3d(*origin));
    }
  }
  return hash.key();
}

StageKey key_of_light(const formats::Bsp& bsp, const std::vector<formats::Entity>& entities,
                      const FaceKeys& face_keys, const LightOptions& options) {
  formats::Bsp asked = unlit(bsp);
  asked.entities = formats::write_entities(entities_for_light(entities));
  Hasher hash(kLightMethod);
  hash.add(hash_of_light_input(asked, face_keys, options));
  return hash.key();
}

}  // namespace temblor::compiler
