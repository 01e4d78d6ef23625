// Saved visibility: round trips, damage, and work shared between processes that exchange only bytes.
#include "compiler/vis/visibility_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "compiler/bsp/tree_portals.h"
#include "support/effort.h"
#include "support/levels/small_bsp.h"
#include "support/mutations.h"

namespace temblor::compiler {
namespace {

using base::ErrorCode;

constexpr auto kNeverStop = [](std::size_t, std::size_t) { return true; };

PortalSet small_portals() {
  return make_tree_portals(test::small_bsp()).value();
}

VisibilityState finish_visibility(const PortalSet& portals) {
  base::Jobs jobs(1);
  VisibilityState state = begin_visibility(portals);
  EXPECT_EQ(continue_visibility(portals, jobs, kNeverStop, state), VisibilityEnd::kFinished);
  return state;
}

// A state in which some portals are finished.
VisibilityState stopped_state(const PortalSet& portals) {
  base::Jobs jobs(1);
  VisibilityState state = begin_visibility(portals);
  const auto stop_midway = [](std::size_t done, std::size_t total) { return done * 3 < total; };
  EXPECT_EQ(continue_visibility(portals, jobs, stop_midway, state), VisibilityEnd::kStopped);
  return state;
}

// A round hall with so many windows that those who look in might see more than 512 rooms: their portals are
// crowded and get sweeps.
PortalSet make_round_hall() {
  constexpr std::uint32_t kRooms = 540;
  constexpr double kRadius = 10'000, kHalfWindow = 40;
  PortalSet portals;
  portals.cluster_count = kRooms + 1;
  for (std::uint32_t room = 0; room < kRooms; ++room) {
    const double angle = 2 * std::numbers::pi * room / kRooms;
    const math::Vec3d out(std::cos(angle), std::sin(angle), 0), along(-out.y, out.x, 0), up(0, 0, 100);
    const math::Vec3d left = out * kRadius + along * kHalfWindow, right = left - along * (2 * kHalfWindow);
    portals.portals.push_back({{left, left + up, right + up, right}, -out, -kRadius, {kRooms, room}});
  }
  return portals;
}

TEST(VisibilityState, ReadsBackEqual) {
  const PortalSet portals = small_portals();
  const VisibilityState begun = begin_visibility(portals);
  VisibilityState swept = stopped_state(portals);
  swept.swept = finish_visibility(portals).seen;
  for (const VisibilityState& state : {begun, stopped_state(portals), finish_visibility(portals), swept}) {
    const auto read = read_visibility_state(write_visibility_state(state), begun);
    ASSERT_TRUE(read.ok()) << read.error().message();
    EXPECT_EQ(*read, state);
  }
}

TEST(VisibilityState, RejectsAnotherLevel) {
  PortalSet portals = small_portals();
  const base::ByteVector bytes = write_visibility_state(finish_visibility(portals));
  portals.portals[0].winding_world[0].x += 1;
  const VisibilityState begun = begin_visibility(portals);
  const auto read = read_visibility_state(bytes, begun);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, ErrorCode::kUsage);
  EXPECT_NE(read.error().what.find("another level"), std::string::npos);

  VisibilityState state = begun;
  const VisibilityState other = finish_visibility(small_portals());
  const auto merged = merge_visibility_state(other, state);
  ASSERT_FALSE(merged.ok());
  EXPECT_EQ(merged.error().code, ErrorCode::kUsage);
  EXPECT_EQ(state, begun);
}

TEST(VisibilityState, RejectsDamage) {
  // Four windows in line between five of 70 clusters, so rows have two words.
  PortalSet portals;
  portals.cluster_count = 70;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const double x = 100.0 * i;
    portals.portals.push_back({{{x, 0, 0}, {x, 0, 10}, {x, 10, 10}, {x, 10, 0}}, {1, 0, 0}, x, {i + 1, i}});
  }
  const VisibilityState begun = begin_visibility(portals);
  const base::ByteVector bytes = write_visibility_state(finish_visibility(portals));
  test::for_each_truncation(bytes, [&](const base::ByteVector& cut) {
    EXPECT_FALSE(read_visibility_state(cut, begun).ok()) << cut.size();
  });
  test::Random random(3);
  for (int i = 0; i < test::effort(2000, 200); ++i) {
    const base::ByteVector damaged = test::with_flipped_bits(bytes, random);
    if (damaged == bytes) continue;  // the same bit twice
    EXPECT_FALSE(read_visibility_state(damaged, begun).ok()) << i;
  }
  const auto newer = read_visibility_state(test::with_number(bytes, 4, std::uint32_t{4}), begun);
  ASSERT_FALSE(newer.ok());
  EXPECT_EQ(newer.error().code, ErrorCode::kUnsupported);
}

