// Writes a level in the layout of any version (records.h).
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "formats/levels/bsp.h"
#include "formats/levels/bsp/bspx.h"
#include "formats/levels/bsp/half_life.h"
#include "formats/levels/bsp/lumps.h"
#include "formats/levels/bsp/records.h"
#include "formats/levels/bsp/textures.h"

namespace temblor::formats {
namespace bsp_file {
namespace {

// An Io for records.h that writes fields, and remembers the first one that does not fit its width.
class RecordWriter {
 public:
  RecordWriter(base::ByteWriter& writer, BspVersion version, TreeSizes tree_sizes)
      : writer_(writer), version_(version), tree_sizes_(tree_sizes) {}

  // The name of the first field that did not fit, or null; and its value.
  const char* misfit() const { return misfit_; }
  double misfit_value() const { return misfit_value_; }

  template <typename Small, typename Large, typename Value>
  void number(const char* name, Width<Small, Large>, const Value& value) {
    if (has_small_fields(version_))
      put<Small>(name, value);
    else
      put<Large>(name, value);
  }
  // The reverse of RecordReader::child(): the value must read back as the same child.
  void child(const char* name, const std::int32_t& child, std::size_t node_count) {
    if (!has_small_fields(version_)) return put<std::int32_t>(name, child);
    const std::int32_t raw = child < 0 ? child + 65536 : child;
    const bool reads_as_node = static_cast<std::size_t>(raw) < node_count;
    if (reads_as_node != (child >= 0)) note_misfit(name, child);
    put<std::uint16_t>(name, raw);
  }
  void bounds(const math::Vec3& mins, const math::Vec3& maxs) {
    for (int axis = 0; axis < 3; ++axis) coordinate("mins", mins[axis], std::floor(mins[axis]));
    for (int axis = 0; axis < 3; ++axis) coordinate("maxs", maxs[axis], std::ceil(maxs[axis]));
  }
  TreeSizes tree_sizes() const { return tree_sizes_; }

 private:
  template <typename File, typename Value>
  void put(const char* name, const Value& value) {
    if constexpr (std::is_integral_v<File>)
      if (!std::in_range<File>(value)) note_misfit(name, static_cast<double>(value));
    writer_.write(static_cast<File>(value));
  }
  void coordinate(const char* name, float exact, float whole) {
    if (version_ == BspVersion::kBsp2) return writer_.f32(exact);
    const bool fits = whole >= -32768.0f && whole <= 32767.0f;
    if (!fits) note_misfit(name, double{whole});
    writer_.i16(fits ? static_cast<std::int16_t>(whole) : std::int16_t{0});
  }
  void note_misfit(const char* name, double value) {
    if (misfit_ != nullptr) return;
    misfit_ = name;
    misfit_value_ = value;
  }

  base::ByteWriter& writer_;
  BspVersion version_;
  TreeSizes tree_sizes_;
  const char* misfit_ = nullptr;
  double misfit_value_ = 0;
};

// Writes all lumps and fills in the header.
class LumpWriter {
 public:
  LumpWriter(const Bsp& bsp, BspVersion version)
      : version_(version), tree_sizes_{bsp.nodes.size(), bsp.clipnodes.size()} {
    begin_header(writer_, version);
  }

  void begin() {
    writer_.align(4);
    begin_ = writer_.size();
  }
  void end(BspLump lump) {
    set_lump(writer_, lump,
             {static_cast<std::uint32_t>(begin_), static_cast<std::uint32_t>(writer_.size() - begin_)});
  }

  void bytes(BspLump lump, base::Bytes data) {
    begin();
    writer_.bytes(data);
    end(lump);
  }
  void text(BspLump lump, std::string_view text) {
    begin();
    writer_.bytes(base::as_bytes(text));
    writer_.u8(0);
    end(lump);
  }
  template <typename Record>
  base::Status records(BspLump lump, const std::vector<Record>& records) {
    begin();
    for (std::size_t i = 0; i < records.size(); ++i) {
      RecordWriter record_writer(writer_, version_, tree_sizes_);
      fields(record_writer, records[i]);
      if (record_writer.misfit() != nullptr)
        return error(base::ErrorCode::kTooLarge, "lump {}: {} {}: {} {} does not fit version {}",
                     lump_name(lump), record_name(lump), i, record_writer.misfit(),
                     record_writer.misfit_value(), version_name(version_));
    }
    end(lump);
    return base::Ok{};
  }

  base::ByteWriter& writer() { return writer_; }

 private:
  base::ByteWriter writer_;
  BspVersion version_;
  TreeSizes tree_sizes_;
  std::size_t begin_ = 0;
};

}  // namespace
}  // namespace bsp_file

base::Result<base::ByteVector> write_bsp(const Bsp& bsp, BspVersion version) {
  const bool is_half_life = version == BspVersion::k30;
  bsp_file::LumpWriter lumps(bsp, version);
  lumps.text(BspLump::kEntities, bsp.entities);
  TRY_STATUS(lumps.records(BspLump::kPlanes, bsp.planes));
  lumps.begin();
  TRY_STATUS(bsp_file::write_textures(lumps.writer(), bsp.miptexes, version));
  lumps.end(BspLump::kTextures);
  TRY_STATUS(lumps.records(BspLump::kVertices, bsp.vertices));
  lumps.bytes(BspLump::kVisibility, std::as_bytes(std::span(bsp.visibility)));
  TRY_STATUS(lumps.records(BspLump::kNodes, bsp.nodes));
  TRY_STATUS(lumps.records(BspLump::kTexinfo, bsp.texinfos));
  if (is_half_life) {
    TRY(const std::vector<BspFace> faces, bsp_file::count_light_bytes(bsp.faces));
    TRY_STATUS(lumps.records(BspLump::kFaces, faces));
    lumps.bytes(BspLump::kLighting, bsp_file::colored_light(bsp));
  } else {
    TRY_STATUS(lumps.records(BspLump::kFaces, bsp.faces));
    lumps.bytes(BspLump::kLighting, std::as_bytes(std::span(bsp.lighting)));
  }
  TRY_STATUS(lumps.records(BspLump::kClipnodes, bsp.clipnodes));
  TRY_STATUS(lumps.records(BspLump::kLeaves, bsp.leaves));
  TRY_STATUS(lumps.records(BspLump::kMarksurfaces, bsp.marksurfaces));
  TRY_STATUS(lumps.records(BspLump::kEdges, bsp.edges));
  TRY_STATUS(lumps.records(BspLump::kSurfedges, bsp.surfedges));
  TRY_STATUS(lumps.records(BspLump::kModels, bsp.models));
  TRY_STATUS(bsp_file::write_bspx(lumps.writer(),
                                  is_half_life ? bsp_file::lumps_without_light(bsp.bspx) : bsp.bspx));
  if (lumps.writer().size() > std::numeric_limits<std::int32_t>::max())
    return error(base::ErrorCode::kTooLarge, "the level is larger than 2 GiB");
  return std::move(lumps.writer()).take();
}

}  // namespace temblor::formats
