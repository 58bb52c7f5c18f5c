#include "walk/motion_search.h"

#include <utility>

#include "walk/guided_search.h"
#include "walk/thesis_search.h"

namespace stridegraph {

std::string_view searchName(SearchKind search) {
  switch (search) {
    case SearchKind::kGuided:
      return "guided";
    case SearchKind::kThesis:
      return "thesis";
    case SearchKind::kThesisChecked:
      return "thesis-checked";
  }
  return "unknown";
}

std::optional<SearchKind> searchFromName(std::string_view name) {
  for (const SearchKind kind : kAllSearchKinds) {
    if (searchName(kind) == name) return kind;
  }
  return std::nullopt;
}

namespace {

/// A search that gives one answer.
class OneAnswer : public MotionSearch {
 public:
  explicit OneAnswer(MotionResult answer) : answer_(std::move(answer)) {}
  const MotionResult& best() const override { return answer_; }

 private:
  MotionResult answer_;
};

}  // namespace

std::unique_ptr<MotionSearch> searchMotion(SearchKind kind, const MotionQuery& query) {
  if (kind == SearchKind::kGuided) return std::make_unique<GuidedSearch>(query);
  return std::make_unique<OneAnswer>(
      thesisSearch(query, {.checkCollisions = kind == SearchKind::kThesisChecked}));
}

}  // namespace stridegraph
