// Reads a level: the header, the records of each lump (records.h), and BSPX; then validates all with
// find_fault(), without the records that no game reaches and after repair.
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "base/text.h"
#include "formats/levels/bsp.h"
#include "formats/levels/bsp/bspx.h"
#include "formats/levels/bsp/half_life.h"
#include "formats/levels/bsp/lumps.h"
#include "formats/levels/bsp/records.h"
#include "formats/levels/bsp/repair.h"
#include "formats/levels/bsp/textures.h"
#include "formats/levels/bsp/unused.h"
#include "formats/levels/bsp_validate.h"

namespace temblor::formats {
namespace bsp_file {
namespace {

constexpr std::int32_t kEmptyContents = -1;

// An Io for records.h that reads fields.
class RecordReader {
 public:
  RecordReader(base::Bytes bytes, BspVersion version, TreeSizes tree_sizes)
      : reader_(bytes), version_(version), tree_sizes_(tree_sizes) {}

  template <typename Small, typename Large, typename Value>
  void number(const char*, Width<Small, Large>, Value& out_value) {
    if (has_small_fields(version_))
      out_value = static_cast<Value>(reader_.read<Small>());
    else
      out_value = static_cast<Value>(reader_.read<Large>());
  }
  void child(const char*, std::int32_t& out_child, std::size_t node_count) {
    if (has_small_fields(version_)) {
      const std::int32_t raw = reader_.u16();
      out_child = static_cast<std::size_t>(raw) < node_count ? raw : raw - 65536;
    } else {
      out_child = reader_.i32();
    }
  }
  void bounds(math::Vec3& out_mins, math::Vec3& out_maxs) {
    for (math::Vec3* corner : {&out_mins, &out_maxs})
      for (int axis = 0; axis < 3; ++axis) (*corner)[axis] = coordinate();
  }
  TreeSizes tree_sizes() const { return tree_sizes_; }

 private:
  float coordinate() {
    if (version_ == BspVersion::kBsp2)
      return std::clamp(reader_.f32(), -kBspMaxCoordinate, kBspMaxCoordinate);  // NaN stays NaN
    return static_cast<float>(reader_.i16());
  }

  base::ByteReader reader_;
  BspVersion version_;
  TreeSizes tree_sizes_;
};

// Reads the lumps of a file after its header.
class LumpReader {
 public:
  LumpReader(base::Bytes file, const Header& header) : file_(file), header_(header) {
    tree_sizes_.nodes = header[BspLump::kNodes].size / record_bytes<BspNode>(header.version);
    tree_sizes_.clipnodes = header[BspLump::kClipnodes].size / record_bytes<BspClipnode>(header.version);
  }

  base::Bytes bytes(BspLump lump) const { return lump_bytes(file_, header_[lump]); }

  std::vector<std::uint8_t> numbers(BspLump lump) const {
    const auto values = base::as_u8(bytes(lump));
    return {values.begin(), values.end()};
  }

  template <typename Record>
  base::Result<std::vector<Record>> records(BspLump lump) const {
    const std::size_t size = header_[lump].size, record_size = record_bytes<Record>(header_.version);
    if (size % record_size != 0)
      return base::malformed("lump {}: {} bytes at offset {:#x} are not a whole number of {}-byte records",
                             lump_name(lump), size, header_[lump].offset, record_size);
    std::vector<Record> records(size / record_size);
    RecordReader reader(bytes(lump), header_.version, tree_sizes_);
    for (Record& record : records) fields(reader, record);
    return records;
  }

