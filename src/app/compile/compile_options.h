// Options of `temblor compile`, and the parsers of those that are neither numbers nor names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::app {

enum class CompileStage : std::uint8_t { kBsp, kVisibility, kLight };

// The part of one process in a stage that several processes share, counted from 1: "2/4".
struct Shard {
  std::uint32_t number = 1, count = 1;
};
constexpr std::uint32_t kMaxShards = 9999;
// Parses "K/N" with 1 <= K <= N <= kMaxShards.
base::Result<Shard> parse_shard(std::string_view text);

// Parses "bsp", "vis", or "light".
base::Result<CompileStage> parse_compile_stage(std::string_view text);
const char* stage_name(CompileStage stage);

// Parses "X,Y,Z", each at least 1.
base::Result<math::Vec3> parse_grid_dist(std::string_view text);

struct CompileCommandOptions {
  // A .map file, or a .bsp to compute visibility and light for.
  std::string source;
  // The level to write; empty: the source with .bsp.
  std::string out;
  // Folder of PNG files, which precede all other textures; empty: none.
  std::string textures;
  // WADs, levels, and folders, searched before those that the map names.
  std::vector<std::string> wads;
  // Run only this stage, and keep what is still valid of the others.
  std::optional<CompileStage> only{};
  // Compute this part of visibility or light, or merge the results of all parts. Both need `only`.
  std::optional<Shard> shard{};
  bool merge = false;
  // Compile again after every change.
  bool watch = false;
  // Neither read nor write a build file.
  bool clean = false;
  // Rough visibility; light without dirt and bounces.
  bool fast = false;
  // Skip the stage.
  bool no_vis = false, no_light = false;
  // Liquids block visibility.
  bool opaque_water = false;
  // Compute mip levels instead of using those of the source.
  bool built_mips = false;
  // Write BSP2 even if the level fits version 29.
  bool bsp2 = false;
  // Write version 30, with the clip hulls and colored light of Half-Life.
  bool hlbsp = false;
  // Light samples in each direction: 1, 2, or 4.
  int extra = 1;
  // 0 to 16; nothing: as the map says.
  std::optional<int> bounces{};
  // Texels between light samples on all faces, 1 to 128; nothing: as the map says.
  std::optional<int> luxel_texels{};
  // Units between light samples on all faces, whatever their texture; 0: by texels; nothing: as the map says.
  std::optional<double> units_per_luxel{};
  // Write a light grid; its samples are this many units apart along each axis.
  bool light_grid = false;
  math::Vec3 light_grid_dist{32.0f};
  // Nothing or 0: one per core.
  std::optional<int> threads{};
};

}  // namespace temblor::app
