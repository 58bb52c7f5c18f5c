#include "render/gl_objects.h"

#include <array>
#include <cstddef>

namespace stridegraph {

namespace {

Result<GLuint> compile(GLenum stage, const std::string& common, const char* source) {
  const GLuint shader = glCreateShader(stage);
  const std::string head =
      "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2DShadow;\n" +
      common;
  const std::array<const char*, 2> parts = {head.c_str(), source};
  glShaderSource(shader, 2, parts.data(), nullptr);
  glCompileShader(shader);
  GLint done = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done == GL_TRUE) return shader;
  std::array<char, 2048> log = {};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  glDeleteShader(shader);
  return fail(ErrorCode::kInvalidArgument, std::string("a shader does not compile: ") + log.data());
}

void describeAttributes(std::span<const int> sizes, GLuint firstLocation, GLuint divisor) {
  int stride = 0;
  for (const int size : sizes) stride += size;
  std::size_t offset = 0;
  GLuint location = firstLocation;
  for (const int size : sizes) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, stride * static_cast<int>(sizeof(float)),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(location, divisor);
    offset += static_cast<std::size_t>(size) * sizeof(float);
    ++location;
  }
}

}  // namespace

GlBuffer makeBuffer() {
  GLuint name = 0;
  glGenBuffers(1, &name);
  return GlBuffer(name);
}

GlVertexArray makeVertexArray() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  return GlVertexArray(name);
}

GlTexture makeTexture() {
  GLuint name = 0;
  glGenTextures(1, &name);
  return GlTexture(name);
}

GlFramebuffer makeFramebuffer() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  return GlFramebuffer(name);
}

Result<GlProgram> makeProgram(const std::string& common, const char* vertex, const char* fragment) {
  Result<GLuint> vertexStage = compile(GL_VERTEX_SHADER, common, vertex);
  if (!vertexStage) return fail(std::move(vertexStage));
  Result<GLuint> fragmentStage = compile(GL_FRAGMENT_SHADER, common, fragment);
  if (!fragmentStage) return fail(std::move(fragmentStage));
  GlProgram program(glCreateProgram());
  glAttachShader(program.name(), *vertexStage);
  glAttachShader(program.name(), *fragmentStage);
  glLinkProgram(program.name());
  glDeleteShader(*vertexStage);
  glDeleteShader(*fragmentStage);
  GLint done = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &done);
  if (done == GL_TRUE) return program;
  std::array<char, 2048> log = {};
  glGetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
  return fail(ErrorCode::kInvalidArgument, std::string("a shader does not link: ") + log.data());
}

GLint uniformOf(const GlProgram& program, const char* name) {
  return glGetUniformLocation(program.name(), name);
}

InstancedMesh::InstancedMesh(std::span<const float> vertices, std::span<const unsigned short> indices,
                             Layout layout)
    : array_(makeVertexArray()),
      vertices_(makeBuffer()),
      indices_(makeBuffer()),
      instances_(makeBuffer()),
      indexCount_(static_cast<GLsizei>(indices.size())) {
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data(),
               GL_STATIC_DRAW);
  describeAttributes(layout.vertex, 0, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
  describeAttributes(layout.instance, static_cast<GLuint>(layout.vertex.size()), 1);
  glBindVertexArray(0);
}

void InstancedMesh::draw(std::span<const float> instances, int floatsEach) {
  if (instances.empty()) return;
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(),
               GL_STREAM_DRAW);
  glDrawElementsInstanced(GL_TRIANGLES, indexCount_, GL_UNSIGNED_SHORT, nullptr,
                          static_cast<GLsizei>(instances.size()) / floatsEach);
  glBindVertexArray(0);
}

}  // namespace stridegraph
