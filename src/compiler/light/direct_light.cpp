// Method: light after light, each for all luxels of the face, so that the rays of a packet run side by side.
// The light without shadows comes first; only luxels that it reaches trace rays.
#include "compiler/light/direct_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "compiler/light/faces/fill_hidden.h"
#include "compiler/light/faces/light_bytes.h"
#include "compiler/light/shadows/dirt.h"
#include "compiler/light/shadows/shadow_record.h"
#include "world/visibility.h"

namespace temblor::compiler {
namespace {

// Steps at the edge of a shadow below this many steps of the light map are not refined.
constexpr float kRoughBelow = 1;
constexpr std::uint32_t kWorldChannels = 1;  // of the world, the sky, and surface lights

// Bounds the sample points of a face, for quick tests against lights.
struct Sphere {
  math::Vec3 middle{0.0f};
  float radius = 0;
};

Sphere make_bounding_sphere(std::span<const math::Vec3> points) {
  math::Vec3 mins = points[0], maxs = points[0];
  for (const math::Vec3& point : points) {
    mins = glm::min(mins, point);
    maxs = glm::max(maxs, point);
  }
  return {(mins + maxs) * 0.5f, glm::length(maxs - mins) * 0.5f};
}

// Whether the face sticks out into a brush of sky.
bool lies_in_sky(const world::Level& level, std::span<const world::LeafIndex> leaves) {
  return std::any_of(leaves.begin(), leaves.end(), [&](world::LeafIndex leaf) {
    return level.leaf(leaf).contents == world::Contents::kSky;
  });
}

// Whether cached layers fit the map, since a damaged cache may hold anything.
bool are_of_size(std::span<const LightLayer> layers, std::size_t luxels) {
  return std::all_of(layers.begin(), layers.end(),
                     [&](const LightLayer& layer) { return layer.samples.size() == luxels; });
}

// The light factor for each quantized share.
constexpr std::array<float, kWholeShare + 1> kFactors = [] {
  std::array<float, kWholeShare + 1> factors{};
  for (std::size_t i = 0; i < factors.size(); ++i)
    factors[i] = static_cast<float>(i) / static_cast<float>(kWholeShare);
  return factors;
}();
math::Vec3 share_factor(const Share& share) {
  return {kFactors[share[0]], kFactors[share[1]], kFactors[share[2]]};
}

// Lights one light map. Holds what all lights share: sample points, normals, shadow filter and the cache's
// records.
class FaceLighter {
 public:
  // `learned`: outlives this; null: nothing is kept.
  FaceLighter(const DirectLightInput& input, LightGrid grid, SamplePoints places, LightCache::Map* learned)
      : input_(input),
        grid_(std::move(grid)),
        filter_(input.lit, input.scene, grid_, input.sampling, std::move(places)),
        places_(filter_.luxel_places().points),
        bounds_(make_bounding_sphere(places_)),
        flat_normal_(grid_.normal),
        is_flat_(!input.phong.is_curved(grid_.face) || grid_.corners_world.size() < 3),
        is_in_sky_(lies_in_sky(*input.lit.level, filter_.luxel_places().leaves)),
        is_lit_behind_(input.lit.takes_light_behind(grid_.face)),
        unshadowed_(places_.size()),
        known_(learned != nullptr && input.known != nullptr ? input.known->map(grid_.map) : nullptr),
        learned_(learned),
        shadows_before_(known_ != nullptr ? base::Bytes(known_->shadows) : base::Bytes(), places_.size()),
        shadows_(places_.size()) {
    if (!is_flat_) set_normals();
    if (input.needs_dirt && input.lit.surface_keys(grid_.face).takes_dirt) light_.dirt = dirt();
  }

  void add_all() {
    const std::vector<world::LeafIndex> leaves = input_.sight.find_leaves(grid_.face, filter_.luxel_places());
    const std::uint32_t channels = input_.lit.surface_keys(grid_.face).channels;
    for (std::size_t i = 0; i < input_.lights.size(); ++i) {
      const LightSource& light = input_.lights[i];
      if ((light.channels & channels) == 0 || !may_reach(light)) continue;
      // The world, which hides leaves from each other, may let light of other channels through.
      if ((light.shadow_channels & kWorldChannels) == 0 || input_.sight.light_may_reach(i, leaves)) add(i);
    }
    if ((channels & kWorldChannels) != 0 && input_.scene.has_sky() && !input_.beams.empty() &&
        input_.sight.sky_may_reach(leaves))
      add_sky();
  }

