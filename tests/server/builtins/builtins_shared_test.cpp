// The built-in functions of newer engines for texts and numbers, which the HUD program has too.
#include <gtest/gtest.h>

#include "server/builtins/builtin_stage.h"

namespace temblor::test {
namespace {

TEST(SharedBuiltins, CompareTexts) {
  Stage stage;
  EXPECT_EQ(stage.number("strncmp", "abc", "abd"), -1);
  EXPECT_EQ(stage.number("strncmp", "abc", "abd", 2), 0);
  EXPECT_EQ(stage.number("strncmp", "abc", "ab"), 1);
  EXPECT_EQ(stage.number("strncmp", "xxab", "yab", 9, 2, 1), 0);
  EXPECT_EQ(stage.number("strncmp", "ab", "", 9, 99, -1), 0) << "nothing is left";
  EXPECT_EQ(stage.number("strcasecmp", "ABC", "abc"), 0);
  EXPECT_EQ(stage.number("strncasecmp", "ABx", "aby", 2), 0);
  EXPECT_EQ(stage.number("strncmp", "\x80", "a"), 1) << "bytes are unsigned";
}

TEST(SharedBuiltins, SearchAndReplace) {
  Stage stage;
  EXPECT_EQ(stage.number("strstrofs", "banana", "an"), 1);
  EXPECT_EQ(stage.number("strstrofs", "banana", "an", 2), 3);
  EXPECT_EQ(stage.number("strstrofs", "banana", "x"), -1);
  EXPECT_EQ(stage.number("strstrofs", "banana", "an", 99), -1);
  EXPECT_EQ(stage.text("strreplace", "an", "AN", "banana"), "bANANa");
  EXPECT_EQ(stage.text("strireplace", "AN", "-", "banana"), "b--a");
  EXPECT_EQ(stage.text("strreplace", "", "x", "banana"), "banana");
  EXPECT_NE(stage.error("strreplace", "a", std::string(60000, 'b'), std::string(60000, 'a')), "");
}

TEST(SharedBuiltins, ConvertLetters) {
  Stage stage;
  EXPECT_EQ(stage.number("str2chr", "aB", 1), 'B');
  EXPECT_EQ(stage.number("str2chr", "aB", -1), 'B');
  EXPECT_EQ(stage.number("str2chr", "aB", 2), 0);
  EXPECT_EQ(stage.text("chr2str", 'h', 'i', 225), "hi\xe1");
  EXPECT_EQ(stage.text("strtolower", "Hi 9!"), "hi 9!");
  EXPECT_EQ(stage.text("strtoupper", "Hi 9!"), "HI 9!");
  EXPECT_EQ(stage.text("strconv", 2, 2, 1, "a1\xb2"), "\xc1\x31\x32");
  EXPECT_EQ(stage.text("strpad", 4, "ab"), "ab  ");
  EXPECT_EQ(stage.text("strpad", -4, "a", "b"), "  ab");
  EXPECT_EQ(stage.text("strpad", 1, "abc"), "abc");
  EXPECT_EQ(stage.text("strdecolorize", "^1red^xF00 ^^ ^"), "red ^ ^");
  EXPECT_EQ(stage.number("strlennocol", "^1red"), 3);
}

TEST(SharedBuiltins, ConvertIntegersInfoStringsAndUris) {
  Stage stage;
  EXPECT_EQ(stage.text("itos", RawWord{0xffffffff}), "-1");
  EXPECT_EQ(stage.text("htos", RawWord{0xbeef}), "0000beef");
  stage.run("stoi", " -12x");
  EXPECT_EQ(std::bit_cast<std::int32_t>(stage.machine.returned_float()), -12);
  stage.run("stoh", "0xff");
  EXPECT_EQ(std::bit_cast<std::int32_t>(stage.machine.returned_float()), 255);
  EXPECT_EQ(stage.text("infoadd", "\\a\\1\\b\\2", "a", "3"), "\\b\\2\\a\\3");
  EXPECT_EQ(stage.text("infoadd", "\\a\\1\\b\\2", "b", ""), "\\a\\1");
  EXPECT_EQ(stage.text("infoget", "\\a\\1\\b\\2", "b"), "2");
  EXPECT_EQ(stage.text("infoget", "\\a\\1\\b", "b"), "");
  EXPECT_EQ(stage.text("infoget", "\\a\\1", "1"), "") << "a value is no key";
  EXPECT_EQ(stage.text("uri_escape", "a b/\xe9~"), "a%20b%2F%E9~");
  EXPECT_EQ(stage.text("uri_unescape", "a%20b%2f%zz%4"), "a b/%zz%4");
  EXPECT_EQ(stage.number("crc16", 0, "123456789"), 0x29b1) << "the check value of CRC-16/CCITT-FALSE";
  EXPECT_EQ(stage.number("crc16", 1, "AB"), stage.number("crc16", 0, "ab"));
}

TEST(SharedBuiltins, SplitTexts) {
  Stage stage;
  EXPECT_EQ(stage.number("tokenizebyseparator", "a,b--c,", ",", "--", "-"), 4);
  EXPECT_EQ(stage.text("argv", 1), "b");
  EXPECT_EQ(stage.text("argv", 2), "c");
  EXPECT_EQ(stage.text("argv", 3), "");
  EXPECT_EQ(stage.number("tokenizebyseparator", "", ","), 0);
  EXPECT_EQ(stage.number("tokenize_console", "say \"a b\" // no\nend"), 3);
  EXPECT_EQ(stage.text("argv", 2), "end");
  EXPECT_EQ(stage.number("argv_start_index", 1), 4);
  EXPECT_EQ(stage.number("argv_end_index", 1), 9);
  EXPECT_EQ(stage.number("argv_start_index", 3), -1);
}

TEST(SharedBuiltins, KeepListsOfStrings) {
  Stage stage;
  const float buffer = stage.number("buf_create"), copy = stage.number("buf_create");
  EXPECT_NE(buffer, copy);
  EXPECT_EQ(stage.number("bufstr_add", buffer, "pear", 1), 0);
  stage.run("bufstr_set", buffer, 2, "apple");
  EXPECT_EQ(stage.number("bufstr_add", buffer, "fig", 0), 1) << "the first empty place";
  EXPECT_EQ(stage.number("buf_getsize", buffer), 3);
  stage.run("buf_copy", buffer, copy);
  stage.run("buf_sort", buffer, 0, 0);
  EXPECT_EQ(stage.text("buf_implode", buffer, " "), "apple fig pear");
  stage.run("buf_sort", buffer, 0, 1);
  EXPECT_EQ(stage.text("bufstr_get", buffer, 0), "pear");
  EXPECT_EQ(stage.text("bufstr_get", buffer, 3), "");
  stage.run("bufstr_free", copy, 2);
  EXPECT_EQ(stage.number("buf_getsize", copy), 2);
  stage.run("buf_del", buffer);
  EXPECT_EQ(stage.number("buf_getsize", buffer), -1);
  EXPECT_NE(stage.printed.find("is not a string buffer"), std::string::npos);
  EXPECT_NE(stage.error("bufstr_set", copy, 65536, "x"), "");
}

TEST(SharedBuiltins, Calculate) {
  Stage stage;
  EXPECT_NEAR(stage.number("atan2", 1, 1), 0.785398, 1e-6);
  EXPECT_NEAR(stage.number("asin", 1), 1.570796, 1e-6);
  EXPECT_NEAR(stage.number("acos", 1), 0, 1e-6);
  EXPECT_NEAR(stage.number("tan", 1), 1.557408, 1e-6);
  EXPECT_NEAR(stage.number("atan", 1), 0.785398, 1e-6);
  EXPECT_EQ(stage.number("mod", -7, 3), -1);
  EXPECT_EQ(stage.number("mod", 7, 0), 0);
  EXPECT_EQ(stage.number("anglemod", -90), 270);
  EXPECT_EQ(stage.number("bitshift", 3, 4), 48);
  EXPECT_EQ(stage.number("bitshift", 48, -4), 3);
  EXPECT_EQ(stage.number("bitshift", 1, 99), stage.number("bitshift", 1, 31));
}

TEST(SharedBuiltins, NumberEntitiesAndTurnDirections) {
  Stage stage;
  const vm::EntityIndex a = stage.spawn(), b = stage.spawn();
  EXPECT_EQ(stage.number("num_for_edict", b), static_cast<float>(base::to_size(b)));
  stage.edict(a).set(kScoreField, 6);
  EXPECT_EQ(stage.entity("findchainflags", kScoreField, 2), a);
  EXPECT_EQ(stage.entity("findchainflags", kScoreField, 1), vm::kWorld);
  const auto direction = [&](vm::GlobalIndex global) { return stage.machine.global_vector(global); };
  for (const math::Vec3& angles : {math::Vec3(0, 30, 0), math::Vec3(-40, 200, 0), math::Vec3(70, 300, 0)}) {
    stage.run("makevectors", angles);
    const math::Vec3 forward = direction(server::global::kForward), right = direction(server::global::kRight),
                     up = direction(server::global::kUp);
    stage.run("vectorvectors", forward * 7.0f);
    EXPECT_LT(glm::distance(direction(server::global::kForward), forward), 1e-5f);
    EXPECT_LT(glm::distance(direction(server::global::kRight), right), 1e-5f);
    EXPECT_LT(glm::distance(direction(server::global::kUp), up), 1e-5f);
  }
}

TEST(SharedBuiltins, KnowVariablesAndFunctions) {
  Stage stage;
  stage.variables.add_float("sv_gravity", 800, 0, 2000, "How hard things fall.");
  ASSERT_TRUE(stage.variables.set("sv_gravity", "100").ok());
  EXPECT_EQ(stage.text("cvar_defstring", "sv_gravity"), "800");
  EXPECT_EQ(stage.text("cvar_description", "sv_gravity"), "How hard things fall.");
  EXPECT_EQ(stage.number("cvar_type", "sv_gravity"), 27);
  EXPECT_EQ(stage.number("cvar_type", "nothing"), 0);
  stage.run("cvar_setf", "sv_gravity", 200);
  EXPECT_EQ(stage.number("cvar", "sv_gravity"), 200);
  EXPECT_EQ(stage.number("isfunction", "floor"), 1);
  EXPECT_EQ(stage.number("isfunction", "ceiling"), 0);
  EXPECT_EQ(stage.number("callfunction", 2.5f, "floor"), 2);
  stage.run("callfunction", "ceiling");
  EXPECT_NE(stage.printed.find("no function \"ceiling\""), std::string::npos);
  EXPECT_NE(stage.error("callfunction"), "");
  EXPECT_GT(stage.number("numentityfields"), 5);
  EXPECT_EQ(stage.text("entityfieldname", -1), "");
}

}  // namespace
}  // namespace temblor::test
