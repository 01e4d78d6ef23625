// Map text compiled and lit for a test, and what a game shows of it.
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
// Every texture is a checker. CHECKs that the map compiles, and does not leak.
std::shared_ptr<const world::Level> lit_map(const std::string& text, const LitMapOptions& options = {});

// The light of a style at a point of a face, between luxels going from one to the next linearly: by channel,
// 0 to 255; 0 where the face has no such style.
math::Vec3d shown_light(const world::Level& level, const world::Face& face, const math::Vec3d& place,
                        std::uint8_t style = 0);

// The face that a point lies on, facing that way; CHECKs that there is one.
const world::Face& face_under(const world::Level& level, const math::Vec3d& place, const math::Vec3d& normal);

}  // namespace temblor::test
