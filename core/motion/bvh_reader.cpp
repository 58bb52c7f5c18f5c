#include "motion/bvh_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "motion/bvh_hierarchy.h"
#include "motion/bvh_interpretation.h"
#include "motion/bvh_motion.h"
#include "motion/bvh_scanner.h"

namespace stridegraph {

Result<BvhDocument> readBvh(std::string_view text, std::string_view name, const BvhReadParams& params) {
  const double unitsPerMetre = params.unitsPerMetre.value_or(1.0);
  if (!std::isfinite(unitsPerMetre) || unitsPerMetre < 1e-6 || unitsPerMetre > 1e9) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("found {} units per metre, expected a number from 1e-6 to 1e9", unitsPerMetre));
  }
  BvhScanner scanner(text, name);
  Result<BvhHierarchy> hierarchy = parseBvhHierarchy(scanner);
  if (!hierarchy) return fail(std::move(hierarchy));
  Result<BvhMotion> motion = parseBvhMotion(scanner, hierarchy->columns);
  if (!motion) return fail(std::move(motion));
  return interpretBvh(std::move(*hierarchy), std::move(*motion), name, params);
}

}  // namespace stridegraph
