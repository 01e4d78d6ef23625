#include "app/compile/compile_options.h"

#include <algorithm>
#include <charconv>

#include "app/commands/options.h"

namespace temblor::app {
namespace {

// Returns 0 unless the whole text is a number. 0 is not valid in a shard either.
std::uint32_t parse_option_number(std::string_view text) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() ? number : 0;
}

}  // namespace

base::Result<Shard> parse_shard(std::string_view text) {
  const std::size_t slash = text.find('/');
  const std::uint32_t number = parse_option_number(text.substr(0, slash));
  const std::uint32_t count =
      slash == std::string_view::npos ? 0 : parse_option_number(text.substr(slash + 1));
  if (number == 0 || number > count || count > kMaxShards)
    return base::error(base::ErrorCode::kUsage,
                       "\"{1}\" is not a shard K/N, like 2/4, with 1 <= K <= N <= {0}", kMaxShards, text);
  return Shard{number, count};
}

base::Result<CompileStage> parse_compile_stage(std::string_view text) {
  for (const CompileStage stage : {CompileStage::kBsp, CompileStage::kVisibility, CompileStage::kLight})
    if (text == stage_name(stage)) return stage;
  return base::error(base::ErrorCode::kUsage, "unknown stage \"{}\"; the stages are bsp, vis, and light",
                     text);
}

base::Result<math::Vec3> parse_grid_dist(std::string_view text) {
  TRY(const math::Vec3 dist, parse_vec3(text));
  if (std::min({dist.x, dist.y, dist.z}) < 1)
    return base::error(base::ErrorCode::kUsage, "\"{}\" has a distance below 1 unit", text);
  return dist;
}

const char* stage_name(CompileStage stage) {
  switch (stage) {
    case CompileStage::kBsp:
      return "bsp";
    case CompileStage::kVisibility:
      return "vis";
    case CompileStage::kLight:
      return "light";
  }
  return "";
}

}  // namespace temblor::app
