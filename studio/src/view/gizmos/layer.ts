/// Draws many figures with one draw call for each kind of thing in them.
import {
    Color, ConeGeometry, DynamicDrawUsage, InstancedMesh, Matrix4, MeshBasicMaterial,
    MeshLambertMaterial, Object3D, Quaternion, SphereGeometry, Vector3,
} from 'three';
import type { BufferGeometry, Material } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { ViewContext } from '../parts';
import { DotCloud } from './dot_cloud';
import { together, type Figure, type GhostBall, type Label, type Line, type Tip } from './figure';

const kTipSize = 13; // CSS pixels
const kAbove = 10; // drawn after everything else of the scene

/// Some figures by their names.
export class Layer {
    readonly group = new Object3D(); // drawn in the order of what is in it
    readonly figures = new Map<string, Figure>();
    draws = 0; // so far, for tests
    private readonly strong = makeLines(2.2, 1);
    private readonly faint = makeLines(1.4, 0.45);
    private readonly dots = new DotCloud();
    private tips = makeInstances(kTip, kTipMaterial, 0);
    private balls = makeInstances(kBall, kBallMaterial, 0);
    private whole: Figure = {};

    constructor(private readonly context: ViewContext) {
        this.group.add(this.faint, this.strong, this.dots.points, this.tips, this.balls);
        this.dots.points.renderOrder = kAbove + 2;
        context.scene.add(this.group);
    }

    get labels(): readonly Label[] {
        return this.whole.labels ?? [];
    }

    dispose(): void {
        this.group.removeFromParent();
        for (const drawn of [this.faint, this.strong, this.dots.points]) {
            drawn.geometry.dispose();
            drawn.material.dispose();
        }
        this.tips.dispose();
        this.balls.dispose();
    }

    draw(): void {
        this.draws += 1;
        this.whole = together(...this.figures.values());
        const lines = this.whole.lines ?? [];
        setLines(this.strong, lines.filter((line) => !line.isFaint));
        setLines(this.faint, lines.filter((line) => line.isFaint));
        this.dots.update(this.whole.dots ?? []);
        this.placeBalls(this.whole.balls ?? []);
        this.placeTips();
    }

    private placeBalls(balls: readonly GhostBall[]): void {
        this.balls = enough(this.balls, balls.length);
        balls.forEach((ball, i) => {
            this.balls.setMatrixAt(i, new Matrix4().makeScale(ball.radius, ball.radius, ball.radius)
                .setPosition(...ball.at));
            this.balls.setColorAt(i, new Color(ball.colour));
        });
        written(this.balls, balls.length);
    }

    placeTips(): void {
        const tips: readonly Tip[] = this.whole.tips ?? [];
        this.tips = enough(this.tips, tips.length);
        const up = new Vector3(0, 1, 0);
        tips.forEach((tip, i) => {
            const along = new Vector3(...tip.along).normalize();
            const size = (tip.size ?? kTipSize) * this.context.metresPerPixel(tip.at);
            const turn = new Quaternion().setFromUnitVectors(up, along);
            this.tips.setMatrixAt(i, new Matrix4().compose(
                new Vector3(...tip.at), turn, new Vector3(size, size, size)));
            this.tips.setColorAt(i, new Color(tip.colour));
        });
        written(this.tips, tips.length);
    }
}

/// A cone with its tip at the origin, along y.
const kTip = new ConeGeometry(0.36, 1, 12).translate(0, -0.5, 0);
const kTipMaterial = new MeshBasicMaterial({ depthTest: false, transparent: true });
const kBall = new SphereGeometry(1, 24, 16);
const kBallMaterial = new MeshLambertMaterial({
    transparent: true, opacity: 0.42, depthWrite: false,
});

type Instances = InstancedMesh<BufferGeometry, Material>;

function makeInstances(geometry: BufferGeometry, material: Material, count: number): Instances {
    const mesh = new InstancedMesh(geometry, material, Math.max(count, 4));
    mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    mesh.frustumCulled = false;
    mesh.renderOrder = kAbove + 1;
    mesh.count = 0;
    mesh.visible = false;
    // Without it the first colours would not be in the shader.
    mesh.setColorAt(0, new Color(0xffffff));
    return mesh;
}

/// The instances, or larger ones in their place.
function enough(mesh: Instances, count: number): Instances {
    if (count <= mesh.instanceMatrix.count) {
        return mesh;
    }
    const larger = makeInstances(mesh.geometry, mesh.material, 2 * count);
    mesh.parent?.add(larger);
    mesh.removeFromParent();
    mesh.dispose();
    return larger;
}

function written(mesh: Instances, count: number): void {
    mesh.count = count;
    mesh.visible = count > 0;
    mesh.instanceMatrix.needsUpdate = true;
    if (mesh.instanceColor) {
        mesh.instanceColor.needsUpdate = true;
    }
}

function makeLines(width: number, opacity: number): LineSegments2 {
    const lines = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({
        vertexColors: true, linewidth: width, transparent: true, opacity, depthTest: false,
    }));
    lines.frustumCulled = false;
    lines.visible = false;
    lines.renderOrder = kAbove;
    return lines;
}

function setLines(drawn: LineSegments2, lines: readonly Line[]): void {
    drawn.visible = lines.length > 0;
    if (lines.length === 0) {
        return;
    }
    drawn.geometry.dispose();
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(lines.flatMap(({ from, to }) => [...from, ...to]));
    geometry.setColors(lines.flatMap(({ colour }) => {
        const one = new Color(colour).toArray();
        return [...one, ...one];
    }));
    drawn.geometry = geometry;
}
