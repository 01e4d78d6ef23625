// Method: light by light over all luxels of the face, so that the rays of a packet run side by side. What a
// light would give without shadows is worked out first; only luxels that it reaches ask whether they see it.
#include "compiler/light/direct_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "compiler/light/shadows/dirt.h"
#include "compiler/light/shadows/shadow_record.h"
#include "world/visibility.h"

namespace temblor::compiler {
namespace {

// Steps in a shadow's edge that are smaller than this in the light map are not looked into.
constexpr float kRoughBelow = 1;

struct Sphere {
  math::Vec3 middle{0.0f};
  float radius = 0;
};

Sphere sphere_around(std::span<const math::Vec3> points) {
  math::Vec3 mins = points[0], maxs = points[0];
  for (const math::Vec3& point : points) {
    mins = glm::min(mins, point);
    maxs = glm::max(maxs, point);
  }
  return {(mins + maxs) * 0.5f, glm::length(maxs - mins) * 0.5f};
}

// What stands up into a brush of sky is drawn there.
bool lies_in_sky(const world::Level& level, std::span<const world::LeafIndex> leaves) {
  return std::any_of(leaves.begin(), leaves.end(), [&](world::LeafIndex leaf) {
    return level.leaf(leaf).contents == world::Contents::kSky;
  });
}

// Gives luxels that lie within something solid the mean of their neighbors, ring by ring, so that what is
// seen of them fades into the rest. All stays as it is where all are hidden.
void fill_hidden(const LightGrid& grid, const SamplePlaces& places, std::span<math::Vec3> io_samples) {
  std::vector<std::uint8_t> unknown;
  for (std::size_t i = 0; i < places.leaves.size(); ++i) unknown.push_back(places.is_hidden(i) ? 1 : 0);
  const int width = grid.width, height = grid.height;
  const auto left = [&] { return std::count(unknown.begin(), unknown.end(), std::uint8_t{1}); };
  for (auto before = left(); before > 0 && before < static_cast<std::ptrdiff_t>(unknown.size());) {
    const std::vector<std::uint8_t> was_unknown = unknown;
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        const auto luxel = static_cast<std::size_t>(row * width + column);
        if (was_unknown[luxel] == 0) continue;
        math::Vec3 sum(0.0f);
        float count = 0;
        for (int y = std::max(0, row - 1); y <= std::min(height - 1, row + 1); ++y)
          for (int x = std::max(0, column - 1); x <= std::min(width - 1, column + 1); ++x) {
            const auto other = static_cast<std::size_t>(y * width + x);
            if (was_unknown[other] != 0) continue;
            sum += io_samples[other];
            ++count;
          }
        if (count == 0) continue;
        io_samples[luxel] = sum / count;
        unknown[luxel] = 0;
      }
    const auto now = left();
    if (now == before) return;
    before = now;
  }
}

bool are_of_size(std::span<const LightLayer> layers, std::size_t luxels) {
  return std::all_of(layers.begin(), layers.end(),
                     [&](const LightLayer& layer) { return layer.samples.size() == luxels; });
}

// The factor for each step of a share.
constexpr std::array<float, kWholeShare + 1> kFactors = [] {
  std::array<float, kWholeShare + 1> factors{};
  for (std::size_t i = 0; i < factors.size(); ++i)
    factors[i] = static_cast<float>(i) / static_cast<float>(kWholeShare);
  return factors;
}();
math::Vec3 factor_of(const Share& share) {
  return {kFactors[share[0]], kFactors[share[1]], kFactors[share[2]]};
}

class FaceLighter {
 public:
  // `learned`: null when nothing is to be kept; outlives this.
  FaceLighter(const DirectLightInput& input, LightGrid grid, SamplePlaces places, LightCache::Map* learned)
      : input_(input),
        grid_(std::move(grid)),
        filter_(input.lit, input.scene, grid_, input.sampling, std::move(places)),
        places_(filter_.luxel_places().points),
        bounds_(sphere_around(places_)),
        flat_normal_(grid_.normal),
        is_flat_(!input.phong.is_curved(grid_.face) || grid_.corners_world.size() < 3),
        is_in_sky_(lies_in_sky(*input.lit.level, filter_.luxel_places().leaves)),
        unshadowed_(places_.size()),
        known_(learned != nullptr && input.known != nullptr ? input.known->map(grid_.map) : nullptr),
        learned_(learned),
        shadows_before_(known_ != nullptr ? base::Bytes(known_->shadows) : base::Bytes(), places_.size()),
        shadows_(places_.size()) {
    if (!is_flat_) set_normals();
    if (input.settings.dirt.on && input.lit.keys_of(grid_.face).takes_dirt) light_.dirt = dirt();
  }

