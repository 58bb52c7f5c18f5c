#include "render/scene_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/meshes.h"
#include "render/shaders.h"
#include "state/editor.h"

namespace stridegraph {

namespace {

constexpr int kShadowSize = 2048;
constexpr double kSmallestShadowReachMetres = 5.0;
constexpr std::size_t kMostCapsules = 40;  // As many as the shader has room for.
constexpr int kBlockFloats = 11, kBodyFloats = 11, kLineFloats = 12, kMarkFloats = 13;
constexpr double kFloorReachMetres = 400.0;
constexpr double kWallHeightMetres = 0.22, kWallThicknessMetres = 0.12;
constexpr float kBevelMetres = 0.022F;

Vec3 toSun() {
  return Vec3(-0.45, 0.80, 0.38).normalized();
}

float f(double value) {
  return static_cast<float>(value);
}

template <typename... Values>
void push(std::vector<float>& out, Values... values) {
  (out.push_back(f(static_cast<double>(values))), ...);
}

void setMatrix(const GlProgram& program, const char* name, const Eigen::Matrix4f& matrix) {
  glUniformMatrix4fv(uniformOf(program, name), 1, GL_FALSE, matrix.data());
}

void setColour(const GlProgram& program, const char* name, const Colour& colour) {
  glUniform3f(uniformOf(program, name), colour.red, colour.green, colour.blue);
}

void pushBlock(std::vector<float>& out, const Rectangle& block, double height, const Colour& colour) {
  push(out, block.centre.x(), 0.0, block.centre.y(), 0.0);
  push(out, block.size.x(), height, block.size.y(), kBevelMetres);
  push(out, colour.red, colour.green, colour.blue);
}

Colour mixed(const Colour& a, const Colour& b, float share) {
  return {a.red + (b.red - a.red) * share, a.green + (b.green - a.green) * share,
          a.blue + (b.blue - a.blue) * share, a.alpha};
}

std::vector<float> blocksOf(const AppState& state) {
  const Palette& palette = paletteFor(state.view.dark);
  const Scene& scene = state.shownScene();
  std::vector<float> out;
  const std::vector<Rectangle> blocks = shownBlocks(state);
  out.reserve((blocks.size() + 4) * kBlockFloats);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const bool moves = i >= scene.obstacles.size();
    const Item item =
        moves ? Item{ItemKind::kMoving, i - scene.obstacles.size()} : Item{ItemKind::kObstacle, i};
    Colour colour = moves ? palette.movingBlock : palette.block;
    if (state.hovered == item) colour = mixed(colour, palette.chosenBlock, 0.25F);
    if (state.selection == item) colour = palette.chosenBlock;
    pushBlock(out, blocks[i], kBlockHeightMetres, colour);
  }
  const double w = scene.widthMetres, d = scene.depthMetres, t = kWallThicknessMetres;
  for (const double x : {-t / 2, w + t / 2}) {
    pushBlock(out, {{x, d / 2}, {t, d + 2 * t}}, kWallHeightMetres, palette.wall);
  }
  for (const double z : {-t / 2, d + t / 2}) {
    pushBlock(out, {{w / 2, z}, {w, t}}, kWallHeightMetres, palette.wall);
  }
  return out;
}

void pushBody(std::vector<float>& out, const ShownBody& body) {
  for (const Capsule& capsule : body.capsules) {
    push(out, capsule.from.x(), capsule.from.y(), capsule.from.z(), capsule.fromRadius);
    push(out, capsule.to.x(), capsule.to.y(), capsule.to.z(), capsule.toRadius);
    push(out, body.colour.red, body.colour.green, body.colour.blue);
  }
}

const ShownBody* firstBody(const Picture& picture) {
  return picture.bodies.empty() ? nullptr : &picture.bodies.front();
}

Eigen::Matrix4f shadowMatrix(const Vec2& centre, double reach) {
  const Vec3 back = toSun();
  const Vec3 right = Vec3::UnitY().cross(back).normalized();
  const Vec3 up = back.cross(right);
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  const double deep = reach + 8.0;
  m.block<1, 3>(0, 0) = right.transpose() / reach;
  m.block<1, 3>(1, 0) = up.transpose() / reach;
  m.block<1, 3>(2, 0) = -back.transpose() / deep;
  const Vec3 middle(centre.x(), 0.0, centre.y());
  m.block<3, 1>(0, 3) = -(m.block<3, 3>(0, 0) * middle);
  return m.cast<float>();
}

}  // namespace

