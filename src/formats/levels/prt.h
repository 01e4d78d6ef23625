// The openings between the leaves of a level (.prt), text that qbsp programs write for vis programs. Three
// dialects:
//
//   PRT1                  PRT2                    PRT1-AM
//   leaves                leaves                  clusters
//   portals               clusters                portals
//   PORTAL ...            portals                 leaves
//                         PORTAL ...              PORTAL ...
//                         LEAF ... -1   for each  CLUSTER       for each leaf
//                                       cluster
//
//   PORTAL: points cluster cluster (x y z ) ...   the first cluster is in front of the plane, from where the
//                                                 points are clockwise
//
// A cluster is a group of leaves with the same visibility; in PRT1 each leaf is one. Leaf i of the file is
// leaf i + 1 of the level, whose leaf 0 is solid. Layout: observed in files of public tools.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

struct PrtPortal {
  std::vector<math::Vec3d> points_world;    // 3 to kMaxPrtPoints
  std::array<std::uint32_t, 2> clusters{};  // in front of the plane, behind it; below cluster_count
  bool operator==(const PrtPortal&) const = default;
};

struct PortalFile {
  std::uint32_t cluster_count = 0;
  std::vector<std::uint32_t> cluster_of_leaf;  // by leaf of the file; below cluster_count
  std::vector<PrtPortal> portals;
  bool operator==(const PortalFile&) const = default;
};

constexpr std::size_t kMaxPrtLeaves = 1 << 20;
constexpr std::size_t kMaxPrtPoints = 1024;  // of a portal

// Errors name the line: another header, counts beyond the limits, a missing or unusable number, a leaf
// without a cluster or with two.
base::Result<PortalFile> read_prt(std::string_view text);

// Writes PRT1 if every leaf is its own cluster, otherwise PRT2. Coordinates read back exactly.
std::string write_prt(const PortalFile& file);

}  // namespace temblor::formats
