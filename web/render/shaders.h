#pragma once

namespace stridegraph::shaders {

/// In front of every stage: colours are computed in linear light and leave as sRGB.
inline constexpr char kCommon[] = R"(
// The sRGB curve by polynomials of c and of its roots: within half a step of 255, at a fraction of the cost.
vec3 toLinear(vec3 c) { return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878); }
vec3 toDisplay(vec3 c) {
  vec3 a = sqrt(clamp(c, 0.0, 1.0));
  vec3 b = sqrt(a);
  return 0.662002687 * a + 0.684122060 * b - 0.323583601 * sqrt(b) - 0.0225411470 * c;
}
// Half a step of noise keeps wide, soft gradients free of bands.
vec3 dithered(vec3 c, vec2 pixel) {
  float n = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
  return c + (n - 0.5) / 255.0;
}
)";

/// Sun with the blocks' shadow map, and the body's own soft shadow and occlusion, computed exactly from its
/// capsules at every fragment: a foot that slides or floats is seen at once.
inline constexpr char kLighting[] = R"(
uniform vec3 uToSun;
uniform vec3 uSunLight;
uniform vec3 uSkyLight;
// Two maps of the blocks: a sharp one around the middle of the view, and one of the whole room.
uniform mat4 uNearShadowFromWorld;
uniform mat4 uShadowFromWorld;
uniform sampler2DShadow uNearShadowMap;
uniform sampler2DShadow uShadowMap;
uniform float uShadowTexel;
uniform vec4 uCapsuleFrom[40];
uniform vec4 uCapsuleTo[40];
uniform int uCapsuleCount;
uniform vec4 uBodySphere;

float shadowTaps(sampler2DShadow map, vec3 c) {
  vec2 r = vec2(uShadowTexel * 0.6, uShadowTexel * 1.5);
  return 0.25 * (texture(map, c + vec3(r.x, r.y, 0.0)) + texture(map, c + vec3(-r.y, r.x, 0.0)) +
                 texture(map, c + vec3(-r.x, -r.y, 0.0)) + texture(map, c + vec3(r.y, -r.x, 0.0)));
}

bool isInMap(vec3 c) { return all(greaterThan(c.xy, vec2(0.004))) && all(lessThan(c.xy, vec2(0.996))); }

float blockShadow(vec3 p, vec3 n) {
  vec4 from = vec4(p + n * 0.02, 1.0);
  vec3 c = (uNearShadowFromWorld * from).xyz * 0.5 + 0.5;
  c.z -= 0.0004;
  if (isInMap(c)) return shadowTaps(uNearShadowMap, c);
  c = (uShadowFromWorld * from).xyz * 0.5 + 0.5;
  c.z -= 0.0004;
  return isInMap(c) ? shadowTaps(uShadowMap, c) : 1.0;
}

// How much of the sun passes a capsule: the gap between ray and capsule over the way to it, as an angle,
// against the angle under which the sun appears.
float capsuleShadow(vec3 p, vec3 a, vec3 b, float radius) {
  const float kSunTangent = 0.14;
  vec3 ba = b - a;
  vec3 pa = p - a;
  float baba = dot(ba, ba) + 1e-6;
  float along = dot(ba, uToSun);
  float det = baba - along * along;
  float s = det > 1e-5 ? clamp((dot(pa, ba) - along * dot(pa, uToSun)) / det, 0.0, 1.0) : 0.5;
  float t = max(dot(a + s * ba - p, uToSun), 0.0);
  s = clamp(dot(p + t * uToSun - a, ba) / baba, 0.0, 1.0);
  vec3 q = a + s * ba;
  t = max(dot(q - p, uToSun), 0.0);
  float gap = length(p + t * uToSun - q) - radius;
  float width = max(t, 0.02) * kSunTangent + 0.004;
  return t <= 0.0 ? 1.0 : smoothstep(-width, width, gap);
}

float capsuleOcclusion(vec3 p, vec3 n, vec3 a, vec3 b, float radius) {
  vec3 ba = b - a;
  float s = clamp(dot(p - a, ba) / (dot(ba, ba) + 1e-6), 0.0, 1.0);
  vec3 d = a + s * ba - p;
  float l = length(d);
  return clamp(dot(n, d) / l, 0.0, 1.0) * radius * radius / max(l * l, radius * radius);
}