Result<SceneRenderer> SceneRenderer::create() {
  using namespace shaders;
  SceneRenderer made;
  const std::string plain = kCommon;
  const std::string lit = plain + kLighting;
  struct Wanted {
    GlProgram& program;
    const std::string& common;
    const char* vertex;
    const char* fragment;
  };
  const std::array<Wanted, 8> wanted = {{{made.sky_, plain, kSkyVertex, kSkyFragment},
                                         {made.floor_, lit, kFloorVertex, kFloorFragment},
                                         {made.block_, lit, kBlockVertex, kBlockFragment},
                                         {made.blockDepth_, plain, kBlockVertex, kDepthFragment},
                                         {made.body_, lit, kBodyVertex, kBodyFragment},
                                         {made.bodyDepth_, plain, kBodyVertex, kDepthFragment},
                                         {made.line_, plain, kLineVertex, kLineFragment},
                                         {made.mark_, plain, kMarkVertex, kMarkFragment}}};
  for (const Wanted& each : wanted) {
    Result<GlProgram> program = makeProgram(each.common, each.vertex, each.fragment);
    if (!program) return fail(std::move(program));
    each.program = std::move(*program);
  }
  static constexpr std::array<int, 1> kTwo = {2}, kFour = {4};
  static constexpr std::array<int, 2> kSix = {3, 3};
  static constexpr std::array<int, 3> kBlock = {4, 4, 3};
  static constexpr std::array<int, 4> kLine = {3, 3, 4, 2}, kMark = {3, 4, 4, 2};
  const MeshData quad = quadMesh(), cube = bevelledCubeMesh(), cone = roundConeMesh();
  made.quad_ = InstancedMesh(quad.vertices, quad.indices, {kTwo, {}});
  made.lineMesh_ = InstancedMesh(quad.vertices, quad.indices, {kTwo, kLine});
  made.markMesh_ = InstancedMesh(quad.vertices, quad.indices, {kTwo, kMark});
  made.blockMesh_ = InstancedMesh(cube.vertices, cube.indices, {kSix, kBlock});
  made.bodyMesh_ = InstancedMesh(cone.vertices, cone.indices, {kFour, kBlock});
  made.nearShadow_ = makeShadowMap();
  made.roomShadow_ = makeShadowMap();
  return made;
}

SceneRenderer::ShadowMap SceneRenderer::makeShadowMap() {
  ShadowMap map;
  map.depth = makeTexture();
  map.target = makeFramebuffer();
  glBindTexture(GL_TEXTURE_2D, map.depth.name());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, kShadowSize, kShadowSize);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glBindFramebuffer(GL_FRAMEBUFFER, map.target.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map.depth.name(), 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return map;
}

