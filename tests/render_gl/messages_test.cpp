// Errors that nobody asked for: check() reports them in all builds, and debug builds add what the driver
// says.
#include <gtest/gtest.h>

#include "platform/egl/offscreen_context.h"
#include "render_gl/gl/objects.h"

namespace temblor::render_gl {
namespace {

class Messages : public testing::Test {
 protected:
  void SetUp() override {
    auto context = platform::egl::make_offscreen_context();
    if (!context.ok()) GTEST_SKIP() << "no OpenGL: " << context.error().what;
    context_ = std::move(context).value();
    gl_ = load_functions([this](const char* name) { return context_->find_function(name); }).value();
  }

  std::unique_ptr<platform::GlContext> context_;
  Functions gl_;
};

TEST_F(Messages, AreOneLineAndComeOnce) {
  gl_.Enable(0x1234);
  gl_.Enable(0x1235);
  const base::Status checked = gl_.check("testing");
  ASSERT_FALSE(checked.ok());
  EXPECT_TRUE(checked.error().what.starts_with("testing: OpenGL error 0x500")) << checked.error().what;
  EXPECT_EQ(checked.error().what.find('\n'), std::string::npos);
  EXPECT_TRUE(gl_.check("testing").ok());
}

// Other code may have taken the error, but the driver's message stays.
TEST_F(Messages, OfTheDriverFailInDebugBuilds) {
  if (gl_.GetDebugMessageLog == nullptr) GTEST_SKIP() << "a release build, or a driver without KHR_debug";
  gl_.Enable(0x1234);
  EXPECT_NE(gl_.GetError(), GLenum{GL_NO_ERROR});
  const base::Status checked = gl_.check("testing");
  ASSERT_FALSE(checked.ok());
  EXPECT_NE(checked.error().what.find("glEnable"), std::string::npos) << checked.error().what;
  EXPECT_TRUE(gl_.check("testing").ok());
}

TEST_F(Messages, OfOthersAreNotOurs) {
  gl_.Enable(0x1234);
  gl_.GetError();
  const Functions later =
      load_functions([this](const char* name) { return context_->find_function(name); }).value();
  EXPECT_TRUE(later.check("testing").ok());
}

#ifdef NDEBUG
TEST_F(Messages, AreOffInReleaseBuilds) {
  EXPECT_EQ(gl_.GetDebugMessageLog, nullptr);
}
#endif

}  // namespace
}  // namespace temblor::render_gl
