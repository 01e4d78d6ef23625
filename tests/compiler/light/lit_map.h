// Map text that is compiled and lit for a test, and the light that a game shows.
#pragma once

#include <memory>
#include <string>

#include "compiler/light/light_level.h"
#include "formats/images/palette.h"
#include "math/vec.h"
#include "world/level.h"

namespace temblor::test {

struct LitMapOptions {
  compiler::LightOptions light{};
  formats::Palette palette{};
};
// Every texture is a checkerboard. CHECKs that the map compiles and does not leak.
std::shared_ptr<const world::Level> lit_map(const std::string& text, const LitMapOptions& options = {});

// The light of a style at a point of a face, interpolated between luxels: by channel, 0 to 255; 0 if the face
// lacks the style.
math::Vec3d shown_light(const world::Level& level, const world::Face& face, const math::Vec3d& place,
                        std::uint8_t style = 0);

// The face at a point that faces in a direction; CHECKs that there is one.
const world::Face& face_under(const world::Level& level, const math::Vec3d& place, const math::Vec3d& normal);

}  // namespace temblor::test
