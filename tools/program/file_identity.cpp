#include "program/file_identity.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <climits>
#include <cstring>

#include "program/shown_text.h"

namespace stridegraph::tools {
namespace {

constexpr int kMostLinks = 40;

std::string baseNameOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

/// The name with small letters for capitals and the other way round; ASCII alone.
std::string withOtherCase(std::string name) {
  for (char& letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    if (std::isalpha(byte) == 0 || byte > 127) continue;
    letter = static_cast<char>(std::isupper(byte) != 0 ? std::tolower(byte) : std::toupper(byte));
  }
  return name;
}

/// Whether the file system takes names that differ in case for the same, by the folder's own name.
bool ignoresCase(const std::string& folder, const struct stat& status) {
  std::array<char, PATH_MAX> resolved{};
  if (::realpath(folder.c_str(), resolved.data()) == nullptr) return false;
  const std::string path = resolved.data();
  const std::string other = folderOf(path) + "/" + withOtherCase(baseNameOf(path));
  struct stat found {};
  return other != path && ::stat(other.c_str(), &found) == 0 && found.st_dev == status.st_dev &&
         found.st_ino == status.st_ino;
}

std::string lowerCase(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return name;
}

Result<void> checkFolder(const NamedPath& output) {
  struct stat status {};
  const std::string shown = shownText(output.path);
  if (output.path.empty())
    return fail(ErrorCode::kFile,
                fmt::format("{}: found an empty name, expected that of a file", output.role));
  if (::stat(output.path.c_str(), &status) == 0 && S_ISDIR(status.st_mode))
    return fail(ErrorCode::kFile, fmt::format("{}: found a folder, expected a file", output.role), {shown});
  const std::string folder = folderOf(resolveLinks(output.path));
  if (::stat(folder.c_str(), &status) != 0)
    return fail(ErrorCode::kFile, fmt::format("{}: the folder {} cannot be opened: {}", output.role,
                                              shownText(folder), std::strerror(errno)));
  if (!S_ISDIR(status.st_mode))
    return fail(ErrorCode::kFile,
                fmt::format("{}: found {}, expected a folder", output.role, shownText(folder)));
  return {};
}

}  // namespace

std::string folderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

std::string resolveLinks(const std::string& path) {
  std::string resolved = path;
  for (int i = 0; i < kMostLinks; ++i) {
    std::array<char, PATH_MAX> target{};
    const ssize_t size = ::readlink(resolved.c_str(), target.data(), target.size());
    if (size <= 0 || static_cast<std::size_t>(size) == target.size()) return resolved;
    const std::string next(target.data(), static_cast<std::size_t>(size));
    resolved = next.starts_with('/') ? next : folderOf(resolved) + "/" + next;
  }
  return resolved;
}

FileIdentity::FileIdentity(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) {
    if (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode)) key_ = {status.st_dev, status.st_ino, {}};
    return;
  }
  const std::string resolved = resolveLinks(path);
  const std::string folder = folderOf(resolved);
  const std::string name = baseNameOf(resolved);
  if (name.empty() || ::stat(folder.c_str(), &status) != 0) return;
  key_ = {status.st_dev, status.st_ino, ignoresCase(folder, status) ? lowerCase(name) : name};
}

bool FileIdentity::isSameAs(const FileIdentity& other) const {
  return key_ && other.key_ && *key_ == *other.key_;
}

Result<void> checkOutputs(const std::vector<NamedPath>& inputs, const std::vector<NamedPath>& outputs) {
  for (std::size_t o = 0; o < outputs.size(); ++o) {
    const NamedPath& output = outputs[o];
    if (auto checked = checkFolder(output); !checked) return checked;
    const FileIdentity identity(output.path);
    const auto isSame = [&](const NamedPath& other) { return identity.isSameAs(FileIdentity(other.path)); };
    const auto input = std::find_if(inputs.begin(), inputs.end(), isSame);
    if (input != inputs.end())
      return fail(ErrorCode::kFile,
                  fmt::format("{} would overwrite {}, expected another file", output.role, input->role),
                  {shownText(output.path)});
    const auto first = outputs.begin() + static_cast<std::ptrdiff_t>(o);
    const auto earlier = std::find_if(outputs.begin(), first, isSame);
    if (earlier != first)
      return fail(ErrorCode::kFile,
                  fmt::format("{} would overwrite {}, expected another file", output.role, earlier->role),
                  {shownText(output.path)});
  }
  return {};
}

}  // namespace stridegraph::tools
