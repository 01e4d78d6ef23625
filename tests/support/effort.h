// How much work a property test does. Sanitizer builds run 5 to 30 times slower, so they only do a part of
// it.
#pragma once

namespace temblor::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kQuick = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
constexpr bool kQuick = true;
#else
constexpr bool kQuick = false;
#endif
#else
constexpr bool kQuick = false;
#endif

constexpr int effort(int full, int quick) {
  return kQuick ? quick : full;
}

}  // namespace temblor::test
