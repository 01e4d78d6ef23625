// TEST and TEST_F as GoogleTest defines them, made faster to compile. GoogleTest's own TEST makes a class, a
// factory class, and the code to register them, which takes g++ 13 ms, for each of our thousands of tests.
// Here, TEST makes a function. The precompiled header of tests has this file. Without it (`make lint`), tests
// use GoogleTest's macros and run the same.
//
// The sanitizer tree optimizes tests with slow references. There, clang leaves GoogleTest's templates and the
// bodies of tests as they are: optimizing them takes longer than it saves.
#pragma once

#ifdef __clang__
#pragma clang optimize off
#endif
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#ifdef __clang__
#pragma clang optimize on
#define TEMBLOR_UNOPTIMIZED [[clang::optnone]]
#else
#define TEMBLOR_UNOPTIMIZED
#endif

namespace temblor::test {

class FunctionTest : public ::testing::Test {
 public:
  explicit FunctionTest(void (*body)()) : m_body(body) {}

 private:
  void TestBody() override { m_body(); }

  void (*m_body)();
};

[[gnu::noinline]] inline bool add_test(const char* suite, const char* name, const char* file, int line,
                                       void (*body)()) {
  ::testing::RegisterTest(suite, name, nullptr, nullptr, file, line,
                          [body]() -> ::testing::Test* { return new FunctionTest(body); });
  return true;
}

template <typename Fixture>
[[gnu::noinline]] bool add_fixture_test(const char* fixture, const char* name, const char* file, int line,
                                        Fixture* (*make)()) {
  ::testing::RegisterTest(fixture, name, nullptr, nullptr, file, line, make);
  return true;
}

}  // namespace temblor::test

#undef TEST
#define TEST(suite, name)                                                                   \
  TEMBLOR_UNOPTIMIZED static void suite##_##name##_Test();                                  \
  [[maybe_unused]] static const bool suite##_##name##_is_added =                            \
      ::temblor::test::add_test(#suite, #name, __FILE__, __LINE__, &suite##_##name##_Test); \
  static void suite##_##name##_Test()

#undef TEST_F
#define TEST_F(fixture, name)                                                                         \
  struct fixture##_##name##_Test : fixture {                                                          \
    TEMBLOR_UNOPTIMIZED void TestBody() override;                                                     \
    static fixture* new_test() { return new fixture##_##name##_Test; }                                \
  };                                                                                                  \
  [[maybe_unused]] static const bool fixture##_##name##_is_added = ::temblor::test::add_fixture_test( \
      #fixture, #name, __FILE__, __LINE__, &fixture##_##name##_Test::new_test);                       \
  void fixture##_##name##_Test::TestBody()
