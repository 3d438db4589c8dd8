/// The numbers on the balls, where the renderer paints them: in the middle of both discs. The meshes
/// of the server have the discs without figures.
import {
    BufferGeometry, CanvasTexture, Float32BufferAttribute, Group, Matrix4, Mesh, MeshLambertMaterial, SRGBColorSpace,
    type Object3D,
} from 'three';
import type { SceneObject, ShotState } from '../protocol';

const kDiscRadius = 0.385; // in ball radii, as in render/scene/material_description.h
const kAbove = 1.012; // in ball radii: in front of the disc
const kPieces = 6; // of a patch's side
const kPixels = 64; // of a figure's side
const kInk = '#12100f';

/// A ball's two patches, on the unit sphere in the axes of the file (y up): seen from +x the right-hand
/// side is the ball's +y, which is the file's -z; the figure on the other side stands on its head.
export function figurePatches(): BufferGeometry {
    const places: number[] = [];
    const uvs: number[] = [];
    const indices: number[] = [];
    for (const side of [1, -1]) {
        const first = places.length / 3;
        for (let i = 0; i <= kPieces; ++i) {
            for (let k = 0; k <= kPieces; ++k) {
                const [u, v] = [i / kPieces, k / kPieces];
                const [right, up] = [(2 * u - 1) * kDiscRadius, (2 * v - 1) * kDiscRadius];
                places.push(side * Math.sqrt(1 - right * right - up * up), side * up, -right);
                uvs.push(u, v);
            }
        }
        for (let i = 0; i < kPieces; ++i) {
            for (let k = 0; k < kPieces; ++k) {
                const at = first + i * (kPieces + 1) + k;
                const next = at + kPieces + 1;
                indices.push(at, next, at + 1, at + 1, next, next + 1);
            }
        }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(places, 3));
    geometry.setAttribute('normal', new Float32BufferAttribute(places, 3));
    geometry.setAttribute('uv', new Float32BufferAttribute(uvs, 2));
    geometry.setIndex(indices);
    return geometry;
}

function pictureOf(number: number): CanvasTexture {
    const canvas = document.createElement('canvas');
    canvas.width = kPixels;
    canvas.height = kPixels;
    const pen = canvas.getContext('2d');
    if (pen) {
        pen.fillStyle = kInk;
        pen.font = `bold ${number < 10 ? 34 : 27}px sans-serif`;
        pen.textAlign = 'center';
        pen.textBaseline = 'middle';
        pen.fillText(String(number), kPixels / 2, kPixels / 2 + 2);
        if (number === 6 || number === 9) {
            pen.fillRect(kPixels / 2 - 9, kPixels - 14, 18, 3);
        }
    }
    const texture = new CanvasTexture(canvas);
    texture.colorSpace = SRGBColorSpace;
    return texture;
}

/// The balls that have a figure, as one text: the figures are made anew when it changes.
function keyOf(balls: readonly SceneObject[]): string {
    return balls.map(({ name, number, radius }) => `${name} ${number} ${radius}`).join('\n');
}

export class BallFigures {
    /// In world axes.
    readonly group = new Group();
    private readonly geometry = figurePatches();
    private shown: { patch: Mesh<BufferGeometry, MeshLambertMaterial>; ball: SceneObject }[] = [];
    private key = '';

    /// Makes the figures of a shot's balls.
    take(shot: ShotState): void {
        const balls = shot.objects.filter(({ kind, number }) => kind === 'ball' && number);
        if (keyOf(balls) === this.key) {
            return;
        }
        this.clear();
        this.key = keyOf(balls);
        this.shown = balls.map((ball) => {
            const material = new MeshLambertMaterial({
                map: pictureOf(ball.number ?? 0), transparent: true, depthWrite: false,
            });
            const patch = new Mesh(this.geometry, material);
            patch.matrixAutoUpdate = false;
            patch.raycast = () => {};
            this.group.add(patch);
            return { patch, ball };
        });
    }

    /// Puts them on the balls' meshes, whose matrices have to be up to date.
    place(nodeOf: (name: string) => Object3D | undefined, areSurfaces: boolean): void {
        const size = new Matrix4();
        for (const { patch, ball } of this.shown) {
            const node = nodeOf(ball.name);
            patch.visible = areSurfaces && node !== undefined && node.visible;
            if (node) {
                size.makeScale(kAbove * ball.radius, kAbove * ball.radius, kAbove * ball.radius);
                patch.matrix.copy(node.matrixWorld).multiply(size);
                patch.matrixWorldNeedsUpdate = true;
            }
        }
    }

    clear(): void {
        this.key = '';
        for (const { patch } of this.shown.splice(0)) {
            patch.removeFromParent();
            patch.material.map?.dispose();
            patch.material.dispose();
        }
    }

    dispose(): void {
        this.clear();
        this.geometry.dispose();
    }
}
