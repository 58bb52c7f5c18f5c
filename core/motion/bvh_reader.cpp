#include "motion/bvh_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/utf8.h"
#include "motion/bvh_hierarchy.h"
#include "motion/bvh_interpretation.h"
#include "motion/bvh_motion.h"
#include "motion/bvh_scanner.h"
#include "motion/bvh_text.h"

namespace stridegraph {

Result<BvhDocument> readBvh(std::string_view bytes, std::string_view name, const BvhReadParams& params) {
  const double unitsPerMetre = params.unitsPerMetre.value_or(1.0);
  if (!std::isfinite(unitsPerMetre) || unitsPerMetre < 1e-6 || unitsPerMetre > 1e9) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("found {} units per metre, expected a number from 1e-6 to 1e9", unitsPerMetre));
  }
  const std::string file = toUtf8(name);
  Result<BvhText> text = decodeBvhText(bytes, file);
  if (!text) return fail(std::move(text));
  BvhScanner scanner(text->view(), file);
  Result<BvhHierarchy> hierarchy = parseBvhHierarchy(scanner);
  if (!hierarchy) return fail(std::move(hierarchy));
  Result<BvhMotion> motion = parseBvhMotion(scanner, *hierarchy);
  if (!motion) return fail(std::move(motion));
  motion->warnings.insert(motion->warnings.begin(), text->warnings.begin(), text->warnings.end());
  return interpretBvh(std::move(*hierarchy), std::move(*motion), file, params);
}

}  // namespace stridegraph
