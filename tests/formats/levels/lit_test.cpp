#include "formats/levels/lit.h"

#include <gtest/gtest.h>

#include "formats/levels/bsp.h"
#include "support/game_data.h"

namespace temblor::formats {
namespace {

using namespace std::string_literals;

TEST(Lit, ReadsHeaderAndSamples) {
  const std::string file = "QLIT\1\0\0\0\x0a\x0b\x0c\xfd\xfe\xff"s;
  const auto lit = read_lit(base::as_bytes(file));
  ASSERT_TRUE(lit.ok()) << lit.error().message();
  EXPECT_EQ(lit->samples, (std::vector<std::uint8_t>{10, 11, 12, 253, 254, 255}));
  EXPECT_EQ(base::as_text(write_lit(*lit)), file);
}

TEST(Lit, MayHoldNoSamples) {
  const auto lit = read_lit(base::as_bytes("QLIT\1\0\0\0"s));
  ASSERT_TRUE(lit.ok()) << lit.error().message();
  EXPECT_TRUE(lit->samples.empty());
}

TEST(Lit, RejectsOtherFiles) {
  const auto error_text = [](const std::string& file) { return read_lit(base::as_bytes(file)).error().what; };
  EXPECT_EQ(error_text(""), "not a colored light file: it does not start with QLIT");
  EXPECT_EQ(error_text("QLI"), "not a colored light file: it does not start with QLIT");
  EXPECT_EQ(error_text("TILQ\1\0\0\0"s), "not a colored light file: it does not start with QLIT");
  EXPECT_EQ(error_text("QLIT\1\0\0"s), "7 bytes are shorter than the header");
  EXPECT_EQ(error_text("QLIT\2\0\0\0"s), "version 2 of colored light is not supported (supported: 1)");
  EXPECT_EQ(error_text("QLIT\1\0\0\0four"s), "4 bytes after the header are not a multiple of 3");
}

TEST(Lit, StockFilesHaveThreeBytesForEachSampleOfTheirLevel) {
  DATA_FOLDER_OR_SKIP(data);
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data / "id1" / "maps")) {
    if (entry.path().extension() != ".lit") continue;
    SCOPED_TRACE(entry.path().filename());
    const base::ByteVector stock = test::read_file(entry.path());
    const auto lit = read_lit(stock);
    ASSERT_TRUE(lit.ok()) << lit.error().message();
    EXPECT_EQ(write_lit(*lit), stock);

    auto level_path = entry.path();
    const auto bsp = read_bsp(test::read_file(level_path.replace_extension(".bsp")));
    ASSERT_TRUE(bsp.ok()) << bsp.error().message();
    EXPECT_EQ(lit->samples.size(), 3 * bsp->lighting.size());
    ++files;
  }
  EXPECT_GT(files, 0);
}

}  // namespace
}  // namespace temblor::formats
