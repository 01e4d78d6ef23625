// The figures of a technique: its times and counts, and its errors against the oracle.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/bench/measurement.h"
#include "app/lab/errors/light_figures.h"
#include "app/lab/errors/texel_figures.h"
#include "app/lab/lab_scenes.h"
#include "app/lab/model_figures.h"
#include "lab/registry.h"
#include "oracle/comparison.h"

namespace temblor::app {

// Means of several views, which are drawn once more with counters.
struct ViewFigures {
  std::size_t views = 0;
  double pixels_written = 0;                                        // per pixel of the frame; 1: no overdraw
  double pixels_tested = 0;                                         // per pixel
  double comparisons = 0, splits = 0, spans_sorted = 0, bytes = 0;  // per frame
  double planes_tested = 0, cache_hits = 0;                         // per frame
  double portals_clipped = 0, leaves_reached = 0, edges_saved = 0;  // per frame
  double rays = 0;                                                  // per pixel
  double pixels_off = 0;       // share of the frame: they show another texel
  double max_texel_error = 0;  // of all views, in texels of mip 0
  oracle::Tally tally;
  LightErrors light;
  TexelErrors texels;  // zero for techniques that change texels
  ModelErrors models;  // zero without models
  // Sums over the views, of models that are drawn from a stack of vertices.
  lab::Counts stack;
  double loads_per_vertex() const { return divide_by(stack.vertices, stack.vertex_loads); }
  double misses_per_triangle(std::uint64_t misses) const { return divide_by(stack.model_triangles, misses); }

 private:
  static double divide_by(std::uint64_t divisor, std::uint64_t value) {
    return divisor == 0 ? 0 : static_cast<double>(value) / static_cast<double>(divisor);
  }
};

struct TechniqueFigures {
  lab::Choice choice;
  Measurement measurement;
  ViewFigures views;
};

struct FigureOptions {
  MeasureOptions measure;  // its technique is not used
  // Measurements of each technique; the one with the smallest median counts.
  int rounds = 1;
  // Pixels of each view that are compared with the oracle.
  int judged_pixels = 4000;
  // The size of the pictures that light and texels are compared in; 0x0: that of `measure`.
  FrameSize error_size{0, 0};
};

// The figures of each technique. Techniques are measured in turns, because a machine's speed changes.
base::Result<std::vector<TechniqueFigures>> find_figures(const LabScenes& scenes,
                                                         std::span<const lab::Choice> choices,
                                                         const FigureOptions& options);

// A table with a column for each technique; ratios are to the first one.
std::string describe_figures(const std::string& name, std::span<const TechniqueFigures> figures);

// An object: map or demo, size, color, threads, and a list "techniques" of
//
//   name, parameters {name: value}
//   frame_ms {p50, p99, max}, ratio                      of medians, to the first technique
//   stages {name: ms}, cycles_per_pixel {name: cycles}
//   faces_drawn, edges, spans, surfaces_built            medians, and a sum
//   pixels_written, pixels_tested, rays                  per pixel of the frame
//   comparisons, splits, spans_sorted, bytes, planes_tested,     per frame
//   cache_hits, portals_clipped, leaves_reached, edges_saved
//   texels_off, max_texel_error                          share of pixels; the largest distance along s or t
//   judged {pixels, wrong, tied, near_edge}              against the oracle
//   light {error, turn, roll}, each {mean, max}          in steps of light (light_figures.h)
//   texels {error, turn, roll}, each {mean, max}         in texels (texel_figures.h)
//   models {outline, texels, texels_off}                 against their exact picture (model_figures.h):
//                                                        shares of pixels, and the mean distance in texels
//   stack {loads_per_vertex, pentium {list, stack},      models that are drawn from a stack: simulated cache
//     today {list, stack}}                               misses per triangle
//     (lab/models/stack/cache_misses.h)
//   surface_texels {p50, p99, max}                       per frame; texels_built: mean
nlohmann::json make_json(const std::string& name, std::span<const TechniqueFigures> figures);

}  // namespace temblor::app
