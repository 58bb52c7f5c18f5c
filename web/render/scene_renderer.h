#pragma once

#include "render/body.h"
#include "render/gl_objects.h"
#include "render/marks.h"
#include "render/palette.h"
#include "state/app_state.h"

namespace stridegraph {

/// The size of what is drawn into.
struct PixelSize {
  int width = 1;
  int height = 1;
  double perPoint = 1.0;  ///< Device pixels in a point.
};

/// Everything that one frame of the room shows.
struct Picture {
  const AppState& state;
  const CameraView& view;
  const FloorMarks& marks;
  const std::vector<Capsule>& body;
  bool bodyIsBlended = false;
  PixelSize size;
};

/// Draws the room. Owns every OpenGL object that takes.
class SceneRenderer {
 public:
  static Result<SceneRenderer> create();

  void draw(const Picture& picture);

 private:
  SceneRenderer() = default;

  void drawShadowMap(const Picture& picture, const std::vector<float>& blocks);
  void setLight(const GlProgram& program, const Picture& picture) const;
  void drawBackground(const Picture& picture);
  void drawFloor(const Picture& picture);
  void drawMarks(const Picture& picture, const std::vector<Mark>& marks);
  void drawLines(const Picture& picture);
  void drawBlocks(const Picture& picture, const std::vector<float>& blocks);
  void drawBody(const Picture& picture);

  GlProgram sky_, floor_, block_, blockDepth_, body_, line_, mark_;
  InstancedMesh quad_, blockMesh_, bodyMesh_, lineMesh_, markMesh_;
  GlTexture shadowMap_;
  GlFramebuffer shadowTarget_;
  Eigen::Matrix4f shadowFromWorld_ = Eigen::Matrix4f::Identity();
  std::vector<float> shadowBlocks_;  ///< What the shadow map shows, to draw it only when that changes.
  Vec2 shadowCentre_ = Vec2::Zero();
  double shadowReach_ = 0.0;
};

}  // namespace stridegraph
