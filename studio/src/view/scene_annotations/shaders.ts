/// What the shaders of annotations share. Colours are sRGB already, as the film's are when
/// annotations are drawn on it.

/// Places in the camera's coordinates, a little nearer than they are, so that the surfaces in which
/// they lie do not hide them; and where they are on the canvas: pixels from its lower left corner,
/// and the depth, which is linear there.
export const kPlaces = `
uniform vec2 size; // of the canvas, pixels
uniform float height; // of the picture, pixels
const float kNear = 0.02; // m
const float kNearer = 5e-5; // of the distance, or of a metre

bool hasPerspective() {
    return projectionMatrix[3][3] == 0.0;
}
vec3 placeOf(vec3 point) {
    vec3 at = (modelViewMatrix * vec4(point, 1.0)).xyz;
    return hasPerspective() ? at * (1.0 - kNearer) : at + vec3(0.0, 0.0, kNearer);
}
bool isBehind(vec3 place) {
    return hasPerspective() && place.z > -kNear;
}
vec3 onCanvas(vec3 place) {
    vec4 clip = projectionMatrix * vec4(place, 1.0);
    vec3 seen = clip.xyz / clip.w;
    return vec3((0.5 + 0.5 * seen.xy) * size, seen.z);
}
vec4 fromCanvas(vec2 pixel, float depth) {
    return vec4(2.0 * pixel / size - 1.0, depth, 1.0);
}`;

/// Nothing is drawn.
export const kNowhere = 'vec4(2.0, 2.0, 2.0, 1.0)';