  void add_all() {
    const std::vector<world::LeafIndex> leaves = input_.sight.leaves_of(grid_.face, filter_.luxel_places());
    for (std::size_t i = 0; i < input_.lights.size(); ++i)
      if (may_reach(input_.lights[i]) && input_.sight.light_may_reach(i, leaves)) add(i);
    if (input_.scene.has_sky() && !input_.beams.empty() && input_.sight.sky_may_reach(leaves)) add_sky();
  }

  FaceLight take() && {
    if (learned_ != nullptr) {
      learned_->shadows = std::move(shadows_).take();
      learned_->dirt = light_.dirt;
    }
    for (LightLayer& layer : light_.layers) fill_hidden(grid_, filter_.luxel_places(), layer.samples);
    return std::move(light_);
  }

 private:
  void add(std::size_t number) {
    const LightSource& light = input_.lights[number];
    lit_luxels_.clear();
    float brightest = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      unshadowed_[i] = is_hidden(i) ? 0 : value_of(light, i);
      if (std::abs(unshadowed_[i]) <= kLightGate) continue;
      lit_luxels_.push_back(static_cast<std::uint32_t>(i));
      brightest = std::max(brightest, std::abs(unshadowed_[i]));
    }
    if (lit_luxels_.empty()) return;
    const LayerKind kind = light.attenuation == Attenuation::kLocalMinlight ? LayerKind::kRaise
                           : light.value < 0                                ? LayerKind::kSubtract
                                                                            : LayerKind::kAdd;
    deposit(shares_of(number, is_rough(brightest)), {light.color, light.style, kind, light.takes_dirt},
            light_);
  }

  // The shares of the lit luxels: from the cache, where it has the answer to the same question.
  std::span<const Share> shares_of(std::size_t number, bool rough) {
    std::optional<std::span<const Share>> shares;
    if (known_ != nullptr && input_.known->number_of(number) != CachedLight::kUnknown)
      shares = shadows_before_.find({input_.known->number_of(number), lit_luxels_, rough});
    if (!shares)
      shares = filter_.shares(
          lit_luxels_, rough, [&](std::span<const math::Vec3> points, std::span<math::Vec3> out) {
            input_.scene.towards_point(points, input_.lights[number].origin_world, out, model());
          });
    if (learned_ != nullptr) shadows_.add({static_cast<std::uint32_t>(number), lit_luxels_, rough}, *shares);
    return *shares;
  }

  // All beams are added up by themselves, so that their sum can be kept.
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

  void add(const SkyBeam& beam, FaceLight& io_sky) {
    if (is_flat_ && glm::dot(flat_normal_, beam.towards_sky) <= 0) return;
    lit_luxels_.clear();
    for (std::size_t i = 0; i < places_.size(); ++i) {
      unshadowed_[i] = beam.value * angle_factor(beam.angle_scale, glm::dot(normal_of(i), beam.towards_sky));
      if (unshadowed_[i] != 0 && !is_hidden(i)) lit_luxels_.push_back(static_cast<std::uint32_t>(i));
    }
    if (lit_luxels_.empty()) return;
    const auto shares = filter_.shares(lit_luxels_, is_rough(std::abs(beam.value)),
                                       [&](std::span<const math::Vec3> points, std::span<math::Vec3> out) {
                                         if (is_in_sky_)
                                           input_.scene.towards_void(points, beam.towards_sky, out, model());
                                         else
                                           input_.scene.towards_sky(points, beam.towards_sky, out, model());
                                       });
    const LayerKind kind = beam.value < 0 ? LayerKind::kSubtract : LayerKind::kAdd;
    deposit(shares, {beam.color, beam.style, kind, beam.takes_dirt}, io_sky);
  }

