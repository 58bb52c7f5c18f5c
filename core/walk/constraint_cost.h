#pragma once

#include <span>

#include "math/floor_transform.h"
#include "scene/scene.h"
#include "walk/search_tables.h"

namespace stridegraph {

/// Faster than this a body runs: people change from walking to running at about 2 m/s (Thorstensson and
/// Roberthson 1987).
inline constexpr double kRunMetresPerSecond = 1.9;

/// Whether going at a speed keeps to the gait and speeds asked for; by up to 0.05 m/s off it does.
bool keepsTo(const WalkConstraints& constraints, double metresPerSecond);

/// What it costs a walk to go against what the scene asks for (constraints at run time, Alankus 2005,
/// 4.2.2): wishes that are paid for, so that a walk keeps to them wherever it can and still arrives where it
/// cannot, say while it starts and stops. Metres of cost. Borrows the constraints.
class ConstraintCost {
 public:
  ConstraintCost(const WalkConstraints& constraints, double framesPerSecond)
      : constraints_(constraints), framesPerSecond_(framesPerSecond) {}

  /// Of a second at a speed that is too fast, too slow, or of another gait.
  double perSecondAt(double metresPerSecond) const;
  /// Of going a way at such a speed.
  double ofPace(const SearchEdge& way) const;
  /// The same of one of the tables' arrivals.
  double ofPace(const SearchTables& tables, std::uint32_t arrival) const;
  /// Of beginning in motion where a walk could from a stand: more than getting going takes, since to keep a
  /// pace from the first frame on is no reason for it.
  double ofMovingStart() const;
  /// Of where the samples of a way lead, seen from a placement.
  double ofPlaces(const FloorTransform& from, std::span<const Eigen::Vector2f> samples) const;
  /// How much more a metre costs at a place, 0 or more; nothing where no area says otherwise.
  double perMetreAt(const Vec2& point) const;

  bool asksForPlaces() const { return !constraints_.areas.empty(); }

 private:
  const WalkConstraints& constraints_;
  double framesPerSecond_;
};

}  // namespace stridegraph
