#include "lab/world_light/effects/change_block.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/hash.h"
#include "render/edges/face_outlines.h"
#include "render/view/model_view.h"

namespace temblor::lab {

namespace {

using render::BlockRequest;

// Floors and ceilings are flatter than this.
constexpr double kSteepest = 0.7;
constexpr double kNodeRange = 32767;
constexpr double kBiasUnit = 4096;
// Bounds of the bias; a pattern has 255.
constexpr double kMaxBias = 1000;
// The bias may change by so much over a row.
constexpr double kMaxRowBias = 1e5;
// Patterns jump back after so long, because times of demos may be of any size.
constexpr double kPeriod_s = 3600;

// The pattern's bias on a block: linear in its columns and rows.
struct Bias {
  double first = 0, per_column = 0, per_row = 0;
};

struct FaceHeights {
  double bottom_units;      // of the lowest corner
  math::Vec3d first_texel;  // the point whose s and t are 0
};

FaceHeights find_heights(const world::Level& level, const world::Face& face,
                         const render::FacePlacement& placed, const render::TexelSteps& steps) {
  const auto corner = [&](std::uint32_t i) {
    return math::Vec3d(level.vertices[level.surfedge_start(face.first_surfedge + i)]);
  };
  const math::Vec3d at = corner(0);
  FaceHeights heights{at.z, at - steps.s * (glm::dot(placed.s_axis, at) + placed.s_offset) -
                                steps.t * (glm::dot(placed.t_axis, at) + placed.t_offset)};
  for (std::uint32_t i = 1; i < face.surfedge_count; ++i)
    heights.bottom_units = std::min(heights.bottom_units, corner(i).z);
  return heights;
}

Bias find_bias(const PatternStyle& style, const FaceHeights& heights, const render::TexelSteps& steps,
               const BlockRequest& request) {
  const double texel = std::ldexp(1.0, request.mip);
  const double s = request.tile_s * render::kTileTexels + texel / 2;
  const double t = request.tile_t * render::kTileTexels + texel / 2;
  const double height = (heights.first_texel + steps.s * s + steps.t * t).z - heights.bottom_units;
  return {style.bias_at_bottom + style.bias_per_unit * height, style.bias_per_unit * steps.s.z * texel,
          style.bias_per_unit * steps.t.z * texel};
}

// One octave of a block, row by row.
class OctaveRows {
 public:
  // `first_s` and `first_t`: the first texel of the block on the texture, in texels of the block, which are
  // 2^mip texels of mip 0. The pattern has moved down by `moved` texels of mip 0.
  OctaveRows(const Octave& octave, std::uint64_t seed, std::int64_t first_s, double first_t, int mip,
             std::size_t width, base::Arena& arena)
      : weight_(octave.weight * kNodeRange), seed_(seed), first_t_(first_t) {
    // Nodes closer together than texels would flicker between mip levels: their mean shows.
    is_even_ = octave.shift_s < mip || octave.shift_t < mip;
    row_.shift = std::max(octave.shift_s - mip, 0);
    nodes_per_texel_ = std::ldexp(1.0, mip - octave.shift_t);
    first_node_ = first_s >> row_.shift;
    row_.first = static_cast<std::int32_t>(first_s - (first_node_ << row_.shift));
    const std::size_t nodes = (width >> row_.shift) + 1 + kNodePadding;
    for (std::span<std::int32_t>* const out : {&above_, &below_}) *out = arena.allocate<std::int32_t>(nodes);
    between_ = arena.allocate_filled(nodes, static_cast<std::int32_t>(weight_ / 2));
    row_.nodes = between_.data();
  }

  // Row `y` of the block.
  const OctaveRow& at_row(std::int32_t y) {
    if (is_even_) return row_;
    const double at = (first_t_ + y) * nodes_per_texel_;
    const auto above = static_cast<std::int64_t>(std::floor(at));
    if (!row_above_ || *row_above_ != above) {
      fill(above, above_);
      fill(above + 1, below_);
      row_above_ = above;
    }
    const auto fraction = static_cast<std::int32_t>((at - static_cast<double>(above)) * 256);
    for (std::size_t i = 0; i < between_.size(); ++i)
      between_[i] = above_[i] + ((below_[i] - above_[i]) * fraction >> 8);
    return row_;
  }

