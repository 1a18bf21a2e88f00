/**
 * The shape is drawn from 32-bit words: input indices of landmarks, birth, deaths. Positions lie in textures that
 * are uploaded once a cloud; the step is a uniform. So neither a step nor a growing run uploads what is there.
 */

const COMMON = /* glsl */ `
precision highp float;
precision highp int;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform highp sampler2D uPositions;
uniform highp sampler2D uBeyond;
uniform bool uHasBeyond;
uniform mat4 uAxes;  // what of the first four coordinates points right, up and towards the eye
uniform mat4 uAxesBeyond;  // of the next four
uniform uint uStep;
uniform uint uTrack;
uniform float uRecent;  // the step of a moment ago while the film plays, else uStep
uniform vec2 uViewport;
uniform vec4 uCut;  // section plane: normal and offset in the scene; what lies beyond it is not drawn

vec3 positionOf(uint index) {
  ivec2 at = ivec2(int(index & 2047u), int(index >> 11));
  vec3 here = (uAxes * texelFetch(uPositions, at, 0)).xyz;
  return uHasBeyond ? here + (uAxesBeyond * texelFetch(uBeyond, at, 0)).xyz : here;
}
float cutOf(uint index) {
  return dot(uCut.xyz, positionOf(index)) - uCut.w;
}
vec3 viewOf(uint index) {
  return (modelViewMatrix * vec4(positionOf(index), 1.0)).xyz;
}
/** How much of the moment since uRecent had passed at a step: from 0 to 1 at uStep. */
float momentAt(uint step) {
  return clamp((float(step) - uRecent) / max(float(uStep) - uRecent, 1.0), 0.0, 1.0);
}
/** 1: lives; below: died a moment ago; 0: is not there. */
float presenceOf(uint birth, uvec2 death) {
  uint end = uTrack == 0u ? death.x : death.y;
  if (birth > uStep || birth >= end) return 0.0;
  return uStep < end ? 1.0 : 0.75 * momentAt(end);
}
const vec4 NOWHERE = vec4(2.0, 2.0, 2.0, 1.0);
`;

/** Depth as haze: what is far behind the middle of the unit sphere goes towards the background. */
const HAZE = /* glsl */ `
uniform float uDistance;
uniform float uHaze;  // 0 in the plane, 1 in space
float hazeAt(float depth) {
  return uHaze * smoothstep(-0.8, 1.2, depth - uDistance);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
precision highp int;
out vec4 outColor;
uniform float uByAge;  // 0: color by plateau, 1: by age
uniform vec3 uAccent;  // of what is new

/** Blue, gray, yellow: told apart by all eyes, and in print. Age 0 is the first landmark, 1 the newest. */
vec3 tinted(vec3 color, float age) {
  vec3 blue = vec3(0.16, 0.36, 0.68);
  vec3 gray = vec3(0.62, 0.62, 0.60);
  vec3 yellow = vec3(0.98, 0.84, 0.28);
  vec3 ramp = age < 0.5 ? mix(blue, gray, 2.0 * age) : mix(gray, yellow, 2.0 * age - 1.0);
  return mix(color, ramp, uByAge);
}
// Colors are mixed as on screen, not linearly: nothing after this shader converts them.
`;

