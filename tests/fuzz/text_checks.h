#pragma once

#include <string_view>

#include "base/error.h"

namespace stridegraph::fuzz {

/// A sentence for people: not empty, UTF-8, and without numbers that are none.
void requireSentence(std::string_view sentence);
/// A refusal says why, and only places that the text has: `lines` of it.
void requireSound(const Error& error, std::size_t lines);
void requireSound(const Warnings& warnings, std::size_t lines);

/// How many lines a text has at most, whatever counts as a line end.
std::size_t mostLines(std::string_view text);

}  // namespace stridegraph::fuzz
