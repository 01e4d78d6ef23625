// Small maps that are compiled by the BSP stage alone, and queries about the result.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "compiler/bsp/make_draft.h"
#include "world/trace.h"

namespace temblor::test {

// The inside of room_text().
constexpr math::Vec3d kRoomMins(-128, -128, 0), kRoomMaxs(128, 128, 128);
constexpr double kFloorArea = 256 * 256;

// A closed room with the texture "wall" and a player's start at its center; `more_brushes` are added to the
// world.
std::string room_text(const std::string& more_brushes = {});

// A pool of 512 x 512 units with a rim of 128 small tiles, whose corners are vertices of the water's surface
// too.
std::string tiled_pool_text();

// Every texture is 64 by 64 texels.
compiler::DraftResult compile_draft(const std::string& map_text, const compiler::DraftOptions& options = {},
                                    int threads = 1);
// A map's brushes as a level that is not filled: everything outside them is empty.
std::shared_ptr<const world::Level> make_level_of_brushes(const formats::Map& map,
                                                          compiler::DraftOptions options = {});
base::Result<compiler::DraftResult> try_compile_draft(const std::string& map_text,
                                                      compiler::Warnings& io_warnings);

// Returns the reader's verdict on the level; textures still have no pixels.
std::string find_level_fault(const compiler::DraftResult& result);

world::Contents contents_at(const compiler::DraftResult& result, const math::Vec3& point,
                            world::Hull hull = world::Hull::kPoint);

// The area of the faces with a texture that face along an axis (sign 1 or -1) at that place on it.
double measure_area(const compiler::DraftResult& result, std::string_view texture, int axis, int sign,
                    float at);
inline double measure_area_looking_up(const compiler::DraftResult& result, std::string_view texture,
                                      float height) {
  return measure_area(result, texture, 2, 1, height);
}
int count_faces(const compiler::DraftResult& result, std::string_view texture);

}  // namespace temblor::test
