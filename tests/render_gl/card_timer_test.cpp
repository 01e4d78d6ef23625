// The card's own times of frames, from queries of a card that is made here.
#include "render_gl/gl/card_timer.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace temblor::render_gl {
namespace {

// Queries: their results in nanoseconds, as soon as the test gives them.
struct FakeQueries {
  std::set<GLuint> names;
  std::map<GLuint, GLuint> results;
  GLuint running = 0, last = 0;
  int errors = 0;
  bool is_disjoint = false;
};
thread_local FakeQueries* queries = nullptr;

Functions make_fake_functions() {
  Functions gl;
  gl.has_timer = true;
  gl.has_disjoint_timer = true;
  gl.GenQueries = [](GLsizei, GLuint* name) {
    *name = static_cast<GLuint>(queries->names.size() + 1);
    queries->names.insert(*name);
  };
  gl.DeleteQueries = [](GLsizei, const GLuint* name) { queries->names.erase(*name); };
  gl.BeginQuery = [](GLenum, GLuint name) {
    if (queries->running != 0) ++queries->errors;
    queries->running = queries->last = name;
    queries->results.erase(name);
  };
  gl.EndQuery = [](GLenum) {
    if (queries->running == 0) ++queries->errors;
    queries->running = 0;
  };
  gl.GetQueryObjectuiv = [](GLuint name, GLenum what, GLuint* out) {
    const auto found = queries->results.find(name);
    if (what == GL_QUERY_RESULT_AVAILABLE)
      *out = found != queries->results.end();
    else
      *out = found->second;
  };
  gl.GetIntegerv = [](GLenum, GLint* out) { *out = queries->is_disjoint; };
  return gl;
}

class CardTimerTest : public testing::Test {
 protected:
  CardTimerTest() { queries = &fake_; }
  ~CardTimerTest() override { EXPECT_EQ(fake_.errors, 0); }

  // Draws a frame. Returns its query.
  GLuint draw(CardTimer& io_timer, const CardTimer::FrameSize& size = {640, 480}) {
    fake_.last = 0;
    io_timer.begin(gl_, size);
    io_timer.end(gl_);
    return fake_.last;
  }

  FakeQueries fake_;
  const Functions gl_ = make_fake_functions();
};

TEST_F(CardTimerTest, ReportsTimesWhenTheyHaveCome) {
  CardTimer timer(gl_);
  const GLuint first = draw(timer), second = draw(timer);
  EXPECT_FALSE(timer.seconds());
  fake_.results[first] = 2'000'000;
  draw(timer);
  EXPECT_DOUBLE_EQ(timer.seconds().value(), 0.002);
  fake_.results[second] = 3'000'000;
  draw(timer);
  EXPECT_DOUBLE_EQ(timer.seconds().value(), 0.003);
}

TEST_F(CardTimerTest, SkipsFramesIfNoTimeComes) {
  CardTimer timer(gl_);
  for (int i = 0; i < 4; ++i) EXPECT_NE(draw(timer), 0u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(draw(timer), 0u);
  for (const GLuint name : fake_.names) fake_.results[name] = 1'000'000;
  EXPECT_NE(draw(timer), 0u);
  EXPECT_DOUBLE_EQ(timer.seconds().value(), 0.001);
}

// Frames of another size say nothing about those of this size.
TEST_F(CardTimerTest, ForgetsTimesOfAnotherSize) {
  CardTimer timer(gl_);
  fake_.results[draw(timer)] = 5'000'000;
  const GLuint large = draw(timer);
  EXPECT_TRUE(timer.seconds());
  const GLuint small = draw(timer, {320, 240});
  EXPECT_FALSE(timer.seconds());
  fake_.results[large] = 6'000'000;
  draw(timer, {320, 240});
  EXPECT_FALSE(timer.seconds());
  fake_.results[small] = 1'000'000;
  draw(timer, {320, 240});
  EXPECT_DOUBLE_EQ(timer.seconds().value(), 0.001);
}

TEST_F(CardTimerTest, IgnoresTimesWhileTheClockChanges) {
  CardTimer timer(gl_);
  fake_.results[draw(timer)] = 5'000'000;
  fake_.is_disjoint = true;
  draw(timer);
  EXPECT_FALSE(timer.seconds());
}

// A frame that failed has not ended its time.
TEST_F(CardTimerTest, EndsAnOlderTime) {
  {
    CardTimer timer(gl_);
    timer.begin(gl_, {640, 480});
    draw(timer);
    timer.end(gl_);
  }
  EXPECT_EQ(fake_.running, 0u);
  EXPECT_TRUE(fake_.names.empty());
}

}  // namespace
}  // namespace temblor::render_gl
