// Method: clusters, not leaves, see each other, so one row for each cluster is coded and shared by all of its
// leaves. Different clusters with equal rows share them as well.
#include "compiler/vis/visibility_lump.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/check.h"

namespace temblor::compiler {

namespace {

using ByteRow = std::vector<std::uint8_t>;

// Slots of formats::BspLeaf::ambient. Slot 2, slime, is left to the engine's default.
enum AmbientSlot : std::size_t { kWater = 0, kSky = 1, kLava = 3 };
constexpr std::uint8_t kFullLevel = 255;

template <typename Visit>
void for_each_bit(std::span<const BitMatrix::Word> row, Visit visit) {
  for (std::size_t i = 0; i < row.size(); ++i)
    for (BitMatrix::Word rest = row[i]; rest != 0; rest &= rest - 1)
      visit(i * 64 + static_cast<std::size_t>(std::countr_zero(rest)));
}

std::vector<std::vector<std::uint32_t>> group_leaves_by_cluster(const PortalSet& portals) {
  std::vector<std::vector<std::uint32_t>> leaves(portals.cluster_count);
  for (std::uint32_t leaf = 0; leaf < portals.cluster_of_leaf.size(); ++leaf)
    if (portals.cluster_of_leaf[leaf] != kNoCluster) leaves[portals.cluster_of_leaf[leaf]].push_back(leaf);
  return leaves;
}

// Returns the coded row as text, which serves as a map key.
// Only zero bytes are stored as runs, as the game expects.
std::string encode_run_length(const ByteRow& row) {
  std::string coded;
  for (std::size_t i = 0; i < row.size();) {
    coded.push_back(static_cast<char>(row[i]));
    if (row[i++] != 0) continue;
    std::uint8_t run = 1;
    for (; i < row.size() && row[i] == 0 && run < 255; ++i) ++run;
    coded.push_back(static_cast<char>(run));
  }
  return coded;
}

// All rows, one after another; equal ones are stored once.
struct RowStore {
  std::vector<std::uint8_t> bytes;
  std::map<std::string, std::size_t> offsets;