  // Hands over the light, and what a cache keeps of it.
  FaceLight take() && {
    if (learned_ != nullptr) {
      learned_->shadows = std::move(shadows_).take();
      learned_->dirt = light_.dirt;
    }
    std::vector<std::uint8_t> hidden;
    for (std::size_t i = 0; i < places_.size(); ++i) hidden.push_back(is_hidden(i) ? 1 : 0);
    for (LightLayer& layer : light_.layers) fill_hidden(grid_.width, grid_.height, hidden, layer.samples);
    return std::move(light_);
  }

 private:
  // The properties of a light or beam besides its value.
  struct Arriving {
    math::Vec3 color;
    std::uint8_t style;
    LayerKind kind;
    bool takes_dirt;
    std::optional<float> dirt_scale, dirt_gain;
    float bounce_scale;
    math::Vec3 source;  // where the light is; of a beam: the direction toward the sky
    bool is_beam;
  };

  // Adds one light.
  void add(std::size_t number) {
    const LightSource& light = input_.lights[number];
    lit_luxels_.clear();
    find_tints(light);
    float brightest = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      unshadowed_[i] = is_hidden(i) || is_dark_in_picture(i) ? 0 : compute_unshadowed(light, i);
      if (std::abs(unshadowed_[i]) <= kLightGate) continue;
      lit_luxels_.push_back(static_cast<std::uint32_t>(i));
      brightest = std::max(brightest, std::abs(unshadowed_[i]));
    }
    if (lit_luxels_.empty()) return;
    const LayerKind kind = light.attenuation == Attenuation::kLocalMinlight ? LayerKind::kRaise
                           : light.value < 0                                ? LayerKind::kSubtract
                                                                            : LayerKind::kAdd;
    const bool rough = is_rough(brightest);
    const Arriving arriving{light.color,        light.style,        kind,
                            light.takes_dirt,   light.dirt_scale,   light.dirt_gain,
                            light.bounce_scale, light.origin_world, false};
    deposit(find_shares(number, rough), arriving, light_);
    add_switched(arriving, rough, light.shadow_channels, light_, [&](const LightPath& path) {
      return [this, &light, path](std::span<const math::Vec3> points, std::span<math::Vec3> out) {
        input_.scene.trace_to_point(points, light.origin_world, out, path);
      };
    });
  }

  // The picture that the light throws on each luxel, if it projects one.
  void find_tints(const LightSource& light) {
    tints_.clear();
    if (!light.projection) return;
    const Projection& projection = input_.projections[*light.projection];
    const math::Vec3 across(grid_.column_step), along(grid_.row_step);
    for (const math::Vec3& place : places_)
      tints_.push_back(compute_projected_mean(projection, place - light.origin_world, across, along));
  }
  bool is_dark_in_picture(std::size_t luxel) const {
    return !tints_.empty() && tints_[luxel] == math::Vec3(0.0f);
  }

  // Light of style 0 behind switchable shadows comes back in their styles. `make_query(path)` returns a
  // ShareQuery.
  template <typename MakeQuery>
  void add_switched(Arriving arriving, bool rough, std::uint32_t shadow_channels, FaceLight& io_light,
                    const MakeQuery& make_query) {
    if (arriving.style != 0) return;
    LightPath path{model(), shadow_channels, LightPath::Switched::kOnly, 0, {}};
    for (const std::uint8_t style : input_.scene.switch_styles()) {
      path.only_style = arriving.style = style;
      const auto query = make_query(path);
      deposit(filter_.compute_shares(lit_luxels_, rough, query), arriving, io_light);
    }
  }
  LightPath find_path(std::uint8_t style, std::uint32_t shadow_channels) const {
    const bool stops = style == 0 && !input_.scene.switch_styles().empty();
    return {model(), shadow_channels, stops ? LightPath::Switched::kStop : LightPath::Switched::kPass, 0, {}};
  }

  // The shares of light that arrive at the lit luxels; from the cache, if it knows the same question. The
  // cache knows a light by its origin, so it has no shadows that depend on other keys of the light.
  std::span<const Share> find_shares(std::size_t number, bool rough) {
    const LightSource& light = input_.lights[number];
    const bool is_usual = light.shadow_channels == kWorldChannels && input_.scene.switch_styles().empty();
    std::optional<std::span<const Share>> shares;
    if (is_usual && known_ != nullptr && input_.known->cached_number(number) != CachedLight::kUnknown)
      shares = shadows_before_.find({input_.known->cached_number(number), lit_luxels_, rough});
    if (!shares)
      shares = filter_.compute_shares(
          lit_luxels_, rough, [&](std::span<const math::Vec3> points, std::span<math::Vec3> out) {
            input_.scene.trace_to_point(points, light.origin_world, out,
                                        find_path(light.style, light.shadow_channels));
          });
    if (is_usual && learned_ != nullptr)
      shadows_.add({static_cast<std::uint32_t>(number), lit_luxels_, rough}, *shares);
    return *shares;
  }

