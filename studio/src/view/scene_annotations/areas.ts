/// Plane areas of annotations, in one draw call.
import {
    BufferGeometry, DoubleSide, Float32BufferAttribute, Mesh, ShaderMaterial, ShapeUtils, Vector2,
} from 'three';
import type { Triple } from '../../protocol';
import { cross } from '../../motion/vectors';
import { kPlaces } from './shaders';
import type { SharedUniforms } from './uniforms';

export interface ShownArea {
    corners: readonly Triple[];
    colour: Triple; // sRGB
    opacity: number;
}

const kVertexShader = `
attribute vec4 tint;
varying vec4 vTint;
${kPlaces}
void main() {
    vTint = tint;
    gl_Position = projectionMatrix * vec4(placeOf(position), 1.0);
}`;

const kFragmentShader = `
varying vec4 vTint;
void main() {
    gl_FragColor = vTint;
}`;

/// Corners of the triangles of an area, convex or not, as indices.
export function trianglesOf(corners: readonly Triple[]): number[] {
    // By Newell's method; the plane is looked at along the axis that its normal is nearest to.
    const normal: Triple = [0, 0, 0];
    corners.forEach((corner, i) => {
        cross(corner, corners[(i + 1) % corners.length] ?? corner)
            .forEach((value, axis) => { normal[axis] = (normal[axis] ?? 0) + value; });
    });
    const sizes = normal.map(Math.abs);
    const axis = sizes.indexOf(Math.max(...sizes));
    const contour = corners.map((corner) =>
        new Vector2(corner[(axis + 1) % 3] ?? 0, corner[(axis + 2) % 3] ?? 0));
    return ShapeUtils.triangulateShape(contour, []).flat();
}

export class Areas {
    readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;

    constructor(uniforms: SharedUniforms) {
        this.mesh = new Mesh(new BufferGeometry(), new ShaderMaterial({
            vertexShader: kVertexShader, fragmentShader: kFragmentShader, uniforms: { ...uniforms },
            transparent: true, depthWrite: false, side: DoubleSide, forceSinglePass: true,
        }));
        this.mesh.frustumCulled = false;
        this.mesh.raycast = () => {};
        this.mesh.visible = false;
    }

    update(areas: readonly ShownArea[]): void {
        this.mesh.visible = areas.length > 0;
        if (areas.length === 0) {
            return;
        }
        const places: number[] = [];
        const tints: number[] = [];
        const index: number[] = [];
        for (const { corners, colour, opacity } of areas) {
            const first = places.length / 3;
            index.push(...trianglesOf(corners).map((corner) => first + corner));
            corners.forEach((corner) => {
                places.push(...corner);
                tints.push(...colour, opacity);
            });
        }
        this.mesh.geometry.dispose();
        this.mesh.geometry = new BufferGeometry()
            .setAttribute('position', new Float32BufferAttribute(places, 3))
            .setAttribute('tint', new Float32BufferAttribute(tints, 4));
        this.mesh.geometry.setIndex(index);
    }

    dispose(): void {
        this.mesh.removeFromParent();
        this.mesh.geometry.dispose();
        this.mesh.material.dispose();
    }
}