 private:
  void fill(std::int64_t row, std::span<std::int32_t> out) const {
    const std::uint64_t of_row = base::hash_with(seed_, static_cast<std::uint64_t>(row));
    for (std::size_t i = 0; i < out.size(); ++i) {
      const std::uint64_t hash = base::hash_with(of_row, static_cast<std::uint64_t>(first_node_) + i);
      out[i] = static_cast<std::int32_t>(static_cast<double>(hash >> 40) * 0x1p-24 * weight_);
    }
  }

  const double weight_;
  const std::uint64_t seed_;
  const double first_t_;
  double nodes_per_texel_;
  std::int64_t first_node_;
  bool is_even_;
  OctaveRow row_{};
  std::optional<std::int64_t> row_above_;
  std::span<std::int32_t> above_, below_, between_;
};

// Texture axes of damaged levels may make it infinite, or not a number.
std::int32_t to_fixed(double bias, double max) {
  return static_cast<std::int32_t>((bias > -max ? std::min(bias, max) : -max) * kBiasUnit);
}

void change_row(const render::FrameContext& context, const PatternRow& row, std::byte* io_texels) {
  const bool simd = context.settings.simd_kernels;
  if (context.is_indexed())
    (simd ? change_row_u8_simd : change_row_u8_scalar)(row, reinterpret_cast<std::uint8_t*>(io_texels));
  else
    (simd ? change_row_u32_simd : change_row_u32_scalar)(row, reinterpret_cast<std::uint32_t*>(io_texels));
}

}  // namespace

void change_block(const render::FrameContext& context, const TexelPattern& pattern,
                  const BlockRequest& request, base::Arena& scratch) {
  scratch.reset();
  const world::Level& level = context.level();
  const world::Face& face = level.face(request.face);
  const render::FacePlacement placed = render::place_face(level, face, {});
  const std::optional<render::TexelSteps> steps = render::find_texel_steps(placed);
  const PatternStyle& style = pattern.style;
  const bool is_wall = std::abs(placed.normal.z) < kSteepest;
  if (!steps || face.kind != world::FaceKind::kLit || (style.only_walls && !is_wall)) return;

  const Bias bias = find_bias(style, find_heights(level, face, placed, *steps), *steps, request);
  const render::SurfaceShape shape = request.block.shape;
  const auto first = [&](std::int32_t mins, std::int64_t tile) {
    return render::at_mip(mins + tile * render::kTileTexels, request.mip);
  };
  const double down = placed.t_axis.z > 0 ? -1 : 1;  // of t
  const double time_s = std::isfinite(pattern.time_s) ? std::fmod(pattern.time_s, kPeriod_s) : 0;
  std::array<std::optional<OctaveRows>, kPatternOctaves> octaves;
  for (std::size_t i = 0; i < octaves.size(); ++i) {
    const Octave& octave = style.octaves[i];
    const double moved = std::ldexp(octave.texels_per_second * time_s * down, -request.mip);
    octaves[i].emplace(octave, i + 1, first(face.texture_mins[0], request.tile_s),
                       static_cast<double>(first(face.texture_mins[1], request.tile_t)) - moved, request.mip,
                       static_cast<std::size_t>(shape.width), scratch);
  }
  PatternRow row{};
  row.count = shape.width;
  row.bias_step = to_fixed(bias.per_column, kMaxRowBias / shape.width);
  row.inks = pattern.colors.inks.data();
  row.indices = pattern.colors.indices.data();
  row.clear = level.texture(request.contents.texture).name.starts_with('{') ? 255 : 256;
  const std::size_t row_bytes = static_cast<std::size_t>(shape.width) * (context.is_indexed() ? 1 : 4);
  const bool can_skip_rows = pattern.colors.inks[0] == kClearInk;
  for (std::int32_t y = 0; y < shape.height; ++y) {
    const double bias_first = bias.first + bias.per_row * y;
    if (can_skip_rows && std::max(bias_first, bias_first + bias.per_column * shape.width) < -256) continue;
    for (std::size_t i = 0; i < octaves.size(); ++i) row.octaves[i] = octaves[i]->at_row(y);
    row.bias_first = to_fixed(bias_first, kMaxBias);
    change_row(context, row, request.block.texels + static_cast<std::size_t>(y) * row_bytes);
  }
}

}  // namespace temblor::lab
