// Shares the graphs of levels between the runs of one process. A flood takes a second or more, and games with
// other seeds, or on other skills, often start with the same one.
//
// Two floods are the same if everything that they read is the same: the trees of the level, the parts of its
// facts that stop or move players, and the starts. The cache compares all of it, word by word.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scripted_player/navigation/nav_graph.h"
#include "scripted_player/navigation/nav_space.h"

namespace temblor::player {

class GraphCache {
 public:
  // Returns the graph that NavGraph's constructor would make.
  std::shared_ptr<const NavGraph> find_or_make(const NavSpace& space, std::span<const math::Vec3> starts);
  // Returns the number of different graphs.
  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    // Everything that the flood reads, in a fixed order.
    std::vector<std::uint32_t> input;
    std::shared_ptr<const NavGraph> graph;
  };
  std::vector<Entry> entries_;
};

}  // namespace temblor::player
