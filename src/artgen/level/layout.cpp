#include "artgen/level/layout.h"

namespace temblor::artgen {
namespace {

constexpr math::Vec3 kWhite{1, 1, 1};
constexpr math::Vec3 kWarm{1.0f, 0.8f, 0.55f};
constexpr math::Vec3 kDaylight{0.8f, 0.88f, 1.0f};
constexpr math::Vec3 kPoolBlue{0.35f, 0.75f, 1.0f};
constexpr math::Vec3 kEmber{1.0f, 0.4f, 0.2f};
constexpr math::Vec3 kViolet{0.75f, 0.4f, 1.0f};

void add_box(SmallLevelLayout& io_layout, const math::Vec3& mins, const math::Vec3& maxs,
             std::int32_t contents, CellLook look) {
  io_layout.boxes.push_back({{mins, maxs}, contents, look});
}

void add_hall(SmallLevelLayout& io_layout) {
  add_box(io_layout, {0, 0, 0}, {512, 512, 192}, kContentsEmpty, CellLook::kHall);
  for (const float x : {96.0f, 384.0f})
    for (const float y : {96.0f, 384.0f})
      add_box(io_layout, {x, y, 0}, {x + 32, y + 32, 192}, kContentsSolid, CellLook::kTrim);
  // Recessed into the ceiling, so that only their lower sides are visible.
  for (const float y : {160.0f, 288.0f})
    add_box(io_layout, {224, y, 192}, {288, y + 64, 208}, kContentsSolid, CellLook::kPanel);
  io_layout.lights.push_back({{256, 192, 168}, 330, 0, kWarm});
  io_layout.lights.push_back({{256, 320, 168}, 330, 0, kWarm});
}

void add_corridor(SmallLevelLayout& io_layout) {
  add_box(io_layout, {512, 192, 0}, {768, 320, 128}, kContentsEmpty, CellLook::kCorridor);
  io_layout.door = {{632, 192, 0}, {648, 320, 128}};
  io_layout.lights.push_back({{576, 256, 112}, 160, 0, kWarm});
  io_layout.lights.push_back({{704, 256, 112}, 200, 0, kDaylight});
}

void add_court(SmallLevelLayout& io_layout) {
  add_box(io_layout, {768, 0, -128}, {1408, 640, 384}, kContentsEmpty, CellLook::kCourt);
  add_box(io_layout, {768, 0, 384}, {1408, 640, 448}, kContentsSky, CellLook::kCourt);
  constexpr int kSteps = 7;
  for (int step = 0; step < kSteps; ++step) {
    const float x = 768.0f + 24.0f * static_cast<float>(step);
    const float top = -16.0f * static_cast<float>(step + 1);
    add_box(io_layout, {x, 192, -128}, {x + 24, 320, top}, kContentsSolid, CellLook::kTrim);
  }
  // The pool: a hole in the ground, filled with water up to 16 units below its rim.
  add_box(io_layout, {1088, 64, -256}, {1344, 384, -128}, kContentsEmpty, CellLook::kCorridor);
  add_box(io_layout, {1088, 64, -256}, {1344, 384, -144}, kContentsWater, CellLook::kCorridor);
  add_box(io_layout, {1120, 480, -128}, {1312, 640, -64}, kContentsSolid, CellLook::kTrim);
  // Four weak lights high up, which together light the court almost evenly, like a sky.
  for (const float x : {1008.0f, 1168.0f})
    for (const float y : {240.0f, 400.0f})
      io_layout.lights.push_back({{x, y, 340}, 700, 0, 0.25f * kDaylight});
  io_layout.lights.push_back({{1216, 224, -208}, 220, 0, kPoolBlue});
  io_layout.lights.push_back({{1216, 560, -24}, 180, 1, kEmber});
}

// With `four_styles`, two more lights with styles of their own reach the cellar's faces.
void add_cellar(SmallLevelLayout& io_layout, bool four_styles) {
  add_box(io_layout, {192, 512, 0}, {320, 704, 128}, kContentsEmpty, CellLook::kCorridor);
  add_box(io_layout, {64, 704, 0}, {448, 1024, 160}, kContentsEmpty, CellLook::kCellar);
  add_box(io_layout, {224, 832, 0}, {288, 896, 48}, kContentsSolid, CellLook::kTrim);
  io_layout.lights.push_back({{128, 960, 96}, 260, 1, kEmber});
  io_layout.lights.push_back({{384, 768, 96}, 220, 0, kViolet});
  if (!four_styles) return;
  io_layout.lights.push_back({{384, 960, 96}, 300, 2, kPoolBlue});
  io_layout.lights.push_back({{128, 768, 96}, 300, 5, kWarm});
}

// Contains every kind of contents and of texture in one room.
void add_tiny_room(SmallLevelLayout& io_layout, bool four_styles) {
  add_box(io_layout, {0, 0, 0}, {192, 192, 112}, kContentsEmpty, CellLook::kHall);
  add_box(io_layout, {0, 0, 112}, {96, 192, 128}, kContentsSky, CellLook::kHall);
  add_box(io_layout, {96, 96, -32}, {160, 160, -8}, kContentsWater, CellLook::kHall);
  add_box(io_layout, {96, 96, -8}, {160, 160, 0}, kContentsEmpty, CellLook::kHall);
  add_box(io_layout, {112, 16, 112}, {144, 48, 128}, kContentsSolid, CellLook::kPanel);
  io_layout.door = {{16, 144, 0}, {80, 160, 80}};
  io_layout.lights.push_back({{128, 64, 96}, 260, 0, kWarm});
  io_layout.lights.push_back({{32, 32, 96}, 160, 1, kDaylight});
  if (four_styles) {
    io_layout.lights.push_back({{160, 32, 64}, 300, 2, kPoolBlue});
    io_layout.lights.push_back({{32, 96, 64}, 300, 5, kWhite});
  }
  io_layout.entities.push_back({"info_player_start", {48, 48, 24}, 45});
}

}  // namespace

SmallLevelLayout make_layout(const SmallLevelOptions& options) {
  SmallLevelLayout layout;
  if (options.tiny) {
    add_tiny_room(layout, options.four_styles);
    return layout;
  }
  add_hall(layout);
  add_corridor(layout);
  add_court(layout);
  add_cellar(layout, options.four_styles);
  layout.entities.push_back({"info_player_start", {48, 256, 24}, 0});
  layout.entities.push_back({"info_player_deathmatch", {832, 560, -104}, 315});
  layout.entities.push_back({"info_teleport_destination", {256, 960, 24}, 270});
  layout.entities.push_back({"info_intermission", {800, 32, 200}, 45});
  return layout;
}

}  // namespace temblor::artgen
