#include "world/loading/light_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "formats/levels/decoupled_light.h"
#include "formats/levels/scaled_light.h"
#include "world/animation.h"
#include "world/face_at.h"
#include "world/loading/texel_range.h"

namespace temblor::world {
namespace {

constexpr std::int32_t kStockTexels = 16;

// Compilers let few large faces share light samples, if any. A malicious file could let all of them share one
// large light map, and so ask for far more surface memory than the file has bytes.
constexpr std::uint64_t kMaxSharing = 64;
// Faces with few samples of their own need surface memory too. This allows for that of 4,000 tiles of 256
// texels.
constexpr std::uint64_t kMinAllowedSamples = 1 << 20;

// The light map of a face as a lump describes it; offset -1: none.
struct MapSource {
  formats::FaceStyles styles;
  std::int32_t offset;
  LightMapGrid grid;
};

std::uint64_t count_samples(std::int32_t width, std::int32_t height) {
  return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
}

// Whether a face may have light. Most compilers mark liquids as never lit.
bool can_be_lit(const formats::Bsp& bsp, const Level& level, std::size_t number) {
  const FaceKind kind = level.faces[number].kind;
  return kind == FaceKind::kLit ||
         (kind == FaceKind::kLiquid && (bsp.texinfos[bsp.faces[number].texinfo].flags & kFlagNoLight) == 0);
}

// Sets a face's styles and first sample; an offset of -1 is no light. `samples` for each style must be inside
// of the level's; after an error, the face has no light.
base::Status set_light(const Level& level, const formats::FaceStyles& styles, std::int32_t offset,
                       std::uint64_t samples, std::size_t number, Face& io_face) {
  io_face.styles = {kNoStyle, kNoStyle, kNoStyle, kNoStyle};
  io_face.style_count = 0;
  io_face.light = kNoLight;
  const auto count = static_cast<std::uint8_t>(std::ranges::find(styles, kNoStyle) - styles.begin());
  if (offset < 0 || count == 0) return base::Ok{};
  const auto first = static_cast<std::uint64_t>(offset);
  const std::uint64_t all_samples = samples * count;
  if (first + all_samples > level.light.size())
    return base::malformed("face {}: its {} light samples at {} are outside of the level's {}", number,
                           all_samples, first, level.light.size());
  // No game can set a higher style. In the original, those have normal light, as style 0 has.
  for (std::size_t i = 0; i < count; ++i)
    io_face.styles[i] = styles[i] < kLightStyles ? styles[i] : std::uint8_t{0};
  io_face.style_count = count;
  io_face.light = static_cast<std::uint32_t>(first);
  return base::Ok{};
}

// Engines ignored any light of liquids, so light with unknown styles is ignored too.
bool has_only_known_styles(const formats::FaceStyles& styles) {
  const auto end = std::ranges::find(styles, kNoStyle);
  return std::all_of(styles.begin(), end, [](std::uint8_t style) { return style < kLightStyles; });
}

// How many samples may have surfaces for them.
std::uint64_t count_allowed_samples(const Level& level) {
  return std::max(level.light.size() * kMaxSharing, kMinAllowedSamples);
}

// The file stores only the offset of the samples; their number follows from the size of the face and the
// number of its styles. A face whose samples would be outside of the level's has none, and neither has a
// large one beyond the limit.
void set_stock_maps(const formats::Bsp& bsp, Level& io_level) {
  const std::uint64_t allowed = count_allowed_samples(io_level);
  std::uint64_t samples = 0;
  std::size_t outside = 0, crowded = 0;
  for (std::size_t i = 0; i < io_level.faces.size(); ++i) {
    Face& face = io_level.faces[i];
    const formats::BspFace& from = bsp.faces[i];
    const std::uint64_t own = count_samples(face.light_width(), face.light_height());
    bool is_lit = can_be_lit(bsp, io_level, i);
    if (face.kind == FaceKind::kLiquid) is_lit &= has_only_known_styles(from.styles);
    const bool is_crowded = is_lit && from.light_offset >= 0 && face.is_large() && samples + own > allowed;
    if (is_crowded) ++crowded;
    const std::int32_t offset = is_lit && !is_crowded ? from.light_offset : -1;
    if (!set_light(io_level, from.styles, offset, own, i, face).ok() && face.kind == FaceKind::kLit)
      ++outside;
    if (face.light != kNoLight && face.is_large()) samples += own;
  }
  if (outside > 0)
    io_level.notes.push_back(fmt::format("{} with light samples outside of the level's {}: no light there",
                                         base::counted(outside, "face"), io_level.light.size()));
  if (crowded > 0)
    io_level.notes.push_back(fmt::format("{} too large to share the level's {} light samples: no light there",
                                         base::counted(crowded, "face"), io_level.light.size()));
}

bool is_multiple(double value, double unit) {
  constexpr double kRounding = 1e-6;
  return std::abs(value - std::round(value / unit) * unit) < kRounding;
}

// Whether all samples lie at multiples of `texels` from the face's first texel. Rows of samples may run along
// s or t.
bool lies_on_lattice(const LightMapGrid& grid, std::int32_t texels) {
  constexpr double kParallel = 1e-9;
  const auto fits = [&](double per_texel, double first, double per_other_texel, double other_first) {
    return per_texel != 0 && per_other_texel != 0 && is_multiple(1 / per_texel, texels) &&
           is_multiple(first / per_texel, texels) && is_multiple(1 / per_other_texel, texels) &&
           is_multiple(other_first / per_other_texel, texels);
  };
  if (std::abs(grid.per_s.y) < kParallel && std::abs(grid.per_t.x) < kParallel)
    return fits(grid.per_s.x, grid.first.x, grid.per_t.y, grid.first.y);
  return std::abs(grid.per_s.x) < kParallel && std::abs(grid.per_t.y) < kParallel &&
         fits(grid.per_s.y, grid.first.y, grid.per_t.x, grid.first.x);
}

// The coarsest lattice that contains all samples shows them exactly. Other grids get two points for each
// sample.
std::int32_t choose_lattice_texels(const LightMapGrid& grid) {
  const math::Vec2d step = glm::max(glm::abs(grid.per_s), glm::abs(grid.per_t));
  const double samples_per_texel = std::max(step.x, step.y);
  for (std::int32_t texels = kStockTexels; texels > 1; texels /= 2)
    if (lies_on_lattice(grid, texels) || samples_per_texel * texels <= 0.5) return texels;
  return 1;
}

bool is_stock(const LightMapGrid& grid, const Face& face) {
  constexpr double kPerTexel = 1.0 / kStockTexels;
  return grid.width == face.light_width() && grid.height == face.light_height() &&
         grid.first == math::Vec2d(0.0) && grid.per_s == math::Vec2d(kPerTexel, 0) &&
         grid.per_t == math::Vec2d(0, kPerTexel);
}

// A grid with a sample at each multiple of `texels`, which covers the face.
LightMapGrid make_scaled_grid(const Level& level, const Face& face, std::int32_t texels) {
  const double per_texel = 1.0 / texels;
  LightMapGrid grid{};
  for (const int axis : {0, 1}) {
    const TexelRange range = find_texel_range(level, face, axis);
    const double first = std::floor(range.min * per_texel);
    const auto samples = static_cast<std::int32_t>(std::ceil(range.max * per_texel) - first) + 1;
    (axis == 0 ? grid.width : grid.height) = samples;
    grid.first[axis] = face.texture_mins[static_cast<std::size_t>(axis)] * per_texel - first;
  }
  grid.per_s = {per_texel, 0};
  grid.per_t = {0, per_texel};
  return grid;
}

// The grid of a face whose texture axes do not span its plane: all texels have the light of its first corner.
void pin_to_first_corner(const Level& level, const Face& face, const math::Vec3d& x_axis,
                         const math::Vec3d& y_axis, LightMapGrid& io_grid) {
  const math::Vec3d corner(level.vertices[level.surfedge_start(face.first_surfedge)]);
  io_grid.first += math::Vec2d(glm::dot(corner, x_axis), glm::dot(corner, y_axis));
}

// The grid as a function of texels instead of positions.
LightMapGrid make_decoupled_grid(const Level& level, const Face& face,
                                 const formats::DecoupledLightMap& map) {
  constexpr double kMinVolume = 1e-6;
  const TextureAxes& axes = level.texture_axes[face.axes];
  const FacePlane plane = compute_face_plane(level, face);
  const math::Vec3d s(axes.s_axis), t(axes.t_axis), n = plane.normal, x(map.x_axis), y(map.y_axis);
  LightMapGrid grid{};
  grid.width = map.width;
  grid.height = map.height;
  grid.first = {double{map.x_offset}, double{map.y_offset}};
  const double volume = glm::dot(glm::cross(s, t), n);
  if (!(std::abs(volume) > kMinVolume * glm::length(s) * glm::length(t))) {
    pin_to_first_corner(level, face, x, y, grid);
    return grid;
  }
  // How far a position in the plane moves for a step of one texel, and for one unit of the plane's distance.
  const math::Vec3d by_s = glm::cross(t, n) / volume, by_t = glm::cross(n, s) / volume,
                    by_n = glm::cross(s, t) / volume;
  const math::Vec3d first_texel = by_s * (double(face.texture_mins[0]) - double{axes.s_offset}) +
                                  by_t * (double(face.texture_mins[1]) - double{axes.t_offset}) +
                                  by_n * plane.distance;
  grid.first += math::Vec2d(glm::dot(first_texel, x), glm::dot(first_texel, y));
  grid.per_s = {glm::dot(by_s, x), glm::dot(by_s, y)};
  grid.per_t = {glm::dot(by_t, x), glm::dot(by_t, y)};
  return grid;
}

base::Result<std::vector<MapSource>> find_scaled_maps(const formats::Bsp& bsp, const Level& level) {
  std::vector<MapSource> sources;
  TRY(const std::vector<formats::ScaledLightMap> maps, formats::read_scaled_light(bsp));
  sources.reserve(maps.size());
  for (std::size_t i = 0; i < maps.size(); ++i)
    sources.push_back(
        {maps[i].styles, maps[i].offset, make_scaled_grid(level, level.faces[i], 1 << maps[i].shift)});
  return sources;
}

base::Result<std::vector<MapSource>> find_decoupled_maps(const formats::Bsp& bsp, const Level& level) {
  std::vector<MapSource> sources;
  TRY(const std::vector<formats::DecoupledLightMap> maps, formats::read_decoupled_light(bsp));
  if (maps.empty()) return sources;
  TRY(const std::vector<formats::FaceStyles> styles, formats::read_face_styles(bsp));
  sources.reserve(maps.size());
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const bool has_samples = maps[i].width > 0 && maps[i].height > 0;
    sources.push_back(
        {styles[i], has_samples ? maps[i].offset : -1, make_decoupled_grid(level, level.faces[i], maps[i])});
  }
  return sources;
}

// Gives the faces the light maps of a lump, one for each face. After an error, the faces are in an unknown
// state.
base::Status set_maps(const formats::Bsp& bsp, const std::vector<MapSource>& sources, Level& io_level) {
  io_level.light_map_grids.clear();
  const std::uint64_t allowed = count_allowed_samples(io_level);
  std::uint64_t stock_samples = 0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    Face& face = io_level.faces[i];
    LightMapGrid grid = sources[i].grid;
    const std::int32_t offset = can_be_lit(bsp, io_level, i) ? sources[i].offset : -1;
    TRY_STATUS(
        set_light(io_level, sources[i].styles, offset, count_samples(grid.width, grid.height), i, face));
    if (face.light == kNoLight) continue;
    // Surfaces are as large as the face, whatever the size of its light map.
    stock_samples += count_samples(face.light_width(), face.light_height());
    if (stock_samples > allowed)
      return base::malformed("face {}: the faces up to this one are too large for {} light samples", i,
                             io_level.light.size());
    if (is_stock(grid, face)) continue;
    grid.texels = choose_lattice_texels(grid);
    face.light_map_grid = static_cast<std::uint32_t>(io_level.light_map_grids.size());
    io_level.light_map_grids.push_back(grid);
  }
  return base::Ok{};
}