void SceneRenderer::draw(const Picture& picture) {
  Casters casters{blocksOf(picture.state), {}};
  for (std::size_t i = 1; i < picture.bodies.size(); ++i) pushBody(casters.bodies, picture.bodies[i]);
  drawShadowMaps(picture, casters);
  glViewport(0, 0, picture.size.width, picture.size.height);
  const Colour& back = paletteFor(picture.state.view.dark).horizon;
  glClearColor(back.red, back.green, back.blue, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  drawFloor(picture);
  drawBackground(picture);
  // Nothing but the floor is there yet: its marks need no depth test, and so never flicker against it.
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  drawMarks(picture, picture.marks.under);
  drawLines(picture);
  drawMarks(picture, picture.marks.over);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  drawBlocks(picture, casters.blocks);
  drawBodies(picture);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
}

void SceneRenderer::drawShadowMaps(const Picture& picture, const Casters& casters) {
  const Scene& scene = picture.state.shownScene();
  const double roomReach = 0.5 * std::hypot(scene.widthMetres, scene.depthMetres) + 1.5;
  drawShadowMap(roomShadow_, Vec2(scene.widthMetres / 2, scene.depthMetres / 2), roomReach, casters);
  // The near map follows the view in steps, so that it is drawn rarely and its texels stay in place.
  const CameraPose& pose = picture.state.camera.current;
  double reach = kSmallestShadowReachMetres;
  while (reach < 2.2 * pose.halfHeightMetres) reach *= 2.0;
  reach = std::min(reach, roomReach);
  const double step = reach / 4.0;
  drawShadowMap(nearShadow_, (pose.target / step).array().round().matrix() * step, reach, casters);
}

void SceneRenderer::drawShadowMap(ShadowMap& map, const Vec2& centre, double reachMetres,
                                  const Casters& casters) {
  if (casters == map.casters && centre == map.centre && reachMetres == map.reachMetres) return;
  map.casters = casters;
  map.centre = centre;
  map.reachMetres = reachMetres;
  map.mapFromWorld = shadowMatrix(centre, reachMetres);
  glBindFramebuffer(GL_FRAMEBUFFER, map.target.name());
  glViewport(0, 0, kShadowSize, kShadowSize);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  // Far sides cast the shadow, so that lit sides never shade themselves.
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  glUseProgram(blockDepth_.name());
  setMatrix(blockDepth_, "uClipFromWorld", map.mapFromWorld);
  blockMesh_.draw(casters.blocks, kBlockFloats);
  glUseProgram(bodyDepth_.name());
  setMatrix(bodyDepth_, "uClipFromWorld", map.mapFromWorld);
  bodyMesh_.draw(casters.bodies, kBodyFloats);
  glCullFace(GL_BACK);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void SceneRenderer::setLight(const GlProgram& program, const Picture& picture, const ShownBody* body) const {
  const Palette& palette = paletteFor(picture.state.view.dark);
  const Vec3 sun = toSun();
  setMatrix(program, "uClipFromWorld", picture.view.clipFromWorld.cast<float>());
  glUniform3f(uniformOf(program, "uToSun"), f(sun.x()), f(sun.y()), f(sun.z()));
  // The open floor receives exactly 1 of both together, so that its colour is the palette's.
  const float sunScale = f(0.66 / sun.y());
  glUniform3f(uniformOf(program, "uSunLight"), palette.sun.red * sunScale, palette.sun.green * sunScale,
              palette.sun.blue * sunScale);
  setColour(program, "uSkyLight", palette.sky);
  setMatrix(program, "uNearShadowFromWorld", nearShadow_.mapFromWorld);
  setMatrix(program, "uShadowFromWorld", roomShadow_.mapFromWorld);
  glUniform1f(uniformOf(program, "uShadowTexel"), 1.0F / kShadowSize);
  glUniform1i(uniformOf(program, "uNearShadowMap"), 0);
  glUniform1i(uniformOf(program, "uShadowMap"), 1);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, roomShadow_.depth.name());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, nearShadow_.depth.name());
  std::vector<float> from, to;
  Vec3 low = Vec3::Constant(1e9), high = Vec3::Constant(-1e9);
  const std::size_t count = body != nullptr ? std::min(body->capsules.size(), kMostCapsules) : 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Capsule& capsule = body->capsules[i];
    push(from, capsule.from.x(), capsule.from.y(), capsule.from.z(), capsule.fromRadius);
    push(to, capsule.to.x(), capsule.to.y(), capsule.to.z(), capsule.toRadius);
    low = low.cwiseMin(capsule.from).cwiseMin(capsule.to);
    high = high.cwiseMax(capsule.from).cwiseMax(capsule.to);
  }
  glUniform1i(uniformOf(program, "uCapsuleCount"), static_cast<GLint>(count));
  if (count == 0) {
    glUniform4f(uniformOf(program, "uBodySphere"), 0.0F, -1e4F, 0.0F, 0.0F);
    return;
  }
  glUniform4fv(uniformOf(program, "uCapsuleFrom"), static_cast<GLsizei>(count), from.data());
  glUniform4fv(uniformOf(program, "uCapsuleTo"), static_cast<GLsizei>(count), to.data());
  const Vec3 middle = (low + high) / 2;
  glUniform4f(uniformOf(program, "uBodySphere"), f(middle.x()), f(middle.y()), f(middle.z()),
              f((high - low).norm() / 2 + 0.12));
}

