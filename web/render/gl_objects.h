#pragma once

#include <GLES3/gl3.h>

#include <span>
#include <string>
#include <utility>

#include "base/result.h"

namespace stridegraph {

/// Sole owner of one OpenGL object; Deleter knows how such an object goes.
template <typename Deleter>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(GLuint name) : name_(name) {}
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) Deleter()(name_);
  }

  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

struct DeleteBuffer {
  void operator()(GLuint name) const { glDeleteBuffers(1, &name); }
};
struct DeleteVertexArray {
  void operator()(GLuint name) const { glDeleteVertexArrays(1, &name); }
};
struct DeleteTexture {
  void operator()(GLuint name) const { glDeleteTextures(1, &name); }
};
struct DeleteFramebuffer {
  void operator()(GLuint name) const { glDeleteFramebuffers(1, &name); }
};
struct DeleteProgram {
  void operator()(GLuint name) const { glDeleteProgram(name); }
};
using GlBuffer = GlObject<DeleteBuffer>;
using GlVertexArray = GlObject<DeleteVertexArray>;
using GlTexture = GlObject<DeleteTexture>;
using GlFramebuffer = GlObject<DeleteFramebuffer>;
using GlProgram = GlObject<DeleteProgram>;

GlBuffer makeBuffer();
GlVertexArray makeVertexArray();
GlTexture makeTexture();
GlFramebuffer makeFramebuffer();

/// Compiles and links; `common` is put in front of both stages. Fails with the driver's log.
Result<GlProgram> makeProgram(const std::string& common, const char* vertex, const char* fragment);

GLint uniformOf(const GlProgram& program, const char* name);

/// An instanced mesh: one buffer of vertices, one of indices, one of instances that is filled every frame.
class InstancedMesh {
 public:
  /// Floats in a row per vertex and per instance, as attribute sizes: {3, 3} is two vec3. Vertex attributes
  /// get the locations 0.., instance attributes follow.
  struct Layout {
    std::span<const int> vertex;
    std::span<const int> instance;
  };

  InstancedMesh() = default;
  InstancedMesh(std::span<const float> vertices, std::span<const unsigned short> indices, Layout layout);

  void draw(std::span<const float> instances, int floatsEach);

 private:
  GlVertexArray array_;
  GlBuffer vertices_;
  GlBuffer indices_;
  GlBuffer instances_;
  GLsizei indexCount_ = 0;
};

}  // namespace stridegraph
