// The renderer's choices of method as console variables: r_threads, r_mip_rule, r_show and so on.
#pragma once

#include "command/variables.h"
#include "render/renderer.h"

namespace temblor::host {

class RenderSettings {
 public:
  // Registers the variables, each with its help; the defaults are those of render::Settings, but for threads:
  // as many as the machine has cores.
  explicit RenderSettings(command::Variables& variables);

  // What the variables say now. `variables` is the table they were registered in.
  render::Settings read(const command::Variables& variables) const;

 private:
  command::VariableIndex threads_, job_backend_, mip_rule_, force_mip_, perspective_, vector_kernels_,
      prefetch_, surface_cache_, cache_mb_, use_pvs_, fill_depth_, colored_light_, relight_alternate_,
      band_rows_, show_, alias_raster_, alias_snap_;
};

}  // namespace temblor::host
