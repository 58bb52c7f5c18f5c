#pragma once

#include <emscripten/val.h>

#include <memory>

#include "session.h"
#include "walk/anytime_plan.h"

namespace stridegraph::bindings {

/// A plan that gets better while it is stepped.
class PlanHandle {
 public:
  PlanHandle(std::shared_ptr<Session> session, AnytimePlan plan);

  /// See planValue; of the best plan so far.
  emscripten::val walk() const;
  /// Some milliseconds of work; whether there is a better walk now.
  bool step();
  bool isDone() const { return plan_.isDone(); }
  double progress() const { return plan_.progress(); }

 private:
  void remember();

  std::shared_ptr<Session> session_;
  AnytimePlan plan_;
};

}  // namespace stridegraph::bindings