  // Sums the sky on its own, so that the cache can keep the sum.
  void add_sky() {
    FaceLight sky;
    sky.dirt = light_.dirt;
    if (known_ != nullptr && input_.known->holds_sky() && are_of_size(known_->sky, places_.size()))
      sky.layers = known_->sky;
    else
      for (const SkyBeam& beam : input_.beams) add(beam, sky);
    for (const LightLayer& from : sky.layers) {
      std::vector<math::Vec3>& samples = light_.layer(from.style, from.kind, places_.size()).samples;
      for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += from.samples[i];
    }
    if (learned_ != nullptr) learned_->sky = std::move(sky.layers);
  }

  // Adds one beam of the sky.
  void add(const SkyBeam& beam, FaceLight& io_sky) {
    if (is_flat_ && !is_lit_behind_ && glm::dot(flat_normal_, beam.toward_sky) <= 0) return;
    lit_luxels_.clear();
    tints_.clear();
    for (std::size_t i = 0; i < places_.size(); ++i) {
      unshadowed_[i] =
          beam.value * angle_factor(beam.angle_scale, find_facing(glm::dot(normal_at(i), beam.toward_sky)));
      if (unshadowed_[i] != 0 && !is_hidden(i)) lit_luxels_.push_back(static_cast<std::uint32_t>(i));
    }
    if (lit_luxels_.empty()) return;
    const auto make_query = [&](LightPath path) {
      path.sky_name = beam.sky_name;
      return [this, &beam, path](std::span<const math::Vec3> points, std::span<math::Vec3> out) {
        if (is_in_sky_)
          input_.scene.trace_to_void(points, beam.toward_sky, out, path);
        else
          input_.scene.trace_to_sky(points, beam.toward_sky, out, path);
      };
    };
    const bool rough = is_rough(std::abs(beam.value));
    const auto query = make_query(find_path(beam.style, kWorldChannels));
    const LayerKind kind = beam.value < 0 ? LayerKind::kSubtract : LayerKind::kAdd;
    const Arriving arriving{beam.color, beam.style, kind, beam.takes_dirt, {}, {}, 1, beam.toward_sky, true};
    deposit(filter_.compute_shares(lit_luxels_, rough, query), arriving, io_sky);
    add_switched(arriving, rough, kWorldChannels, io_sky, make_query);
  }

  // Dirt takes many rays for each luxel, so the cache is asked first.
  std::vector<float> dirt() {
    if (known_ != nullptr && input_.known->holds_dirt() && known_->dirt.size() == places_.size())
      return known_->dirt;
    if (is_flat_) set_normals();
    return compute_dirt(input_.scene, places_, normals_, input_.settings.dirt);
  }

  // Curved faces have a normal for each luxel; flat ones need them only for dirt.
  void set_normals() {
    normals_.reserve(places_.size());
    for (int row = 0; row < grid_.height; ++row)
      for (int column = 0; column < grid_.width; ++column)
        normals_.push_back(input_.phong.at(
            grid_, grid_.origin_world + grid_.column_step * double(column) + grid_.row_step * double(row)));
  }
  std::uint32_t model() const { return input_.lit.model_of_face[grid_.face]; }
  bool is_hidden(std::size_t luxel) const { return filter_.luxel_places().is_hidden(luxel); }
  const math::Vec3& normal_at(std::size_t luxel) const { return is_flat_ ? flat_normal_ : normals_[luxel]; }
  bool is_rough(float brightest) const { return brightest * input_.settings.range < kRoughBelow; }

  // A quick test by the light's reach and the side of the face that it is on.
  bool may_reach(const LightSource& light) const {
    const float reach = light_reach(light) + bounds_.radius;
    const math::Vec3 way = light.origin_world - bounds_.middle;
    if (glm::dot(way, way) > reach * reach) return false;
    return !is_flat_ || is_lit_behind_ ||
           glm::dot(flat_normal_, light.origin_world - places_[0]) > -bounds_.radius;
  }

