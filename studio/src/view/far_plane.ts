/// Continues the planes of the file, which are 40 m wide, to the horizon: in rings that grow, because
/// the graphics card computes the depth within very large triangles too coarsely.
import {
    BufferGeometry, Float32BufferAttribute, Mesh, type BufferAttribute, type InterleavedBufferAttribute,
    type Object3D,
} from 'three';

const kHalf = 20; // m, of a plane in the file
const kRings = [kHalf, 200, 2000, 20000]; // m, half the edge of each ring
const kName = 'far plane';

/// A level plane without its middle, y upwards.
function rings(): BufferGeometry {
    const points: number[] = [];
    const faces: number[] = [];
    for (const half of kRings) {
        points.push(-half, 0, -half, -half, 0, half, half, 0, half, half, 0, -half);
    }
    for (let ring = 0; ring + 1 < kRings.length; ++ring) {
        for (let corner = 0; corner < 4; ++corner) {
            const [a, b] = [4 * ring + corner, 4 * ring + (corner + 1) % 4];
            faces.push(a, a + 4, b + 4, a, b + 4, b);
        }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
    geometry.setIndex(faces);
    geometry.computeVertexNormals();
    return geometry;
}

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/// The coordinates of textures on a flat rectangle, continued to other points of its plane.
function continued(uv: Attribute, corners: Attribute, points: Attribute): Float32BufferAttribute {
    // Corners 0, 1 and 3 have a right angle at corner 0.
    const along = (corner: number): readonly [number, number] => [
        corners.getX(corner) - corners.getX(0), corners.getZ(corner) - corners.getZ(0)];
    const edges = [1, 3].map((corner) => {
        const [x, z] = along(corner);
        return { corner, x, z, length2: x * x + z * z };
    });
    const values: number[] = [];
    for (let i = 0; i < points.count; ++i) {
        const x = points.getX(i) - corners.getX(0);
        const z = points.getZ(i) - corners.getZ(0);
        let [u, v] = [uv.getX(0), uv.getY(0)];
        for (const edge of edges) {
            const part = (x * edge.x + z * edge.z) / edge.length2;
            u += part * (uv.getX(edge.corner) - uv.getX(0));
            v += part * (uv.getY(edge.corner) - uv.getY(0));
        }
        values.push(u, v);
    }
    return new Float32BufferAttribute(values, 2);
}

/// What continues a plane, with the coordinates of its textures.
export function ringsAround(plane: BufferGeometry): BufferGeometry {
    const geometry = rings();
    const corners = plane.getAttribute('position');
    for (const name of ['uv', 'uv1', 'uv2', 'uv3']) {
        const uv = plane.getAttribute(name) as Attribute | undefined;
        if (uv && corners.count === 4) {
            geometry.setAttribute(name, continued(uv, corners, geometry.getAttribute('position')));
        }
    }
    return geometry;
}

/// Continues the plane of a node of the file, once.
export function reachHorizon(node: Object3D): void {
    if (node.getObjectByName(kName)) {
        return;
    }
    const planes: Mesh[] = [];
    node.traverse((part) => {
        if (part instanceof Mesh) {
            planes.push(part);
        }
    });
    for (const plane of planes) {
        const far = new Mesh(ringsAround(plane.geometry as BufferGeometry), plane.material);
        far.name = kName;
        far.raycast = () => {};
        plane.add(far);
    }
}