// Undoes set_maps().
void clear_maps(Level& io_level) {
  io_level.light_map_grids.clear();
  for (Face& face : io_level.faces) face.light_map_grid = kStockGrid;
}

// Returns whether the lump exists and fits the level; if it does not fit, adds a note.
bool use_maps(const formats::Bsp& bsp, const base::Result<std::vector<MapSource>>& sources, const char* lump,
              Level& io_level) {
  base::Status status = base::Ok{};
  if (!sources.ok())
    status = sources.error();
  else if (sources->empty())
    return false;
  else
    status = set_maps(bsp, *sources, io_level);
  if (status.ok()) return true;
  clear_maps(io_level);
  const std::string& what = status.error().what;
  const std::string place = what.starts_with("lump") ? "" : fmt::format("lump {}: ", lump);
  io_level.notes.push_back(fmt::format("{}{}; it is ignored", place, what));
  return false;
}

// Makes liquids without samples dark, like other faces, if the level has light for other liquids. A compiler
// stores no samples for a face that no light reaches. The first sample of a face without styles does not
// matter.
void darken_liquids(const formats::Bsp& bsp, Level& io_level) {
  const bool has_lit_liquids = std::ranges::any_of(io_level.faces, [](const Face& face) {
    return face.kind == FaceKind::kLiquid && face.light != kNoLight;
  });
  if (!has_lit_liquids) return;
  const std::uint64_t allowed = count_allowed_samples(io_level);
  std::uint64_t samples = 0;
  for (std::size_t i = 0; i < io_level.faces.size(); ++i) {
    Face& face = io_level.faces[i];
    if (face.kind != FaceKind::kLiquid || face.light != kNoLight || !can_be_lit(bsp, io_level, i)) continue;
    samples += count_samples(face.light_width(), face.light_height());
    if (samples > allowed) return;
    face.light = 0;
  }
}

}  // namespace

void set_light_maps(const formats::Bsp& bsp, Level& io_level) {
  if (!use_maps(bsp, find_decoupled_maps(bsp, io_level), "DECOUPLED_LM", io_level) &&
      !use_maps(bsp, find_scaled_maps(bsp, io_level), "LMSHIFT", io_level))
    set_stock_maps(bsp, io_level);
  darken_liquids(bsp, io_level);
}

}  // namespace temblor::world