  // The light at a luxel without shadows and dirt.
  float compute_unshadowed(const LightSource& light, std::size_t luxel) const {
    const math::Vec3 way = light.origin_world - places_[luxel];
    const float facing = find_facing(glm::dot(way, normal_at(luxel)));
    if (facing <= 0) return 0;
    const float distance = glm::length(way);
    float value = value_at(light, distance);
    if (std::abs(value) <= kLightGate) return 0;
    // A minimum is the same on every side.
    if (light.attenuation != Attenuation::kLocalMinlight)
      value *= angle_factor(light.angle_scale, facing / distance);
    return light.cone ? value * cone_factor(*light.cone, way / distance) : value;
  }

  // Adds arriving light to the layer of its style and kind.
  void deposit(std::span<const Share> shares, const Arriving& light, FaceLight& io_light) {
    if (std::all_of(shares.begin(), shares.end(), [](const Share& share) { return are_equal(share, {}); }))
      return;
    std::vector<math::Vec3>& samples = io_light.layer(light.style, light.kind, places_.size()).samples;
    const std::span<const float> dirt = find_dirt_shares(light, io_light);
    const bool bounces_as_usual = light.bounce_scale == 1 || light.kind != LayerKind::kAdd;
    const bool has_directions = input_.settings.has_directions && light.kind == LayerKind::kAdd;
    arriving_.clear();
    for (std::size_t i = 0; i < lit_luxels_.size(); ++i) {
      const std::uint32_t luxel = lit_luxels_[i];
      const float value = std::abs(unshadowed_[luxel]) * (dirt.empty() ? 1 : dirt[luxel]);
      math::Vec3 arriving = light.color * share_factor(shares[i]) * value;
      if (!tints_.empty()) arriving *= tints_[luxel];
      samples[luxel] =
          light.kind == LayerKind::kRaise ? glm::max(samples[luxel], arriving) : samples[luxel] + arriving;
      if (!bounces_as_usual || has_directions) arriving_.push_back(arriving);
    }
    if (has_directions) add_directions(light, io_light);
    if (bounces_as_usual) return;
    std::vector<math::Vec3>& more =
        io_light.layer(light.style, LayerKind::kBounceMore, places_.size()).samples;
    for (std::size_t i = 0; i < lit_luxels_.size(); ++i)
      more[lit_luxels_[i]] += arriving_[i] * (light.bounce_scale - 1);
  }

  // Adds the direction of light that has arrived. Light from behind counts as from the front.
  void add_directions(const Arriving& light, FaceLight& io_light) {
    std::vector<math::Vec3>& sums =
        io_light.layer(light.style, LayerKind::kDirection, places_.size()).samples;
    for (std::size_t i = 0; i < lit_luxels_.size(); ++i) {
      const std::uint32_t luxel = lit_luxels_[i];
      math::Vec3 toward = light.is_beam ? light.source : glm::normalize(light.source - places_[luxel]);
      const float facing = glm::dot(toward, flat_normal_);
      if (is_lit_behind_ && facing < 0) toward -= flat_normal_ * (2 * facing);
      sums[luxel] += toward * max_channel(arriving_[i]);
    }
  }

  // By luxel, the share of a light that dirt leaves; empty: all. Valid until the next call.
  std::span<const float> find_dirt_shares(const Arriving& light, const FaceLight& from) {
    if (!light.takes_dirt || from.dirt.empty()) return {};
    const DirtSettings& level = input_.settings.dirt;
    const float scale = light.dirt_scale.value_or(level.scale), gain = light.dirt_gain.value_or(level.gain);
    if (dirt_shares_.empty() || scale != shares_scale_ || gain != shares_gain_) {
      dirt_shares_.clear();
      for (const float around : from.dirt) dirt_shares_.push_back(find_share_after_dirt(around, scale, gain));
      shares_scale_ = scale;
      shares_gain_ = gain;
    }
    return dirt_shares_;
  }

  // The cosine of light from behind counts as from the front on faces that it passes through.
  float find_facing(float cosine) const { return is_lit_behind_ ? std::abs(cosine) : cosine; }

