#pragma once

#include <CLI/CLI.hpp>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "program/number_text.h"

namespace stridegraph::tools {

/// Options that take numbers. Each is checked when it is parsed: what is no number or out of range ends in a
/// CLI::ValidationError that names the option, what was found and what was expected. Help shows range, unit
/// and the default, which is the value that the variable has when the option is added.

/// The value that an option's text stands for.
double numberOrThrow(const std::string& name, const std::string& text, const NumberRange& range);
std::uint64_t wholeOrThrow(const std::string& name, const std::string& text, const WholeRange& range);

/// The text where it is one of the choices.
std::string choiceOrThrow(const std::string& name, const std::string& text,
                          const std::vector<std::string>& choices);

/// Adds an option whose text goes to `take`, which throws what it refuses.
CLI::Option* addText(CLI::App& command, const std::string& name,
                     const std::function<void(const std::string&)>& take, const std::string& meaning);

CLI::Option* addNumber(CLI::App& command, const std::string& name, double& value, const NumberRange& range,
                       const std::string& meaning);

/// The range lies within what the variable's type holds.
template <std::integral Whole>
CLI::Option* addWhole(CLI::App& command, const std::string& name, Whole& value, const WholeRange& range,
                      const std::string& meaning) {
  const auto take = [&value, name, range](const std::string& text) {
    value = static_cast<Whole>(wholeOrThrow(name, text, range));
  };
  return addText(command, name, take, meaning + ": " + describe(range))
      ->type_name("N")
      ->default_str(std::to_string(value));
}

/// Whole numbers with commas between them: "1000,10000". May be given more than once.
CLI::Option* addWholeList(CLI::App& command, const std::string& name, std::vector<std::size_t>& values,
                          const WholeRange& range, const std::string& meaning);

/// A text that has to be one of the choices.
CLI::Option* addChoice(CLI::App& command, const std::string& name, std::string& value,
                       const std::vector<std::string>& choices, const std::string& meaning);

/// A file or folder by its name; `word` is what help calls it: "FILE", "FOLDER".
CLI::Option* addPath(CLI::App& command, const std::string& name, std::string& path, const std::string& word,
                     const std::string& meaning);

/// Whether an option was given.
inline bool isGiven(const CLI::Option* option) {
  return option->count() > 0;
}

/// Adds --quiet.
void addQuiet(CLI::App& command, bool& isQuiet);

/// All values that a seed may have.
inline constexpr WholeRange kSeedRange{0, std::numeric_limits<std::uint64_t>::max(), ""};

}  // namespace stridegraph::tools
