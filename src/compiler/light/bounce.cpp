// Method: radiosity, gathered by rays. Every face gets a grid of nodes, one for every fourth luxel along each
// axis and at least on the rim. From each node go kRays rays, distributed by the cosine of their angle, and
// each remembers the node nearest to where it ends. The mean light of those nodes is what the node gets. So
// each ray is traced only once, however often the light bounces. Light is interpolated between nodes.
#include "compiler/light/bounce.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <set>
#include <span>

#include "compiler/light/faces/sample_points.h"
#include "compiler/light/sources/directions.h"
#include "world/face_at.h"

namespace temblor::compiler {
namespace {

constexpr int kLuxelsToNode = 4;
constexpr int kRays = 128;  // of each node
constexpr std::uint32_t kNoNode = std::numeric_limits<std::uint32_t>::max();
constexpr float kFar = 1 << 20;  // longer than any level
// How bright bounced light is: measured on finished levels that their makers lit with one bounce. Each
// further bounce keeps a fifth, like dark stone.
constexpr float kFirstBounce = 1.125f;
constexpr float kReflectance = 0.2f;

// The nodes of one face.
struct NodeGrid {
  std::uint32_t first_node = 0;
  int columns = 0, rows = 0;  // in nodes; 0: the face gets no light
  int width = 0, height = 0;  // in luxels

