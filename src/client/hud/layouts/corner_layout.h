// The layouts without a bar, at the frame's corners. Minimal: only the numbers of health and ammo.
//
//   | armor 25                            frags, keys, sigils |
//   | face 100                                        ammo 50 |
#pragma once

#include <cstdint>

#include "client/hud/hud.h"
#include "client/hud/layouts/player_figures.h"
#include "client/hud/panel.h"
#include "client/session/client_state.h"

namespace temblor::client {

// The distance from the frame's edges.
constexpr int kCornerMargin = 2;

// The upper right rows: the leaders, and these items.
struct CornerItems {
  bool are_shown = true;
  // Without those that are shown elsewhere.
  std::uint32_t items = ~0u;
};

// The heights of both sides above the frame's bottom, in the panel's pixels.
struct CornerHeights {
  int left, right;
};
CornerHeights measure_corners(const Game& game, const CornerItems& items);

// `panel`: any panel of the frame.
void draw_corners(const Panel& panel, const Game& game, const HudTimes& times, double time_s,
                  const BarLook& look, const CornerItems& items);

constexpr int kMinimalHeight = kCornerMargin + kFigureHeight;
void draw_minimal(const Panel& panel, const Game& game, const BarLook& look);

}  // namespace temblor::client
