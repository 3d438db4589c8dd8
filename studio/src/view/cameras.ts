/// The cameras of the view: the free one, that of the plan, and one that follows a camera of the shot.
import { MOUSE, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { cameraAxes, type CameraPose } from '../motion/camera';
import type { Triple } from '../protocol';
import { freePose, viewMoving } from '../state/state';
import { fovOfView, type Rectangle } from './letterbox';
import type { ViewCamera } from './parts';

const kNear = 0.01; // m
const kFar = 20000; // m; where the horizon of a floor is
const kFlatDepth = 100; // m, before and behind an orthographic camera
const kFov = 40; // degrees, of the free view
const kMargin = 1.08; // of what is framed
const kClosest = 0.05; // m, to what is framed

/// A box in the world.
export interface Bounds {
    low: Triple;
    high: Triple;
}

function cornersOf({ low, high }: Bounds): Vector3[] {
    return Array.from({ length: 8 }, (_, corner) => new Vector3(
        (corner & 1 ? high : low)[0], (corner & 2 ? high : low)[1], (corner & 4 ? high : low)[2]));
}

export class Cameras {
    readonly free = new PerspectiveCamera(kFov, 1, kNear, kFar);
    readonly flat = new OrthographicCamera(-1, 1, 1, -1, -kFlatDepth, kFlatDepth);
    readonly through = new PerspectiveCamera(kFov, 1, kNear, kFar);
    readonly orbit: OrbitControls;
    readonly pan: OrbitControls; // of the orthographic one
    size = { width: 1, height: 1 };
    /// The one that is looked through.
    current: ViewCamera = this.free;
    private own: ViewCamera = this.free; // while no camera of the shot is looked through
    private film: Rectangle | null = null; // while one is

    constructor(canvas: HTMLCanvasElement, changed: () => void) {
        this.free.up.set(0, 0, 1);
        this.orbit = new OrbitControls(this.free, canvas);
        this.orbit.mouseButtons = { LEFT: MOUSE.ROTATE, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.PAN };
        this.pan = new OrbitControls(this.flat, canvas);
        this.pan.enableRotate = false;
        this.pan.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.PAN };
        for (const controls of [this.orbit, this.pan]) {
            controls.zoomToCursor = true;
            controls.addEventListener('change', changed);
            controls.addEventListener('start', () => { viewMoving.value = true; });
            controls.addEventListener('end', () => { viewMoving.value = false; });
        }
        this.use(this.free);
    }

    /// Whether the view's own camera is the orthographic one.
    get isFlat(): boolean {
        return this.own === this.flat;
    }

    /// In CSS pixels.
    resize(width: number, height: number): void {
        this.size = { width: Math.max(1, width), height: Math.max(1, height) };
        const aspect = this.size.width / this.size.height;
        this.free.aspect = aspect;
        this.through.aspect = aspect;
        this.flat.left = -this.flat.top * aspect;
        this.flat.right = this.flat.top * aspect;
        for (const camera of [this.free, this.through, this.flat]) {
            camera.updateProjectionMatrix();
        }
    }

    /// Looks with perspective from a place at another.
    lookFrom(position: Triple, target: Triple): void {
        this.free.position.set(...position);
        this.orbit.target.set(...target);
        this.own = this.free;
        this.orbit.update();
        this.use(this.free);
    }

    /// Looks along a direction, orthographic, so that the box fills the view.
    lookAlong(direction: Triple, up: Triple, box: Bounds): void {
        const middle = new Vector3(...box.low).add(new Vector3(...box.high)).divideScalar(2);
        const axis = new Vector3(...direction).normalize();
        this.flat.up.set(...up);
        this.flat.position.copy(middle).addScaledVector(axis, -10);
        this.pan.target.copy(middle);
        this.flat.lookAt(middle);
        this.own = this.flat;
        this.use(this.flat);
        this.fitFlat(box);
    }

    /// Shows the box as large as it fits, in the direction that is looked in now.
    frame(box: Bounds): void {
        if (this.isFlat) {
            const axis = this.flat.getWorldDirection(new Vector3());
            this.lookAlong(axis.toArray(), this.flat.up.toArray(), box);
            return;
        }
        const back = this.free.position.clone().sub(this.orbit.target).normalize();
        const middle = new Vector3(...box.low).add(new Vector3(...box.high)).divideScalar(2);
        const right = new Vector3(0, 0, 1).cross(back).normalize();
        const up = back.clone().cross(right);
        const tangent = Math.tan((this.free.fov * Math.PI) / 360);
        const distance = Math.max(kClosest, ...cornersOf(box).map((corner) => {
            const from = corner.sub(middle);
            const wide = Math.abs(from.dot(right)) / this.free.aspect;
            return (Math.max(wide, Math.abs(from.dot(up))) * kMargin) / tangent + from.dot(back);
        }));
        const position = middle.clone().addScaledVector(back, distance);
        this.lookFrom(position.toArray(), middle.toArray());
    }

    /// Looks as a camera of the shot does, whose picture fills the rectangle.
    lookThrough(pose: CameraPose, film: Rectangle): void {
        const { right, up, back } = cameraAxes(pose);
        this.through.matrix.set(
            right[0], up[0], back[0], 0, right[1], up[1], back[1], 0,
            right[2], up[2], back[2], 0, 0, 0, 0, 1);
        this.through.quaternion.setFromRotationMatrix(this.through.matrix);
        this.through.position.set(...pose.position);
        this.through.fov = (fovOfView(pose.verticalFov, this.size.height, film) * 180) / Math.PI;
        this.through.updateProjectionMatrix();
        this.film = film;
        freePose.value = null;
        this.use(this.through);
    }

    /// Looks as a camera that is being moved.
    lookHeld(camera: PerspectiveCamera): void {
        this.use(camera);
    }

    /// Looks with the view's own camera.
    lookFreely(): void {
        this.film = null;
        this.use(this.own);
        const controls = this.isFlat ? this.pan : this.orbit;
        freePose.value = {
            position: this.own.position.toArray(), target: controls.target.toArray(),
            up: this.own.up.toArray(), orthographic: this.isFlat,
            fov: this.isFlat ? 0 : (this.free.fov * Math.PI) / 180,
            height: this.isFlat ? (2 * this.flat.top) / this.flat.zoom : 0,
        };
    }

    /// The film's rectangle, or the whole view.
    box(): Rectangle {
        return this.film ?? { left: 0, top: 0, ...this.size };
    }

    dispose(): void {
        this.orbit.dispose();
        this.pan.dispose();
    }

    private use(camera: ViewCamera): void {
        this.current = camera;
        this.orbit.enabled = camera === this.free;
        this.pan.enabled = camera === this.flat;
        camera.updateMatrixWorld();
    }

    /// The half height of what is seen, so that the box fits; the camera looks at its middle.
    private fitFlat(box: Bounds): void {
        this.flat.updateMatrixWorld();
        const extent: [number, number] = [0, 0];
        for (const corner of cornersOf(box)) {
            const at = corner.applyMatrix4(this.flat.matrixWorldInverse);
            extent[0] = Math.max(extent[0], Math.abs(at.x));
            extent[1] = Math.max(extent[1], Math.abs(at.y));
        }
        const aspect = this.size.width / this.size.height;
        const half = Math.max(extent[1], extent[0] / aspect, 0.01) * kMargin;
        this.flat.top = half;
        this.flat.bottom = -half;
        this.flat.left = -half * aspect;
        this.flat.right = half * aspect;
        this.flat.zoom = 1;
        this.flat.updateProjectionMatrix();
    }
}
