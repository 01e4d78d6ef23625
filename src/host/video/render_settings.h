// The renderer's settings as console variables: r_threads, r_mip_rule, r_show, and so on. render/settings.h
// documents what each setting does; the renderer itself does not depend on console variables.
#pragma once

#include "command/variables.h"
#include "render/settings.h"

namespace temblor::host {

class RenderSettings {
 public:
  // Registers the variables with their help. The defaults are those of render::Settings, except for threads:
  // one per core of the machine.
  explicit RenderSettings(command::Variables& variables);

  // The current values. `variables` is the table that the variables were registered in.
  render::Settings read(const command::Variables& variables) const;

 private:
  command::VariableIndex threads_, job_backend_, filter_, sharp_texels_, mip_rule_, force_mip_, perspective_,
      simd_kernels_, prefetch_, surface_cache_, cache_mb_, use_pvs_, fill_depth_, draw_world_, full_bright_,
      light_only_, colored_light_, lit_liquids_, caustics_, relight_alternate_, band_rows_, show_,
      alias_raster_, alias_snap_;
};

}  // namespace temblor::host
