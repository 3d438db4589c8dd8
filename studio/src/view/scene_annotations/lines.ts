/// Lines of the width that the film gives them, with dark edges, in one draw call. Each pixel has the
/// depth of the nearest point of its line.
import {
    DynamicDrawUsage, Float32BufferAttribute, InstancedBufferGeometry, InstancedInterleavedBuffer,
    InterleavedBufferAttribute, Mesh, ShaderMaterial,
} from 'three';
import {
    kCoreOnly, kEdgeOnly, kHead, kJoinsAfter, kJoinsBefore, kNumbersPerPiece, kRound,
} from './line_pieces';
import { kNowhere, kPlaces } from './shaders';
import type { SharedUniforms } from './uniforms';

// Of the edges (pipeline/picture/placed_shapes.cpp and scene_layer.cpp).
const kEdge = 0.0026; // picture heights
const kLeastEdge = 0.7; // pixels
const kEdgeOpacity = 0.75;
const kHeadWidth = 0.8; // of an arrowhead, of its length

const kVertexShader = `
attribute vec3 from;
attribute vec3 to;
attribute vec3 before;
attribute vec3 after;
attribute vec3 colour;
attribute vec3 edge;
attribute vec4 look; // opacity at both ends, width in picture heights, kind
flat varying vec4 ends; // pixels
flat varying vec4 joints; // along the line at its ends, where another one continues it
flat varying vec2 depths;
flat varying vec3 vColour;
flat varying vec3 vEdge;
flat varying vec4 vLook; // opacity at both ends, half the width in pixels, kind
flat varying float edgeWidth; // pixels
${kPlaces}

bool has(int kind, int what) {
    return (kind & what) != 0;
}
/// The point, or where the way from it to one in front of the camera comes in front of it.
vec3 inFront(vec3 place, vec3 other) {
    return isBehind(place) && !isBehind(other)
        ? mix(place, other, (-kNear - place.z) / (other.z - place.z)) : place;
}
vec2 towards(vec2 a, vec2 b, vec2 usual) {
    float far = distance(a, b);
    return far > 1e-3 ? (b - a) / far : usual;
}
void main() {
    int kind = int(look.w + 0.5);
    vec3 a = placeOf(from);
    vec3 b = placeOf(to);
    if (isBehind(a) && isBehind(b)) {
        gl_Position = ${kNowhere};
        return;
    }
    bool joinsBefore = has(kind, ${kJoinsBefore}) && !isBehind(a);
    bool joinsAfter = has(kind, ${kJoinsAfter}) && !isBehind(b);
    vec3 start = onCanvas(inFront(a, b));
    vec3 end = onCanvas(inFront(b, a));
    vec2 along = towards(start.xy, end.xy, vec2(1.0, 0.0));
    vec2 came = joinsBefore
        ? towards(onCanvas(inFront(placeOf(before), a)).xy, start.xy, along) : vec2(0.0);
    vec2 goes = joinsAfter
        ? towards(end.xy, onCanvas(inFront(placeOf(after), b)).xy, along) : vec2(0.0);
    joints = vec4(joinsBefore ? came + along : vec2(0.0), joinsAfter ? along + goes : vec2(0.0));
    ends = vec4(start.xy, end.xy);
    depths = vec2(start.z, end.z);
    vColour = colour;
    vEdge = edge;
    vLook = vec4(look.xy, 0.5 * look.z * height, look.w);
    edgeWidth = max(${kLeastEdge}, ${kEdge} * height);
    float half_ = has(kind, ${kHead})
        ? ${0.5 * kHeadWidth} * distance(start.xy, end.xy) : vLook.z;
    float reach = half_ + edgeWidth + 1.5;
    vec2 corner = mix(start.xy, end.xy, position.x)
        + reach * ((2.0 * position.x - 1.0) * along + position.y * vec2(-along.y, along.x));
    gl_Position = fromCanvas(corner, 0.0);
}`;

