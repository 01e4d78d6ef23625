// Small maps, compiled as far as the BSP stage, and questions about what became of them.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "compiler/make_draft.h"
#include "world/trace.h"

namespace temblor::test {

// The inside of room().
constexpr math::Vec3d kRoomMins(-128, -128, 0), kRoomMaxs(128, 128, 128);
constexpr double kFloorArea = 256 * 256;

// A closed room textured "wall" with a player's start in its middle; `more_brushes` are the world's, too.
std::string room_text(const std::string& more_brushes = {});

// Every texture is 64 by 64 texels.
compiler::DraftResult draft_of(const std::string& map_text, const compiler::DraftOptions& options = {},
                               int threads = 1);
// A map's brushes as a level of which nothing is filled: what lies outside of them is empty.
std::shared_ptr<const world::Level> level_of_brushes(const formats::Map& map);
base::Result<compiler::DraftResult> try_draft_of(const std::string& map_text,
                                                 compiler::Warnings& io_warnings);

// What the reader of levels would say of it; textures are only named so far.
std::string fault_of(const compiler::DraftResult& result);

world::Contents contents_at(const compiler::DraftResult& result, const math::Vec3& point,
                            world::Hull hull = world::Hull::kPoint);

// Of the faces with a texture that look along an axis (to `sign` 1 or -1), at that place on it.
double area_of(const compiler::DraftResult& result, std::string_view texture, int axis, int sign, float at);
inline double area_looking_up(const compiler::DraftResult& result, std::string_view texture, float height) {
  return area_of(result, texture, 2, 1, height);
}
int count_faces(const compiler::DraftResult& result, std::string_view texture);

}  // namespace temblor::test
