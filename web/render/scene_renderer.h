#pragma once

#include "motion/round_body.h"
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

/// A walker's body.
struct ShownBody {
  std::vector<Capsule> capsules;
  Colour colour;
};

/// Everything that one frame of the room shows.
struct Picture {
  const AppState& state;
  const CameraView& view;
  const FloorMarks& marks;
  const std::vector<ShownBody>& bodies;  ///< The first walker's first.
  PixelSize size;
};

/// Draws the room. Owns every OpenGL object that takes.
class SceneRenderer {
 public:
  static Result<SceneRenderer> create();

  void draw(const Picture& picture);

 private:
  SceneRenderer() = default;

  /// What casts shadows beside the first body, whose own are computed: instances of blocks and of round
  /// cones.
  struct Casters {
    std::vector<float> blocks;
    std::vector<float> bodies;

    bool operator==(const Casters&) const = default;
  };
  /// What the casters' shadows look like from the sun, within a square around a floor point.
  struct ShadowMap {
    GlTexture depth;
    GlFramebuffer target;
    Eigen::Matrix4f mapFromWorld = Eigen::Matrix4f::Identity();
    Casters casters;  ///< What it shows, to draw it only when that changes.
    Vec2 centre = Vec2::Zero();
    double reachMetres = 0.0;
  };

  static ShadowMap makeShadowMap();
  void drawShadowMaps(const Picture& picture, const Casters& casters);
  void drawShadowMap(ShadowMap& map, const Vec2& centre, double reachMetres, const Casters& casters);
  /// Light on a surface, and the body whose shade falls on it, if any.
  void setLight(const GlProgram& program, const Picture& picture, const ShownBody* body) const;
  void drawBackground(const Picture& picture);
  void drawFloor(const Picture& picture);
  void drawMarks(const Picture& picture, const std::vector<Mark>& marks);
  void drawLines(const Picture& picture);
  void drawBlocks(const Picture& picture, const std::vector<float>& blocks);
  void drawBodies(const Picture& picture);

  GlProgram sky_, floor_, block_, blockDepth_, body_, bodyDepth_, line_, mark_;
  InstancedMesh quad_, blockMesh_, bodyMesh_, lineMesh_, markMesh_;
  ShadowMap nearShadow_, roomShadow_;
};

}  // namespace stridegraph
