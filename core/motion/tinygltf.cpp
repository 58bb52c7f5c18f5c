// The one place where the library's own code is compiled. What of it is left out (files, images, exceptions)
// is said in this folder's CMakeLists.txt, since every user of its header must say the same. Without files it
// still names file streams, whose header it then leaves to others.
#include <fstream>

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
