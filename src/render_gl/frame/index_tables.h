// The CPU's tables of palette indices on the graphics card, for indexed frames: fog, blends, and whatever
// else maps indices to indices.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "render_gl/frame/target.h"

namespace temblor::render_gl {

// Locations of the variables of kIndexPart (shader_look.h); -1 for those that a program lacks.
struct IndexUniforms {
  IndexUniforms(const Functions& gl, const Program& program);
  GLint fog_table, below, blend_table, dim_table, dim_column;
};

// How a translucent thing changes the indices below it: table[front * 256 + below], where front is
// dims[index * 256 + dim_column] if there are `dims`.
struct IndexBlend {
  const std::uint8_t* table = nullptr;
  const std::uint8_t* dims = nullptr;
  int dim_column = -1;
};

class IndexTables {
 public:
  // The table of the frame's fog (FogTables); null without fog. Fails if the card lacks memory.
  base::Status set_fog(const Functions& gl, const std::uint8_t* rows);
  // The texture of a table that never changes and lives as long as this object: 256 columns, `rows` rows.
  // Fails if the card lacks memory.
  base::Result<GLuint> find(const Functions& gl, const std::uint8_t* table, int rows);

  // These set variables of the program in use.
  void use_fog(const Functions& gl, const IndexUniforms& uniforms) const;
  // For drawing inside of `rect` over what the target shows, which is copied. The target is drawn to from
  // then on. Fails if the card lacks memory.
  base::Status use_blend(const Functions& gl, const IndexUniforms& uniforms, const IndexBlend& blend,
                         const PixelRect& rect, Target& io_target);

 private:
  std::vector<std::uint8_t> fog_rows_;  // those of the texture
  Texture fog_;
  std::unordered_map<const std::uint8_t*, Texture> tables_;
};

}  // namespace temblor::render_gl