// x: share of the sun, y: share of the sky that the body leaves.
vec2 bodyLight(vec3 p, vec3 n, int skip) {
  vec3 d = uBodySphere.xyz - p;
  vec3 beside = d - max(dot(d, uToSun), 0.0) * uToSun;
  bool shadowed = dot(beside, beside) < (uBodySphere.w + 0.35) * (uBodySphere.w + 0.35);
  bool near = dot(d, d) < (uBodySphere.w + 0.8) * (uBodySphere.w + 0.8);
  vec2 lit = vec2(1.0);
  if (!shadowed && !near) return lit;
  for (int i = 0; i < 40; ++i) {
    if (i >= uCapsuleCount) break;
    if (i == skip) continue;
    vec4 a = uCapsuleFrom[i];
    vec4 b = uCapsuleTo[i];
    float radius = 0.5 * (a.w + b.w);
    if (shadowed) lit.x = min(lit.x, capsuleShadow(p, a.xyz, b.xyz, radius));
    if (near) lit.y *= 1.0 - 0.75 * capsuleOcclusion(p, n, a.xyz, b.xyz, radius);
  }
  return lit;
}

vec3 shade(vec3 albedo, vec3 p, vec3 n, vec2 body, float openness) {
  float facing = max(dot(n, uToSun), 0.0);
  float sun = facing > 0.0 ? facing * blockShadow(p, n) * body.x : 0.0;
  float sky = (0.72 + 0.28 * n.y) * body.y * openness;
  return albedo * (uSunLight * sun + uSkyLight * sky);
}
)";

inline constexpr char kSkyVertex[] = R"(
layout(location = 0) in vec2 aCorner;
uniform mat4 uWorldFromClip;
uniform vec3 uEye;
out vec3 vDirection;
void main() {
  vec4 far = uWorldFromClip * vec4(aCorner, 1.0, 1.0);
  vDirection = far.xyz / far.w - uEye;
  gl_Position = vec4(aCorner, 1.0, 1.0);
}
)";
inline constexpr char kSkyFragment[] = R"(
in vec3 vDirection;
uniform vec3 uHorizon;
uniform vec3 uZenith;
out vec4 oColour;
void main() {
  float up = max(normalize(vDirection).y, 0.0);
  oColour = vec4(dithered(mix(uHorizon, uZenith, smoothstep(0.0, 0.45, up)), gl_FragCoord.xy), 1.0);
}
)";

inline constexpr char kFloorVertex[] = R"(
layout(location = 0) in vec2 aCorner;
uniform mat4 uClipFromWorld;
uniform vec2 uRoom;
uniform float uReach;
out vec2 vFloor;
void main() {
  vFloor = uRoom * 0.5 + aCorner * uReach;
  gl_Position = uClipFromWorld * vec4(vFloor.x, 0.0, vFloor.y, 1.0);
}
)";
inline constexpr char kFloorFragment[] = R"(
in vec2 vFloor;
uniform vec2 uRoom;
uniform vec3 uFloor;
uniform vec3 uOutside;
uniform vec4 uGridLine;
uniform vec3 uHorizon;
out vec4 oColour;
// Share of a pixel that lines of a width cover, one line every `every` metres.
float lines(vec2 p, float every, float width, vec2 pixel) {
  vec2 q = abs(fract(p / every + 0.5) - 0.5) * every;
  vec2 cover = clamp((width * 0.5 - q) / pixel + 0.5, 0.0, 1.0) * min(vec2(1.0), width / pixel);
  vec2 calm = 1.0 - smoothstep(vec2(0.15), vec2(0.5), pixel / every);
  cover *= calm;
  return max(cover.x, cover.y);
}
void main() {
  vec2 pixel = max(fwidth(vFloor), vec2(1e-5));
  vec2 beyond = abs(vFloor - uRoom * 0.5) - uRoom * 0.5;
  float edge = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0);
  float inside = clamp(0.5 - edge / max(fwidth(edge), 1e-5), 0.0, 1.0);
  vec3 colour = mix(uOutside, uFloor, inside);
  float metre = lines(vFloor, 1.0, max(0.012, min(pixel.x, pixel.y)), pixel);
  float five = lines(vFloor, 5.0, max(0.03, 1.4 * min(pixel.x, pixel.y)), pixel);
  float grid = max(metre * 0.75, five) * mix(0.35, 1.0, inside);
  colour = mix(colour, uGridLine.rgb, grid * uGridLine.a);
  // Nothing casts a shadow far outside of the room: the open floor's light is 1 by the palette's measure.
  if (edge < 3.0) {
    vec3 p = vec3(vFloor.x, 0.0, vFloor.y);
    vec3 n = vec3(0.0, 1.0, 0.0);
    colour = toDisplay(shade(toLinear(colour), p, n, bodyLight(p, n, -1), 1.0));
  } else {
    colour = toDisplay(toLinear(colour) * (uSunLight * uToSun.y + uSkyLight));
  }
  float haze = smoothstep(0.0, 1.0, max(edge, 0.0) / (0.55 * max(uRoom.x, uRoom.y) + 4.0));
  oColour = vec4(dithered(mix(colour, uHorizon, haze), gl_FragCoord.xy), 1.0);
}
)";

