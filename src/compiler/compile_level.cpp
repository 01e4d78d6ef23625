#include "compiler/compile_level.h"

#include <algorithm>
#include <chrono>
#include <string>

#include "base/text.h"
#include "compiler/visibility.h"
#include "compiler/visibility_lump.h"

namespace temblor::compiler {
namespace {

// Tells the watcher of stages, and keeps how long each takes.
class Stages {
 public:
  Stages(CompileWatcher& watcher, std::vector<StageTime>& out) : watcher_(watcher), out_(out) {}

  template <typename Stage>
  auto run(const char* name, const Stage& stage) {
    using Clock = std::chrono::steady_clock;
    watcher_.begin_stage(name);
    const Clock::time_point start = Clock::now();
    auto result = stage();
    out_.push_back({name, std::chrono::duration<double>(Clock::now() - start).count()});
    return result;
  }

 private:
  CompileWatcher& watcher_;
  std::vector<StageTime>& out_;
};

std::vector<std::string_view> texture_names(const formats::Map& map) {
  std::vector<std::string_view> names;
  for (const formats::MapEntity& entity : map.entities)
    for (const formats::MapBrush& brush : entity.brushes)
      for (const formats::MapSide& side : brush.sides)
        if (names.empty() || names.back() != side.texture) names.push_back(side.texture);
  return names;
}

math::Vec2d size_of(const TextureSet& set, std::string_view name) {
  const std::optional<std::uint32_t> found = set.find(name);
  if (!found) return {64, 64};
  const formats::BspMiptex& texture = set.miptexes[*found];
  return {texture.width, texture.height};
}

// The rest of a name in an animation: "+0lava" and "+1lava" are frames of one.
std::string sequence_of(std::string_view name) {
  return name.size() > 2 && name.front() == '+' ? base::to_lower(name.substr(2)) : std::string{};
}

// The draft's textures by name become those of the set; whole animations come along.
void put_textures(const TextureSet& set, formats::Bsp& io_bsp) {
  std::vector<std::string> sequences;
  std::vector<bool> taken(set.miptexes.size(), false);
  for (formats::BspMiptex& texture : io_bsp.miptexes) {
    const std::optional<std::uint32_t> found = set.find(texture.name);
    if (const std::string sequence = sequence_of(texture.name); !sequence.empty())
      sequences.push_back(sequence);
    if (!found) continue;
    taken[*found] = true;
    texture = set.miptexes[*found];
  }
  for (std::size_t i = 0; i < set.miptexes.size(); ++i) {
    const std::string sequence = sequence_of(set.miptexes[i].name);
    if (taken[i] || sequence.empty()) continue;
    if (std::find(sequences.begin(), sequences.end(), sequence) != sequences.end())
      io_bsp.miptexes.push_back(set.miptexes[i]);
  }
}

base::Status add_visibility(const PortalSet& portals, bool fast, base::Jobs& jobs, Progress progress,
                            CompiledLevel& io_level) {
  BitMatrix visible;
  if (fast) {
    visible = roughly_visible_clusters(portals, jobs);
  } else {
    VisibilityState state = begin_visibility(portals);
    if (continue_visibility(portals, jobs, progress, state) != VisibilityEnd::kFinished)
      return base::error(base::ErrorCode::kUsage, "stopped while working out visibility");
    visible = visible_clusters(portals, state);
  }
  io_level.mean_visible_share = mean_visible_share(portals, visible);
  return write_visibility(portals, visible, {}, io_level.bsp);
}

}  // namespace

base::Result<CompiledLevel> compile_level(const formats::Map& map, std::span<const TextureSource> sources,
                                          const formats::Palette& palette, const CompileOptions& options,
                                          base::Jobs& jobs, CompileWatcher& watcher, Warnings& io_warnings) {
  CompiledLevel level;
  Stages stages(watcher, level.times);
  const TextureSet textures = stages.run("textures", [&] {
    return make_texture_set(texture_names(map), sources, palette, options.mip_levels, io_warnings);
  });
  const auto size = [&](std::string_view name) { return size_of(textures, name); };
  TRY(DraftResult made,
      stages.run("bsp", [&] { return make_draft(map, size, options.draft, jobs, io_warnings); }));
  level.leak = std::move(made.leak);
  level.bsp = std::move(made.draft.bsp);
  put_textures(textures, level.bsp);
  const auto progress = [&](std::size_t done, std::size_t total) { return watcher.progress(done, total); };
  if (options.visibility && !level.leak)
    TRY_STATUS(stages.run("visibility", [&] {
      return add_visibility(made.draft.portals, options.fast_visibility, jobs, progress, level);
    }));
  if (options.lighting) {
    const FaceKeys keys{std::move(made.draft.surface_keys), std::move(made.draft.keys_of_face)};
    TRY(level.light, stages.run("light", [&] {
      LightOptions how = options.light;
      how.palette = palette;
      return light_level(level.bsp, keys, how, jobs, progress, io_warnings);
    }));
    if (level.light.coloured) level.lit = level.light.lit;
  }
  return level;
}

}  // namespace temblor::compiler
