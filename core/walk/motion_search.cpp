#include "walk/motion_search.h"

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

MotionResult searchMotion(SearchKind kind, const MotionQuery& query) {
  if (kind == SearchKind::kGuided) return guidedSearch(query);
  return thesisSearch(query, {.checkCollisions = kind == SearchKind::kThesisChecked});
}

}  // namespace stridegraph