  std::vector<float> dirt() {
    if (known_ != nullptr && input_.known->holds_dirt() && known_->dirt.size() == places_.size())
      return known_->dirt;
    if (is_flat_) set_normals();
    return dirt_at(input_.scene, places_, normals_, input_.settings.dirt);
  }

  void set_normals() {
    normals_.reserve(places_.size());
    for (int row = 0; row < grid_.height; ++row)
      for (int column = 0; column < grid_.width; ++column)
        normals_.push_back(input_.phong.at(
            grid_, grid_.origin_world + grid_.column_step * double(column) + grid_.row_step * double(row)));
  }
  std::uint32_t model() const { return input_.lit.model_of_face[grid_.face]; }
  bool is_hidden(std::size_t luxel) const { return filter_.luxel_places().is_hidden(luxel); }
  const math::Vec3& normal_of(std::size_t luxel) const { return is_flat_ ? flat_normal_ : normals_[luxel]; }
  bool is_rough(float brightest) const { return brightest * input_.settings.range < kRoughBelow; }

  bool may_reach(const LightSource& light) const {
    const float reach = reach_of(light) + bounds_.radius;
    const math::Vec3 way = light.origin_world - bounds_.middle;
    if (glm::dot(way, way) > reach * reach) return false;
    return !is_flat_ || glm::dot(flat_normal_, light.origin_world - places_[0]) > -bounds_.radius;
  }

  // Without shadows and dirt.
  float value_of(const LightSource& light, std::size_t luxel) const {
    const math::Vec3 way = light.origin_world - places_[luxel];
    const float facing = glm::dot(way, normal_of(luxel));
    if (facing <= 0) return 0;
    const float distance = glm::length(way);
    float value = value_at(light, distance);
    if (std::abs(value) <= kLightGate) return 0;
    value *= angle_factor(light.angle_scale, facing / distance);
    return light.cone ? value * cone_factor(*light.cone, way / distance) : value;
  }

  struct Arriving {
    math::Vec3 color;
    std::uint8_t style;
    LayerKind kind;
    bool takes_dirt;
  };
  void deposit(std::span<const Share> shares, const Arriving& light, FaceLight& io_light) {
    if (std::all_of(shares.begin(), shares.end(), [](const Share& share) { return share == Share{}; }))
      return;
    std::vector<math::Vec3>& samples = io_light.layer(light.style, light.kind, places_.size()).samples;
    const bool dirty = light.takes_dirt && !io_light.dirt.empty();
    for (std::size_t i = 0; i < lit_luxels_.size(); ++i) {
      const std::uint32_t luxel = lit_luxels_[i];
      const float value = std::abs(unshadowed_[luxel]) * (dirty ? io_light.dirt[luxel] : 1);
      const math::Vec3 arriving = light.color * factor_of(shares[i]) * value;
      samples[luxel] =
          light.kind == LayerKind::kRaise ? glm::max(samples[luxel], arriving) : samples[luxel] + arriving;
    }
  }

  const DirectLightInput& input_;
  LightGrid grid_;
  ShadowFilter filter_;
  std::span<const math::Vec3> places_;
  Sphere bounds_;
  math::Vec3 flat_normal_;
  bool is_flat_, is_in_sky_;
  std::vector<math::Vec3> normals_;
  std::vector<float> unshadowed_;  // by luxel, of the light at hand
  std::vector<std::uint32_t> lit_luxels_;
  const LightCache::Map* known_;  // null: nothing is known
  LightCache::Map* learned_;      // null: nothing is kept
  ShadowReader shadows_before_;
  ShadowWriter shadows_;
  FaceLight light_;
};

