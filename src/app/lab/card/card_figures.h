// How the card's cache of surfaces does at several sizes, and how methods without such a cache do: frames of
// one level or demo, drawn through OpenGL with each in turn. VQuake's card had 4 MB, less its pictures, and
// 16-bit texels (Abrash, "Quake: A Post-Mortem and a Glimpse into the Future").
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/distribution.h"
#include "app/commands/options.h"
#include "app/lab/lab_scenes.h"
#include "render_gl/cache_options.h"
#include "render_gl/draw_options.h"

namespace temblor::app {

struct CardGrid {
  std::vector<FrameSize> sizes{{320, 200}, {640, 480}, {1920, 1080}};
  std::vector<std::size_t> megabytes{2, 4, 64, 256};
  double step_deg = 5;   // between two views of a level
  double seconds = 2.5;  // that the first cache of each size draws
  int lights = 0;        // that move around the eye, besides those of the scene
};

// One cache, or another method, at one frame size. Counts are means per frame, after the first one, which
// fills the cache.
struct CardFigures {
  FrameSize size;
  render_gl::WorldMethod method = render_gl::WorldMethod::kBlocks;
  render_gl::CacheOptions cache;
  std::size_t cache_bytes = 0;  // its memory on the card
  std::size_t frames = 0;
  // Wall time of the whole frame: the CPU's stages, uploads, drawing, and reading the picture back.
  Distribution frame_ms;
  // The card's part of it, by its own timer; nothing if it has none.
  std::optional<Distribution> card_ms;
  double hits = 0, uploads = 0, evicted = 0, portions = 0, bytes_uploaded = 0;
  double max_bytes_uploaded = 0;
  // Pixels whose channels are within 2 of 255 of the CPU's: their share, in a sample of the frames. With 8
  // bits: pixels whose palette index is the CPU's in 256 colors.
  double equal_share = 0;
  std::string problem;  // why this cache could not be measured; else empty
};

struct CardResults {
  std::string name, driver;
  int lights = 0;
  // By size. First kBlocks by format, then megabytes, then the other methods with 64 MB. Frames of texels
  // with 8 bits are indexed: palette indices are what the card keeps, as "8-bpp palettized hardware
  // textures".
  std::vector<CardFigures> runs;
};

// At one size, every run draws the same frames: as many as the first one draws in the time. Fails without
// OpenGL.
base::Result<CardResults> measure_card(const LabScenes& scenes, const CardGrid& grid,
                                       const render::Settings& settings);

// The size of a texel: 32, 16, or 8.
int count_bits(render_gl::TexelFormat format);

// A table for each size.
std::string describe_card(const CardResults& results);

// An object: scene, driver, lights, and a list "runs" of
//
//   size, method, megabytes, bits (32, 16, or 8), cache_bytes, frames
//   frame_ms {p50, p99, max}
//   card_ms {p50, p99, max}                              only of cards with a timer
//   hits, uploads, evicted, portions, bytes_uploaded     means per frame
//   max_bytes_uploaded                                   in one frame
//   equal_share
//   problem                                              only of those that could not be measured
nlohmann::json make_card_json(const CardResults& results);

}  // namespace temblor::app
