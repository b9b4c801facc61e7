// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// Points as discs of one size in space, lit from where the viewer stands, on both sides.

export const vertexShader = /* glsl */ `
attribute vec4 tint;
uniform float diameter;       // in space
uniform float pixelsPerUnit;  // at distance 1, or anywhere without perspective
uniform float smallest;       // in pixels
uniform float largest;
uniform float light;          // how much of the brightness depends on the normal
uniform bool hideOutliers;
uniform bool sliced;
uniform vec4 plane;           // normal and offset of the middle of the slab
uniform vec2 reach;           // in front of and behind the plane
varying vec3 colour;
varying float corner;         // squared distance from the middle where a point ends

void main() {
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * eye;
  float far = isOrthographic ? 1.0 : max(-eye.z, 1e-6);
  gl_PointSize = clamp(diameter * pixelsPerUnit / far, smallest, largest);
  // Of a few pixels nobody sees the corners.
  corner = gl_PointSize > 4.0 ? 0.25 : 1.0;
  vec3 direction = normalize(normalMatrix * normal + vec3(0.0, 0.0, 1e-6));
  float facing = abs(dot(direction, normalize(vec3(0.25, 0.35, 0.9))));
  colour = tint.rgb * (1.0 - light + light * facing);
  bool hidden = hideOutliers && tint.a > 0.5;
  if (sliced) {
    float across = dot(position, plane.xyz) - plane.w;
    hidden = hidden || across > reach.x || across < -reach.y;
  }
  if (hidden) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
`;

export const fragmentShader = /* glsl */ `
varying vec3 colour;
varying float corner;
void main() {
  vec2 from = gl_PointCoord - 0.5;
  if (dot(from, from) > corner) discard;
  gl_FragColor = vec4(colour, 1.0);
}
`;
