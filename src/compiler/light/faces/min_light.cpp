// Method of the pattern: random numbers at the corners of cubes, interpolated between them (value noise). It
// depends on the place alone, so it continues across faces.
#include "compiler/light/faces/min_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/hash.h"
#include "compiler/light/faces/sample_points.h"
#include "compiler/light/shadows/dirt.h"

namespace temblor::compiler {
namespace {

constexpr double kMottleUnits = 32, kMottleStrength = 0.25;

// A random number from -1 to 1 for a corner of a cube.
double find_corner_value(const std::array<std::int64_t, 3>& corner) {
  std::uint64_t hash = 0;
  for (const std::int64_t number : corner) hash = base::hash_with(hash, static_cast<std::uint64_t>(number));
  return static_cast<double>(hash >> 40) / (1 << 23) - 1;
}

// Whether a brush asks for no minimum light on a texture.
bool is_excluded(const SurfaceKeys& keys, std::string_view texture) {
  const auto& excludes = keys.min_light_excludes;
  if (std::all_of(excludes.begin(), excludes.end(), [](const TextureKey& key) { return key[0] == 0; }))
    return false;
  return std::find(excludes.begin(), excludes.end(), make_texture_key(texture)) != excludes.end();
}

// The factors of mottled light for all luxels of a map.
std::vector<float> find_mottles(const LitLevel& lit, std::size_t map) {
  const LightGrid grid = make_light_grid(lit, map);
  std::vector<float> factors;
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column)
      factors.push_back(
          find_mottle(grid.origin_world + grid.column_step * double(column) + grid.row_step * double(row)));
  return factors;
}

}  // namespace

float find_mottle(const math::Vec3d& place_world) {
  const math::Vec3d at = place_world / kMottleUnits, low = glm::floor(at), part = at - low;
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    std::array<std::int64_t, 3> number{};
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const bool upper = (corner >> axis & 1) != 0;
      number[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(low[axis]) + (upper ? 1 : 0);
      weight *= upper ? part[axis] : 1 - part[axis];
    }
    sum += weight * find_corner_value(number);
  }
  return static_cast<float>(1 + kMottleStrength * sum);
}

void add_min_light(const LitLevel& lit, const LightSettings& settings, std::size_t map,
                   const FaceLight& light, std::vector<math::Vec3>& io_samples) {
  const std::size_t face = lit.maps[map].face;
  const SurfaceKeys& keys = lit.surface_keys(face);
  if (is_excluded(keys, lit.level->texture(lit.level->faces[face].texture).name)) return;
  const math::Vec3 level = settings.min_light_color * settings.min_light;
  const math::Vec3 own =
      math::Vec3(keys.min_light_color[0], keys.min_light_color[1], keys.min_light_color[2]) * keys.min_light;
  const math::Vec3 least = glm::max(level, own);
  if (least == math::Vec3(0.0f)) return;
  const bool dirty = settings.min_light_dirt && !light.dirt.empty();
  const std::vector<float> mottles = keys.mottles_min_light ? find_mottles(lit, map) : std::vector<float>();
  for (std::size_t i = 0; i < io_samples.size(); ++i) {
    const DirtSettings& dirt = settings.dirt;
    float factor = dirty ? find_share_after_dirt(light.dirt[i], dirt.scale, dirt.gain) : 1;
    if (!mottles.empty()) factor *= mottles[i];
    const math::Vec3 minimum = least * factor;
    io_samples[i] = settings.adds_min_light ? io_samples[i] + minimum : glm::max(io_samples[i], minimum);
  }
}

}  // namespace temblor::compiler
