// MD3 files written by a test from the format's description.
#include "formats/models/md3.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/models/posed_model.h"
#include "support/models/posed_samples.h"

namespace temblor::formats {
namespace {

using ::testing::HasSubstr;

// Two surfaces with three vertices each in two frames.
Md3 small_md3() {
  Md3 md3;
  md3.flags = kMdlRotate;
  md3.frames = {{"rest", {{-1, -2, -3}, {4, 5, 6}}}, {"jump", {{0, 0, 0}, {1, 1, 1}}}};
  for (std::int16_t number = 0; number < 2; ++number) {
    Md3Surface surface;
    surface.name = number == 0 ? "body" : "head";
    surface.shaders = {"models/gem/skin.tga", "models/gem/blue"};
    surface.texels = {{0, 0}, {1, 0}, {0.5f, 1}};
    surface.triangles = {{0, 1, 2}};
    for (std::int16_t i = 0; i < 6; ++i)
      surface.vertices.push_back({{static_cast<std::int16_t>(64 * i), number, -32768}, 64, 64});
    md3.surfaces.push_back(surface);
  }
  return md3;
}

// Offsets in the file of small_md3().
constexpr std::size_t kFirstSurface = 108 + 2 * 56;

std::string read_error(base::ByteVector bytes, std::size_t offset, std::uint32_t value) {
  base::ByteWriter writer;
  writer.bytes(bytes);
  writer.patch(offset, value);
  const auto md3 = read_md3(writer.view());
  return md3.ok() ? "" : md3.error().what;
}

TEST(Md3, ReadsWhatIsWritten) {
  const Md3 written = small_md3();
  const Md3 md3 = read_md3(test::write_md3(written)).value();
  EXPECT_EQ(md3.flags, written.flags);
  ASSERT_EQ(md3.frames.size(), 2u);
  EXPECT_EQ(md3.frames[1].name, "jump");
  EXPECT_EQ(md3.frames[0].bounds.mins, math::Vec3(-1, -2, -3));
  ASSERT_EQ(md3.surfaces.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(md3.surfaces[i].name, written.surfaces[i].name);
    EXPECT_EQ(md3.surfaces[i].shaders, written.surfaces[i].shaders);
    EXPECT_EQ(md3.surfaces[i].texels, written.surfaces[i].texels);
    EXPECT_EQ(md3.surfaces[i].triangles, written.surfaces[i].triangles);
    EXPECT_EQ(md3.surfaces[i].vertices, written.surfaces[i].vertices);
  }
}

TEST(Md3, PosesAreInUnits) {
  const PosedModel model = pose_md3(small_md3()).value();
  EXPECT_EQ(model.pose_count, 2u);
  EXPECT_EQ(model.frames.size(), 2u);
  EXPECT_EQ(model.flags, kMdlRotate);
  EXPECT_EQ(model.meshes[1].positions[4], math::Vec3(4, 1.0f / 64, -512));
  EXPECT_EQ(compute_bounds(model).maxs, math::Vec3(5, 1.0f / 64, -512));
}

TEST(Md3, ErrorsNameThePlace) {
  const base::ByteVector bytes = test::write_md3(small_md3());
  EXPECT_THAT(read_error(bytes, 0, 0), HasSubstr("does not start with \"IDP3\""));
  EXPECT_THAT(read_error(bytes, 4, 14), HasSubstr("version 14"));
  EXPECT_THAT(read_error(bytes, 76, 0), HasSubstr("0 frames"));
  EXPECT_THAT(read_error(bytes, 76, 0xffffffff), HasSubstr("the limit is 4096"));
  EXPECT_THAT(read_error(bytes, 84, 65), HasSubstr("65 surfaces"));
  EXPECT_THAT(read_error(bytes, 92, 0x7fffffff), HasSubstr("frames at offset 0x7fffffff"));
  EXPECT_THAT(read_error(bytes, 100, 0xfffffff0), HasSubstr("surface 0 at offset 0xfffffff0"));
  EXPECT_THAT(read_error(bytes, 108, 0x7f800000), HasSubstr("frame 0 at offset 0x6c: its box is not finite"));
  EXPECT_THAT(read_error(bytes, kFirstSurface, 0), HasSubstr("surface 0"));
  EXPECT_THAT(read_error(bytes, kFirstSurface + 72, 3), HasSubstr("3 frames, but the model has 2"));
  EXPECT_THAT(read_error(bytes, kFirstSurface + 76, 1000), HasSubstr("1000 shaders"));
  EXPECT_THAT(read_error(bytes, kFirstSurface + 80, 0), HasSubstr("0 vertices"));
  EXPECT_THAT(read_error(bytes, kFirstSurface + 80, 1u << 31), HasSubstr("vertices"));
  EXPECT_THAT(read_error(bytes, kFirstSurface + 80, 60000), HasSubstr("needs 480000 bytes"));
  EXPECT_THAT(read_error(bytes, kFirstSurface + 84, 100000), HasSubstr("triangles of surface 0"));
  EXPECT_THAT(read_error(bytes, kFirstSurface + 108, 3), HasSubstr("triangle 0 has vertex 3 of 3"));
  const std::size_t texels = kFirstSurface + 108 + 12 + 2 * 68;
  EXPECT_THAT(read_error(bytes, texels, 0x7fc00000), HasSubstr("texels of surface 0"));
  // The next surface is this one again: overlapping surfaces are harmless.
  EXPECT_EQ(read_error(bytes, kFirstSurface + 104, 0), "");
}

TEST(Md3, TruncatedFilesAreErrors) {
  const base::ByteVector bytes = test::write_md3(small_md3());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(read_md3(base::Bytes(bytes).first(size)).ok()) << size;
}

}  // namespace
}  // namespace temblor::formats
