// What `temblor compile` is asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace temblor::app {

enum class CompileStage : std::uint8_t { kBsp, kVisibility, kLight };

// One of several processes, counted from 1: "2/4".
struct Shard {
  std::uint32_t number = 1, count = 1;
};
constexpr std::uint32_t kMaxShards = 9999;
base::Result<Shard> parse_shard(std::string_view text);

// "bsp", "vis", "light".
base::Result<CompileStage> parse_compile_stage(std::string_view text);
const char* name_of(CompileStage stage);

struct CompileCommandOptions {
  std::string source;             // a .map file, or a .bsp that gets visibility and light
  std::string out;                // empty: beside the source, .bsp
  std::string textures;           // a folder of PNG files, which come before all other textures
  std::vector<std::string> wads;  // WADs or levels, looked through before those that the map names
  std::optional<CompileStage> only{};
  std::optional<Shard> shard{};  // of visibility or light
  bool merge = false;
  bool watch = false;
  bool clean = false;  // uses and leaves no build file
  bool fast = false;
  bool no_vis = false, no_light = false;
  bool opaque_water = false;
  bool built_mips = false;
  bool bsp2 = false;
  int extra = 1;
  std::optional<int> bounces{};
  std::optional<int> threads{};
};

}  // namespace temblor::app
