#include "compiler/bsp/brushes/key_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/text.h"

namespace temblor::compiler {
namespace {

using Keys = std::span<const std::string_view>;

// The keys that take numbers, for all entities, worldspawn, lights, and entities with brushes. Each may also
// begin with an underscore.
constexpr std::string_view kNumbersOfAll[] = {"angle", "spawnflags"};
constexpr std::string_view kNumbersOfWorld[] = {"addmin",
                                                "anglescale",
                                                "anglesense",
                                                "bounce",
                                                "bouncecolorscale",
                                                "bouncescale",
                                                "bouncestyled",
                                                "compilerstyle_max",
                                                "compilerstyle_start",
                                                "dirt",
                                                "dirtangle",
                                                "dirtdepth",
                                                "dirtgain",
                                                "dirtmode",
                                                "dirtscale",
                                                "dirty",
                                                "dist",
                                                "gamma",
                                                "lavaalpha",
                                                "light",
                                                "lightmap_scale",
                                                "maxlight",
                                                "minlight",
                                                "minlight_dirt",
                                                "range",
                                                "slimealpha",
                                                "spotlightautofalloff",
                                                "sun2",
                                                "sun_light",
                                                "sunlight",
                                                "sunlight2",
                                                "sunlight2_dirt",
                                                "sunlight3",
                                                "sunlight_dirt",
                                                "sunlight_penumbra",
                                                "telealpha",
                                                "wateralpha",
                                                "world_units_per_luxel"};
constexpr std::string_view kNumbersOfLights[] = {"anglescale",
                                                 "anglesense",
                                                 "bouncescale",
                                                 "delay",
                                                 "deviance",
                                                 "dirt",
                                                 "dirtgain",
                                                 "dirtscale",
                                                 "falloff",
                                                 "light_channel_mask",
                                                 "nostaticlight",
                                                 "project_fov",
                                                 "samples",
                                                 "shadow_channel_mask",
                                                 "softangle",
                                                 "style",
                                                 "sun",
                                                 "sunlight2",
                                                 "sunlight3",
                                                 "surface_offset",
                                                 "surface_spotlight",
                                                 "surflight_group",
                                                 "surflight_rescale",
                                                 "wait"};
constexpr std::string_view kNumbersOfBrushes[] = {"alpha",
                                                  "autominlight",
                                                  "bounce",
                                                  "bouncescale",
                                                  "chop_order",
                                                  "dirt",
                                                  "hulls",
                                                  "light_alpha",
                                                  "light_twosided",
                                                  "lightcolorscale",
                                                  "lightignore",
                                                  "lightmap_scale",
                                                  "litwater",
                                                  "lmscale",
                                                  "maxlight",
                                                  "minlight",
                                                  "minlightMottle",
                                                  "minlight_mottle",
                                                  "mirrorinside",
                                                  "noclipfaces",
                                                  "object_channel_mask",
                                                  "omitbrushes",
                                                  "phong",
                                                  "phong_angle",
                                                  "phong_angle_concave",
                                                  "phong_group",
                                                  "selfshadow",
                                                  "shadow",
                                                  "shadowself",
                                                  "shadowworldonly",
                                                  "splitturb",
                                                  "surflight_group",
                                                  "surflight_rescale",
                                                  "surflight_style",
                                                  "switchableshadow",
                                                  "world_units_per_luxel"};
constexpr std::string_view kTriplesOfAll[] = {"origin"};
constexpr std::string_view kTriplesOfWorld[] = {
    "mincolor",        "minlight_color",  "sun2_color",      "sun2_mangle",     "sun_angle",
    "sun_color",       "sun_mangle",      "sunlight2_color", "sunlight3_color", "sunlight_color",
    "sunlight_color2", "sunlight_color3", "sunlight_mangle"};
constexpr std::string_view kTriplesOfLights[] = {"color", "mangle", "project_mangle"};
constexpr std::string_view kTriplesOfBrushes[] = {"mincolor", "minlight_color", "surflight_color"};

// The numbers in a text, separated by white space; nothing if the text has anything else.
std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (text.empty()) return numbers;
    if (text.front() == '+') text.remove_prefix(1);
    double number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc{} || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

// Checks the keys of one entity.
class Reader {
 public:
  Reader(const formats::MapEntity& entity, std::size_t number, Warnings& io_warnings)
      : entity_(entity), number_(number), warnings_(io_warnings) {}

  void read() {
    const std::string_view of_class = entity_.fields.classname();
    is_world_ = of_class == "worldspawn";
    is_light_ = of_class.starts_with("light");
    for (const auto& [key, value] : entity_.fields.pairs)
      read_pair(key, std::string_view(key).substr(key.starts_with('_') ? 1 : 0), value);
  }

 private:
  void read_pair(std::string_view key, std::string_view name, std::string_view value) {
    if (value.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
    const std::optional<std::vector<double>> numbers = numbers_in(value);
    const std::size_t count = numbers ? numbers->size() : 0;
    if (is_world_ && name == "fog") {
      if (count != 1 && count != 4)
        warn(key, value, "its density, or density, red, green and blue");
      else if (count == 4 && *std::max_element(numbers->begin() + 1, numbers->end()) > 1)
        // Fog colors are clamped when drawn: on the scale of 0 to 255 that other keys accept, every color is
        // white.
        warnings_.push_back(
            {"fog brighter than white",
             fmt::format("line {}: fog takes its density, then red, green and blue from 0 to 1",
                         entity_.line)});
    } else if (is_light_ && name == "light") {
      if (count != 1 && count != 3 && count != 4)
        warn(key, value, "a number, or red, green, blue and a number");
    } else if (takes(name, kTriplesOfAll, kTriplesOfWorld, kTriplesOfLights, kTriplesOfBrushes)) {
      if (count != 3) warn(key, value, "three numbers");
    } else if (takes(name, kNumbersOfAll, kNumbersOfWorld, kNumbersOfLights, kNumbersOfBrushes)) {
      if (count != 1) warn(key, value, "a number");
    }
  }

  // Whether a key of this entity is in one of the lists that apply to it.
  bool takes(std::string_view name, Keys of_all, Keys of_world, Keys of_lights, Keys of_brushes) const {
    const auto has = [name](Keys keys) { return std::ranges::find(keys, name) != keys.end(); };
    return has(of_all) || (is_world_ && has(of_world)) || (is_light_ && has(of_lights)) ||
           (!entity_.brushes.empty() && has(of_brushes));
  }

  // Names the entity by its number in the map and its line, so that an editor finds it.
  void warn(std::string_view key, std::string_view value, std::string_view wanted) {
    warnings_.push_back({"value that cannot be read",
                         fmt::format("entity {} ({}), line {}: {} is \"{}\" but should be {}; it is ignored",
                                     number_, base::quotable(entity_.fields.classname()), entity_.line,
                                     base::quotable(key), base::quotable(value), wanted)});
  }

  const formats::MapEntity& entity_;
  std::size_t number_;
  bool is_world_ = false, is_light_ = false;
  Warnings& warnings_;
};

}  // namespace

void warn_about_unreadable_values(const formats::Map& map, Warnings& io_warnings) {
  for (std::size_t i = 0; i < map.entities.size(); ++i) Reader(map.entities[i], i, io_warnings).read();
}

}  // namespace temblor::compiler
