#include "formats/bspx/brush_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace temblor::test {
namespace {

using formats::ListedBrush;
using formats::ListedModel;

std::vector<ListedModel> some_models() {
  const ListedBrush box{{-1, -2, -3}, {4, 5, 6}, -2, {}};
  const ListedBrush wedge{
      {0, 0, 0}, {8, 8, 8}, formats::kClipContents, {{{0.6f, 0.8f, 0}, 5}, {{0, 0.6f, 0.8f}, -7}}};
  return {{0, {box, wedge}}, {3, {}}, {7, {wedge}}};
}

TEST(BrushList, HasTheDescribedLayout) {
  const std::vector<ListedModel> models = {{2, {{{1, 2, 3}, {4, 5, 6}, -6, {{{0, 0.5f, 0}, 9}}}}}};
  const base::ByteVector bytes = formats::write_brush_list(models);
  base::ByteReader reader(bytes);
  for (const std::uint32_t number : {1u, 2u, 1u, 1u}) EXPECT_EQ(reader.u32(), number);
  for (const float number : {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f}) EXPECT_EQ(reader.f32(), number);
  EXPECT_EQ(reader.i16(), -6);
  EXPECT_EQ(reader.u16(), 1);
  for (const float number : {0.0f, 0.5f, 0.0f, 9.0f}) EXPECT_EQ(reader.f32(), number);
  EXPECT_TRUE(reader.ok());
  EXPECT_EQ(reader.remaining(), 0u);
}

TEST(BrushList, ReadsWhatItWrites) {
  EXPECT_EQ(formats::read_brush_list(formats::write_brush_list(some_models())).value(), some_models());
  EXPECT_TRUE(formats::read_brush_list({}).value().empty());
}

// Every model begins with its counts, so only an end between two models is valid.
TEST(BrushList, RefusesEveryTruncation) {
  const base::ByteVector bytes = formats::write_brush_list(some_models());
  const std::size_t first = 16 + 28 + 28 + 32, second = first + 16;
  for (std::size_t size = 1; size < bytes.size(); ++size)
    EXPECT_EQ(formats::read_brush_list(base::Bytes(bytes).first(size)).ok(), size == first || size == second)
        << size;
}

TEST(BrushList, RefusesBadNumbers) {
  const base::ByteVector bytes = formats::write_brush_list(some_models());
  const auto fault = [&](std::size_t offset, auto number) {
    base::ByteWriter writer;
    writer.bytes(bytes);
    writer.patch(offset, number);
    const auto read = formats::read_brush_list(writer.view());
    return read.ok() ? std::string() : read.error().what;
  };
  EXPECT_NE(fault(0, 2u).find("version 2"), std::string::npos);
  EXPECT_NE(fault(8, 0xffffffffu), "") << "a huge number of brushes";
  EXPECT_NE(fault(12, 3u).find("2 planes, but announces 3"), std::string::npos);
  EXPECT_NE(fault(16 + 26, std::uint16_t{65535}), "") << "a huge number of planes";
  for (const float number : {std::numeric_limits<float>::infinity(), std::nanf("")})
    EXPECT_NE(fault(16, number).find("not finite"), std::string::npos);
}

}  // namespace
}  // namespace temblor::test
