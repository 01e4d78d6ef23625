#include "lab/registry.h"

#include <gtest/gtest.h>

#include <set>

namespace temblor::lab {
namespace {

std::string find_error(const char* text) {
  const base::Result<Choice> choice = parse_choice(text);
  return choice.ok() ? "" : choice.error().what;
}

TEST(Registry, DescribesEveryTechnique) {
  std::set<std::string_view> names;
  for (const Technique& technique : list_techniques()) {
    EXPECT_TRUE(names.insert(technique.name).second) << technique.name;
    for (const std::string_view text :
         {technique.title, technique.summary, technique.article, technique.heading, technique.expected})
      EXPECT_FALSE(text.empty()) << technique.name;
    for (const Parameter& parameter : technique.parameters) {
      EXPECT_LE(parameter.min, parameter.value) << parameter.name;
      EXPECT_LE(parameter.value, parameter.max) << parameter.name;
      EXPECT_FALSE(parameter.meaning.empty()) << parameter.name;
    }
    const base::Result<Choice> choice = parse_choice(technique.name);
    ASSERT_TRUE(choice.ok()) << technique.name;
    EXPECT_EQ(choice->label(), technique.name);
  }
}

TEST(Registry, ReadsParameters) {
  const base::Result<Choice> choice = parse_choice("abutting-edges:mesh=0,epsilon=0.01");
  ASSERT_TRUE(choice.ok());
  EXPECT_EQ(choice->values, (std::vector<double>{0.01, 1, 0}));
  EXPECT_EQ(choice->label(), "abutting-edges:epsilon=0.01,mesh=0");
}

TEST(Registry, ExplainsWrongNamesAndValues) {
  EXPECT_EQ(find_error("raytracing"), "there is no technique \"raytracing\"; `temblor lab list` lists them");
  EXPECT_EQ(find_error(""), "there is no technique \"\"; `temblor lab list` lists them");
  EXPECT_EQ(find_error("painter:size=3"), "painter has no parameter \"size\"; it has pvs");
  EXPECT_EQ(find_error("bsp-edges:pvs=1"), "bsp-edges has no parameters, so \"pvs=1\" cannot be set");
  for (const char* text : {"painter:pvs=2", "painter:pvs=-1", "painter:pvs=", "painter:pvs",
                           "painter:pvs=nan", "painter:pvs=1e999", "painter:pvs=1x", "painter:pvs=0.5"})
    EXPECT_NE(find_error(text).find("must be pvs=N, with a whole N from 0 to 1"), std::string::npos) << text;
  EXPECT_NE(find_error("abutting-edges:epsilon=nan").find("must be epsilon=N, with N from 0 to 0.1"),
            std::string::npos);
}

}  // namespace
}  // namespace temblor::lab