// One luxel in the middle of the face's model.
SamplePlaces place_in_middle(const LitLevel& lit, std::size_t face) {
  const math::Bounds& bounds = lit.level->models[lit.model_of_face[face]].bounds;
  SamplePlaces places;
  places.points.push_back((bounds.mins + bounds.maxs) * 0.5f + lit.offset_of(face));
  const world::LeafIndex leaf = world::find_leaf(*lit.level, places.points[0]);
  const bool solid = lit.level->leaf(leaf).contents == world::Contents::kSolid;
  places.leaves.push_back(solid ? world::LeafIndex{0} : leaf);
  return places;
}

// For a face of a brush model with all of its luxels inside something solid, as the sides of a closed door:
// the mean light in the model's middle, from all six sides, for every luxel.
FaceLight light_in_middle(const DirectLightInput& input, const LightGrid& grid) {
  FaceLight mean;
  for (int side = 0; side < 6; ++side) {
    LightGrid single;
    single.face = grid.face;
    single.width = single.height = 1;
    single.normal[side / 2] = side % 2 == 0 ? 1 : -1;
    SamplePlaces middle = place_in_middle(input.lit, grid.face);
    single.corners_world = {math::Vec3d(middle.points[0])};  // a point, and so flat
    if (middle.is_hidden(0)) return {};
    FaceLighter lighter(input, std::move(single), std::move(middle), nullptr);
    lighter.add_all();
    for (const LightLayer& layer : std::move(lighter).take().layers)
      for (math::Vec3& sample : mean.layer(layer.style, layer.kind, grid.size()).samples)
        sample += layer.samples[0] / 6.0f;
  }
  return mean;
}

std::vector<std::uint32_t> hidden_luxels(const SamplePlaces& places) {
  std::vector<std::uint32_t> hidden;
  for (std::size_t i = 0; i < places.leaves.size(); ++i)
    if (places.is_hidden(i)) hidden.push_back(static_cast<std::uint32_t>(i));
  return hidden;
}

// Gives some luxels the light of another map of the same size, and no other.
void put(const FaceLight& from, std::span<const std::uint32_t> luxels, std::size_t size,
         FaceLight& io_light) {
  for (LightLayer& layer : io_light.layers)
    for (const std::uint32_t luxel : luxels) layer.samples[luxel] = math::Vec3(0.0f);
  for (const LightLayer& layer : from.layers)
    for (const std::uint32_t luxel : luxels)
      io_light.layer(layer.style, layer.kind, size).samples[luxel] = layer.samples[luxel];
}

}  // namespace

FaceLight direct_light_of(const DirectLightInput& input, std::size_t map, LightCache::Map* out_learned) {
  const LitLevel& lit = input.lit;
  const std::size_t face = lit.maps[map].face;
  LightGrid grid = make_light_grid(lit, map);
  SamplePlaces places = sample_points(lit, input.scene, grid, 1);
  const SurfaceKeys& keys = lit.keys_of(face);
  const bool takes_light = !keys.ignores_light;
  const bool may_take_middle = takes_light && lit.model_of_face[face] != 0 && keys.auto_min_light >= 0;
  const std::vector<std::uint32_t> hidden = hidden_luxels(places);
  if (may_take_middle && hidden.size() == grid.size()) return light_in_middle(input, grid);
  FaceLight middle;
  if (may_take_middle && keys.auto_min_light > 0 && !hidden.empty()) middle = light_in_middle(input, grid);
  const std::size_t size = grid.size();
  FaceLighter lighter(input, std::move(grid), std::move(places), out_learned);
  if (takes_light) lighter.add_all();
  FaceLight light = std::move(lighter).take();
  if (may_take_middle && keys.auto_min_light > 0) put(middle, hidden, size, light);
  return light;
}

}  // namespace temblor::compiler
