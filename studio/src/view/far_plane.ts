/// Continues the planes of the file, which are 40 m wide, to the horizon: in rings that grow, because
/// the graphics card computes the depth within very large triangles too coarsely.
import { BufferGeometry, Float32BufferAttribute, Mesh, type Object3D } from 'three';

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
        const far = new Mesh(rings(), plane.material);
        far.name = kName;
        far.raycast = () => {};
        plane.add(far);
    }
}
