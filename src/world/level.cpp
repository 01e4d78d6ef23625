// Converts the structs of the file to a level, and computes everything that can be computed once. Relies on
// the reader's validation (formats/levels/bsp_validate.h): indices, ranges, trees without cycles, finite
// numbers.
#include "world/level.h"

#include <fmt/format.h>

#include <utility>

#include "world/loading/brush_entities.h"
#include "world/loading/faces.h"
#include "world/loading/textures.h"

namespace temblor::world {
namespace {

// The original expands models by this many units on every side, and game code relies on it.
constexpr float kModelMargin = 1;

Plane make_plane(const formats::BspPlane& plane) {
  // Do not trust the file's own `type`: a wrong one would make every query wrong.
  std::int32_t axis = 3;
  for (std::int32_t i = 0; i < 3; ++i) {
    math::Vec3 unit(0.0f);
    unit[i] = 1;
    if (plane.normal == unit) axis = i;
  }
  return {plane.normal, plane.distance, axis};
}

Node make_node(const formats::BspNode& node) {
  return {node.plane,
          {Child{node.children[0]}, Child{node.children[1]}},
          {node.mins, node.maxs},
          node.first_face,
          node.face_count};
}

// Contents that only matter to a compiler or to other games' entities, such as Half-Life's translucent (-15)
// and ladder (-16), are empty.
Contents make_contents(std::int32_t value) {
  const auto contents = static_cast<Contents>(value);
  const bool is_known = (contents <= Contents::kEmpty && contents >= Contents::kSky) ||
                        (contents <= Contents::kCurrent0 && contents >= Contents::kCurrentDown);
  return is_known ? contents : Contents::kEmpty;
}

Leaf make_leaf(const formats::BspLeaf& leaf) {
  return {make_contents(leaf.contents), leaf.visibility_offset, {leaf.mins, leaf.maxs},
          leaf.first_marksurface,       leaf.marksurface_count, leaf.ambient};
}

Model make_model(const formats::BspModel& model) {
  return {{model.mins - kModelMargin, model.maxs + kModelMargin},
          model.origin,
          Child{model.head_nodes[0]},
          {model.head_nodes[1], model.head_nodes[2], model.head_nodes[3]},
          model.first_face,
          model.face_count};
}

template <typename To, typename From, typename Make>
std::vector<To> convert(const std::vector<From>& from, Make make) {
  std::vector<To> to;
  to.reserve(from.size());
  for (const From& element : from) to.push_back(make(element));
  return to;
}

// Moves lists that need no conversion, because levels may be large.
void take_geometry(formats::Bsp& io_bsp, Level& io_level) {
  io_level.planes = convert<Plane>(io_bsp.planes, make_plane);
  io_level.nodes = convert<Node>(io_bsp.nodes, make_node);
  io_level.leaves = convert<Leaf>(io_bsp.leaves, make_leaf);
  io_level.models = convert<Model>(io_bsp.models, make_model);
  io_level.clipnodes = convert<Clipnode>(io_bsp.clipnodes, [](const formats::BspClipnode& node) {
    return Clipnode{node.plane, node.children};
  });
  io_level.texture_axes = convert<TextureAxes>(io_bsp.texinfos, [](const formats::BspTexinfo& info) {
    return TextureAxes{info.s_axis, info.s_offset, info.t_axis, info.t_offset};
  });
  io_level.marked_faces = convert<FaceIndex>(io_bsp.marksurfaces,
                                             [](std::uint32_t face) { return static_cast<FaceIndex>(face); });
  io_level.vertices = std::move(io_bsp.vertices);
  io_level.edges = std::move(io_bsp.edges);
  io_level.surfedges = std::move(io_bsp.surfedges);
  io_level.visibility = std::move(io_bsp.visibility);
  io_level.visible_leaf_count = static_cast<std::uint32_t>(io_bsp.models[0].visible_leaves);
}

base::Status take_light(formats::Bsp& io_bsp, const formats::Lit* lit, Level& io_level) {
  io_level.light = std::move(io_bsp.lighting);
  io_level.has_light = !io_level.light.empty();
  const std::size_t rgb_size = io_level.light.size() * 3;
  if (lit != nullptr) {
    if (lit->samples.size() != rgb_size)
      return base::malformed("the .lit file has {} bytes of color, but the level's {} light samples need {}",
                             lit->samples.size(), io_level.light.size(), rgb_size);
    io_level.light_rgb = lit->samples;
  } else if (const formats::BspxLump* lump = io_bsp.find_bspx("RGBLIGHTING")) {
    if (lump->data.size() == rgb_size) {
      const auto samples = base::as_u8(lump->data);
      io_level.light_rgb.assign(samples.begin(), samples.end());
    } else {
      io_level.notes.push_back(fmt::format(
          "lump RGBLIGHTING: {} bytes of color, but the level's {} light samples need {}; it is ignored",
          lump->data.size(), io_level.light.size(), rgb_size));
    }
  }
  return base::Ok{};
}

void take_light_grid(const formats::Bsp& bsp, Level& io_level) {
  const formats::BspxLump* lump = bsp.find_bspx(formats::kLightGridLump);
  if (lump == nullptr) return;
  base::Result<formats::LightGrid> grid = formats::read_light_grid(lump->data);
  if (grid.ok())
    io_level.light_grid = std::move(grid).value();
  else
    io_level.notes.push_back(
        fmt::format("lump {}: {}; it is ignored", formats::kLightGridLump, grid.error().what));
}

}  // namespace

base::Result<std::shared_ptr<const Level>> make_level(formats::Bsp bsp, std::string name,
                                                      const formats::Lit* lit, ColoredTextures colored) {
  auto level = std::make_shared<Level>();
  level->name = std::move(name);
  level->is_half_life = bsp.version == formats::BspVersion::k30;
  if (level->is_half_life) level->hull_boxes = kHalfLifeHulls;
  if (!bsp.repairs.empty()) level->notes.push_back(std::move(bsp.repairs));
  formats::EntityText text = formats::read_faulty_entities(bsp.entities);
  level->entities = std::move(text.entities);
  if (!text.first_fault.empty())
    level->notes.push_back(fmt::format("lump entities: {}; it is passed over", text.first_fault));
  take_geometry(bsp, *level);
  if (level->is_half_life) level->brush_entities = read_brush_entities(level->entities, level->models.size());
  TRY_STATUS(take_light(bsp, lit, *level));
  take_light_grid(bsp, *level);
  level->textures =
      make_textures(bsp.miptexes, colored, level->is_half_life ? NameRules::kHalfLife : NameRules::kQuake);
  make_faces(bsp, *level);
  return std::shared_ptr<const Level>(std::move(level));
}

}  // namespace temblor::world
