/// The edges of the shot's meshes, drawn in place of their surfaces.
import {
    BufferGeometry, Color, EdgesGeometry, Float32BufferAttribute, LineBasicMaterial,
    LineSegments, Mesh, type Material, type Object3D,
} from 'three';
import type { ShotState } from '../protocol';
import type { ViewColours } from './theme_colours';

const kSmoothAngle = 25; // degrees between two triangles; more is an edge
const kCirclePieces = 48;

/// Three great circles, perpendicular to each other: they show how a ball turns.
function circles(radius: number): BufferGeometry {
    const points: number[] = [];
    for (let axis = 0; axis < 3; ++axis) {
        for (let piece = 0; piece < kCirclePieces; ++piece) {
            for (const end of [piece, piece + 1]) {
                const angle = (2 * Math.PI * end) / kCirclePieces;
                const place = [0, 0, 0];
                place[(axis + 1) % 3] = radius * Math.cos(angle);
                place[(axis + 2) % 3] = radius * Math.sin(angle);
                points.push(...place);
            }
        }
    }
    return new BufferGeometry().setAttribute('position', new Float32BufferAttribute(points, 3));
}

function setSurfaces(of: Object3D, isVisible: boolean): void {
    of.traverse((part) => {
        for (const material of part instanceof Mesh ? [part.material as Material].flat() : []) {
            material.visible = isVisible; // rays meet it all the same
        }
    });
}

export class Wires {
    private readonly lines: LineSegments[] = [];
    private readonly materials: LineBasicMaterial[] = [];
    private material = new LineBasicMaterial();
    private of: Object3D | null = null;

    /// Shows the edges of everything in `of` instead of its surfaces; null: surfaces again.
    show(of: Object3D | null, colours: ViewColours, shot: ShotState | null): void {
        this.clear();
        if (!of) {
            return;
        }
        const plain = this.paint(new Color(colours.faint));
        this.of = of;
        setSurfaces(of, false);
        const balls = new Map(shot?.objects.filter((one) => one.kind === 'ball')
            .map((ball) => [ball.name, ball]));
        for (const node of of.children) {
            const ball = balls.get(String(node.userData['name'] ?? node.name));
            this.material = ball
                ? this.paint(new Color(...ball.colour).lerp(new Color(colours.text), 0.35)) : plain;
            if (ball) {
                this.add(node, circles(ball.radius));
            } else {
                this.addEdges(node);
            }
        }
    }

    private paint(color: Color): LineBasicMaterial {
        const material = new LineBasicMaterial({ color });
        this.materials.push(material);
        return material;
    }

    private addEdges(node: Object3D): void {
        const meshes: Mesh[] = [];
        node.traverse((part) => {
            if (part instanceof Mesh) {
                meshes.push(part);
            }
        });
        meshes.forEach((mesh) => this.add(mesh, new EdgesGeometry(mesh.geometry, kSmoothAngle)));
    }

    private add(parent: Object3D, geometry: BufferGeometry): void {
        const lines = new LineSegments(geometry, this.material);
        lines.raycast = () => {};
        parent.add(lines);
        this.lines.push(lines);
    }

    private clear(): void {
        for (const lines of this.lines.splice(0)) {
            lines.removeFromParent();
            lines.geometry.dispose();
        }
        this.materials.splice(0).forEach((material) => material.dispose());
        if (this.of) {
            setSurfaces(this.of, true);
            this.of = null;
        }
    }
}