/// A bevelled block: corners of a unit cube, pushed out to the instance's size less the bevel.
inline constexpr char kBlockVertex[] = R"(
layout(location = 0) in vec3 aCorner;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec4 aPlace;
layout(location = 3) in vec4 aSize;
layout(location = 4) in vec3 aColour;
uniform mat4 uClipFromWorld;
// A bevel may be narrower than a pixel: taken at pixel centres its normals would be far off.
centroid out vec3 vPoint;
centroid out vec3 vNormal;
flat out vec3 vColour;
void main() {
  float bevel = min(aSize.w, 0.45 * min(aSize.x, min(aSize.y, aSize.z)));
  vec3 half_ = aSize.xyz * 0.5;
  vec3 p = aCorner * (half_ - bevel) + aNormal * bevel;
  vPoint = aPlace.xyz + vec3(0.0, half_.y, 0.0) + p;
  vNormal = aNormal;
  vColour = aColour;
  gl_Position = uClipFromWorld * vec4(vPoint, 1.0);
}
)";
inline constexpr char kBlockFragment[] = R"(
centroid in vec3 vPoint;
centroid in vec3 vNormal;
flat in vec3 vColour;
out vec4 oColour;
void main() {
  vec3 n = normalize(vNormal);
  float foot = mix(0.62, 1.0, smoothstep(0.0, 0.55, vPoint.y));
  float openness = mix(foot, 1.0, max(n.y, 0.0));
  vec3 lit = shade(toLinear(vColour), vPoint, n, bodyLight(vPoint, n, -1), openness);
  oColour = vec4(dithered(toDisplay(lit), gl_FragCoord.xy), 1.0);
}
)";
inline constexpr char kDepthFragment[] = R"(
void main() {}
)";

