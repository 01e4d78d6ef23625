#include "formats/levels/light_grid.h"

#include <algorithm>
#include <cmath>

namespace temblor::formats {
namespace {

constexpr std::size_t kNodeBytes = 44, kLeafHeaderBytes = 24;
constexpr int kMaxDepth = 32;

bool is_finite_place(const math::Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

math::Vec3 read_vec3(base::ByteReader& io_reader) {
  const float x = io_reader.f32(), y = io_reader.f32(), z = io_reader.f32();
  return {x, y, z};
}

template <typename Number, std::size_t kCount>
std::array<Number, kCount> read_array(base::ByteReader& io_reader) {
  std::array<Number, kCount> numbers{};
  for (Number& number : numbers) number = io_reader.read<Number>();
  return numbers;
}

base::Status read_nodes(base::ByteReader& io_reader, LightGrid& io_grid) {
  const std::uint32_t count = io_reader.u32();
  if (!io_reader.ok() || count > io_reader.remaining() / kNodeBytes)
    return base::malformed("{} nodes are more than the lump can hold", count);
  io_grid.nodes.resize(count);
  for (GridNode& node : io_grid.nodes) {
    node.middle = read_array<std::uint32_t, 3>(io_reader);
    for (GridChild& child : node.children) child.value = io_reader.u32();
  }
  return base::Ok{};
}

// Returns the number of samples of a box, or nullopt if it is empty or has more than `most`.
std::optional<std::size_t> count_samples(const std::array<std::int32_t, 3>& size, std::size_t most) {
  std::size_t count = 1;
  for (const std::int32_t side : size) {
    if (side <= 0 || static_cast<std::size_t>(side) > most / count) return std::nullopt;
    count *= static_cast<std::size_t>(side);
  }
  return count;
}

base::Status read_leaf(base::ByteReader& io_reader, LightGrid& io_grid) {
  GridLeaf leaf;
  leaf.mins = read_array<std::int32_t, 3>(io_reader);
  leaf.size = read_array<std::int32_t, 3>(io_reader);
  leaf.first_sample = static_cast<std::uint32_t>(io_grid.samples.size());
  // Each sample has at least one byte.
  const auto count = count_samples(leaf.size, io_reader.remaining());
  if (!count)
    return base::malformed("leaf {} of {} x {} x {} samples is larger than the lump", io_grid.leaves.size(),
                           leaf.size[0], leaf.size[1], leaf.size[2]);
  for (std::size_t i = 0; i < *count; ++i) {
    GridSample sample{static_cast<std::uint32_t>(io_grid.lights.size()), io_reader.u8()};
    for (int light = 0; sample.light_count != GridSample::kOccluded && light < sample.light_count; ++light) {
      const std::uint8_t style = io_reader.u8();
      io_grid.lights.push_back({style, read_array<std::uint8_t, 3>(io_reader)});
    }
    if (!io_reader.ok()) return base::malformed("the lump ends inside of leaf {}", io_grid.leaves.size());
    io_grid.samples.push_back(sample);
  }
  io_grid.leaves.push_back(leaf);
  return base::Ok{};
}

base::Status read_leaves(base::ByteReader& io_reader, LightGrid& io_grid) {
  const std::uint32_t count = io_reader.u32();
  if (!io_reader.ok() || count > io_reader.remaining() / kLeafHeaderBytes)
    return base::malformed("{} leaves are more than the lump can hold", count);
  io_grid.leaves.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) TRY_STATUS(read_leaf(io_reader, io_grid));
  return base::Ok{};
}

// Walks the tree from its root. Because nothing is reached twice, this ends, and a walk down does too.
base::Status check_tree(const LightGrid& grid) {
  struct Visit {
    GridChild child;
    int depth;
  };
  std::vector<std::uint8_t> is_reached(grid.nodes.size(), 0);
  std::vector<Visit> open{{grid.root, 0}};
  while (!open.empty()) {
    const auto [child, depth] = open.back();
    open.pop_back();
    if (child.is_missing()) continue;
    const std::uint32_t number = child.number();
    if (number >= (child.is_leaf() ? grid.leaves.size() : grid.nodes.size()))
      return base::malformed("there is no {} {}", child.is_leaf() ? "leaf" : "node", number);
    if (child.is_leaf()) continue;
    if (is_reached[number] != 0) return base::malformed("node {} is reached twice", number);
    if (depth >= kMaxDepth) return base::malformed("node {} is deeper than {}", number, kMaxDepth);
    is_reached[number] = 1;
    for (const GridChild& next : grid.nodes[number].children) open.push_back({next, depth + 1});
  }
  return base::Ok{};
}

}  // namespace

base::Result<LightGrid> read_light_grid(base::Bytes lump) {
  base::ByteReader reader(lump);
  LightGrid grid;
  grid.step = read_vec3(reader);
  grid.size = read_array<std::int32_t, 3>(reader);
  grid.mins = read_vec3(reader);
  reader.u8();  // the largest number of styles follows from the samples
  grid.root.value = reader.u32();
  if (!reader.ok()) return base::malformed("{} bytes are shorter than the header", lump.size());
  if (!is_finite_place(grid.mins) || !is_finite_place(grid.step) ||
      std::min({grid.step.x, grid.step.y, grid.step.z}) <= 0)
    return base::malformed(
        "the place of a sample is not finite, or the step between samples is not positive");
  TRY_STATUS(read_nodes(reader, grid));
  TRY_STATUS(read_leaves(reader, grid));
  TRY_STATUS(check_tree(grid));
  return grid;
}

base::ByteVector write_light_grid(const LightGrid& grid) {
  base::ByteWriter writer;
  const auto write_each = [&writer](const auto& numbers) {
    for (const auto number : numbers) writer.write(number);
  };
  write_each(std::array{grid.step.x, grid.step.y, grid.step.z});
  write_each(grid.size);
  write_each(std::array{grid.mins.x, grid.mins.y, grid.mins.z});
  std::uint8_t most_styles = 0;
  for (const GridSample& sample : grid.samples)
    if (sample.light_count != GridSample::kOccluded) most_styles = std::max(most_styles, sample.light_count);
  writer.u8(most_styles);
  writer.u32(grid.root.value);
  writer.u32(static_cast<std::uint32_t>(grid.nodes.size()));
  for (const GridNode& node : grid.nodes) {
    write_each(node.middle);
    for (const GridChild& child : node.children) writer.u32(child.value);
  }
  writer.u32(static_cast<std::uint32_t>(grid.leaves.size()));
  for (const GridLeaf& leaf : grid.leaves) {
    write_each(leaf.mins);
    write_each(leaf.size);
    const std::size_t count = static_cast<std::size_t>(leaf.size[0]) *
                              static_cast<std::size_t>(leaf.size[1]) * static_cast<std::size_t>(leaf.size[2]);
    for (const GridSample& sample : std::span(grid.samples).subspan(leaf.first_sample, count)) {
      writer.u8(sample.light_count);
      if (sample.light_count == GridSample::kOccluded) continue;
      for (const GridLight& light : std::span(grid.lights).subspan(sample.first_light, sample.light_count)) {
        writer.u8(light.style);
        write_each(light.rgb);
      }
    }
  }
  return std::move(writer).take();
}

std::optional<std::span<const GridLight>> find_grid_lights(const LightGrid& grid,
                                                           const std::array<std::int32_t, 3>& sample) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (sample[axis] < 0 || sample[axis] >= grid.size[axis]) return std::nullopt;
  GridChild at = grid.root;
  while (!at.is_missing() && !at.is_leaf()) {
    const GridNode& node = grid.nodes[at.number()];
    const auto is_upper = [&](std::size_t axis) {
      return static_cast<std::uint32_t>(sample[axis]) >= node.middle[axis] ? 1u : 0u;
    };
    at = node.children[is_upper(0) * 4 + is_upper(1) * 2 + is_upper(2)];
  }
  if (at.is_missing()) return std::nullopt;
  const GridLeaf& leaf = grid.leaves[at.number()];
  std::array<std::size_t, 3> local{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t offset = std::int64_t{sample[axis]} - leaf.mins[axis];
    if (offset < 0 || offset >= leaf.size[axis]) return std::nullopt;
    local[axis] = static_cast<std::size_t>(offset);
  }
  const std::size_t row = local[1] + static_cast<std::size_t>(leaf.size[1]) * local[2];
  const GridSample& found =
      grid.samples[leaf.first_sample + local[0] + static_cast<std::size_t>(leaf.size[0]) * row];
  if (found.light_count == GridSample::kOccluded) return std::nullopt;
  return std::span(grid.lights).subspan(found.first_light, found.light_count);
}

}  // namespace temblor::formats