  const DirectLightInput& input_;
  LightGrid grid_;
  ShadowFilter filter_;
  std::span<const math::Vec3> places_;
  Sphere bounds_;
  math::Vec3 flat_normal_;
  bool is_flat_, is_in_sky_, is_lit_behind_;
  std::vector<math::Vec3> normals_;
  std::vector<float> unshadowed_;  // by luxel, of the current light
  std::vector<std::uint32_t> lit_luxels_;
  std::vector<math::Vec3> tints_;     // by luxel, if the current light projects a picture
  std::vector<math::Vec3> arriving_;  // by lit luxel, of the current light
  std::vector<float> dirt_shares_;    // by luxel, for the scale and gain below
  float shares_scale_ = 1, shares_gain_ = 1;
  const LightCache::Map* known_;  // null: nothing is known
  LightCache::Map* learned_;      // null: nothing is kept
  ShadowReader shadows_before_;
  ShadowWriter shadows_;
  FaceLight light_;
};

// A single sample point at the center of the face's model.
SamplePoints make_center_point(const LitLevel& lit, std::size_t face) {
  SamplePoints places;
  places.points.push_back(lit.center_of_model[lit.model_of_face[face]]);
  const world::LeafIndex leaf = world::find_leaf(*lit.level, places.points[0]);
  const bool solid = lit.level->leaf(leaf).contents == world::Contents::kSolid;
  places.leaves.push_back(solid ? world::LeafIndex{0} : leaf);
  return places;
}

// For a face of a brush model whose luxels are all inside solid, such as the side of a closed door: every
// luxel gets the mean light at the model's center, over all six directions.
FaceLight compute_center_light(const DirectLightInput& input, const LightGrid& grid) {
  FaceLight mean;
  for (int side = 0; side < 6; ++side) {
    LightGrid single;
    single.face = grid.face;
    single.width = single.height = 1;
    single.normal[side / 2] = side % 2 == 0 ? 1 : -1;
    SamplePoints middle = make_center_point(input.lit, grid.face);
    single.corners_world = {math::Vec3d(middle.points[0])};  // a single point counts as flat
    if (middle.is_hidden(0)) return {};
    FaceLighter lighter(input, std::move(single), std::move(middle), nullptr);
    lighter.add_all();
    for (const LightLayer& layer : std::move(lighter).take().layers)
      for (math::Vec3& sample : mean.layer(layer.style, layer.kind, grid.size()).samples)
        sample += layer.samples[0] / 6.0f;
  }
  return mean;
}

std::vector<std::uint32_t> list_hidden_luxels(const SamplePoints& places) {
  std::vector<std::uint32_t> hidden;
  for (std::size_t i = 0; i < places.leaves.size(); ++i)
    if (places.is_hidden(i)) hidden.push_back(static_cast<std::uint32_t>(i));
  return hidden;
}

// Gives only the listed luxels the light of another map of the same size.
void replace_luxels(const FaceLight& from, std::span<const std::uint32_t> luxels, std::size_t size,
                    FaceLight& io_light) {
  for (LightLayer& layer : io_light.layers)
    for (const std::uint32_t luxel : luxels) layer.samples[luxel] = math::Vec3(0.0f);
  for (const LightLayer& layer : from.layers)
    for (const std::uint32_t luxel : luxels)
      io_light.layer(layer.style, layer.kind, size).samples[luxel] = layer.samples[luxel];
}

// Makes light at least as bright as `least`, style by style.
void raise_to(const FaceLight& least, std::size_t size, FaceLight& io_light) {
  for (const LightLayer& layer : least.layers) {
    if (layer.kind != LayerKind::kAdd) continue;
    std::vector<math::Vec3>& samples = io_light.layer(layer.style, LayerKind::kRaise, size).samples;
    for (std::size_t i = 0; i < size; ++i) samples[i] = glm::max(samples[i], layer.samples[i]);
  }
}

}  // namespace

// Brush models often start inside other brushes, as doors do. Hidden luxels take the light at the model's
// center if _autominlight asks for it, or if all luxels are hidden.
FaceLight compute_direct_light(const DirectLightInput& input, std::size_t map, LightCache::Map* out_learned) {
  const LitLevel& lit = input.lit;
  const std::size_t face = lit.maps[map].face;
  LightGrid grid = make_light_grid(lit, map);
  SamplePoints places = sample_points(lit, input.scene, grid, 1);
  const SurfaceKeys& keys = lit.surface_keys(face);
  const bool takes_light = !keys.ignores_light;
  const bool may_take_center = takes_light && lit.model_of_face[face] != 0 && keys.auto_min_light >= 0;
  const std::vector<std::uint32_t> hidden = list_hidden_luxels(places);
  if (may_take_center && hidden.size() == grid.size()) return compute_center_light(input, grid);
  FaceLight middle;
  if (may_take_center && keys.auto_min_light > 0) middle = compute_center_light(input, grid);
  const std::size_t size = grid.size();
  FaceLighter lighter(input, std::move(grid), std::move(places), out_learned);
  if (takes_light) lighter.add_all();
  FaceLight light = std::move(lighter).take();
  if (may_take_center && keys.auto_min_light > 0) {
    replace_luxels(middle, hidden, size, light);
    raise_to(middle, size, light);
  }
  return light;
}

}  // namespace temblor::compiler
