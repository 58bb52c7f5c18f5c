#pragma once

#include <string>

#include "base/error.h"
#include "graph/library.h"

namespace stridegraph {

/// Warnings as a JSON array of {topic, message, file, line, column}; line and column from 1, 0 when unknown.
std::string toJson(const Warnings& warnings);

/// What a library is made of, as a JSON object: hash, fps, frames, transitions, license, clips (an array of
/// {name, frames, mirrored}) and notes (toJson(Warnings)).
std::string toJson(const MotionLibrary& library);

}  // namespace stridegraph
