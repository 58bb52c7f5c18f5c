#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "path/distance_field.h"
#include "walk/cost_to_go.h"
#include "walk/motion_search.h"
#include "walk/pace_tables.h"
#include "walk/search_trouble.h"

namespace stridegraph {

/// A query made ready for the guided search: what its constraints come to, the field that heeds its areas,
/// and the estimate of what a walk still costs. Does not move, since its parts refer to one another; what the
/// query refers to has to outlive it.
class GuidedTask {
 public:
  explicit GuidedTask(const MotionQuery& query);
  GuidedTask(const GuidedTask&) = delete;
  GuidedTask& operator=(const GuidedTask&) = delete;

  /// With constraints, be they empty, which hold the pace that it takes to be there in time.
  const MotionQuery& query() const { return query_; }
  const DistanceField& field() const { return ownField_ ? *ownField_ : *query_.field; }
  CostToGo& costToGo() { return costToGo_; }

  double metresFromStart() const { return field().metresToGoal(query_.start.position); }
  bool meetsOthers() const { return query_.traffic != nullptr && !query_.traffic->empty(); }
  bool outOfTime() const { return query_.outOfTime && query_.outOfTime(); }
  /// Where areas lead the search another way than the query's path: that way, from start to goal. Else empty.
  std::vector<Vec2> way() const;
  /// Why no walk was found, for people.
  std::string explain(SearchStatus status, const SearchTrouble& trouble) const;

 private:
  WalkConstraints wishes_;
  PaceTables ownPaces_;
  MotionQuery query_;
  std::shared_ptr<const PaceTable> pace_;
  std::optional<DistanceField> ownField_;
  CostToGo costToGo_;
};

}  // namespace stridegraph
