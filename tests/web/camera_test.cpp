#include "state/camera.h"

#include <gtest/gtest.h>

#include <numbers>

#include "math/random.h"

namespace stridegraph {
namespace {

constexpr Viewport kViewport{1280.0, 720.0, 250.0, 250.0, 60.0, 80.0};

TEST(Camera, raysMeetTheFloorWherePointsAreShown) {
  Random random(5);
  const CameraView view = viewOf(poseOverRoom(20.0, 12.0, kViewport), kViewport);
  for (int i = 0; i < 100; ++i) {
    const Vec2 floor(random.uniform(0.0, 20.0), random.uniform(0.0, 12.0));
    const std::optional<Vec2> shown = view.project({floor.x(), 0.0, floor.y()});
    ASSERT_TRUE(shown);
    const std::optional<Vec2> met = meetPlane(view.rayAt(*shown), 0.0);
    ASSERT_TRUE(met);
    EXPECT_LT((*met - floor).norm(), 1e-6);
  }
}

TEST(Camera, showsTheWholeRoomBetweenThePanels) {
  for (const Vec2& room : {Vec2(20.0, 12.0), Vec2(6.0, 30.0), Vec2(60.0, 60.0)}) {
    for (const CameraPose& pose :
         {poseOverRoom(room.x(), room.y(), kViewport), poseAboveRoom(room.x(), room.y(), kViewport)}) {
      const CameraView view = viewOf(pose, kViewport);
      for (const Vec2& corner : {Vec2(0.0, 0.0), Vec2(room.x(), 0.0), Vec2(0.0, room.y()), room}) {
        const std::optional<Vec2> shown = view.project({corner.x(), 0.0, corner.y()});
        ASSERT_TRUE(shown);
        EXPECT_GE(shown->x(), kViewport.left);
        EXPECT_LE(shown->x(), kViewport.width - kViewport.right);
        EXPECT_GE(shown->y(), kViewport.top);
        EXPECT_LE(shown->y(), kViewport.height - kViewport.bottom);
      }
    }
  }
}

TEST(Camera, plansHaveXToTheRightAndZDownwards) {
  const CameraView view = viewOf(poseAboveRoom(10.0, 10.0, kViewport), kViewport);
  const Vec2 corner = *view.project({0.0, 0.0, 0.0});
  EXPECT_GT(view.project({1.0, 0.0, 0.0})->x(), corner.x() + 10.0);
  EXPECT_GT(view.project({0.0, 0.0, 1.0})->y(), corner.y() + 10.0);
}

TEST(Camera, zoomKeepsTheFloorPointUnderThePointer) {
  Camera camera;
  camera.wanted = poseAboveRoom(10.0, 10.0, kViewport);
  const Vec2 about(2.0, 3.0);
  const Vec2 before = *viewOf(camera.wanted, kViewport).project({about.x(), 0.0, about.y()});
  zoom(camera, 0.5, about);
  const Vec2 after = *viewOf(camera.wanted, kViewport).project({about.x(), 0.0, about.y()});
  EXPECT_LT((after - before).norm(), 0.5);
}

TEST(Camera, glidesToWhereItIsWantedAndRests) {
  Camera camera;
  camera.wanted = poseOverRoom(20.0, 12.0, kViewport);
  int frames = 0;
  while (glide(camera, 1.0 / 60.0) && frames < 600) ++frames;
  EXPECT_LT(frames, 300);
  EXPECT_EQ(camera.current.target, camera.wanted.target);
  EXPECT_EQ(camera.current.halfHeightMetres, camera.wanted.halfHeightMetres);
}

TEST(Camera, neverTurnsBelowTheFloorOrOverTheTop) {
  Camera camera;
  turn(camera, Vec2(0.0, 1e5));
  EXPECT_LT(camera.wanted.pitchRadians, std::numbers::pi / 2.0);
  turn(camera, Vec2(0.0, -1e5));
  EXPECT_GT(camera.wanted.pitchRadians, 0.0);
}

TEST(Camera, metresPerPointMatchesWhatIsShown) {
  const CameraView view = viewOf(poseAboveRoom(10.0, 10.0, kViewport), kViewport);
  const Vec3 middle(5.0, 0.0, 5.0);
  const double points = (*view.project({6.0, 0.0, 5.0}) - *view.project(middle)).norm();
  EXPECT_NEAR(view.metresPerPoint(middle), 1.0 / points, 1e-3 / points);
}

}  // namespace
}  // namespace stridegraph
