#include "formats/bspx/face_normals.h"

#include <gtest/gtest.h>

#include "base/bytes.h"

namespace temblor::test {
namespace {

using formats::FaceNormals;

// Two faces with three and four corners.
formats::Bsp level_of_two_faces() {
  formats::Bsp bsp;
  bsp.faces.resize(2);
  bsp.faces[0].surfedge_count = 3;
  bsp.faces[1].surfedge_count = 4;
  return bsp;
}

FaceNormals some_normals() {
  FaceNormals normals{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}};
  for (std::uint32_t i = 0; i < 7; ++i) normals.corners.push_back({i % 3, (i + 1) % 3, 2});
  return normals;
}

TEST(FaceNormals, ReadsWhatItWrites) {
  formats::Bsp bsp = level_of_two_faces();
  EXPECT_EQ(formats::read_face_normals(bsp).value(), FaceNormals{});
  for (int time = 0; time < 2; ++time) formats::set_face_normals(some_normals(), bsp);
  ASSERT_EQ(bsp.bspx.size(), 1u) << "the second replaces the first";
  EXPECT_EQ(formats::read_face_normals(bsp).value(), some_normals());
  // The layout.
  base::ByteReader reader(bsp.bspx[0].data);
  EXPECT_EQ(reader.u32(), 3u);
  EXPECT_EQ(reader.f32(), 1);
  reader.seek(4 + 3 * 12 + 12);
  for (const std::uint32_t number : {1u, 2u, 2u}) EXPECT_EQ(reader.u32(), number) << "the second corner";
}

TEST(FaceNormals, RefusesOtherSizesAndNumbersOutOfRange) {
  formats::Bsp bsp = level_of_two_faces();
  formats::set_face_normals(some_normals(), bsp);
  const base::ByteVector whole = bsp.bspx[0].data;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    bsp.bspx[0].data.resize(size);
    EXPECT_FALSE(formats::read_face_normals(bsp).ok()) << size;
    bsp.bspx[0].data = whole;
  }
  for (const std::size_t offset : {std::size_t{0}, whole.size() - 4}) {
    bsp.bspx[0].data = whole;
    for (std::size_t i = 0; i < 4; ++i) bsp.bspx[0].data[offset + i] = std::byte{255};
    EXPECT_FALSE(formats::read_face_normals(bsp).ok()) << offset;
  }
}

}  // namespace
}  // namespace temblor::test
