#include "walk/anytime_plan.h"

#include <utility>

#include "walk/crowd.h"
#include "walk/keeping.h"

namespace stridegraph {
namespace {

/// A walk that still holds is left for another only where that saves this share of what is left to go.
constexpr double kWorthTurning = 0.03;

bool isWorthTurning(const Plan& other, const AnytimePlan::UnderWay& current) {
  return allArrive(other) &&
         metresLeft(other, current.frame) <= (1.0 - kWorthTurning) * metresLeft(current.walk, current.frame);
}

}  // namespace

AnytimePlan::AnytimePlan(Plan kept) : best_(std::move(kept)) {}

AnytimePlan::AnytimePlan(std::unique_ptr<Crowd> crowd, std::optional<UnderWay> underWay)
    : crowd_(std::move(crowd)), underWay_(std::move(underWay)) {
  if (underWay_) best_ = underWay_->walk;
  adopt();
}

AnytimePlan::~AnytimePlan() = default;
AnytimePlan::AnytimePlan(AnytimePlan&&) noexcept = default;
AnytimePlan& AnytimePlan::operator=(AnytimePlan&&) noexcept = default;

bool AnytimePlan::step(std::uint64_t expansions) {
  if (isDone()) return false;
  const bool better = crowd_->improve(expansions);
  // At the end reports tell of the whole search.
  if (!better && crowd_->canImprove()) return false;
  return adopt() && better;
}

double AnytimePlan::progress() const {
  return crowd_ ? crowd_->progress() : 1.0;
}

/// Takes over what was found, if that is worth it, and lets go of a crowd that finds no more.
bool AnytimePlan::adopt() {
  const bool more = crowd_->canImprove();
  Plan found = more ? crowd_->plan() : std::move(*crowd_).plan();
  if (!more) crowd_.reset();
  if (underWay_ && !isWorthTurning(found, *underWay_)) return false;
  best_ = std::move(found);
  return true;
}

}  // namespace stridegraph
