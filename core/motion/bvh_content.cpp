#include "motion/bvh_content.h"

#include <array>
#include <cstddef>

namespace stridegraph {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kFirstWord = "HIERARCHY";
constexpr std::string_view kBlanks = " \t\n\v\f\r";

/// Bytes at a fixed place by which files of a kind are known.
struct Signature {
  std::size_t at;
  std::string_view bytes;
  std::string_view content;
};

constexpr std::array kSignatures = {
    Signature{0, "\x1F\x8B"sv, "a gzip archive"},
    Signature{0, "PK\x03\x04"sv, "a ZIP archive"},
    Signature{0, "PK\x05\x06"sv, "an empty ZIP archive"},
    Signature{0, "7z\xBC\xAF\x27\x1C"sv, "a 7z archive"},
    Signature{0, "Rar!"sv, "a RAR archive"},
    Signature{0, "BZh"sv, "a bzip2 archive"},
    Signature{0, "\xFD\x37zXZ"sv, "an xz archive"},
    Signature{0, "\x28\xB5\x2F\xFD"sv, "a Zstandard archive"},
    Signature{257, "ustar"sv, "a tar archive"},
    Signature{0, "Kaydara FBX Binary"sv, "a binary FBX file"},
    Signature{0, "glTF"sv, "a GLB file"},
    Signature{0, "BLENDER"sv, "a Blender file"},
    Signature{0, "\x02\x50"sv, "a C3D file"},
    Signature{0, "%PDF"sv, "a PDF file"},
    Signature{0, "\x89PNG"sv, "a PNG picture"},
    Signature{0, "\xFF\xD8\xFF"sv, "a JPEG picture"},
    Signature{0, "GIF8"sv, "a GIF picture"},
    Signature{0, "\x7F\x45LF"sv, "a program"},
    Signature{4, "SGRF"sv, "a library of this program (.sgraph)"},
};

/// Beginnings of texts, after blanks.
constexpr std::array kBeginnings = {
    Signature{0, "{"sv, "JSON, such as a scene or a glTF file"},
    Signature{0, "["sv, "JSON"},
    Signature{0, "<"sv, "XML or HTML, such as a COLLADA file or a saved web page"},
    Signature{0, "; FBX"sv, "an FBX file"},
    Signature{0, "version https://git-lfs"sv, "a Git LFS pointer in place of the file"},
    Signature{0, ":version"sv, "an Acclaim skeleton (ASF)"},
    Signature{0, "#!OML"sv, "an Acclaim motion (AMC)"},
    Signature{0, ":FULLY-SPECIFIED"sv, "an Acclaim motion (AMC)"},
    Signature{0, "PathFileType"sv, "a table of markers (TRC)"},
    Signature{0, "#usda"sv, "a USD file"},
    Signature{0, "PXR-USDC"sv, "a USD file"},
};

bool holds(std::string_view bytes, const Signature& signature) {
  return bytes.size() >= signature.at && bytes.substr(signature.at).starts_with(signature.bytes);
}

char upperCase(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// Characters of `width` bytes each, of which one, at `place`, is not 0 in ASCII.
struct WideAscii {
  std::size_t width;
  std::size_t place;
};

/// The ASCII character number `index`; 0 when there is none.
char characterAt(std::string_view bytes, const WideAscii& form, std::size_t index) {
  const std::size_t at = index * form.width;
  if (bytes.size() < at + form.width) return 0;
  for (std::size_t i = 0; i < form.width; ++i) {
    if (i != form.place && bytes[at + i] != 0) return 0;
  }
  return bytes[at + form.place];
}

bool beginsWithHierarchy(std::string_view bytes, const WideAscii& form) {
  std::size_t index = 0;
  while (true) {
    const char c = characterAt(bytes, form, index);
    if (c == 0 || kBlanks.find(c) == std::string_view::npos) break;
    ++index;
  }
  for (std::size_t i = 0; i < kFirstWord.size(); ++i) {
    if (upperCase(characterAt(bytes, form, index + i)) != kFirstWord[i]) return false;
  }
  return true;
}

}  // namespace

BvhEncoding encodingOf(std::string_view bytes) {
  // The mark of UTF-32 begins with that of UTF-16 and is looked for first.
  if (bytes.starts_with("\xFF\xFE\0\0"sv) || bytes.starts_with("\0\0\xFE\xFF"sv)) return BvhEncoding::kUtf32;
  if (bytes.starts_with("\xFF\xFE"sv)) return BvhEncoding::kUtf16LittleEndian;
  if (bytes.starts_with("\xFE\xFF"sv)) return BvhEncoding::kUtf16BigEndian;
  if (beginsWithHierarchy(bytes, {2, 0})) return BvhEncoding::kUtf16LittleEndian;
  if (beginsWithHierarchy(bytes, {2, 1})) return BvhEncoding::kUtf16BigEndian;
  if (beginsWithHierarchy(bytes, {4, 0}) || beginsWithHierarchy(bytes, {4, 3})) return BvhEncoding::kUtf32;
  return BvhEncoding::kBytes;
}

std::string_view otherContentIn(std::string_view bytes) {
  for (const Signature& signature : kSignatures) {
    if (holds(bytes, signature)) return signature.content;
  }
  const std::size_t begin = bytes.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  for (const Signature& beginning : kBeginnings) {
    if (holds(bytes.substr(begin), beginning)) return beginning.content;
  }
  return {};
}

}  // namespace stridegraph