  std::size_t add(std::string coded) {
    const auto [at, is_new] = offsets.try_emplace(std::move(coded), bytes.size());
    if (is_new) bytes.insert(bytes.end(), at->first.begin(), at->first.end());
    return at->second;
  }
};

// The sound of a texture, by its name in lower case.
std::optional<AmbientSlot> find_ambient_slot(std::string_view name) {
  if (name.starts_with("sky")) return kSky;
  if (!name.starts_with('*')) return std::nullopt;
  if (name.find("water") != name.npos || name.find("slime") != name.npos) return kWater;
  if (name.find("lava") != name.npos) return kLava;
  return std::nullopt;
}

using SoundLevels = std::array<std::uint8_t, 4>;

SoundLevels louder(const SoundLevels& a, const SoundLevels& b) {
  SoundLevels both;
  for (std::size_t i = 0; i < both.size(); ++i) both[i] = std::max(a[i], b[i]);
  return both;
}

// The sounds of the faces in each cluster.
std::vector<SoundLevels> find_cluster_sounds(const PortalSet& portals, const AmbientSounds& wanted,
                                             const formats::Bsp& bsp) {
  std::array<bool, 4> is_wanted{};
  is_wanted[kWater] = wanted.water;
  is_wanted[kSky] = wanted.sky;
  is_wanted[kLava] = wanted.lava;
  std::vector<std::optional<AmbientSlot>> sounds;
  for (const formats::BspMiptex& miptex : bsp.miptexes) {
    std::string name = miptex.name;
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
    const auto slot = find_ambient_slot(name);
    sounds.push_back(slot && is_wanted[*slot] ? slot : std::nullopt);
  }
  std::vector<SoundLevels> levels(portals.cluster_count, SoundLevels{});
  for (std::size_t i = 0; i < bsp.leaves.size(); ++i) {
    if (portals.cluster_of_leaf[i] == kNoCluster) continue;
    const formats::BspLeaf& leaf = bsp.leaves[i];
    for (std::uint32_t k = 0; k < leaf.marksurface_count; ++k) {
      const formats::BspFace& face = bsp.faces[bsp.marksurfaces[leaf.first_marksurface + k]];
      const auto slot = sounds[static_cast<std::size_t>(bsp.texinfos[face.texinfo].miptex)];
      if (slot) levels[portals.cluster_of_leaf[i]][*slot] = kFullLevel;
    }
  }
  return levels;
}

}  // namespace

// Rows count leaves from leaf 1, since leaf 0 is solid and never visible; models other than the world have no
// visibility.
base::Status write_visibility(const PortalSet& portals, const BitMatrix& visible, const AmbientSounds& sounds,
                              formats::Bsp& io_bsp) {
  CHECK(portals.cluster_of_leaf.size() == io_bsp.leaves.size());
  CHECK(portals.cluster_of_leaf[0] == kNoCluster);
  CHECK(visible.rows() == portals.cluster_count && visible.columns() == portals.cluster_count);
  const auto leaves = group_leaves_by_cluster(portals);
  std::uint32_t last_leaf = 0;
  for (const auto& cluster : leaves)
    for (const std::uint32_t leaf : cluster) last_leaf = std::max(last_leaf, leaf);

  RowStore store;
  std::vector<std::size_t> offsets(portals.cluster_count);
  const std::vector<SoundLevels> own_sounds = find_cluster_sounds(portals, sounds, io_bsp);
  std::vector<SoundLevels> heard(portals.cluster_count, SoundLevels{});
  for (std::size_t cluster = 0; cluster < portals.cluster_count; ++cluster) {
    ByteRow row((std::size_t{last_leaf} + 7) / 8);
    for_each_bit(visible.row(cluster), [&](std::size_t seen) {
      heard[cluster] = louder(heard[cluster], own_sounds[seen]);
      for (const std::uint32_t leaf : leaves[seen])
        row[(leaf - 1) / 8] = static_cast<std::uint8_t>(row[(leaf - 1) / 8] | 1u << ((leaf - 1) % 8));
    });
    offsets[cluster] = store.add(encode_run_length(row));
    if (store.bytes.size() > std::size_t{std::numeric_limits<std::int32_t>::max()})
      return base::error(base::ErrorCode::kTooLarge,
                         "the visibility of {} leaves takes more than 2 GB: turn small brushes into "
                         "func_detail, or compile without visibility",
                         last_leaf);
  }

  io_bsp.visibility = std::move(store.bytes);
  io_bsp.models[0].visible_leaves = static_cast<std::int32_t>(last_leaf);
  for (std::size_t i = 0; i < io_bsp.leaves.size(); ++i) {
    const std::uint32_t cluster = portals.cluster_of_leaf[i];
    io_bsp.leaves[i].visibility_offset =
        cluster == kNoCluster ? -1 : static_cast<std::int32_t>(offsets[cluster]);
    io_bsp.leaves[i].ambient = cluster == kNoCluster ? SoundLevels{} : heard[cluster];
  }
  return base::Ok{};
}

double mean_visible_share(const PortalSet& portals, const BitMatrix& visible) {
  const auto leaves = group_leaves_by_cluster(portals);
  double leaf_count = 0, seen_pairs = 0;
  for (std::size_t cluster = 0; cluster < portals.cluster_count; ++cluster) {
    const auto own = static_cast<double>(leaves[cluster].size());
    leaf_count += own;
    for_each_bit(visible.row(cluster),
                 [&](std::size_t seen) { seen_pairs += own * static_cast<double>(leaves[seen].size()); });
  }
  return leaf_count == 0 ? 0 : seen_pairs / (leaf_count * leaf_count);
}

}  // namespace temblor::compiler