/// A round cone: a unit sphere whose halves sit at both ends.
inline constexpr char kBodyVertex[] = R"(
layout(location = 0) in vec4 aShape;  // around the bone (x, z), share of the way to the pole, which end
layout(location = 1) in vec4 aFrom;
layout(location = 2) in vec4 aTo;
layout(location = 3) in vec3 aColour;
uniform mat4 uClipFromWorld;
out vec3 vPoint;
out vec3 vNormal;
flat out vec3 vColour;
flat out int vBone;
void main() {
  vec3 along = aTo.xyz - aFrom.xyz;
  float reach = length(along);
  vec3 y = reach > 1e-5 ? along / reach : vec3(0.0, 1.0, 0.0);
  vec3 x = normalize(abs(y.x) < 0.8 ? cross(vec3(1.0, 0.0, 0.0), y) : cross(vec3(0.0, 0.0, 1.0), y));
  vec3 z = cross(x, y);
  // The cone touches both spheres where the surface normal leans by the difference of the radii.
  float lean = clamp((aFrom.w - aTo.w) / max(reach, 1e-4), -0.9, 0.9);
  vec2 seam = vec2(sqrt(1.0 - lean * lean), lean);
  vec2 pole = vec2(0.0, aShape.w < 0.5 ? -1.0 : 1.0);
  vec2 slope = normalize(mix(seam, pole, aShape.z) + vec2(1e-5, 0.0));
  vec3 n = slope.x * (aShape.x * x + aShape.y * z) + slope.y * y;
  vPoint = (aShape.w < 0.5 ? aFrom.xyz + n * aFrom.w : aTo.xyz + n * aTo.w);
  vNormal = n;
  vColour = aColour;
  vBone = gl_InstanceID;
  gl_Position = uClipFromWorld * vec4(vPoint, 1.0);
}
)";
inline constexpr char kBodyFragment[] = R"(
in vec3 vPoint;
in vec3 vNormal;
flat in vec3 vColour;
flat in int vBone;
uniform vec3 uEye;
uniform vec3 uFloor;
out vec4 oColour;
void main() {
  vec3 n = normalize(vNormal);
  // Neighbouring bones overlap: ignore what lies at the surface itself, keep what stands off from it.
  vec2 around = bodyLight(vPoint + n * 0.035, n, vBone);
  around.x = mix(0.25, 1.0, around.x);
  around.y = mix(0.45, 1.0, around.y);
  vec3 albedo = toLinear(vColour);
  vec3 lit = shade(albedo, vPoint, n, around, 1.0);
  // Light that the floor throws back, strongest low on the body.
  float bounce = max(-n.y * 0.5 + 0.5, 0.0) * exp(-1.1 * max(vPoint.y, 0.0));
  lit += albedo * toLinear(uFloor) * 0.22 * bounce;
  vec3 toEye = normalize(uEye - vPoint);
  float rim = pow(1.0 - max(dot(n, toEye), 0.0), 3.0);
  lit += uSkyLight * rim * 0.28 * around.y;
  vec3 halfway = normalize(toEye + uToSun);
  lit += uSunLight * 0.06 * pow(max(dot(n, halfway), 0.0), 24.0) * around.x;
  oColour = vec4(dithered(toDisplay(lit), gl_FragCoord.xy), 1.0);
}
)";

/// Lines of a width in metres, never thinner than some pixels, with round ends and smooth edges.
inline constexpr char kLineVertex[] = R"(
layout(location = 0) in vec2 aCorner;
layout(location = 1) in vec3 aFrom;
layout(location = 2) in vec3 aTo;
layout(location = 3) in vec4 aColour;
layout(location = 4) in vec2 aWidth;  // metres, least pixels
uniform mat4 uClipFromWorld;
uniform vec2 uPixels;
uniform float uPixelsPerMetre;  // at a clip-space w of 1
flat out vec4 vEnds;
flat out vec2 vRadius;
flat out vec4 vColour;
void main() {
  vec4 a = uClipFromWorld * vec4(aFrom, 1.0);
  vec4 b = uClipFromWorld * vec4(aTo, 1.0);
  const float kNear = 0.05;
  if (a.w < kNear && b.w < kNear) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  if (a.w < kNear) a = mix(b, a, (b.w - kNear) / (b.w - a.w));
  if (b.w < kNear) b = mix(a, b, (a.w - kNear) / (a.w - b.w));
  vec2 pa = (a.xy / a.w * 0.5 + 0.5) * uPixels;
  vec2 pb = (b.xy / b.w * 0.5 + 0.5) * uPixels;
  vRadius = 0.5 * max(vec2(aWidth.y), aWidth.x * uPixelsPerMetre / vec2(a.w, b.w));
  vEnds = vec4(pa, pb);
  vColour = aColour;
  vec2 along = pb - pa;
  float reach = length(along);
  vec2 u = reach > 1e-4 ? along / reach : vec2(1.0, 0.0);
  vec2 v = vec2(-u.y, u.x);
  float r = max(vRadius.x, vRadius.y) + 1.0;
  vec2 p = (aCorner.x < 0.0 ? pa - u * r : pb + u * r) + v * aCorner.y * r;
  float w = aCorner.x < 0.0 ? a.w : b.w;
  float z = aCorner.x < 0.0 ? a.z : b.z;
  gl_Position = vec4((p / uPixels * 2.0 - 1.0) * w, z, w);
}
)";
inline constexpr char kLineFragment[] = R"(
flat in vec4 vEnds;
flat in vec2 vRadius;
flat in vec4 vColour;
out vec4 oColour;
void main() {
  vec2 ba = vEnds.zw - vEnds.xy;
  vec2 pa = gl_FragCoord.xy - vEnds.xy;
  float s = clamp(dot(pa, ba) / max(dot(ba, ba), 1e-6), 0.0, 1.0);
  float cover = clamp(mix(vRadius.x, vRadius.y, s) - length(pa - s * ba) + 0.5, 0.0, 1.0);
  if (cover <= 0.0) discard;
  oColour = vec4(vColour.rgb, vColour.a * cover);
}
)";

