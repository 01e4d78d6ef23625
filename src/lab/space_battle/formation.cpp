#include "lab/space_battle/formation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lab/space_battle/random_numbers.h"

namespace temblor::lab::space {

namespace {

using math::Vec3d;
constexpr double kPi = std::numbers::pi;

constexpr formats::Rgb kRedSide{226, 74, 58}, kBlueSide{70, 132, 232}, kRedShot{255, 214, 96},
    kBlueShot{124, 255, 214};
constexpr double kShotRadius = 0.55;

// The contents of a slot. In a ring, two red ships chase two blue ships, and so on.
struct Role {
  formats::Rgb color;
  bool is_shot;
};
constexpr std::array<Role, 6> kRoles{{{kRedSide, false},
                                      {kRedSide, false},
                                      {kRedShot, true},
                                      {kBlueSide, false},
                                      {kBlueSide, false},
                                      {kBlueShot, true}}};

// Rings side by side, in a square pattern. About this many slots of a ring per row of the pattern give a
// battle that is as deep as it is high.
constexpr double kSlotsPerRow = 9;

struct Rings {
  std::size_t rows, slots_per_ring;
  double first_radius;
};
Rings choose_rings(std::size_t count, double spacing) {
  Rings rings;
  rings.rows = static_cast<std::size_t>(
      std::max(1.0, std::round(std::cbrt(static_cast<double>(count) / kSlotsPerRow))));
  const std::size_t ring_count = rings.rows * rings.rows;
  rings.slots_per_ring = std::max<std::size_t>(3, (count + ring_count - 1) / ring_count);
  // Neighbors are `spacing` apart along the straight line.
  rings.first_radius = spacing / 2 / std::sin(kPi / static_cast<double>(rings.slots_per_ring));
  return rings;
}

formats::Rgb vary(formats::Rgb color, double factor) {
  const auto channel = [&](std::uint8_t value) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(value * factor), 0l, 255l));
  };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

}  // namespace

Formation make_formation(std::size_t count, std::span<const std::uint32_t> ships, std::uint32_t shot,
                         double spacing, std::uint64_t seed) {
  const Rings rings = choose_rings(count, spacing);
  RandomNumbers random(seed);
  Formation formation;
  const double middle = static_cast<double>(rings.rows - 1) / 2;
  const double last_radius = rings.first_radius + 2 * middle * spacing;
  formation.lookout = {-last_radius - 2 * spacing, 0, (1 + middle / 5) * spacing};
  // Slot by slot around all rings, so that none is empty if there are fewer solids than slots.
  for (std::size_t number = 0; number < count; ++number) {
    const std::size_t ring = number % (rings.rows * rings.rows), place = number / (rings.rows * rings.rows);
    const std::size_t column = ring % rings.rows, row = ring / rings.rows;
    const Role& role = kRoles[place % kRoles.size()];
    FormationSlot slot;
    slot.ring_radius = rings.first_radius + static_cast<double>(column) * spacing;
    slot.ring_height = (static_cast<double>(row) - middle) * spacing;
    slot.angle = 2 * kPi * (static_cast<double>(place) / static_cast<double>(rings.slots_per_ring)) +
                 static_cast<double>(ring);
    slot.speed_rad_s = ((column + row) % 2 == 0 ? 3.0 : -2.5) / slot.ring_radius;
    slot.phase = random.between(0, 2 * kPi);
    slot.color = vary(role.color, random.between(0.75, 1));
    if (role.is_shot) {
      slot.solid = shot;
      slot.shot_range = std::max(0.0, spacing / 2 - kShotRadius);
    } else {
      slot.solid = ships[random.below(ships.size())];
      slot.sway = std::max(0.0, (spacing - 2) / 2 * 0.7);
      slot.roll_rad_s = random.between(-0.8, 0.8);
      slot.yaw_rad_s = random.below(4) == 0 ? random.between(-0.5, 0.5) : 0;
    }
    formation.slots.push_back(slot);
  }
  return formation;
}

Placement find_placement(const FormationSlot& slot, double time_s) {
  const double angle = slot.angle + slot.speed_rad_s * time_s;
  const Vec3d outward{std::cos(angle), std::sin(angle), 0}, up{0, 0, 1};
  const Vec3d ahead = (slot.speed_rad_s < 0 ? -1.0 : 1.0) * Vec3d{-outward.y, outward.x, 0};
  Placement placement;
  placement.center = outward * slot.ring_radius + up * slot.ring_height;
  if (slot.shot_range > 0) {
    const double passes = 1.5 * time_s + slot.phase;
    placement.center += ahead * (slot.shot_range * (2 * (passes - std::floor(passes)) - 1));
  } else {
    const double sway = time_s + slot.phase;
    placement.center += slot.sway * (outward * (0.6 * std::sin(sway)) + up * (0.8 * std::cos(1.3 * sway)));
  }
  const double yaw = slot.yaw_rad_s * time_s, roll = slot.roll_rad_s * time_s + slot.phase;
  const Vec3d side = glm::cross(ahead, up);
  placement.axes.forward = ahead * std::cos(yaw) + side * std::sin(yaw);
  const Vec3d level_right = glm::cross(placement.axes.forward, up);
  placement.axes.right = level_right * std::cos(roll) - up * std::sin(roll);
  placement.axes.up = glm::cross(placement.axes.right, placement.axes.forward);
  return placement;
}

}  // namespace temblor::lab::space
