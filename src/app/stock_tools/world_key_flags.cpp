#include "app/stock_tools/world_key_flags.h"

namespace temblor::app {
namespace {

constexpr WorldKeyFlag kWorldKeyFlags[] = {
    {"anglescale", "anglescale", false},
    {"anglesense", "anglescale", false},
    {"bouncecolorscale", "bouncecolorscale", false},
    {"bouncescale", "bouncescale", false},
    {"bouncestyled", "bouncestyled", false},
    {"dirt", "dirt", false},
    {"dirtangle", "dirtangle", false},
    {"dirtdepth", "dirtdepth", false},
    {"dirtgain", "dirtgain", false},
    {"dirtmode", "dirtmode", false},
    {"dirtscale", "dirtscale", false},
    {"dirty", "dirt", false},
    {"dist", "dist", false},
    {"gamma", "gamma", false},
    {"light", "minlight", false},
    {"maxlight", "maxlight", false},
    {"mincolor", "minlight_color", true},
    {"minlight", "minlight", false},
    {"minlight_color", "minlight_color", true},
    {"minlight_dirt", "minlight_dirt", false},
    {"range", "range", false},
    {"spotlightautofalloff", "spotlightautofalloff", false},
    {"sun2", "sun2", false},
    {"sun2_color", "sun2_color", true},
    {"sun2_mangle", "sun2_mangle", true},
    {"sun_angle", "sun_mangle", true},
    {"sun_color", "sunlight_color", true},
    {"sun_light", "sunlight", false},
    {"sun_mangle", "sun_mangle", true},
    {"sunlight", "sunlight", false},
    {"sunlight2", "sunlight2", false},
    {"sunlight2_color", "sunlight2_color", true},
    {"sunlight2_dirt", "sunlight2_dirt", false},
    {"sunlight3", "sunlight3", false},
    {"sunlight3_color", "sunlight3_color", true},
    {"sunlight_color", "sunlight_color", true},
    {"sunlight_color2", "sunlight2_color", true},
    {"sunlight_color3", "sunlight3_color", true},
    {"sunlight_dirt", "sunlight_dirt", false},
    {"sunlight_mangle", "sun_mangle", true},
    {"sunlight_penumbra", "sunlight_penumbra", false},
};

}  // namespace

std::span<const WorldKeyFlag> list_world_key_flags() {
  return kWorldKeyFlags;
}

}  // namespace temblor::app
