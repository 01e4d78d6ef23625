// Layout of `lighting`: for each lit face, in order, the samples of its styles, row by row.
//
//   face 0: style 0 [w * h bytes] style 32 [w * h bytes] | face 1: style 0 [w * h bytes] | ...
//           ^ light_offset of face 0                       ^ light_offset of face 1
//
// The .lit file, RGBLIGHTING, and LIGHTINGDIR have three bytes for each of these, in the same order.
#include "compiler/light/faces/light_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/bytes.h"
#include "compiler/light/faces/light_bytes.h"
#include "compiler/light/faces/light_directions.h"
#include "compiler/light/faces/min_light.h"
#include "compiler/light/faces/soften.h"
#include "formats/bspx/hdr_light.h"
#include "formats/levels/decoupled_light.h"
#include "formats/levels/scaled_light.h"

namespace temblor::compiler {
namespace {

constexpr float kValuePerStep = 2;  // of lights, for one step of a light map

// The packed samples of one style.
struct StyledSamples {
  std::uint8_t style = 0;
  std::vector<std::uint8_t> rgb, gray;
  std::vector<std::uint32_t> hdr;
  std::vector<std::uint8_t> directions;
  std::size_t brightness = 0;  // sum of all rgb
};

// The summed light of one style, or its directions.
std::vector<math::Vec3> find_sum(const FaceLight& light, std::uint8_t style, LayerKind kind,
                                 std::size_t luxels) {
  const LightLayer* sum = light.find(style, kind);
  return sum != nullptr ? sum->samples : std::vector<math::Vec3>(luxels, math::Vec3(0.0f));
}

// Limits and grays light as the brush asks.
math::Vec3 apply_brush_limits(const SurfaceKeys& keys, math::Vec3 light) {
  // In the steps of a light map with the usual _range.
  const float most = keys.max_light * kValuePerStep, brightest = max_channel(light);
  if (keys.max_light > 0 && brightest > most) light *= most / brightest;
  if (keys.light_color_scale == 1) return light;
  // Gray of the same brightness, so that the gray light map stays the same.
  return glm::mix(math::Vec3(max_channel(light)), light, keys.light_color_scale);
}

// Directions of the light of one style. `shown`: that light with all layers joined.
std::vector<std::uint8_t> pack_style_directions(const LitLevel& lit, const PackRules& rules, std::size_t map,
                                                const FaceLight& light, const LightLayer& shown) {
  const LightMapShape& shape = lit.maps[map];
  std::vector<math::Vec3> sums = find_sum(light, shown.style, LayerKind::kDirection, shape.size());
  std::vector<math::Vec3> directed = find_sum(light, shown.style, LayerKind::kAdd, shape.size());
  soften(rules.soft, shape.width, shape.height, sums);
  soften(rules.soft, shape.width, shape.height, directed);
  std::vector<float> undirected;
  for (std::size_t i = 0; i < directed.size(); ++i)
    undirected.push_back(std::max(0.0f, max_channel(shown.samples[i]) - max_channel(directed[i])));
  return pack_light_directions(lit, shape.face, sums, undirected);
}

// Joins the layers of one style and converts the result to bytes.
StyledSamples pack_style(const LitLevel& lit, const PackRules& rules, std::size_t map, const FaceLight& light,
                         std::uint8_t style) {
  const LightMapShape& shape = lit.maps[map];
  const SurfaceKeys& keys = lit.surface_keys(shape.face);
  const std::size_t luxels = shape.size();
  std::vector<math::Vec3> samples = find_sum(light, style, LayerKind::kAdd, luxels);
  if (style == 0) add_min_light(lit, rules.settings, map, light, samples);
  if (const LightLayer* raise = light.find(style, LayerKind::kRaise))
    for (std::size_t i = 0; i < luxels; ++i) samples[i] = glm::max(samples[i], raise->samples[i]);
  if (const LightLayer* less = light.find(style, LayerKind::kSubtract))
    for (std::size_t i = 0; i < luxels; ++i) samples[i] -= less->samples[i];
  soften(rules.soft, shape.width, shape.height, samples);
  StyledSamples result;
  result.style = style;
  for (const math::Vec3& sample : samples) {
    const math::Vec3 bytes = scale_to_bytes(rules.settings, apply_brush_limits(keys, sample));
    for (int channel = 0; channel < 3; ++channel) {
      result.rgb.push_back(round_to_byte(bytes[channel]));
      result.brightness += result.rgb.back();
    }
    result.gray.push_back(round_to_byte(max_channel(bytes)));
    if (rules.settings.has_hdr)
      result.hdr.push_back(formats::pack_e5bgr9(
          scale_to_steps(rules.settings, apply_brush_limits(keys, sample)) * formats::kHdrPerGrayStep));
  }
  if (rules.settings.has_directions)
    result.directions =
        pack_style_directions(lit, rules, map, light, {style, LayerKind::kAdd, std::move(samples)});
  return result;
}

// All packed styles of a light map.
struct FaceStyles {
  std::vector<StyledSamples> styles;  // at most four, the lowest first
  std::size_t dropped = 0;            // styles left out
};

// Style 0 is always tried, even without a light, because minimum light goes there.
FaceStyles pack_styles(const LitLevel& lit, const PackRules& rules, std::size_t map, const FaceLight& light) {
  std::array<bool, 256> used{};
  used[0] = true;
  for (const LightLayer& layer : light.layers) used[layer.style] = true;
  std::vector<StyledSamples> styles;
  for (std::size_t style = 0; style < used.size(); ++style) {
    if (!used[style]) continue;
    StyledSamples samples = pack_style(lit, rules, map, light, static_cast<std::uint8_t>(style));
    if (samples.brightness > 0) styles.push_back(std::move(samples));
  }
  constexpr std::size_t kMaxStyles = 4;
  if (styles.size() <= kMaxStyles) return {std::move(styles), 0};
  const std::size_t dropped = styles.size() - kMaxStyles;
  std::stable_sort(styles.begin(), styles.end(),
                   [](const auto& a, const auto& b) { return a.brightness > b.brightness; });
  styles.resize(kMaxStyles);
  std::sort(styles.begin(), styles.end(), [](const auto& a, const auto& b) { return a.style < b.style; });
  return {std::move(styles), dropped};
}

// Where a light map is in the level; offset -1: the face is dark.
struct MapPlace {
  std::array<std::uint8_t, 4> styles{255, 255, 255, 255};
  std::int32_t offset = -1;
};

// Appends a face's samples.
MapPlace append(const FaceStyles& map, formats::Bsp& io_bsp, PackedLight& io_packed) {
  MapPlace place;
  if (map.styles.empty()) return place;
  place.offset = static_cast<std::int32_t>(io_bsp.lighting.size());
  for (std::size_t i = 0; i < map.styles.size(); ++i) {
    const StyledSamples& samples = map.styles[i];
    place.styles[i] = samples.style;
    io_bsp.lighting.insert(io_bsp.lighting.end(), samples.gray.begin(), samples.gray.end());
    io_packed.lit.samples.insert(io_packed.lit.samples.end(), samples.rgb.begin(), samples.rgb.end());
    io_packed.hdr.insert(io_packed.hdr.end(), samples.hdr.begin(), samples.hdr.end());
    io_packed.directions.insert(io_packed.directions.end(), samples.directions.begin(),
                                samples.directions.end());
  }
  return place;
}

// By face, its best map: the number in LitLevel::maps, and where the samples are.
struct BestMap {
  std::size_t map;
  MapPlace place;
};

// Appends the maps of other scales, and returns the best map of each face.
std::vector<BestMap> append_other_scales(const LitLevel& lit, const std::vector<FaceStyles>& by_map,
                                         formats::Bsp& io_bsp, PackedLight& io_packed) {
  std::vector<BestMap> best;
  for (std::size_t face = 0; face < io_bsp.faces.size(); ++face)
    best.push_back({face, {io_bsp.faces[face].styles, io_bsp.faces[face].light_offset}});
  for (std::size_t map = best.size(); map < lit.maps.size(); ++map)
    best[lit.maps[map].face] = {map, append(by_map[map], io_bsp, io_packed)};
  return best;
}

// Describes the best maps by LMSHIFT, LMOFFSET, and LMSTYLE.
std::vector<formats::ScaledLightMap> describe_scaled(const LitLevel& lit, const std::vector<BestMap>& best) {
  std::vector<formats::ScaledLightMap> maps;
  for (const BestMap& one : best) {
    const auto texels = static_cast<std::uint32_t>(lit.maps[one.map].texels);
    maps.push_back({static_cast<std::uint8_t>(std::countr_zero(texels)), one.place.offset, one.place.styles});
  }
  return maps;
}

// Describes the best maps by DECOUPLED_LM. The usual map of a face over a million texels long does not fit;
// such a face is dark.
std::vector<formats::DecoupledLightMap> describe_decoupled(const LitLevel& lit,
                                                           const std::vector<BestMap>& best) {
  std::vector<formats::DecoupledLightMap> maps;
  for (const BestMap& one : best) {
    const LightMapShape& shape = lit.maps[one.map];
    const LuxelAxes axes = find_luxel_axes(*lit.level, shape);
    const bool fits = std::max(shape.width, shape.height) <= std::numeric_limits<std::uint16_t>::max();
    maps.push_back({static_cast<std::uint16_t>(shape.width), static_cast<std::uint16_t>(shape.height),
                    fits ? one.place.offset : -1, axes.x_axis, axes.x_offset, axes.y_axis, axes.y_offset});
  }
  return maps;
}

// Writes the lumps that describe the best maps. With decoupled maps there is no LMSHIFT, so that LMSTYLE has
// the styles of DECOUPLED_LM.
void describe_maps(const LitLevel& lit, const std::vector<BestMap>& best, formats::Bsp& io_bsp) {
  const bool has_decoupled = std::any_of(lit.maps.begin(), lit.maps.end(),
                                         [](const LightMapShape& map) { return map.is_decoupled; });
  if (!has_decoupled) return formats::set_scaled_light(describe_scaled(lit, best), io_bsp);
  std::vector<formats::FaceStyles> styles;
  for (const BestMap& one : best) styles.push_back(one.place.styles);
  formats::set_decoupled_light(describe_decoupled(lit, best), io_bsp);
  formats::set_face_styles(styles, io_bsp);
}

}  // namespace

PackedLight pack_light_maps(const LitLevel& lit, const PackRules& rules, const std::vector<FaceLight>& light,
                            base::Jobs& io_jobs, formats::Bsp& io_bsp, Warnings& io_warnings) {
  std::vector<FaceStyles> by_map(lit.maps.size());
  io_jobs.parallel_for(by_map.size(), [&](std::size_t map) {
    if (lit.gets_light[lit.maps[map].face]) by_map[map] = pack_styles(lit, rules, map, light[map]);
  });
  PackedLight packed;
  io_bsp.lighting.clear();
  std::size_t dropped = 0;
  for (std::size_t number = 0; number < io_bsp.faces.size(); ++number) {
    const MapPlace place = append(by_map[number], io_bsp, packed);
    io_bsp.faces[number].styles = place.styles;
    io_bsp.faces[number].light_offset = place.offset;
    dropped += by_map[number].dropped;
    if (lit.gets_light[number]) ++(place.offset < 0 ? packed.dark_faces : packed.lit_faces);
  }
  formats::set_scaled_light({}, io_bsp);
  formats::set_decoupled_light({}, io_bsp);
  if (lit.maps.size() > io_bsp.faces.size())
    describe_maps(lit, append_other_scales(lit, by_map, io_bsp, packed), io_bsp);
  for (std::size_t i = 0; i + 2 < packed.lit.samples.size() && !packed.colored; i += 3)
    packed.colored = packed.lit.samples[i] != packed.lit.samples[i + 1] ||
                     packed.lit.samples[i] != packed.lit.samples[i + 2];
  if (dropped > 0)
    io_warnings.push_back({"more than four light styles on one face",
                           fmt::format("{} style{} left out, the darkest on each face: use fewer switchable "
                                       "or flickering lights in one place",
                                       dropped, dropped == 1 ? "" : "s")});
  return packed;
}

}  // namespace temblor::compiler
