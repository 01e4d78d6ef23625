// Method: radiosity, gathered by rays. Every face gets a grid of nodes, one for every third luxel along each
// axis and at least on the rim. From each node go kRays rays, distributed by the cosine of their angle, and
// each remembers the node nearest to where it ends. The mean light of those nodes is what the node gets. So
// each ray is traced only once, however often the light bounces. Light is interpolated between nodes; those
// under brushes take the light of their neighbors. Dirt darkens bounced light, too.
//
// A face sends back the share of its light that its texture's mean color has of white; gray textures count as
// half of white. Light maps count light by 1 - s + s * cosine (s: _anglescale), where a matte surface gets
// the cosine only. Over all directions that is 2 - s times as much, so one bounce counts 2 - s times, too. No
// face sends back more than it gets.
#include "compiler/light/bounce.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <set>
#include <span>

#include "compiler/light/faces/fill_hidden.h"
#include "compiler/light/faces/light_bytes.h"
#include "compiler/light/faces/sample_points.h"
#include "compiler/light/shadows/dirt.h"
#include "compiler/light/sources/directions.h"
#include "world/face_at.h"

namespace temblor::compiler {
namespace {

constexpr int kLuxelsToNode = 3;
constexpr int kRays = 126;  // of each node; of the numbers near it, best for parallel plates
constexpr std::uint32_t kNoNode = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t kHiddenNode = kNoNode - 1;  // the ray begins in solid
constexpr float kFar = 1 << 20;                     // longer than any level
constexpr float kGrayReflectance = 127.0f / 255;    // reflected without the textures' colors

// The nodes of one face.
struct NodeGrid {
  std::uint32_t first_node = 0;
  int columns = 0, rows = 0;  // in nodes; 0: the face gets no light
  int width = 0, height = 0;  // in luxels
  bool gets_light_behind = false;

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

// The nodes of all faces.
struct BouncedWorld {
  std::vector<NodeGrid> grids;  // by face
  std::vector<std::uint32_t> face_of_node;
};

// Lays a grid of nodes on each face that gets light, in the order of the faces, so that node numbers depend
// only on the level.
BouncedWorld lay_nodes(const LitLevel& lit) {
  const world::Level& level = *lit.level;
  BouncedWorld bounced;
  bounced.grids.resize(level.faces.size());
  for (std::size_t face = 0; face < level.faces.size(); ++face) {
    if (!lit.gets_light[face]) continue;
    const world::Face& shape = level.faces[face];
    NodeGrid& grid = bounced.grids[face];
    grid = {static_cast<std::uint32_t>(bounced.face_of_node.size()),
            count_nodes_along(shape.light_width()),
            count_nodes_along(shape.light_height()),
            shape.light_width(),
            shape.light_height(),
            lit.takes_light_behind(face)};
    bounced.face_of_node.insert(bounced.face_of_node.end(),
                                static_cast<std::size_t>(grid.columns * grid.rows),
                                static_cast<std::uint32_t>(face));
  }
  return bounced;
}

// The mean color of a texture's visible texels, 0 to 1; gray for missing texels.
math::Vec3 find_mean_color(const world::Texture& texture, const formats::Palette& palette) {
  constexpr std::uint8_t kHole = 255;
  math::Vec3d sum(0.0);
  double count = 0;
  for (const std::uint8_t texel : texture.mips[0]) {
    if (texture.kind == world::TextureKind::kCutout && texel == kHole) continue;
    sum += math::Vec3d(palette[texel].r, palette[texel].g, palette[texel].b);
    ++count;
  }
  return count > 0 ? math::Vec3(sum / (count * 255)) : math::Vec3(kGrayReflectance);
}

// The share of light that each face sends back, by channel, 0 to 1; 0 for those that take no part.
std::vector<math::Vec3> find_reflectances(const LitLevel& lit, const BounceSettings& settings,
                                          const std::optional<formats::Palette>& palette) {
  const world::Level& level = *lit.level;
  std::vector<math::Vec3> of_texture(level.textures.size(), math::Vec3(kGrayReflectance));
  if (palette && settings.color_scale > 0)
    for (std::size_t i = 0; i < of_texture.size(); ++i)
      of_texture[i] =
          glm::mix(of_texture[i], find_mean_color(level.textures[i], *palette), settings.color_scale);
  const float over_all_angles = 2 - settings.angle_scale;
  std::vector<math::Vec3> reflectances(level.faces.size(), math::Vec3(0.0f));
  for (std::size_t face = 0; face < level.faces.size(); ++face)
    if (lit.gets_light[face] && lit.surface_keys(face).takes_bounce)
      reflectances[face] = glm::min(of_texture[base::to_size(level.faces[face].texture)] * over_all_angles *
                                        lit.surface_keys(face).bounce_scale,
                                    math::Vec3(1.0f));
  return reflectances;
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

// Moves places a little toward the middle of their face: rays from a place right on the edge of a brush would
// see nothing but its sides.
std::vector<math::Vec3> move_off_edges(const LightGrid& grid, std::vector<math::Vec3> places) {
  constexpr double kUnits = 0.5;
  for (math::Vec3& place : places) {
    math::Vec3d way = grid.middle_world - math::Vec3d(place);
    way -= grid.normal * glm::dot(way, grid.normal);
    const double length = glm::length(way);
    if (length > kUnits) place += math::Vec3(way * (kUnits / length));
  }
  return places;
}

// The direction of a ray. A face that gets light from both sides, as liquids do, looks to each with half of
// the rays.
math::Vec3 find_ray_direction(const NodeGrid& grid, const Frame& frame, int ray) {
  if (!grid.gets_light_behind) return in_frame(frame, cosine_direction(ray, kRays));
  math::Vec3 direction = cosine_direction(ray / 2, kRays / 2);
  if (ray % 2 == 1) direction.z = -direction.z;
  return in_frame(frame, direction);
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
  const SamplePoints samples = sample_luxels(lit, scene, grid, luxels);
  const std::vector<math::Vec3> places = move_off_edges(grid, samples.points);
  const Frame frame = frame_around(math::Vec3(grid.normal));
  std::vector<math::Vec3> directions(places.size());
  std::vector<RayHit> hits(places.size());
  for (int ray = 0; ray < kRays; ++ray) {
    std::fill(directions.begin(), directions.end(), find_ray_direction(nodes, frame, ray));
    scene.find_nearest(places, directions, kFar, hits);
    for (std::size_t i = 0; i < places.size(); ++i) {
      std::uint32_t seen = samples.is_hidden(i) ? kHiddenNode : kNoNode;
      if (const RayHit& hit = hits[i]; seen == kNoNode && hit.surface != RayHit::kNone) {
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

// The mean of the luxels around a node of a face.
template <typename Value>
Value find_mean_around(const NodeGrid& grid, int column, int row, const std::vector<Value>& luxels) {
  constexpr int kAround = kLuxelsToNode / 2;
  const auto x = static_cast<int>(std::lround(find_luxel_at_node(column, grid.columns, grid.width)));
  const auto y = static_cast<int>(std::lround(find_luxel_at_node(row, grid.rows, grid.height)));
  Value sum(0.0f);
  float count = 0;
  for (int v = std::max(0, y - kAround); v <= std::min(grid.height - 1, y + kAround); ++v)
    for (int u = std::max(0, x - kAround); u <= std::min(grid.width - 1, x + kAround); ++u, ++count)
      sum += luxels[static_cast<std::size_t>(v * grid.width + u)];
  return sum / count;
}

// The light of a style that each node reflects: the mean of the luxels around it, times the reflectance.
std::vector<math::Vec3> collect_emitted_light(const BouncedWorld& bounced,
                                              std::span<const math::Vec3> reflectances,
                                              const std::vector<FaceLight>& light, std::uint8_t style) {
  std::vector<math::Vec3> sent(bounced.face_of_node.size(), math::Vec3(0.0f));
  for (std::size_t face = 0; face < bounced.grids.size(); ++face) {
    const NodeGrid& grid = bounced.grids[face];
    const LightLayer* layer = light[face].find(style, LayerKind::kAdd);
    if (grid.columns == 0 || layer == nullptr) continue;
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column)
        sent[grid.node(column, row)] =
            find_mean_around(grid, column, row, layer->samples) * reflectances[face];
  }
  return sent;
}

// By light map and luxel, the share of bounced light that dirt leaves; empty without dirt.
using DirtShares = std::vector<std::vector<float>>;
DirtShares find_dirt_shares(const DirtSettings& dirt, const std::vector<FaceLight>& light) {
  DirtShares shares(light.size());
  if (!dirt.is_taken(0)) return shares;
  for (std::size_t map = 0; map < light.size(); ++map)
    for (const float around : light[map].dirt)
      shares[map].push_back(find_share_after_dirt(around, dirt.scale, dirt.gain));
  return shares;
}

// The share of gathered light that each node sends back: the reflectance, less the dirt around it.
std::vector<math::Vec3> find_sent_shares(const BouncedWorld& bounced,
                                         std::span<const math::Vec3> reflectances,
                                         const DirtShares& dirt_shares) {
  std::vector<math::Vec3> shares(bounced.face_of_node.size());
  for (std::size_t face = 0; face < bounced.grids.size(); ++face) {
    const NodeGrid& grid = bounced.grids[face];
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column)
        shares[grid.node(column, row)] =
            reflectances[face] *
            (dirt_shares[face].empty() ? 1 : find_mean_around(grid, column, row, dirt_shares[face]));
  }
  return shares;
}

// The gathered light of a light map, whose scale may differ from that of the nodes; empty if it is black.
std::vector<math::Vec3> interpolate_nodes(const LitLevel& lit, const NodeGrid& grid, const LightMapShape& map,
                                          const std::vector<math::Vec3>& gathered,
                                          std::span<const float> dirt_shares) {
  const std::uint32_t end = grid.first_node + static_cast<std::uint32_t>(grid.columns * grid.rows);
  if (std::all_of(gathered.begin() + grid.first_node, gathered.begin() + end,
                  [](const math::Vec3& light) { return light == math::Vec3(0.0f); }))
    return {};
  std::vector<math::Vec3> samples(map.size());
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
      const auto luxel = static_cast<std::size_t>(y * map.width + x);
      samples[luxel] = glm::mix(above, below, row - static_cast<float>(top)) *
                       (dirt_shares.empty() ? 1 : dirt_shares[luxel]);
    }
  }
  return samples;
}

// Adds bounced light to a face. It comes from all around the normal; the mean direction, weighted by the
// cosine, is two thirds of the normal.
void add_to_face(std::span<const math::Vec3> bounced_light, std::uint8_t style,
                 const std::optional<math::Vec3>& normal, FaceLight& io_light) {
  std::vector<math::Vec3>& samples = io_light.layer(style, LayerKind::kAdd, bounced_light.size()).samples;
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += bounced_light[i];
  if (!normal) return;
  std::vector<math::Vec3>& directions =
      io_light.layer(style, LayerKind::kDirection, bounced_light.size()).samples;
  for (std::size_t i = 0; i < directions.size(); ++i)
    directions[i] += *normal * (max_channel(bounced_light[i]) * 2 / 3);
}

// The light that each node gets over all bounces of the light that is sent first.
// Each bounce reads `sent` and writes gathered_now, so the result does not depend on the order of the faces.
std::vector<math::Vec3> gather_light(const BouncedWorld& bounced, std::span<const std::uint32_t> seen,
                                     std::span<const math::Vec3> sent_shares, const BounceSettings& settings,
                                     std::vector<math::Vec3> sent, base::Jobs& io_jobs) {
  const std::size_t nodes = sent.size();
  std::vector<math::Vec3> gathered(nodes, math::Vec3(0.0f)), gathered_now(nodes);
  std::vector<std::uint8_t> hidden(nodes);
  for (std::size_t node = 0; node < nodes; ++node) hidden[node] = seen[node * kRays] == kHiddenNode ? 1 : 0;
  for (int bounce = 0; bounce < settings.count; ++bounce) {
    io_jobs.parallel_for(bounced.grids.size(), [&](std::size_t face) {
      const NodeGrid& grid = bounced.grids[face];
      const auto last = grid.first_node + static_cast<std::uint32_t>(grid.columns * grid.rows);
      for (std::size_t node = grid.first_node; node < last; ++node) {
        math::Vec3 sum(0.0f);
        for (std::size_t ray = 0; ray < kRays; ++ray)
          if (const std::uint32_t from = seen[node * kRays + ray]; from < kHiddenNode) sum += sent[from];
        gathered_now[node] = sum / static_cast<float>(grid.gets_light_behind ? kRays / 2 : kRays);
      }
      fill_hidden(grid.columns, grid.rows, std::span(hidden).subspan(grid.first_node, last - grid.first_node),
                  std::span(gathered_now).subspan(grid.first_node, last - grid.first_node));
    });
    for (std::size_t node = 0; node < nodes; ++node) {
      gathered[node] += gathered_now[node];
      sent[node] = gathered_now[node] * sent_shares[node];
    }
  }
  for (math::Vec3& light : gathered) light *= settings.scale;
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
           return node < nodes || node >= kHiddenNode;
         });
}

std::vector<math::Vec3> compute_first_bounces(const LitLevel& lit, const BounceSettings& settings,
                                              const std::optional<formats::Palette>& palette) {
  std::vector<math::Vec3> shares = find_reflectances(lit, settings, palette);
  for (math::Vec3& share : shares) share *= settings.count > 0 ? settings.scale : 0.0f;
  return shares;
}

void add_bounced_light(const LitLevel& lit, std::span<const std::uint32_t> seen,
                       const LightSettings& settings, const std::optional<formats::Palette>& palette,
                       base::Jobs& io_jobs, std::vector<FaceLight>& io_light) {
  const BounceSettings& bounce = settings.bounce;
  const BouncedWorld bounced = lay_nodes(lit);
  const std::vector<math::Vec3> reflectances = find_reflectances(lit, bounce, palette);
  const DirtShares dirt_shares = find_dirt_shares(settings.dirt, io_light);
  const std::vector<math::Vec3> sent_shares = find_sent_shares(bounced, reflectances, dirt_shares);
  const std::size_t nodes = bounced.face_of_node.size();
  CHECK(seen.size() == nodes * kRays);
  for (const std::uint8_t style : list_bouncing_styles(bounce, io_light)) {
    const std::vector<math::Vec3> gathered =
        gather_light(bounced, seen, sent_shares, bounce,
                     collect_emitted_light(bounced, reflectances, io_light, style), io_jobs);
    io_jobs.parallel_for(lit.maps.size(), [&](std::size_t map) {
      const std::size_t face = lit.maps[map].face;
      if (bounced.grids[face].columns == 0 || !lit.surface_keys(face).takes_bounce) return;
      const std::vector<math::Vec3> light =
          interpolate_nodes(lit, bounced.grids[face], lit.maps[map], gathered, dirt_shares[map]);
      if (light.empty()) return;
      std::optional<math::Vec3> normal;
      if (settings.has_directions)
        normal = math::Vec3(world::compute_face_plane(*lit.level, lit.level->faces[face]).normal);
      add_to_face(light, style, normal, io_light[map]);
    });
  }
}

}  // namespace temblor::compiler
