#include "net/protocol/mark_request.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace temblor::net {
namespace {

using ::testing::HasSubstr;

MarkRequest read(std::string_view words) {
  const std::string line = "//temblor mark " + std::string(words);
  EXPECT_TRUE(is_mark_request(line));
  return read_mark_request(line).value();
}

std::string problem(std::string_view words) {
  const base::Result<MarkRequest> request = read_mark_request("//temblor mark " + std::string(words));
  return request.ok() ? "none" : request.error().message();
}

TEST(MarkRequest, HasAPictureAPlaceAndARadius) {
  EXPECT_EQ(read("smile 10 -20.5 3e1 16"), (MarkRequest{"smile", {10, -20.5f, 30}, 16}));
  EXPECT_EQ(read("*scorch 1 2 3 0.5 45"), (MarkRequest{"*scorch", {1, 2, 3}, 0.5f, 45}));
  EXPECT_EQ(read("a_b-9 1 2 3 128 -90 *17"), (MarkRequest{"a_b-9", {1, 2, 3}, 128, -90, 17}));
}

// QuakeC's vtos() writes "'%5.1f %5.1f %5.1f'".
TEST(MarkRequest, TakesVectorsAsQuakeCPrintsThem) {
  EXPECT_EQ(read("smile '  1.0 -20.5 300.2' 16"), (MarkRequest{"smile", {1, -20.5f, 300.2f}, 16}));
}

TEST(MarkRequest, NamesAreInLowerCase) {
  EXPECT_EQ(read("SMILE 1 2 3 4").picture, "smile");
}

TEST(MarkRequest, IsNoOtherComment) {
  EXPECT_FALSE(is_mark_request("//temblor moves 1 2 3"));
  EXPECT_FALSE(is_mark_request("// mark"));
  EXPECT_FALSE(is_mark_request("mark smile 1 2 3 4"));
}

TEST(MarkRequest, CannotLeaveTheFolderOfMarks) {
  for (const char* name : {"../../autoexec", "/etc/passwd", "a/b", "a\\b", "a.png", ".", "*other",
                           "\"smile\"", "name_of_more_than_thirty_two_chars"})
    EXPECT_THAT(problem(std::string(name) + " 1 2 3 4"), HasSubstr("bad picture name")) << name;
}

TEST(MarkRequest, SaysWhatIsWrong) {
  EXPECT_THAT(problem(""), HasSubstr("0 words"));
  EXPECT_THAT(problem("smile 1 2 3"), HasSubstr("4 words"));
  EXPECT_THAT(problem("smile 1 2 3 4 5 *6 7"), HasSubstr("8 words"));
  EXPECT_THAT(problem("smile 1 2 x 4"), HasSubstr("coordinate \"x\""));
  EXPECT_THAT(problem("smile 1 2 nan 4"), HasSubstr("coordinate \"nan\""));
  EXPECT_THAT(problem("smile 1 2 1e9 4"), HasSubstr("coordinate \"1e9\""));
  EXPECT_THAT(problem("smile 1 2 3 0.4"), HasSubstr("0.5 to 128"));
  EXPECT_THAT(problem("smile 1 2 3 129"), HasSubstr("0.5 to 128"));
  EXPECT_THAT(problem("smile 1 2 3 inf"), HasSubstr("0.5 to 128"));
  EXPECT_THAT(problem("smile 1 2 3 4 up"), HasSubstr("turn \"up\""));
  for (const char* model : {"*0", "*", "3", "*-1", "*3x", "*99999999999"})
    EXPECT_THAT(problem(std::string("smile 1 2 3 4 5 ") + model), HasSubstr("name of a brush model"))
        << model;
}

}  // namespace
}  // namespace temblor::net
