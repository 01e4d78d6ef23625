#include "render_gl/passes/lit_passes.h"

#include <array>

namespace temblor::render_gl {

namespace {

constexpr std::array kOnePass = {LitPass{}};

constexpr std::array kLightOverTexture = {
    LitPass{.kind = LitPassKind::kTexture},
    LitPass{LitPassKind::kLight, false, GL_DST_COLOR, GL_SRC_COLOR},
    LitPass{LitPassKind::kBright, false, GL_ONE, GL_ZERO},
    LitPass{LitPassKind::kFog, false, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA},
};

constexpr std::array kTextureOverLights = {
    LitPass{.kind = LitPassKind::kLight},
    LitPass{LitPassKind::kPolygons, false, GL_ONE, GL_ONE},
    LitPass{LitPassKind::kTexture, false, GL_DST_COLOR, GL_SRC_COLOR},
    LitPass{LitPassKind::kBright, false, GL_ONE, GL_ZERO},
    LitPass{LitPassKind::kFog, false, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA},
};

}  // namespace

std::span<const LitPass> find_lit_passes(WorldMethod method) {
  if (method == WorldMethod::kLightPass) return kLightOverTexture;
  if (method == WorldMethod::kLightPolygons) return kTextureOverLights;
  return kOnePass;
}

void begin_lit_pass(const Functions& gl, const LitPass& pass) {
  if (pass.is_first) return;
  gl.DepthFunc(pass.kind == LitPassKind::kPolygons ? GL_GREATER : GL_EQUAL);
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(pass.source_factor, pass.target_factor);
}

void end_lit_passes(const Functions& gl) {
  gl.DepthFunc(GL_GREATER);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
}

}  // namespace temblor::render_gl
