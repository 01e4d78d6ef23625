#include "lab/technique.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace temblor::lab {

Counts& Counts::operator+=(const Counts& other) {
  spans_sorted += other.spans_sorted;
  comparisons += other.comparisons;
  cache_hits += other.cache_hits;
  splits += other.splits;
  pixels_tested += other.pixels_tested;
  bytes += other.bytes;
  edges_saved += other.edges_saved;
  planes_tested += other.planes_tested;
  rays += other.rays;
  portals_clipped += other.portals_clipped;
  leaves_reached += other.leaves_reached;
  pixels_off += other.pixels_off;
  max_texel_error = std::max(max_texel_error, other.max_texel_error);
  vertices += other.vertices;
  vertex_loads += other.vertex_loads;
  model_triangles += other.model_triangles;
  list_misses += other.list_misses;
  stack_misses += other.stack_misses;
  list_misses_today += other.list_misses_today;
  stack_misses_today += other.stack_misses_today;
  return *this;
}

Counts Counter::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(sum_, {});
}

std::string Choice::label() const {
  std::string label(technique->name);
  char separator = ':';
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] == technique->parameters[i].value) continue;
    label += fmt::format("{}{}={}", separator, technique->parameters[i].name, values[i]);
    separator = ',';
  }
  return label;
}

}  // namespace temblor::lab