TEST(VisibilityState, RejectsTwoResultsForOnePortal) {
  const PortalSet portals = small_portals();
  const VisibilityState state = finish_visibility(portals);
  VisibilityState wrong = state, merged = state;
  wrong.seen.row(5)[0] ^= 1;
  const auto status = merge_visibility_state(wrong, merged);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().what.find("portal 5"), std::string::npos) << status.error().what;
  EXPECT_EQ(merged, state);
}

// Works as separate processes do: each begins with the bytes that all have, and returns bytes.
base::ByteVector work_in_shares(const PortalSet& portals, std::uint32_t share_count, int& out_rounds) {
  const VisibilityState begun = begin_visibility(portals);
  base::ByteVector all = write_visibility_state(begun);
  base::Jobs jobs(1);
  for (out_rounds = 1; out_rounds < 100; ++out_rounds) {
    VisibilityState merged = begun;
    bool finished = true;
    for (std::uint32_t index = 0; index < share_count; ++index) {
      VisibilityState own = read_visibility_state(all, begun).value();
      const auto end = continue_visibility(portals, jobs, kNeverStop, own, {index, share_count});
      finished = finished && end == VisibilityEnd::kFinished;
      const auto left = read_visibility_state(write_visibility_state(own), begun);
      EXPECT_TRUE(merge_visibility_state(*left, merged).ok());
    }
    all = write_visibility_state(merged);
    if (finished) break;
  }
  return all;
}

TEST(VisibilityState, MergedSharesEqualASingleRun) {
  const PortalSet portals = small_portals();
  const base::ByteVector whole = write_visibility_state(finish_visibility(portals));
  for (const std::uint32_t share_count : {1u, 2u, 3u, 16u}) {
    int rounds = 0;
    EXPECT_EQ(work_in_shares(portals, share_count, rounds), whole) << share_count << " shares";
    EXPECT_LE(rounds, 8) << share_count << " shares";
  }
}

// The first share saves the sweeps; all shares of later rounds begin with them.
TEST(VisibilityState, SharesDoNotRepeatSweeps) {
  const PortalSet portals = make_round_hall();
  const VisibilityState begun = begin_visibility(portals);
  const SearchablePortals searchable(portals);
  base::Jobs jobs(1);
  VisibilityState first = begun, second = begun;
  std::size_t done_first = 1;
  const auto keep_first = [&](std::size_t done, std::size_t) {
    done_first = std::min(done_first, done);
    return true;
  };
  EXPECT_EQ(continue_visibility(searchable, jobs, keep_first, first, {0, 2}), VisibilityEnd::kWaiting);
  EXPECT_EQ(done_first, 0u);
  EXPECT_EQ(first.swept.rows(), first.seen.rows());
  EXPECT_EQ(continue_visibility(searchable, jobs, kNeverStop, second, {1, 2}), VisibilityEnd::kWaiting);
  EXPECT_EQ(second.swept.rows(), 0u);
  VisibilityState merged = begun;
  ASSERT_TRUE(merge_visibility_state(second, merged).ok());
  ASSERT_TRUE(merge_visibility_state(first, merged).ok());
  EXPECT_EQ(merged.swept, first.swept);

  // Nothing but the sweeps: they count as done.
  VisibilityState again = begun;
  again.swept = first.swept;
  std::size_t calls = 0, done_at_start = 0;
  continue_visibility(
      searchable, jobs,
      [&](std::size_t done, std::size_t) {
        if (calls++ == 0) done_at_start = done;
        return false;
      },
      again);
  EXPECT_GT(done_at_start, 0u);

  int rounds = 0;
  EXPECT_EQ(work_in_shares(portals, 2, rounds), write_visibility_state(finish_visibility(portals)));

  first.swept.row(7)[0] ^= 1;
  const auto status = merge_visibility_state(first, merged);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().what.find("different sweeps"), std::string::npos) << status.error().what;
}

// Progress grows in small steps, during sweeps, too, and ends at its total.
TEST(VisibilityState, SweepsReportProgress) {
  base::Jobs jobs(1);
  const PortalSet portals = make_round_hall();
  VisibilityState state = begin_visibility(portals);
  std::size_t last = 0, total_now = 0, largest_step = 0;
  const auto watch = [&](std::size_t done, std::size_t total) {
    largest_step = std::max(largest_step, done - last);
    last = done;
    total_now = total;
    return true;
  };
  EXPECT_EQ(continue_visibility(portals, jobs, watch, state), VisibilityEnd::kFinished);
  EXPECT_EQ(last, total_now);
  EXPECT_LT(largest_step * 20, total_now);
}

}  // namespace
}  // namespace temblor::compiler
