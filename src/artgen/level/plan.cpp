#include "artgen/level/plan.h"

namespace temblor::artgen {
namespace {

constexpr math::Vec3 kWhite{1, 1, 1};
constexpr math::Vec3 kWarm{1.0f, 0.8f, 0.55f};
constexpr math::Vec3 kDaylight{0.8f, 0.88f, 1.0f};
constexpr math::Vec3 kPoolBlue{0.35f, 0.75f, 1.0f};
constexpr math::Vec3 kEmber{1.0f, 0.4f, 0.2f};
constexpr math::Vec3 kViolet{0.75f, 0.4f, 1.0f};

void add_box(SmallLevelPlan& io_plan, const math::Vec3& mins, const math::Vec3& maxs, std::int32_t contents,
             CellLook look) {
  io_plan.boxes.push_back({{mins, maxs}, contents, look});
}

void add_hall(SmallLevelPlan& io_plan) {
  add_box(io_plan, {0, 0, 0}, {512, 512, 192}, kContentsEmpty, CellLook::kHall);
  for (const float x : {96.0f, 384.0f})
    for (const float y : {96.0f, 384.0f})
      add_box(io_plan, {x, y, 0}, {x + 32, y + 32, 192}, kContentsSolid, CellLook::kTrim);
  // In the ceiling: only its lower side is ever seen.
  for (const float y : {160.0f, 288.0f})
    add_box(io_plan, {224, y, 192}, {288, y + 64, 208}, kContentsSolid, CellLook::kPanel);
  io_plan.lights.push_back({{256, 192, 168}, 330, 0, kWarm});
  io_plan.lights.push_back({{256, 320, 168}, 330, 0, kWarm});
}

void add_corridor(SmallLevelPlan& io_plan) {
  add_box(io_plan, {512, 192, 0}, {768, 320, 128}, kContentsEmpty, CellLook::kCorridor);
  io_plan.door = {{632, 192, 0}, {648, 320, 128}};
  io_plan.lights.push_back({{576, 256, 112}, 160, 0, kWarm});
  io_plan.lights.push_back({{704, 256, 112}, 200, 0, kDaylight});
}

void add_court(SmallLevelPlan& io_plan) {
  add_box(io_plan, {768, 0, -128}, {1408, 640, 384}, kContentsEmpty, CellLook::kCourt);
  add_box(io_plan, {768, 0, 384}, {1408, 640, 448}, kContentsSky, CellLook::kCourt);
  constexpr int kSteps = 7;
  for (int step = 0; step < kSteps; ++step) {
    const float x = 768.0f + 24.0f * static_cast<float>(step);
    const float top = -16.0f * static_cast<float>(step + 1);
    add_box(io_plan, {x, 192, -128}, {x + 24, 320, top}, kContentsSolid, CellLook::kTrim);
  }
  add_box(io_plan, {1088, 64, -256}, {1344, 384, -128}, kContentsEmpty, CellLook::kCorridor);
  add_box(io_plan, {1088, 64, -256}, {1344, 384, -144}, kContentsWater, CellLook::kCorridor);
  add_box(io_plan, {1120, 480, -128}, {1312, 640, -64}, kContentsSolid, CellLook::kTrim);
  // Four weak lights far up, which reach everywhere about as well.
  for (const float x : {1008.0f, 1168.0f})
    for (const float y : {240.0f, 400.0f}) io_plan.lights.push_back({{x, y, 340}, 700, 0, 0.25f * kDaylight});
  io_plan.lights.push_back({{1216, 224, -208}, 220, 0, kPoolBlue});
  io_plan.lights.push_back({{1216, 560, -24}, 180, 1, kEmber});
}

void add_cellar(SmallLevelPlan& io_plan, bool four_styles) {
  add_box(io_plan, {192, 512, 0}, {320, 704, 128}, kContentsEmpty, CellLook::kCorridor);
  add_box(io_plan, {64, 704, 0}, {448, 1024, 160}, kContentsEmpty, CellLook::kCellar);
  add_box(io_plan, {224, 832, 0}, {288, 896, 48}, kContentsSolid, CellLook::kTrim);
  io_plan.lights.push_back({{128, 960, 96}, 260, 1, kEmber});
  io_plan.lights.push_back({{384, 768, 96}, 220, 0, kViolet});
  if (!four_styles) return;
  io_plan.lights.push_back({{384, 960, 96}, 300, 2, kPoolBlue});
  io_plan.lights.push_back({{128, 768, 96}, 300, 5, kWarm});
}

void add_tiny_room(SmallLevelPlan& io_plan, bool four_styles) {
  add_box(io_plan, {0, 0, 0}, {192, 192, 112}, kContentsEmpty, CellLook::kHall);
  add_box(io_plan, {0, 0, 112}, {96, 192, 128}, kContentsSky, CellLook::kHall);
  add_box(io_plan, {96, 96, -32}, {160, 160, -8}, kContentsWater, CellLook::kHall);
  add_box(io_plan, {96, 96, -8}, {160, 160, 0}, kContentsEmpty, CellLook::kHall);
  add_box(io_plan, {112, 16, 112}, {144, 48, 128}, kContentsSolid, CellLook::kPanel);
  io_plan.door = {{16, 144, 0}, {80, 160, 80}};
  io_plan.lights.push_back({{128, 64, 96}, 260, 0, kWarm});
  io_plan.lights.push_back({{32, 32, 96}, 160, 1, kDaylight});
  if (four_styles) {
    io_plan.lights.push_back({{160, 32, 64}, 300, 2, kPoolBlue});
    io_plan.lights.push_back({{32, 96, 64}, 300, 5, kWhite});
  }
  io_plan.things.push_back({"info_player_start", {48, 48, 24}, 45});
}

}  // namespace

SmallLevelPlan make_plan(const SmallLevelOptions& options) {
  SmallLevelPlan plan;
  if (options.tiny) {
    add_tiny_room(plan, options.four_styles);
    return plan;
  }
  add_hall(plan);
  add_corridor(plan);
  add_court(plan);
  add_cellar(plan, options.four_styles);
  plan.things.push_back({"info_player_start", {48, 256, 24}, 0});
  plan.things.push_back({"info_player_deathmatch", {832, 560, -104}, 315});
  plan.things.push_back({"info_teleport_destination", {256, 960, 24}, 270});
  plan.things.push_back({"info_intermission", {800, 32, 200}, 45});
  return plan;
}

}  // namespace temblor::artgen
