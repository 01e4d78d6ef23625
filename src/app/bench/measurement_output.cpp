#include "app/bench/measurement_output.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>

namespace temblor::app {
namespace {

constexpr double kMebibyte = 1024.0 * 1024.0;

}  // namespace

nlohmann::json make_json(const Distribution& values) {
  return {{"p50", values.p50}, {"p99", values.p99}, {"max", values.max}};
}

std::string format_size(const FrameSize& size) {
  return fmt::format("{}x{}", size.width, size.height);
}

// The medians of both are from the same run, so slow phases of the machine affect both.
double compute_render_baselines(const Measurement& measurement) {
  return measurement.render_ms.p50 / measurement.baseline_ms.p50;
}

double compute_present_baselines(const Measurement& measurement) {
  return measurement.present_ms.p50 / measurement.baseline_ms.p50;
}

std::string describe_conditions(const MeasureOptions& options) {
  return fmt::format("{} {}, threads: {}", format_size(options.size), pixel_format_name(options.format),
                     options.settings.threads);
}

// Columns are aligned, so that two runs can be compared line by line.
std::string describe_measurement(const std::string& name, const Measurement& m) {
  std::string text;
  auto out = std::back_inserter(text);
  auto times = [&](const char* label, const Distribution& ms) {
    fmt::format_to(out, "  {:<11}{:>9.3f} ms median {:>9.3f} p99 {:>9.3f} max\n", label, ms.p50, ms.p99,
                   ms.max);
  };
  auto counts = [&](const char* label, const Distribution& count) {
    fmt::format_to(out, "  {:<11}{:>9.0f}    median {:>9.0f} p99 {:>9.0f} max\n", label, count.p50, count.p99,
                   count.max);
  };
  const bool is_demo = m.places == 0;
  fmt::format_to(out, "{}: {} frames{}, {}\n", name, m.frames,
                 is_demo ? "" : fmt::format(" from {} places", m.places), describe_conditions(m.options));
  fmt::format_to(out, "  {:<11}{:>9.1f}\n", "fps", m.fps);
  times("frame", m.frame_ms);
  if (is_demo) {
    fmt::format_to(out, "  {:<11}{:>9} is the slowest frame\n", "", m.slowest_frame);
    times("client", m.client_ms);
  }
  times("render", m.render_ms);
  times("present", m.present_ms);
  times("baseline", m.baseline_ms);
  if (m.cold_ms) times("cold cache", *m.cold_ms);
  if (m.relight) {
    times("same light", m.relight->still_ms);
    times("all relit", m.relight->relit_ms);
    times("alternate", m.relight->alternate_ms);
    times("animated", m.relight->animated_ms);
    fmt::format_to(out, "  {:<11}{:>9.1f} surfaces, {:.0f} texels built for a step of the light styles\n", "",
                   m.relight->animated_surfaces, m.relight->animated_texels);
  }
  fmt::format_to(out, "  {:<11}{:>9.3f} fill baselines to render, {:.3f} to present\n", "ratio",
                 compute_render_baselines(m), compute_present_baselines(m));
  for (std::size_t stage = 0; stage < render::kStages; ++stage)
    fmt::format_to(out, "  {:<11}{:>9.3f} ms mean   {:>9.2f} cycles/pixel\n", render::kStageNames[stage],
                   m.stage_ms[stage], m.stage_cycles_per_pixel[stage]);
  if (is_demo) {
    counts("models", m.models);
    counts("triangles", m.triangles);
    counts("particles", m.particles);
  }
  counts("PVS faces", m.faces_in_pvs);
  counts("drawn faces", m.faces_drawn);
  counts("seen faces", m.faces_seen);
  counts("edges", m.edges);
  counts("spans", m.spans);
  counts("surfaces", m.surfaces);
  counts("texels read", m.texels_read);
  fmt::format_to(out, "  {:<11}{:>9.1f} MiB at the end\n", "cache",
                 static_cast<double>(m.cache_bytes) / kMebibyte);
  if (m.circle_cache_bytes)
    fmt::format_to(out, "  {:<11}{:>9.1f} MiB median {:>9.1f} max, for a circle\n", "",
                   m.circle_cache_bytes->p50 / kMebibyte, m.circle_cache_bytes->max / kMebibyte);
  fmt::format_to(out, "  {:<11}{:>9} built\n", "surfaces", m.surfaces_built);
  fmt::format_to(out, "  {:<11}{:>9} frames allocate, at most {} times\n", "heap", m.allocating_frames,
                 m.max_allocations);
  return text;
}

// Scripts depend on the keys, so they keep their names: "floor" is the fill baseline.
nlohmann::json make_json(const std::string& name, const Measurement& m) {
  const bool is_demo = m.places == 0;
  nlohmann::json json = {
      {is_demo ? "demo" : "map", name},
      {"fps", m.fps},
      {"frames", m.frames},
      {"places", m.places},
      {"frame_ms", make_json(m.frame_ms)},
      {"render_ms", make_json(m.render_ms)},
      {"present_ms", make_json(m.present_ms)},
      {"floor_ms", m.baseline_ms.p50},
      {"render_floors", compute_render_baselines(m)},
      {"present_floors", compute_present_baselines(m)},
      {"faces", {{"in_pvs", m.faces_in_pvs.p50}, {"drawn", m.faces_drawn.p50}, {"seen", m.faces_seen.p50}}},
      {"edges", m.edges.p50},
      {"spans", m.spans.p50},
      {"surfaces", m.surfaces.p50},
      {"surfaces_built", m.surfaces_built},
      {"texels_read", m.texels_read.p50},
      {"cache_bytes", m.cache_bytes},
      {"allocations", m.max_allocations},
      {"allocating_frames", m.allocating_frames},
      {"threads", m.options.settings.threads},
      {"size", format_size(m.options.size)},
      {"color", pixel_format_name(m.options.format)}};
  for (std::size_t stage = 0; stage < render::kStages; ++stage) {
    json["stages"][render::kStageNames[stage]] = m.stage_ms[stage];
    json["cycles_per_pixel"][render::kStageNames[stage]] = m.stage_cycles_per_pixel[stage];
  }
  json["stages"]["present"] = m.present_mean_ms;
  if (is_demo) {
    json["stages"]["client"] = m.client_mean_ms;
    json["models"] = m.models.p50;
    json["triangles"] = m.triangles.p50;
    json["particles"] = m.particles.p50;
    json["slowest_frame"] = m.slowest_frame;
  }
  if (m.cold_ms) json["cold_ms"] = make_json(*m.cold_ms);
  if (m.relight)
    json["relight"] = {{"still_ms", make_json(m.relight->still_ms)},
                       {"relit_ms", make_json(m.relight->relit_ms)},
                       {"alternate_ms", make_json(m.relight->alternate_ms)},
                       {"animated_ms", make_json(m.relight->animated_ms)},
                       {"animated_surfaces", m.relight->animated_surfaces},
                       {"animated_texels", m.relight->animated_texels}};
  if (m.circle_cache_bytes) json["circle_cache_bytes"] = make_json(*m.circle_cache_bytes);
  return json;
}

}  // namespace temblor::app