/** An edge is a screen-aligned strip: lines of a chosen width do not exist in WebGL. */
export const EDGE_VERTEX = /* glsl */ `${COMMON}${HAZE}
in vec2 corner;  // which end (0, 1), which side (-1, 1)
in uvec3 simplex;  // two vertices, birth
in uvec2 death;
uniform float uWidth;
out float vHaze;
out float vSide;
out float vCut;
flat out float vAge;
flat out float vGlow;
flat out float vPresence;
const float NEAR = 0.02;

void main() {
  vGlow = momentAt(simplex.z);
  vPresence = presenceOf(simplex.z, death);
  if (vPresence <= 0.0) {
    gl_Position = NOWHERE;
    return;
  }
  vec3 a = viewOf(simplex.x);
  vec3 b = viewOf(simplex.y);
  if (a.z > -NEAR && b.z > -NEAR) {
    gl_Position = NOWHERE;
    return;
  }
  float cutA = cutOf(simplex.x);
  float cutB = cutOf(simplex.y);
  if (a.z > -NEAR) {
    float share = (-NEAR - b.z) / (a.z - b.z);
    a = mix(b, a, share);
    cutA = mix(cutB, cutA, share);
  }
  if (b.z > -NEAR) {
    float share = (-NEAR - a.z) / (b.z - a.z);
    b = mix(a, b, share);
    cutB = mix(cutA, cutB, share);
  }
  vec4 clipA = projectionMatrix * vec4(a, 1.0);
  vec4 clipB = projectionMatrix * vec4(b, 1.0);
  vec2 along = (clipB.xy / clipB.w - clipA.xy / clipA.w) * uViewport;
  float size = length(along);
  vec2 across = size > 0.0 ? vec2(-along.y, along.x) / size : vec2(1.0, 0.0);
  vec4 end = corner.x < 0.5 ? clipA : clipB;
  // One pixel more than the width is left for smooth sides.
  end.xy += across * corner.y * (uWidth + 1.0) / uViewport * end.w;
  end.z -= 0.0004 * end.w;
  gl_Position = end;
  vHaze = hazeAt(-(corner.x < 0.5 ? a : b).z);
  vCut = corner.x < 0.5 ? cutA : cutB;
  vAge = float(simplex.z) / float(uStep);
  vSide = corner.y * (uWidth + 1.0) * 0.5;
}
`;

export const EDGE_FRAGMENT = /* glsl */ `${FRAGMENT}
uniform vec3 uColor;
uniform vec3 uBackground;
uniform float uWidth;
in float vHaze;
in float vSide;
in float vCut;
flat in float vAge;
flat in float vGlow;
flat in float vPresence;

void main() {
  if (vCut > 0.0) discard;
  float alpha = vPresence * clamp(uWidth * 0.5 + 0.5 - abs(vSide), 0.0, 1.0);
  if (alpha < 0.05) discard;
  vec3 color = mix(tinted(uColor, vAge), uAccent, 0.9 * vGlow);
  outColor = vec4(mix(color, uBackground, vHaze * 0.75), alpha);
}
`;

/** One instance a triangle; its normal and its edges come from the three positions, not from shared vertices. */
export const TRIANGLE_VERTEX = /* glsl */ `${COMMON}${HAZE}
in float corner;
in uvec4 simplex;  // three vertices, birth
in uvec2 death;
out vec3 vNormal;
out vec3 vBarycentric;
out float vHaze;
out float vCut;
flat out float vAge;
flat out float vGlow;
flat out float vPresence;

void main() {
  vGlow = momentAt(simplex.w);
  vPresence = presenceOf(simplex.w, death);
  if (vPresence <= 0.0) {
    gl_Position = NOWHERE;
    return;
  }
  vec3 a = viewOf(simplex.x);
  vec3 b = viewOf(simplex.y);
  vec3 c = viewOf(simplex.z);
  vec3 n = cross(b - a, c - a);
  float size = length(n);
  vNormal = size > 0.0 ? n / size : vec3(0.0, 0.0, 1.0);
  vec3 here = corner < 0.5 ? a : corner < 1.5 ? b : c;
  vBarycentric = corner < 0.5 ? vec3(1, 0, 0) : corner < 1.5 ? vec3(0, 1, 0) : vec3(0, 0, 1);
  gl_Position = projectionMatrix * vec4(here, 1.0);
  vHaze = hazeAt(-here.z);
  vCut = cutOf(corner < 0.5 ? simplex.x : corner < 1.5 ? simplex.y : simplex.z);
  vAge = float(simplex.w) / float(uStep);
}
`;

