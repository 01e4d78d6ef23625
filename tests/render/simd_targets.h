// SIMD kernels exist once for each instruction set, and the best one runs. Here each of them runs in turn.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace temblor::test {

// While it exists, kernels run for this instruction set; afterwards the best one is used again.
class ForcedVectorTarget {
 public:
  explicit ForcedVectorTarget(std::int64_t target) { hwy::SetSupportedTargetsForTest(target); }
  ~ForcedVectorTarget() { hwy::SetSupportedTargetsForTest(0); }
  ForcedVectorTarget(const ForcedVectorTarget&) = delete;
  ForcedVectorTarget& operator=(const ForcedVectorTarget&) = delete;
};

// Calls body() for each instruction set that was compiled and that this processor supports. Call it inside
// loops over cases, so that all instruction sets share the case and its scalar result.
template <typename Body>
void for_each_simd_target(Body body) {
  static const std::vector<std::int64_t> targets =
      hwy::SupportedAndGeneratedTargets();  // slow in virtual machines
  for (const std::int64_t target : targets) {
    const ForcedVectorTarget forced(target);
    SCOPED_TRACE(hwy::TargetName(target));
    body();
  }
}

}  // namespace temblor::test