  std::uint32_t node(int column, int row) const {
    return first_node + static_cast<std::uint32_t>(row * columns + column);
  }
};

int count_nodes_along(int luxels) {
  return luxels <= 1 ? 1 : (luxels - 2) / kLuxelsToNode + 2;
}
// Nodes are spaced evenly, from the first luxel to the last one.
double find_luxel_at_node(int node, int nodes, int luxels) {
  return nodes <= 1 ? 0 : static_cast<double>(node) * (luxels - 1) / (nodes - 1);
}

// The nodes of all faces, and what faces reflect.
struct BouncedWorld {
  std::vector<NodeGrid> grids;          // by face
  std::vector<math::Vec3> reflectance;  // by face
  std::vector<std::uint32_t> face_of_node;
};

// Lays a grid of nodes on each face that gets light, in the order of the faces, so that node numbers depend
// only on the level.
BouncedWorld lay_nodes(const LitLevel& lit) {
  const world::Level& level = *lit.level;
  BouncedWorld bounced;
  bounced.grids.resize(level.faces.size());
  bounced.reflectance.assign(level.faces.size(), math::Vec3(kReflectance));
  for (std::size_t face = 0; face < level.faces.size(); ++face) {
    if (!lit.gets_light[face]) continue;
    const world::Face& shape = level.faces[face];
    NodeGrid& grid = bounced.grids[face];
    grid = {static_cast<std::uint32_t>(bounced.face_of_node.size()), count_nodes_along(shape.light_width()),
            count_nodes_along(shape.light_height()), shape.light_width(), shape.light_height()};
    bounced.face_of_node.insert(bounced.face_of_node.end(),
                                static_cast<std::size_t>(grid.columns * grid.rows),
                                static_cast<std::uint32_t>(face));
    if (!lit.surface_keys(face).takes_bounce) bounced.reflectance[face] = math::Vec3(0.0f);
    bounced.reflectance[face] *= lit.surface_keys(face).bounce_scale;
  }
  return bounced;
}

// The mean color of a texture, scaled so that its strongest channel is 1; white for black or missing texels.
math::Vec3 find_mean_hue(const world::Texture& texture, const formats::Palette& palette) {
  math::Vec3d sum(0.0);
  for (const std::uint8_t texel : texture.mips[0])
    sum += math::Vec3d(palette[texel].r, palette[texel].g, palette[texel].b);
  const double strongest = std::max({sum.x, sum.y, sum.z});
  return strongest > 0 ? math::Vec3(sum / strongest) : math::Vec3(1.0f);
}

// Scales the reflectance of faces by the colors of their textures.
void tint_by_textures(const LitLevel& lit, const BounceSettings& settings, const formats::Palette& palette,
                      BouncedWorld& io_bounced) {
  const world::Level& level = *lit.level;
  std::vector<math::Vec3> hues;
  for (const world::Texture& texture : level.textures) hues.push_back(find_mean_hue(texture, palette));
  for (std::size_t face = 0; face < level.faces.size(); ++face)
    io_bounced.reflectance[face] *=
        glm::mix(math::Vec3(1.0f), hues[base::to_size(level.faces[face].texture)], settings.color_scale);
}

// The node of a face that is nearest to a point on it.
std::uint32_t find_node(const LitLevel& lit, const NodeGrid& grid, std::size_t face,
                        const math::Vec3& point) {
  if (grid.columns == 0) return kNoNode;
  const world::Face& shape = lit.level->faces[face];
  const world::TextureAxes& axes = lit.level->texture_axes[shape.axes];
  const math::Vec3 local = point - lit.model_offset(face);
  const auto nearest = [](float texel, int mins, int nodes, int luxels) {
    constexpr float kTexels = 16;
    if (nodes <= 1) return 0;
    const float luxel = (texel - static_cast<float>(mins)) / kTexels;
    const float along = luxel * static_cast<float>(nodes - 1) / static_cast<float>(luxels - 1);
    return static_cast<int>(std::clamp(std::round(along), 0.0f, static_cast<float>(nodes - 1)));
  };
  const int column =
      nearest(glm::dot(local, axes.s_axis) + axes.s_offset, shape.texture_mins[0], grid.columns, grid.width);
  const int row =
      nearest(glm::dot(local, axes.t_axis) + axes.t_offset, shape.texture_mins[1], grid.rows, grid.height);
  return grid.node(column, row);
}

// Traces the rays of a face: kRays node numbers for each of its nodes.
void trace_face(const LitLevel& lit, const RayScene& scene, const BouncedWorld& bounced, std::size_t face,
                std::vector<std::uint32_t>& out_seen) {
  const NodeGrid& nodes = bounced.grids[face];
  const LightGrid grid = make_light_grid(lit, face);
  std::vector<std::uint32_t> luxels;
  for (int row = 0; row < nodes.rows; ++row)
    for (int column = 0; column < nodes.columns; ++column) {
      const auto x = std::lround(find_luxel_at_node(column, nodes.columns, nodes.width));
      const auto y = std::lround(find_luxel_at_node(row, nodes.rows, nodes.height));
      luxels.push_back(static_cast<std::uint32_t>(y * nodes.width + x));
    }
  const std::vector<math::Vec3> places = sample_luxels(lit, scene, grid, luxels).points;
  const Frame frame = frame_around(math::Vec3(grid.normal));
  std::vector<math::Vec3> directions(places.size());
  std::vector<RayHit> hits(places.size());
  for (int ray = 0; ray < kRays; ++ray) {
    std::fill(directions.begin(), directions.end(), in_frame(frame, cosine_direction(ray, kRays)));
    scene.find_nearest(places, directions, kFar, hits);
    for (std::size_t i = 0; i < places.size(); ++i) {
      std::uint32_t seen = kNoNode;
      if (const RayHit& hit = hits[i]; hit.surface != RayHit::kNone) {
        const world::FacePlane plane = world::compute_face_plane(*lit.level, lit.level->faces[hit.surface]);
        // The back of a face is not visible.
        if (glm::dot(math::Vec3d(directions[i]), plane.normal) < 0)
          seen = find_node(lit, bounced.grids[hit.surface], hit.surface,
                           places[i] + directions[i] * hit.distance);
      }
      out_seen[(nodes.first_node + i) * kRays + static_cast<std::size_t>(ray)] = seen;
    }
  }
}

// The light that each node reflects: the mean of the luxels around it, times the
// reflectance.
std::vector<math::Vec3> collect_emitted_light(const BouncedWorld& bounced,
                                              const std::vector<FaceLight>& light, std::uint8_t style) {
  std::vector<math::Vec3> sent(bounced.face_of_node.size(), math::Vec3(0.0f));
  for (std::size_t face = 0; face < bounced.grids.size(); ++face) {
    const NodeGrid& grid = bounced.grids[face];
    const LightLayer* layer = light[face].find(style, LayerKind::kAdd);
    if (grid.columns == 0 || layer == nullptr) continue;
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        const auto x = static_cast<int>(std::lround(find_luxel_at_node(column, grid.columns, grid.width)));
        const auto y = static_cast<int>(std::lround(find_luxel_at_node(row, grid.rows, grid.height)));
        constexpr int kAround = kLuxelsToNode / 2;
        math::Vec3 sum(0.0f);
        float count = 0;
        for (int v = std::max(0, y - kAround); v <= std::min(grid.height - 1, y + kAround); ++v)
          for (int u = std::max(0, x - kAround); u <= std::min(grid.width - 1, x + kAround); ++u, ++count)
            sum += layer->samples[static_cast<std::size_t>(v * grid.width + u)];
        sent[grid.node(column, row)] = sum / count * bounced.reflectance[face];
      }
  }
  return sent;
}

// Adds gathered light to a light map, whose scale may differ from that of the nodes.
void add_to_map(const LitLevel& lit, const NodeGrid& grid, const LightMapShape& map,
                const std::vector<math::Vec3>& gathered, std::uint8_t style, FaceLight& io_light) {
  const std::uint32_t end = grid.first_node + static_cast<std::uint32_t>(grid.columns * grid.rows);
  if (std::all_of(gathered.begin() + grid.first_node, gathered.begin() + end,
                  [](const math::Vec3& light) { return light == math::Vec3(0.0f); }))
    return;
  std::vector<math::Vec3>& samples = io_light.layer(style, LayerKind::kAdd, map.size()).samples;
  const LightMapShape& own = lit.maps[map.face];
  const LuxelTexels luxels = find_luxel_texels(*lit.level, map);
  const auto along = [&](const math::Vec2d& texels, int axis, int nodes, int count) {
    if (count <= 1) return 0.0f;
    const double texel = texels[axis] - own.texture_mins[static_cast<std::size_t>(axis)];
    const double last_texel = (count - 1) * own.texels;
    return static_cast<float>(std::clamp(texel, 0.0, last_texel)) * static_cast<float>(nodes - 1) /
           static_cast<float>(last_texel);
  };
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const math::Vec2d texels = luxels.first + luxels.per_x * double(x) + luxels.per_y * double(y);
      const float row = along(texels, 1, grid.rows, own.height);
      const int top = static_cast<int>(row), bottom = std::min(top + 1, grid.rows - 1);
      const float column = along(texels, 0, grid.columns, own.width);
      const int left = static_cast<int>(column), right = std::min(left + 1, grid.columns - 1);
      const math::Vec3 above = glm::mix(gathered[grid.node(left, top)], gathered[grid.node(right, top)],
                                        column - static_cast<float>(left));
      const math::Vec3 below = glm::mix(gathered[grid.node(left, bottom)], gathered[grid.node(right, bottom)],
                                        column - static_cast<float>(left));
      samples[static_cast<std::size_t>(y * map.width + x)] +=
          glm::mix(above, below, row - static_cast<float>(top));
    }
  }
}

