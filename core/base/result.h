#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "base/error.h"

namespace stridegraph {

/// A value, or the reason why there is none. Core never throws: foreseeable bad input ends here.
template <typename T>
using Result = tl::expected<T, Error>;

/// Shorthand for `return fail(code, "sentence")` in a function that returns a Result.
inline tl::unexpected<Error> fail(ErrorCode code, std::string message, Place place = {}) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(place)});
}

/// Hands on the error of another Result.
template <typename T>
tl::unexpected<Error> fail(Result<T>&& failed) {
  return tl::unexpected<Error>(std::move(failed.error()));
}

}  // namespace stridegraph
