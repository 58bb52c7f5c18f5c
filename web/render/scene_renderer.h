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

  /// What the blocks' shadows look like from the sun, within a square around a floor point.
  struct ShadowMap {
    GlTexture depth;
    GlFramebuffer target;
    Eigen::Matrix4f mapFromWorld = Eigen::Matrix4f::Identity();
    std::vector<float> blocks;  ///< What it shows, to draw it only when that changes.
    Vec2 centre = Vec2::Zero();
    double reachMetres = 0.0;
  };

  static ShadowMap makeShadowMap();
  void drawShadowMaps(const Picture& picture, const std::vector<float>& blocks);
  void drawShadowMap(ShadowMap& map, const Vec2& centre, double reachMetres,
                     const std::vector<float>& blocks);
  void setLight(const GlProgram& program, const Picture& picture) const;
  void drawBackground(const Picture& picture);
  void drawFloor(const Picture& picture);
  void drawMarks(const Picture& picture, const std::vector<Mark>& marks);
  void drawLines(const Picture& picture);
  void drawBlocks(const Picture& picture, const std::vector<float>& blocks);
  void drawBody(const Picture& picture);

  GlProgram sky_, floor_, block_, blockDepth_, body_, line_, mark_;
  InstancedMesh quad_, blockMesh_, bodyMesh_, lineMesh_, markMesh_;
  ShadowMap nearShadow_, roomShadow_;
};

}  // namespace stridegraph