// The light that each node gets over all bounces of the light that is sent first.
// Each bounce reads `sent` and writes gathered_now, so the result does not depend on the order of the faces.
std::vector<math::Vec3> gather_light(const BouncedWorld& bounced, std::span<const std::uint32_t> seen,
                                     const BounceSettings& settings, std::vector<math::Vec3> sent,
                                     base::Jobs& io_jobs) {
  const std::size_t nodes = sent.size();
  std::vector<math::Vec3> gathered(nodes, math::Vec3(0.0f)), gathered_now(nodes);
  for (int bounce = 0; bounce < settings.count; ++bounce) {
    io_jobs.parallel_for(bounced.grids.size(), [&](std::size_t face) {
      const NodeGrid& grid = bounced.grids[face];
      const auto last = grid.first_node + static_cast<std::uint32_t>(grid.columns * grid.rows);
      for (std::size_t node = grid.first_node; node < last; ++node) {
        math::Vec3 sum(0.0f);
        for (std::size_t ray = 0; ray < kRays; ++ray)
          if (const std::uint32_t from = seen[node * kRays + ray]; from != kNoNode) sum += sent[from];
        gathered_now[node] = sum / float{kRays};
      }
    });
    for (std::size_t node = 0; node < nodes; ++node) {
      gathered[node] += gathered_now[node];
      sent[node] = gathered_now[node] * bounced.reflectance[bounced.face_of_node[node]];
    }
  }
  for (math::Vec3& light : gathered) light *= kFirstBounce / kReflectance * settings.scale;
  return gathered;
}

