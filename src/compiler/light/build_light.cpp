#include "compiler/light/build_light.h"

#include <optional>
#include <utility>
#include <vector>

#include "compiler/build/build_keys.h"
#include "compiler/light/faces/light_hash.h"
#include "compiler/light/sources/switchable_styles.h"

namespace temblor::compiler {

void set_light(LightSummary light, StageKey key, Build& io_build) {
  io_build.lit = light.colored ? std::optional(std::move(light.lit)) : std::nullopt;
  io_build.light_key = key;
}

base::Result<StageKey> find_light_key(const Build& build, const LightOptions& options) {
  TRY(const std::vector<formats::Entity> entities, formats::read_entities(build.bsp.entities));
  return make_light_key(build.bsp, entities, build.face_keys, options);
}

base::Status make_light(const LightOptions& options, base::Jobs& jobs, Progress progress, Build& io_build,
                        Warnings& io_warnings) {
  TRY(const StageKey key, find_light_key(io_build, options));
  TRY(LightSummary light, light_level(io_build.bsp, io_build.face_keys, options, jobs, progress, io_warnings,
                                      &io_build.light_cache));
  set_light(std::move(light), key, io_build);
  return base::Ok{};
}

base::Status reuse_light(Build& io_build) {
  TRY(std::vector<formats::Entity> entities, formats::read_entities(io_build.bsp.entities));
  Warnings reported_before;
  if (assign_switchable_styles(entities, reported_before))
    io_build.bsp.entities = formats::write_entities(entities);
  return base::Ok{};
}

void remove_light(Build& io_build) {
  io_build.bsp = strip_light(io_build.bsp);
  io_build.lit.reset();
  io_build.light_key = 0;
}

}  // namespace temblor::compiler
