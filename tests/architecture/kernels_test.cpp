#include "architecture/kernels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "architecture/sources.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

TEST(Kernels, IncludeNoFunctionBodiesOfOurs) {
  EXPECT_THAT(find_kernel_violations(engine_sources()), IsEmpty());
}

TEST(KernelRules, KernelFilesIncludeOnlyPlainData) {
  const std::string kernel =
      "#define HWY_TARGET_INCLUDE \"render/spans/kernel.cpp\"\n"
      "#include \"hwy/foreach_target.h\"\n#include <hwy/highway.h>\n#include \"render/spans/kernel.h\"\n";
  const std::string plain = "struct Span {\n  int x = 0;\n};\nvoid draw(const Span& span);\n";
  EXPECT_THAT(
      find_kernel_violations(invent({{"render/spans/kernel.cpp", kernel}, {"render/spans/kernel.h", plain}})),
      IsEmpty());
  for (const char* body :
       {"inline int f(int x) { return x; }\n", "struct S {\n  int f() const { return 0; }\n};\n",
        "inline auto f(int x) noexcept -> int {\n  return x;\n}\n"}) {
    EXPECT_THAT(find_kernel_violations(invent({{"render/spans/kernel.cpp", kernel},
                                               {"render/spans/kernel.h", "#include \"base/deep.h\"\n"},
                                               {"base/deep.h", body}})),
                ElementsAre(HasSubstr("includes base/deep.h")))
        << body;
  }
}

TEST(KernelRules, KernelFilesShareCodeThatIsCompiledPerTarget) {
  const std::string kernel = "#include \"hwy/foreach_target.h\"\n#include \"render/spans/shared-inl.h\"\n";
  const std::string guard = "#if defined(SHARED_INL_H) == defined(HWY_TARGET_TOGGLE)\n";
  const std::string body = "int f(int x) { return _mm_cvtsi128_si32(g(x)); }\n";
  const auto violations = [&](const std::string& header) {
    return find_kernel_violations(
        invent({{"render/spans/kernel.cpp", kernel}, {"render/spans/shared-inl.h", header}}));
  };
  EXPECT_THAT(violations(guard + "namespace temblor::render::HWY_NAMESPACE {\n" + body), IsEmpty());
  // In a namespace that all targets share, the linker would choose one of their functions.
  const auto is_refused =
      UnorderedElementsAre(HasSubstr("which has function bodies"), HasSubstr("one instruction set"));
  EXPECT_THAT(violations(guard + "namespace temblor::render {\n" + body), is_refused);
  EXPECT_THAT(violations("namespace temblor::render::HWY_NAMESPACE {\n" + body), is_refused);
}

TEST(KernelRules, RejectSimdCodeOutsideTheKernelFolders) {
  EXPECT_THAT(find_kernel_violations(invent({{"world/level.cpp", "#include <hwy/highway.h>\n"}})),
              ElementsAre(HasSubstr("outside the kernel folders")));
  const std::string intrinsic = "x = _mm256_add_ps(a, b);\n";
  EXPECT_THAT(find_kernel_violations(invent({{"render/spans/draw.cpp", intrinsic}})),
              ElementsAre(HasSubstr("one instruction set")));
  EXPECT_THAT(find_kernel_violations(
                  invent({{"render/spans/kernel.cpp", "#include <hwy/foreach_target.h>\n" + intrinsic}})),
              IsEmpty());
}

}  // namespace
}  // namespace temblor::test