export const TRIANGLE_FRAGMENT = /* glsl */ `${FRAGMENT}
uniform vec3 uFront;
uniform vec3 uBack;
uniform vec3 uLine;
uniform vec3 uBackground;
uniform vec2 uShown;  // 1 or 0 each: the inside, the sides
in vec3 vNormal;
in vec3 vBarycentric;
in float vHaze;
in float vCut;
flat in float vAge;
flat in float vGlow;
flat in float vPresence;

void main() {
  if (vCut > 0.0) discard;
  // What fades is drawn through a sieve: blending would need an order.
  float sieve = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  if (vPresence <= sieve) discard;
  vec3 n = gl_FrontFacing ? vNormal : -vNormal;
  float key = max(dot(n, normalize(vec3(-0.35, 0.55, 0.75))), 0.0);
  float fill = max(dot(n, normalize(vec3(0.7, -0.2, 0.45))), 0.0);
  vec3 color = tinted(gl_FrontFacing ? uFront : uBack, vAge) * (0.52 + 0.46 * key + 0.14 * fill);
  color = mix(color, uAccent, 0.55 * vGlow);
  color = mix(color, uBackground, vHaze * 0.3);
  // Where triangles are a few pixels wide their edges would only darken them.
  vec3 pixel = fwidth(vBarycentric);
  vec3 sides = smoothstep(vec3(0.0), pixel * 1.3, vBarycentric);
  float line = 1.0 - min(sides.x, min(sides.y, sides.z));
  float fade = 1.0 - smoothstep(0.12, 0.5, max(pixel.x, max(pixel.y, pixel.z)));
  if (uShown.x < 0.5 && line < 0.4) discard;
  float inked = uShown.x < 0.5 ? 1.0 : line * fade * 0.62;
  outColor = vec4(mix(color, uLine, inked * uShown.y), 1.0);
}
`;

export const WITNESS_VERTEX = /* glsl */ `${COMMON}${HAZE}
uniform float uSize;
out float vHaze;

void main() {
  if (cutOf(uint(gl_VertexID)) > 0.0) {
    gl_Position = NOWHERE;
    return;
  }
  vec3 here = viewOf(uint(gl_VertexID));
  gl_Position = projectionMatrix * vec4(here, 1.0);
  gl_PointSize = uSize;
  vHaze = hazeAt(-here.z);
}
`;

export const WITNESS_FRAGMENT = /* glsl */ `${FRAGMENT}
uniform vec3 uColor;
uniform float uAlpha;
in float vHaze;

void main() {
  float r = length(gl_PointCoord - 0.5);
  float alpha = uAlpha * (1.0 - 0.65 * vHaze) * (1.0 - smoothstep(0.32, 0.5, r));
  outColor = vec4(uColor, alpha);
}
`;

export const LANDMARK_VERTEX = /* glsl */ `${COMMON}${HAZE}
in uvec2 simplex;  // vertex, birth
uniform float uDiameter;  // in units of the scene
uniform vec2 uSizeRange;  // least and most, in pixels
out float vHaze;
out float vNew;
flat out float vAge;
flat out float vSize;

void main() {
  if (cutOf(simplex.x) > 0.0) {
    gl_Position = NOWHERE;
    return;
  }
  vAge = float(simplex.y) / float(uStep);
  vec3 here = viewOf(simplex.x);
  gl_Position = projectionMatrix * vec4(here, 1.0);
  gl_Position.z -= 0.0008 * gl_Position.w;
  float size = uDiameter * projectionMatrix[1][1] * uViewport.y * 0.5 / max(-here.z, 0.02);
  vNew = simplex.y == uStep ? 1.0 : momentAt(simplex.y);
  // Where landmarks are as close as dots are wide, smaller ones let the complex between them be seen.
  float least = clamp(1.5 * size, 0.4 * uSizeRange.x, uSizeRange.x);
  gl_PointSize = clamp(size, least, uSizeRange.y) * (1.0 + 0.6 * vNew);
  vSize = gl_PointSize;
  vHaze = hazeAt(-here.z);
}
`;

export const LANDMARK_FRAGMENT = /* glsl */ `${FRAGMENT}
uniform vec3 uColor;
uniform vec3 uBackground;
in float vHaze;
in float vNew;
flat in float vAge;
flat in float vSize;

void main() {
  vec2 at = (gl_PointCoord - 0.5) * 2.0;
  float r = dot(at, at);
  float inside = (1.0 - sqrt(r)) * 0.5 * vSize + 0.5;  // pixels from the rim
  if (inside <= 0.0) discard;
  vec3 n = vec3(at.x, -at.y, sqrt(max(0.0, 1.0 - r)));
  float light = 0.72 + 0.34 * max(dot(n, normalize(vec3(-0.35, 0.55, 0.75))), 0.0);
  outColor = vec4(mix(mix(tinted(uColor, vAge), uAccent, vNew) * light, uBackground, vHaze * 0.6), min(inside, 1.0));
}
`;
