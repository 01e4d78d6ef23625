#include <algorithm>

#include "compiler/light/grid/grid_blocks.h"

namespace temblor::compiler {
namespace {

using Place = std::array<std::int32_t, 3>;

struct SampleBox {
  Place mins{}, size{};
};

// Calls visit(place) for each sample of a box, x first.
template <typename Visit>
void visit_samples(const SampleBox& box, const Visit& visit) {
  for (std::int32_t z = 0; z < box.size[2]; ++z)
    for (std::int32_t y = 0; y < box.size[1]; ++y)
      for (std::int32_t x = 0; x < box.size[0]; ++x)
        visit(Place{box.mins[0] + x, box.mins[1] + y, box.mins[2] + z});
}

class OctreeWriter {
 public:
  explicit OctreeWriter(const GridBlocks& blocks) : blocks_(blocks) {
    grid_.step = blocks.step;
    grid_.mins = blocks.mins;
    grid_.size = blocks.size;
    grid_.root = add({{0, 0, 0}, blocks.size});
  }
  formats::LightGrid take() && { return std::move(grid_); }

 private:
  formats::GridSample sample_at(const Place& place) const {
    const GridBlock& block = blocks_.block_at(place);
    if (block.samples.empty()) return {0, formats::GridSample::kOccluded};
    return block.samples[GridBlocks::number_in_block(place)];
  }

  formats::GridChild add(const SampleBox& box) {
    std::size_t open = 0, all = 0;
    visit_samples(box, [&](const Place& place) {
      ++all;
      if (sample_at(place).light_count != formats::GridSample::kOccluded) ++open;
    });
    if (open == 0) return {};
    const bool is_small =
        std::all_of(box.size.begin(), box.size.end(), [](std::int32_t side) { return side <= kBlockSide; });
    return is_small || open == all ? add_leaf(box) : add_node(box);
  }

  formats::GridChild add_leaf(const SampleBox& box) {
    const auto number = static_cast<std::uint32_t>(grid_.leaves.size());
    grid_.leaves.push_back({box.mins, box.size, static_cast<std::uint32_t>(grid_.samples.size())});
    visit_samples(box, [&](const Place& place) {
      formats::GridSample sample = sample_at(place);
      const auto first = static_cast<std::uint32_t>(grid_.lights.size());
      if (sample.light_count != formats::GridSample::kOccluded) {
        const auto begin = blocks_.block_at(place).lights.begin() + sample.first_light;
        grid_.lights.insert(grid_.lights.end(), begin, begin + sample.light_count);
      }
      sample.first_light = first;
      grid_.samples.push_back(sample);
    });
    return {formats::GridChild::kLeafBit | number};
  }

  // Splits at borders of blocks, so that small boxes are blocks.
  formats::GridChild add_node(const SampleBox& box) {
    const auto number = static_cast<std::uint32_t>(grid_.nodes.size());
    grid_.nodes.emplace_back();
    formats::GridNode node;
    std::array<SampleBox, 2> halves{box, box};  // each axis on its own
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int32_t half_blocks = (box.size[axis] / 2 + kBlockSide - 1) / kBlockSide;
      const std::int32_t lower = std::min(box.size[axis], std::max(1, half_blocks) * kBlockSide);
      halves[0].size[axis] = lower;
      halves[1].mins[axis] += lower;
      halves[1].size[axis] -= lower;
      node.middle[axis] = static_cast<std::uint32_t>(halves[1].mins[axis]);
    }
    for (std::size_t child = 0; child < 8; ++child) {
      const std::array<std::size_t, 3> upper{child >> 2, child >> 1 & 1, child & 1};
      SampleBox part;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        part.mins[axis] = halves[upper[axis]].mins[axis];
        part.size[axis] = halves[upper[axis]].size[axis];
      }
      node.children[child] = add(part);
    }
    grid_.nodes[number] = node;
    return {number};
  }

  const GridBlocks& blocks_;
  formats::LightGrid grid_;
};

}  // namespace

formats::LightGrid make_octree(const GridBlocks& grid) {
  return OctreeWriter(grid).take();
}

}  // namespace temblor::compiler