// The styles whose light bounces, in order.
std::vector<std::uint8_t> list_bouncing_styles(const BounceSettings& settings,
                                               const std::vector<FaceLight>& light) {
  std::set<std::uint8_t> styles{0};
  if (settings.styled)
    for (const FaceLight& face : light)
      for (const LightLayer& layer : face.layers)
        if (layer.kind == LayerKind::kAdd) styles.insert(layer.style);
  return {styles.begin(), styles.end()};
}

}  // namespace

BounceRays begin_bounces(const LitLevel& lit) {
  const BouncedWorld bounced = lay_nodes(lit);
  BounceRays rays;
  rays.begin_of_face.push_back(0);
  for (const NodeGrid& grid : bounced.grids)
    rays.begin_of_face.push_back(rays.begin_of_face.back() +
                                 static_cast<std::size_t>(grid.columns * grid.rows) * kRays);
  rays.seen.assign(rays.begin_of_face.back(), kNoNode);
  rays.is_traced.assign(bounced.grids.size(), 0);
  return rays;
}

bool trace_bounces(const LitLevel& lit, const RayScene& scene, std::span<const std::uint32_t> faces,
                   base::Jobs& io_jobs, base::FunctionRef<bool()> step, BounceRays& io_rays) {
  const BouncedWorld bounced = lay_nodes(lit);
  std::atomic<bool> stopped{false};
  io_jobs.parallel_for(faces.size(), [&](std::size_t i) {
    const std::uint32_t face = faces[i];
    if (io_rays.is_traced[face] != 0 || stopped.load(std::memory_order_relaxed)) return;
    if (bounced.grids[face].columns > 0) trace_face(lit, scene, bounced, face, io_rays.seen);
    io_rays.is_traced[face] = 1;
    if (!step()) stopped = true;
  });
  return !stopped;
}

bool are_bounces_for(const LitLevel& lit, std::span<const std::uint32_t> seen) {
  const std::size_t nodes = lay_nodes(lit).face_of_node.size();
  return seen.size() == nodes * kRays && std::all_of(seen.begin(), seen.end(), [&](std::uint32_t node) {
           return node < nodes || node == kNoNode;
         });
}

std::vector<math::Vec3> compute_first_bounces(const LitLevel& lit, const BounceSettings& settings,
                                              const std::optional<formats::Palette>& palette) {
  BouncedWorld bounced = lay_nodes(lit);
  if (palette && settings.color_scale > 0) tint_by_textures(lit, settings, *palette, bounced);
  const float scale = settings.count > 0 ? kFirstBounce / kReflectance * settings.scale : 0;
  for (std::size_t face = 0; face < bounced.reflectance.size(); ++face)
    bounced.reflectance[face] *= bounced.grids[face].columns > 0 ? scale : 0;
  return std::move(bounced.reflectance);
}

void add_bounced_light(const LitLevel& lit, std::span<const std::uint32_t> seen,
                       const BounceSettings& settings, const std::optional<formats::Palette>& palette,
                       base::Jobs& io_jobs, std::vector<FaceLight>& io_light) {
  BouncedWorld bounced = lay_nodes(lit);
  if (palette && settings.color_scale > 0) tint_by_textures(lit, settings, *palette, bounced);
  const std::size_t nodes = bounced.face_of_node.size();
  CHECK(seen.size() == nodes * kRays);
  for (const std::uint8_t style : list_bouncing_styles(settings, io_light)) {
    const std::vector<math::Vec3> gathered =
        gather_light(bounced, seen, settings, collect_emitted_light(bounced, io_light, style), io_jobs);
    io_jobs.parallel_for(lit.maps.size(), [&](std::size_t map) {
      const std::size_t face = lit.maps[map].face;
      if (bounced.grids[face].columns > 0 && lit.surface_keys(face).takes_bounce)
        add_to_map(lit, bounced.grids[face], lit.maps[map], gathered, style, io_light[map]);
    });
  }
}

}  // namespace temblor::compiler