const kFragmentShader = `
flat varying vec4 ends;
flat varying vec4 joints;
flat varying vec2 depths;
flat varying vec3 vColour;
flat varying vec3 vEdge;
flat varying vec4 vLook;
flat varying float edgeWidth;

bool has(int kind, int what) {
    return (kind & what) != 0;
}
/// To an isosceles triangle (Quilez, "2D distance functions"), below 0 inside. p: from the tip, along
/// the height and across; far: the height; half_: half the base.
float fromHead(vec2 p, float far, float half_) {
    vec2 q = vec2(half_, far);
    p = vec2(abs(p.y), p.x);
    vec2 a = p - q * clamp(dot(p, q) / dot(q, q), 0.0, 1.0);
    vec2 b = p - q * vec2(clamp(p.x / q.x, 0.0, 1.0), 1.0);
    float side = max(p.x * q.y - p.y * q.x, p.y - q.y);
    return sqrt(min(dot(a, a), dot(b, b))) * sign(side);
}
void main() {
    int kind = int(vLook.w + 0.5);
    vec2 place = gl_FragCoord.xy - ends.xy;
    vec2 way = ends.zw - ends.xy;
    float far = length(way);
    vec2 along = far > 1e-3 ? way / far : vec2(1.0, 0.0);
    float gone = dot(place, along);
    // The pixels around a joint are shared out between both pieces.
    bool joinsBefore = joints.xy != vec2(0.0);
    bool joinsAfter = joints.zw != vec2(0.0);
    if ((joinsBefore && dot(place, joints.xy) < 0.0)
        || (joinsAfter && dot(gl_FragCoord.xy - ends.zw, joints.zw) >= 0.0)) {
        discard;
    }
    float share = far > 1e-3 ? clamp(gone / far, 0.0, 1.0) : 0.0;
    float away = length(place - share * way) - vLook.z; // from the line's side
    float cut = 1.0;
    if (has(kind, ${kHead})) {
        vec2 fromTip = vec2(far - gone, dot(place, vec2(-along.y, along.x)));
        away = fromHead(fromTip, far, ${0.5 * kHeadWidth} * far);
    } else if (!has(kind, ${kRound})) {
        cut = (joinsBefore ? 1.0 : clamp(gone + 0.5, 0.0, 1.0))
            * (joinsAfter ? 1.0 : clamp(far - gone + 0.5, 0.0, 1.0));
    }
    float core = has(kind, ${kEdgeOnly}) ? 0.0 : clamp(0.5 - away, 0.0, 1.0);
    float edge = has(kind, ${kCoreOnly}) ? 0.0
        : ${kEdgeOpacity} * clamp(0.5 + edgeWidth - away, 0.0, 1.0);
    float alpha = core + (1.0 - core) * edge;
    if (alpha * cut < 0.004) {
        discard;
    }
    vec3 colour = mix(vEdge, vColour, core / alpha);
    gl_FragColor = vec4(colour, alpha * cut * mix(vLook.x, vLook.y, share));
    gl_FragDepth = 0.5 + 0.5 * mix(depths.x, depths.y, share);
}`;

const kAttributes: readonly [string, number][] = [['from', 3], ['to', 3], ['before', 3], ['after', 3],
    ['colour', 3], ['edge', 3], ['look', 4]];

function geometryFor(numbers: Float32Array): InstancedBufferGeometry {
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(
        [0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0], 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const buffer = new InstancedInterleavedBuffer(numbers, kNumbersPerPiece)
        .setUsage(DynamicDrawUsage) as InstancedInterleavedBuffer;
    let offset = 0;
    for (const [name, size] of kAttributes) {
        geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, size, offset));
        offset += size;
    }
    return geometry;
}

export class Lines {
    readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
    private numbers = new Float32Array(64 * kNumbersPerPiece);

    constructor(uniforms: SharedUniforms) {
        this.mesh = new Mesh(geometryFor(this.numbers), new ShaderMaterial({
            vertexShader: kVertexShader, fragmentShader: kFragmentShader, uniforms: { ...uniforms },
            transparent: true, depthWrite: false,
        }));
        this.mesh.frustumCulled = false;
        this.mesh.raycast = () => {};
        this.mesh.visible = false;
    }

    get count(): number {
        return this.mesh.visible ? this.mesh.geometry.instanceCount : 0;
    }

    update(pieces: readonly number[]): void {
        if (pieces.length > this.numbers.length) {
            this.mesh.geometry.dispose();
            this.numbers = new Float32Array(2 * pieces.length);
            this.mesh.geometry = geometryFor(this.numbers);
        }
        this.numbers.set(pieces);
        this.mesh.geometry.instanceCount = pieces.length / kNumbersPerPiece;
        (this.mesh.geometry.getAttribute('from') as InterleavedBufferAttribute).data.needsUpdate = true;
        this.mesh.visible = pieces.length > 0;
    }

    dispose(): void {
        this.mesh.removeFromParent();
        this.mesh.geometry.dispose();
        this.mesh.material.dispose();
    }
}
