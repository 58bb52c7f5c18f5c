#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "walk/plan.h"

namespace stridegraph {

class Crowd;

/// A plan that can be shown at once and gets better while there is time (anytime planning, Dean and Boddy
/// 1988): the first walks of all walkers, then better ones, slice by slice. Whoever has enough of it lets go
/// of it. WalkPlanner begins it and has to outlive it.
class AnytimePlan {
 public:
  /// A walk under way which still holds, and is left only for one that saves enough from a frame on.
  struct UnderWay {
    Plan walk;
    std::size_t frame = 0;
  };

  /// A walk that goes on as it is.
  explicit AnytimePlan(Plan kept);
  /// What a crowd has found so far and may still find.
  AnytimePlan(std::unique_ptr<Crowd> crowd, std::optional<UnderWay> underWay);
  ~AnytimePlan();
  AnytimePlan(AnytimePlan&&) noexcept;
  AnytimePlan& operator=(AnytimePlan&&) noexcept;

  /// The best plan so far.
  const Plan& best() const& { return best_; }
  Plan best() && { return std::move(best_); }
  /// Whether best() is as good as it gets within the options.
  bool isDone() const { return crowd_ == nullptr; }
  /// Looks at up to so many more states of the search; whether best() is another one now. In what slices it
  /// is called makes no difference.
  bool step(std::uint64_t expansions);
  /// How much of what the options allow has been looked at, 0..1; 1 when done.
  double progress() const;

 private:
  bool adopt();

  std::unique_ptr<Crowd> crowd_;  ///< None when nothing is left to be found.
  std::optional<UnderWay> underWay_;
  Plan best_;
};

}  // namespace stridegraph