/// Flat marks on the floor, each a small signed distance field.
inline constexpr char kMarkVertex[] = R"(
layout(location = 0) in vec2 aCorner;
layout(location = 1) in vec3 aPlace;
layout(location = 2) in vec4 aForm;   // half size, heading as sin and cos
layout(location = 3) in vec4 aColour;
layout(location = 4) in vec2 aKind;   // which shape, its parameter
uniform mat4 uClipFromWorld;
out vec2 vLocal;
flat out vec4 vColour;
flat out vec4 vKind;
void main() {
  float margin = aKind.x > 3.5 && aKind.x < 4.5 ? aKind.y : 0.12 * max(aForm.x, aForm.y);
  vLocal = aCorner * (aForm.xy + margin);
  vec2 turned = vec2(vLocal.x * aForm.w + vLocal.y * aForm.z, vLocal.y * aForm.w - vLocal.x * aForm.z);
  vColour = aColour;
  vKind = vec4(aKind, aForm.xy);
  gl_Position = uClipFromWorld * vec4(aPlace + vec3(turned.x, 0.0, turned.y), 1.0);
}
)";
inline constexpr char kMarkFragment[] = R"(
in vec2 vLocal;
flat in vec4 vColour;
flat in vec4 vKind;
out vec4 oColour;
float box(vec2 p, vec2 b) { vec2 d = abs(p) - b; return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0); }
float taper(vec2 p, vec2 a, vec2 b, float ra, float rb) {
  vec2 ba = b - a;
  float s = clamp(dot(p - a, ba) / dot(ba, ba), 0.0, 1.0);
  return length(p - a - s * ba) - mix(ra, rb, s);
}
void main() {
  vec2 h = vKind.zw;
  int kind = int(vKind.x + 0.5);
  float d = 0.0;
  float stripes = 1.0;
  if (kind == 0) d = length(vLocal) - h.x;                       // disc
  else if (kind == 1) d = abs(length(vLocal) - h.x + vKind.y * 0.5) - vKind.y * 0.5;  // ring
  else if (kind == 2) {                                          // arrow head towards +z
    vec2 p = vec2(abs(vLocal.x), vLocal.y);
    vec2 side = normalize(vec2(2.0 * h.y, h.x));
    d = max(dot(p - vec2(0.0, h.y), side), -(p.y + h.y));
  } else if (kind == 3) {                                        // footprint, toes towards +z
    float sole = taper(vLocal, vec2(0.0, -0.62 * h.y), vec2(0.0, 0.48 * h.y), 0.62 * h.x, 0.98 * h.x);
    float arch = length(vLocal - vec2(vKind.y * 1.45 * h.x, -0.12 * h.y)) - 0.80 * h.x;
    d = max(sole, -arch);
  } else if (kind == 4) {                                        // soft shadow around a block's foot
    float out_ = max(box(vLocal, h), 0.0);
    float fall = clamp(1.0 - out_ / vKind.y, 0.0, 1.0);
    oColour = vec4(vColour.rgb, vColour.a * fall * fall);
    return;
  } else if (kind == 5) d = abs(box(vLocal, h)) - vKind.y * 0.5; // outline
  else {                                                         // area, with stripes that far apart if any
    d = box(vLocal, h);
    float across = (vLocal.x + vLocal.y) * 0.7071 / max(vKind.y, 1e-3);
    float stripe = abs(fract(across) - 0.5) * 2.0;
    float edge = max(2.0 * fwidth(across), 1e-4);
    float share = mix(0.35, 1.0, smoothstep(0.5 - edge, 0.5 + edge, stripe));
    // Stripes finer than pixels become their mean.
    stripes = vKind.y > 0.0 ? mix(share, 0.675, clamp(edge - 0.5, 0.0, 1.0)) : 1.0;
  }
  float cover = clamp(0.5 - d / max(fwidth(d), 1e-5), 0.0, 1.0);
  if (cover <= 0.0) discard;
  oColour = vec4(vColour.rgb, vColour.a * cover * stripes);
}
)";

}  // namespace stridegraph::shaders
