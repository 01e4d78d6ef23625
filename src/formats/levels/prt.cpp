#include "formats/levels/prt.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "base/text.h"
#include "formats/levels/map/scanner.h"

namespace temblor::formats {
namespace {

constexpr std::uint32_t kUnassigned = ~0u;

class PrtReader {
 public:
  explicit PrtReader(std::string_view text) : scanner_(text) {}

  base::Result<PortalFile> read() {
    const std::string header(scanner_.run());
    std::uint32_t leaves = 0, portals = 0;
    if (header == "PRT1") {
      TRY(leaves, read_count(kMaxPrtLeaves, "leaves"));
      file_.cluster_count = leaves;
      TRY(portals, read_count(kMaxPortals, "portals"));
    } else if (header == "PRT2") {
      TRY(leaves, read_count(kMaxPrtLeaves, "leaves"));
      TRY(file_.cluster_count, read_count(kMaxPrtLeaves, "clusters"));
      TRY(portals, read_count(kMaxPortals, "portals"));
    } else if (header == "PRT1-AM") {
      TRY(file_.cluster_count, read_count(kMaxPrtLeaves, "clusters"));
      TRY(portals, read_count(kMaxPortals, "portals"));
      TRY(leaves, read_count(kMaxPrtLeaves, "leaves"));
    } else {
      return base::malformed("\"{}\" is not the header of a portal file: PRT1, PRT2, or PRT1-AM",
                             base::quotable(header));
    }
    for (std::uint32_t i = 0; i < portals; ++i) TRY_STATUS(read_portal());
    file_.cluster_of_leaf.assign(leaves, kUnassigned);
    if (header == "PRT1")
      std::iota(file_.cluster_of_leaf.begin(), file_.cluster_of_leaf.end(), 0u);
    else
      TRY_STATUS(header == "PRT2" ? read_leaves_of_clusters() : read_clusters_of_leaves());
    return std::move(file_);
  }

 private:
  static constexpr std::size_t kMaxPortals = 1 << 26;  // a line each, so this only bounds the counter

  template <typename... Args>
  base::Error malformed(fmt::format_string<Args...> format, Args&&... args) const {
    return base::malformed("line {}: {}", line_, fmt::format(format, std::forward<Args>(args)...));
  }

  std::optional<std::int32_t> read_whole_number() {
    line_ = scanner_.line();
    return scanner_.whole_number();
  }

  base::Result<std::uint32_t> read_count(std::size_t max, const char* of) {
    const auto count = read_whole_number();
    if (!count || *count < 0 || static_cast<std::size_t>(*count) > max)
      return malformed("expected the number of {}, at most {}", of, max);
    return static_cast<std::uint32_t>(*count);
  }

  base::Result<std::uint32_t> read_index(std::size_t count, const char* of) {
    const auto index = read_whole_number();
    if (!index || *index < 0 || static_cast<std::size_t>(*index) >= count)
      return malformed("expected the number of a {}, below {}", of, count);
    return static_cast<std::uint32_t>(*index);
  }

  base::Status read_portal() {
    const auto points = read_whole_number();
    if (!points || *points < 3 || static_cast<std::size_t>(*points) > kMaxPrtPoints)
      return malformed("expected a portal of 3 to {} points", kMaxPrtPoints);
    PrtPortal portal;
    for (std::uint32_t& cluster : portal.clusters) {
      TRY(cluster, read_index(file_.cluster_count, "cluster"));
    }
    for (std::int32_t i = 0; i < *points; ++i) {
      math::Vec3d& point = portal.points_world.emplace_back();
      bool is_point = scanner_.accept('(');
      for (int axis = 0; axis < 3 && is_point; ++axis) {
        const auto number = scanner_.number();
        is_point = number.has_value();
        point[axis] = number.value_or(0);
      }
      if (!is_point || !scanner_.accept(')')) return malformed("expected a point, \"(x y z )\"");
    }
    file_.portals.push_back(std::move(portal));
    return base::Ok{};
  }

  base::Status read_leaves_of_clusters() {
    std::size_t assigned = 0;
    for (std::uint32_t cluster = 0; cluster < file_.cluster_count; ++cluster)
      for (;;) {
        const auto leaf = read_whole_number();
        if (leaf && *leaf < 0) break;
        if (!leaf || static_cast<std::size_t>(*leaf) >= file_.cluster_of_leaf.size())
          return malformed("expected a leaf of cluster {}, below {}", cluster, file_.cluster_of_leaf.size());
        std::uint32_t& of_leaf = file_.cluster_of_leaf[static_cast<std::size_t>(*leaf)];
        if (of_leaf != kUnassigned) return malformed("leaf {} is in two clusters", *leaf);
        of_leaf = cluster;
        ++assigned;
      }
    if (assigned != file_.cluster_of_leaf.size())
      return malformed("only {} of {} leaves are in a cluster", assigned, file_.cluster_of_leaf.size());
    return base::Ok{};
  }

  base::Status read_clusters_of_leaves() {
    for (std::uint32_t& cluster : file_.cluster_of_leaf) {
      TRY(cluster, read_index(file_.cluster_count, "cluster"));
    }
    return base::Ok{};
  }

  map::Scanner scanner_;
  std::uint32_t line_ = 1;  // of the last whole number
  PortalFile file_;
};

bool has_one_leaf_per_cluster(const PortalFile& file) {
  if (file.cluster_count != file.cluster_of_leaf.size()) return false;
  for (std::size_t leaf = 0; leaf < file.cluster_of_leaf.size(); ++leaf)
    if (file.cluster_of_leaf[leaf] != leaf) return false;
  return true;
}

std::string write_leaves_of_clusters(const PortalFile& file) {
  std::vector<std::string> lines(file.cluster_count);
  for (std::size_t leaf = 0; leaf < file.cluster_of_leaf.size(); ++leaf)
    lines[file.cluster_of_leaf[leaf]] += fmt::format("{} ", leaf);
  std::string text;
  for (const std::string& line : lines) text += line + "-1\n";
  return text;
}

}  // namespace

base::Result<PortalFile> read_prt(std::string_view text) {
  return PrtReader(text).read();
}

std::string write_prt(const PortalFile& file) {
  const bool is_plain = has_one_leaf_per_cluster(file);
  std::string text = is_plain
                         ? fmt::format("PRT1\n{}\n", file.cluster_of_leaf.size())
                         : fmt::format("PRT2\n{}\n{}\n", file.cluster_of_leaf.size(), file.cluster_count);
  text += fmt::format("{}\n", file.portals.size());
  for (const PrtPortal& portal : file.portals) {
    text += fmt::format("{} {} {} ", portal.points_world.size(), portal.clusters[0], portal.clusters[1]);
    for (const math::Vec3d& point : portal.points_world)
      text += fmt::format("({} {} {} ) ", point.x, point.y, point.z);
    text += '\n';
  }
  return is_plain ? text : text + write_leaves_of_clusters(file);
}

}  // namespace temblor::formats