 private:
  base::Bytes file_;
  const Header& header_;
  TreeSizes tree_sizes_;
};

std::size_t end_of_lumps(const Header& header) {
  std::size_t end = kHeaderBytes;
  for (const LumpPlace& place : header.lumps) end = std::max(end, std::size_t{place.offset} + place.size);
  return end;
}

base::Result<Bsp> read_lumps(base::Bytes file, const Header& header) {
  const LumpReader lumps(file, header);
  Bsp bsp;
  bsp.version = header.version;
  bsp.repairs = header.repairs;
  const std::string_view text = base::as_text(lumps.bytes(BspLump::kEntities));
  bsp.entities = text.substr(0, text.find('\0'));
  TRY(bsp.planes, lumps.records<BspPlane>(BspLump::kPlanes));
  bsp.miptexes = read_textures(lumps.bytes(BspLump::kTextures), header.version);
  TRY(bsp.vertices, lumps.records<math::Vec3>(BspLump::kVertices));
  bsp.visibility = lumps.numbers(BspLump::kVisibility);
  TRY(bsp.nodes, lumps.records<BspNode>(BspLump::kNodes));
  TRY(bsp.texinfos, lumps.records<BspTexinfo>(BspLump::kTexinfo));
  TRY(bsp.faces, lumps.records<BspFace>(BspLump::kFaces));
  bsp.lighting = lumps.numbers(BspLump::kLighting);
  TRY(bsp.clipnodes, lumps.records<BspClipnode>(BspLump::kClipnodes));
  TRY(bsp.leaves, lumps.records<BspLeaf>(BspLump::kLeaves));
  TRY(bsp.marksurfaces, lumps.records<std::uint32_t>(BspLump::kMarksurfaces));
  TRY(bsp.edges, lumps.records<BspEdge>(BspLump::kEdges));
  TRY(bsp.surfedges, lumps.records<std::int32_t>(BspLump::kSurfedges));
  TRY(bsp.models, lumps.records<BspModel>(BspLump::kModels));
  bsp.bspx = read_bspx(file, end_of_lumps(header));
  return bsp;
}

// No engine needs the type of a plane: it follows from the normal. Types 3 to 5 are kept, because compilers
// differ in how they choose among equal components.
void correct_plane_types(std::vector<BspPlane>& io_planes) {
  for (BspPlane& plane : io_planes) {
    const std::int32_t type = find_plane_type(plane.normal);
    if (plane.type < 0 || plane.type > 5 || (plane.type < 3 && plane.type != type)) plane.type = type;
  }
}

// Resets offsets into empty lumps, which compilers leave at 0.
void clear_offsets_into_empty_lumps(Bsp& io_bsp) {
  if (io_bsp.visibility.empty())
    for (BspLeaf& leaf : io_bsp.leaves) leaf.visibility_offset = -1;
  if (io_bsp.clipnodes.empty())
    for (BspModel& model : io_bsp.models)
      std::fill(model.head_nodes.begin() + 1, model.head_nodes.end(), kEmptyContents);
}

// Returns the size of a lump's records, for offsets in errors; 0 for lumps without records.
std::size_t lump_record_bytes(BspLump lump, BspVersion version) {
  switch (lump) {
    case BspLump::kPlanes:
      return record_bytes<BspPlane>(version);
    case BspLump::kVertices:
      return record_bytes<math::Vec3>(version);
    case BspLump::kNodes:
      return record_bytes<BspNode>(version);
    case BspLump::kTexinfo:
      return record_bytes<BspTexinfo>(version);
    case BspLump::kFaces:
      return record_bytes<BspFace>(version);
    case BspLump::kClipnodes:
      return record_bytes<BspClipnode>(version);
    case BspLump::kLeaves:
      return record_bytes<BspLeaf>(version);
    case BspLump::kMarksurfaces:
      return record_bytes<std::uint32_t>(version);
    case BspLump::kEdges:
      return record_bytes<BspEdge>(version);
    case BspLump::kSurfedges:
      return record_bytes<std::int32_t>(version);
    case BspLump::kModels:
      return record_bytes<BspModel>(version);
    case BspLump::kEntities:
    case BspLump::kTextures:
    case BspLump::kVisibility:
    case BspLump::kLighting:
      break;
  }
  return 0;
}

// Adds the record's place in the file to a fault.
base::Error describe(const BspFault& fault, const Header& header) {
  if (!fault.record) return base::malformed("lump {}: {}", lump_name(fault.lump), fault.reason);
  const std::size_t offset =
      header[fault.lump].offset + *fault.record * lump_record_bytes(fault.lump, header.version);
  return base::malformed("lump {}: {} {} at offset {:#x}: {}", lump_name(fault.lump), record_name(fault.lump),
                         *fault.record, offset, fault.reason);
}

// Repairs the level, and describes that with the first fault. Returns an error for a fault that remains.
base::Status repair(const BspFault& first_fault, const Header& header, Bsp& io_bsp) {
  const std::size_t changed = repair_level(io_bsp);
  if (const auto fault = find_fault(io_bsp)) return describe(*fault, header);
  if (!io_bsp.repairs.empty()) io_bsp.repairs += "; ";
  io_bsp.repairs += describe(first_fault, header).what;
  if (changed > 1)
    io_bsp.repairs += fmt::format("; this and {} are repaired or left out",
                                  base::counted(changed - 1, "other damaged record"));
  else
    io_bsp.repairs += "; it is repaired or left out";
  return base::Ok{};
}

}  // namespace
}  // namespace bsp_file

base::Result<Bsp> read_bsp(base::Bytes bytes) {
  TRY(const bsp_file::Header header, bsp_file::read_header(bytes));
  TRY(Bsp bsp, bsp_file::read_lumps(bytes, header));
  bsp_file::correct_plane_types(bsp.planes);
  bsp_file::clear_offsets_into_empty_lumps(bsp);
  if (bsp.version == BspVersion::k30) bsp_file::separate_gray_light(bsp);
  if (auto fault = find_fault(bsp)) {
    bsp_file::reset_unused(bsp);
    fault = find_fault(bsp);
    if (fault) TRY_STATUS(bsp_file::repair(*fault, header, bsp));
  }
  return bsp;
}

}  // namespace temblor::formats
