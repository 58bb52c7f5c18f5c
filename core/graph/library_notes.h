#pragma once

#include <string>

#include "base/error.h"
#include "graph/library.h"
#include "motion/bvh_reader.h"

namespace stridegraph {

/// Makes every text of a clip UTF-8: names of clip, joints and end sites, and warnings.
void makeTextsUtf8(BvhDocument& document);

/// The notes as a library may hold them: UTF-8, none twice, long ones cut, and at most kMostLibraryNotes, of
/// which the last then counts those left out.
Warnings keepableNotes(const Warnings& notes);

/// The notes of a library that stay when clips are added to it: all but those of the topic kGraph, which are
/// about the library as a whole and are made anew.
Warnings notesThatStay(const Warnings& notes);

}  // namespace stridegraph
