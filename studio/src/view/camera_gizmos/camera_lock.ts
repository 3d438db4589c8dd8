/// While the view looks through a camera of the shot and is locked to it, turning, panning and
/// zooming the view moves the camera: one gesture of edits.
import { effect } from '@preact/signals';
import { PerspectiveCamera, Quaternion, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { beginGesture, type Gesture } from '../../edit/edit';
import type { CameraPose } from '../../motion/camera';
import { cameraLookedThrough } from '../../motion/clock';
import { subtract } from '../../motion/vectors';
import type { Camera, Triple } from '../../protocol';
import { onCommand } from '../../state/keys';
import { lookThrough } from '../../state/state';
import { isCameraLocked } from '../../state/view_state';
import { activeCamera, activeLens } from './camera_part';
import { movePath } from './move_path';

const kWheelPause = 400; // ms; wheel steps with shorter pauses are one step of undo
const kPrecision = 1e-4; // m

interface Move {
    gesture: Gesture;
    camera: Camera;
    pose: CameraPose; // at its start
}

export class CameraLock {
    private readonly camera = new PerspectiveCamera();
    private readonly controls: OrbitControls;
    private readonly ends: (() => void)[];
    private move: Move | null = null;
    private isHeld = false;
    private readonly home = { position: new Vector3(), turn: new Quaternion(), target: new Vector3() };
    private lastWheel = -Infinity; // ms
    private readonly timer = { id: 0, forget: () => {} };

    /// `moved` is called with the camera to look through.
    constructor(
        canvas: HTMLCanvasElement, private readonly moved: (held: PerspectiveCamera | null) => void,
    ) {
        this.camera.up.set(0, 0, 1);
        this.controls = new OrbitControls(this.camera, canvas);
        this.controls.enabled = false;
        this.controls.addEventListener('start', () => this.begin());
        this.controls.addEventListener('change', () => this.change());
        this.controls.addEventListener('end', () => this.end());
        const wheel = () => { this.lastWheel = performance.now(); };
        canvas.addEventListener('wheel', wheel, { capture: true, passive: true });
        this.ends = [
            () => canvas.removeEventListener('wheel', wheel, { capture: true }),
            effect(() => {
                this.controls.enabled = isCameraLocked.value && lookThrough.value !== null;
                if (!this.controls.enabled) {
                    this.finish((gesture) => gesture.commit('Move the camera'));
                }
            }),
        ];
    }

    /// Whether the view is being moved: then it shows where the camera shall be.
    get isMoving(): boolean {
        return this.move !== null;
    }

    /// Takes over the pose that the view has now.
    place(through: PerspectiveCamera, target: Triple): void {
        if (this.isHeld || this.isMoving) {
            return;
        }
        this.home.position.copy(through.position);
        this.home.turn.copy(through.quaternion);
        this.home.target.set(...target);
        this.goHome();
        this.camera.fov = through.fov;
        this.camera.aspect = through.aspect;
        this.camera.near = through.near;
        this.camera.far = through.far;
        this.camera.updateProjectionMatrix();
    }

    dispose(): void {
        this.finish((gesture) => gesture.cancel());
        this.ends.forEach((end) => end());
        this.controls.dispose();
    }

    private goHome(): void {
        this.camera.position.copy(this.home.position);
        this.camera.quaternion.copy(this.home.turn);
        this.controls.target.copy(this.home.target);
    }

    private begin(): void {
        clearTimeout(this.timer.id);
        this.isHeld = true;
    }

    private change(): void {
        const lens = activeLens.peek();
        if (!this.isHeld) {
            this.goHome(); // Escape was pressed: the pointer moves nothing until it is pressed anew
            return;
        }
        if ( !this.move && (!lens || activeCamera.peek() !== cameraLookedThrough.peek())) {
            return;
        }
        if (!this.move && lens) {
            this.move = { gesture: beginGesture(true), camera: lens.camera, pose: lens.pose };
            this.timer.forget = onCommand('cancel', () => {
                this.isHeld = false;
                this.finish((gesture) => gesture.cancel());
            });
        }
        const move = this.move as Move;
        const { camera, pose } = move;
        const position = this.camera.position.toArray();
        const target = this.controls.target.toArray();
        const changes = [
            ...movePath(camera.position, pose.position, subtract(position, pose.position), kPrecision),
            ...movePath(camera.target, pose.target, subtract(target, pose.target), kPrecision),
        ];
        if (changes.length > 0) {
            move.gesture.update(changes);
        }
        this.moved(this.camera);
    }

    private end(): void {
        this.isHeld = false;
        const commit = () => this.finish((gesture) => gesture.commit('Move the camera'));
        if (performance.now() - this.lastWheel < kWheelPause) {
            this.timer.id = window.setTimeout(commit, kWheelPause);
        } else {
            commit();
        }
    }

    private finish(how: (gesture: Gesture) => void): void {
        clearTimeout(this.timer.id);
        const { move } = this;
        this.move = null;
        this.timer.forget();
        this.timer.forget = () => {};
        if (move) {
            how(move.gesture);
            this.moved(null);
        }
    }
}