void SceneRenderer::drawBackground(const Picture& picture) {
  const Palette& palette = paletteFor(picture.state.view.dark);
  glUseProgram(sky_.name());
  setMatrix(sky_, "uWorldFromClip", picture.view.worldFromClip.cast<float>());
  const Vec3& eye = picture.view.eye;
  glUniform3f(uniformOf(sky_, "uEye"), f(eye.x()), f(eye.y()), f(eye.z()));
  setColour(sky_, "uHorizon", palette.horizon);
  setColour(sky_, "uZenith", palette.zenith);
  static constexpr std::array<float, 1> kOne = {0.0F};
  quad_.draw(kOne, 1);
}

void SceneRenderer::drawFloor(const Picture& picture) {
  const Palette& palette = paletteFor(picture.state.view.dark);
  const Scene& scene = picture.state.shownScene();
  glUseProgram(floor_.name());
  setLight(floor_, picture, firstBody(picture));
  glUniform2f(uniformOf(floor_, "uRoom"), f(scene.widthMetres), f(scene.depthMetres));
  glUniform1f(uniformOf(floor_, "uReach"), f(kFloorReachMetres + scene.widthMetres + scene.depthMetres));
  setColour(floor_, "uFloor", palette.floor);
  setColour(floor_, "uOutside", palette.outside);
  setColour(floor_, "uHorizon", palette.horizon);
  const Colour& line = palette.gridLine;
  glUniform4f(uniformOf(floor_, "uGridLine"), line.red, line.green, line.blue, line.alpha);
  static constexpr std::array<float, 1> kOne = {0.0F};
  quad_.draw(kOne, 1);
}

void SceneRenderer::drawMarks(const Picture& picture, const std::vector<Mark>& marks) {
  std::vector<float> out;
  out.reserve(marks.size() * kMarkFloats);
  for (const Mark& mark : marks) {
    push(out, mark.centre.x(), 0.0, mark.centre.y());
    push(out, mark.halfSize.x(), mark.halfSize.y(), mark.heading.sin, mark.heading.cos);
    push(out, mark.colour.red, mark.colour.green, mark.colour.blue, mark.colour.alpha);
    push(out, static_cast<int>(mark.kind), mark.parameter);
  }
  glUseProgram(mark_.name());
  setMatrix(mark_, "uClipFromWorld", picture.view.clipFromWorld.cast<float>());
  markMesh_.draw(out, kMarkFloats);
}

void SceneRenderer::drawLines(const Picture& picture) {
  std::vector<float> out;
  out.reserve(picture.marks.lines.size() * kLineFloats);
  for (const Line& line : picture.marks.lines) {
    push(out, line.from.x(), 0.0, line.from.y(), line.to.x(), 0.0, line.to.y());
    push(out, line.colour.red, line.colour.green, line.colour.blue, line.colour.alpha);
    push(out, line.widthMetres, line.leastPoints * picture.size.perPoint);
  }
  glUseProgram(line_.name());
  setMatrix(line_, "uClipFromWorld", picture.view.clipFromWorld.cast<float>());
  glUniform2f(uniformOf(line_, "uPixels"), f(picture.size.width), f(picture.size.height));
  glUniform1f(uniformOf(line_, "uPixelsPerMetre"), f(picture.view.focalScale * picture.size.height / 2));
  lineMesh_.draw(out, kLineFloats);
}

void SceneRenderer::drawBlocks(const Picture& picture, const std::vector<float>& blocks) {
  glUseProgram(block_.name());
  setLight(block_, picture, firstBody(picture));
  blockMesh_.draw(blocks, kBlockFloats);
}

void SceneRenderer::drawBodies(const Picture& picture) {
  const Palette& palette = paletteFor(picture.state.view.dark);
  glUseProgram(body_.name());
  const Vec3& eye = picture.view.eye;
  for (const ShownBody& body : picture.bodies) {
    std::vector<float> out;
    pushBody(out, body);
    setLight(body_, picture, &body);
    glUniform3f(uniformOf(body_, "uEye"), f(eye.x()), f(eye.y()), f(eye.z()));
    setColour(body_, "uFloor", palette.floor);
    bodyMesh_.draw(out, kBodyFloats);
  }
}

}  // namespace stridegraph
