#include "walk/motion_search.h"

#include "walk/guided_search.h"
#include "walk/thesis_search.h"

namespace stridegraph {

std::string_view searchName(SearchKind search) {
  return search == SearchKind::kGuided ? "guided" : "thesis";
}

std::optional<SearchKind> searchFromName(std::string_view name) {
  for (const SearchKind kind : {SearchKind::kGuided, SearchKind::kThesis}) {
    if (searchName(kind) == name) return kind;
  }
  return std::nullopt;
}

MotionResult searchMotion(SearchKind kind, const MotionQuery& query) {
  return kind == SearchKind::kGuided ? guidedSearch(query) : thesisSearch(query);
}

}  // namespace stridegraph
