/// What the view draws, and from where: follows the signals of src/state.
import { effect } from '@preact/signals';
import {
    Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Scene,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { cameraAxes } from '../motion/camera';
import { filmCamera, framesOfCameras, tracks } from '../motion/clock';
import {
    filmTime, isStale, lookThrough, meshes, sceneTime, selection, shot,
} from '../state/state';
import type { SceneObject } from '../protocol';
import { onCommand } from '../state/keys';
import { dragBalls } from './ball_drag';
import { Drawing } from './drawing';
import { fovOfView, letterbox } from './letterbox';
import { pick, rayAt } from './picking';
import { SceneMeshes } from './scene_meshes';
import { showTracedPicture } from './traced_picture';
import { Trails } from './trails';

const kClickDistance = 4; // CSS pixels; a longer way is a drag

/// Everything drawn on one canvas.
export class Stage {
    /// Null if the browser has no WebGL.
    static on(canvas: HTMLCanvasElement): Stage | null {
        const scene = new Scene();
        const camera = new PerspectiveCamera(40, 1, 0.01, 200);
        const drawing = Drawing.on(canvas, scene, camera);
        return drawing && new Stage(canvas, drawing, scene, camera);
    }

    private readonly free = new PerspectiveCamera(40, 1, 0.01, 200);
    private readonly trails = new Trails();
    private readonly meshes: SceneMeshes;
    private readonly orbit: OrbitControls;
    private readonly ends: (() => void)[] = [];
    private size = { width: 1, height: 1 };
    private readonly mask = document.createElement('div');

    private constructor(
        private readonly canvas: HTMLCanvasElement, readonly drawing: Drawing,
        private readonly scene: Scene, private readonly camera: PerspectiveCamera,
    ) {
        this.meshes = new SceneMeshes(drawing.isFast);
        this.free.up.set(0, 0, 1);
        this.free.position.set(-0.6, -2.6, 1.7);
        this.orbit = new OrbitControls(this.free, canvas);
        this.orbit.zoomToCursor = true;
        this.orbit.addEventListener('change', () => this.aim());
        const lamp = new DirectionalLight(0xffffff, 1.6);
        lamp.position.set(0.4, -0.8, 2);
        scene.add(new HemisphereLight(0xffffff, 0x404840, 1.8), lamp);
        scene.add(this.meshes.group, this.trails.lines);
        Object.assign(this.mask.style, {
            position: 'absolute', pointerEvents: 'none', boxShadow: '0 0 0 9999px rgb(0 0 0 / 55%)',
        });
        canvas.parentElement?.append(this.mask);
        this.follow();
        this.listen();
        this.answerKeys();
        this.ends.push(showTracedPicture(this.mask));
    }

    /// Sizes in CSS pixels.
    resize(width: number, height: number): void {
        this.size = { width: Math.max(1, width), height: Math.max(1, height) };
        this.free.aspect = this.size.width / this.size.height;
        this.drawing.resize(this.size.width, this.size.height);
        this.aim();
    }

    dispose(): void {
        this.ends.forEach((end) => end());
        this.mask.remove();
        this.orbit.dispose();
        this.drawing.dispose();
    }

    private follow(): void {
        this.ends.push(
            effect(() => this.load(meshes.value)),
            effect(() => {
                this.trails.update(shot.value?.objects ?? [], tracks.value);
                this.drawing.ask();
            }),
            effect(() => {
                this.trails.setStale(isStale.value);
                this.drawing.ask();
            }),
            effect(() => {
                if (shot.value) {
                    this.meshes.pose(shot.value, tracks.value, sceneTime.value);
                }
                this.drawing.ask();
            }),
            effect(() => {
                void [filmTime.value, lookThrough.value, framesOfCameras.value];
                this.aim();
            }),
        );
    }

    private load(hash: string | null): void {
        if (hash === null) {
            return;
        }
        this.meshes.load(hash).then((isShown) => {
            const state = shot.peek();
            if (isShown && state) {
                this.meshes.pose(state, tracks.peek(), sceneTime.peek());
            }
            this.drawing.ask();
        }, (error: unknown) => console.error(error));
    }

    /// Looks from where the free view or the chosen camera is.
    private aim(): void {
        const name = lookThrough.peek();
        const index = shot.peek()?.cameras.findIndex((camera) => camera.name === name) ?? -1;
        const pose = framesOfCameras.peek()[index]?.poseAt(filmTime.peek());
        this.orbit.enabled = !pose;
        this.mask.hidden = !pose;
        if (pose) {
            const { right, up, back } = cameraAxes(pose);
            this.camera.matrix.set(
                right[0], up[0], back[0], 0, right[1], up[1], back[1], 0,
                right[2], up[2], back[2], 0, 0, 0, 0, 1);
            this.camera.quaternion.setFromRotationMatrix(this.camera.matrix);
            this.camera.position.set(...pose.position);
            this.camera.fov = this.letterbox(pose.verticalFov);
        } else {
            this.camera.position.copy(this.free.position);
            this.camera.quaternion.copy(this.free.quaternion);
            this.camera.fov = this.free.fov;
        }
        this.camera.aspect = this.free.aspect;
        this.camera.updateProjectionMatrix();
        this.drawing.ask();
    }

    /// Darkens what the film does not show. Returns the field of view of the whole view, degrees.
    private letterbox(filmFov: number): number {
        const film = shot.peek()?.film;
        const aspect = film && film.height > 0 ? film.width / film.height : 16 / 9;
        const box = letterbox(this.size, aspect);
        for (const side of ['left', 'top', 'width', 'height'] as const) {
            this.mask.style[side] = `${box[side]}px`;
        }
        return (fovOfView(filmFov, this.size.height, box) * 180) / Math.PI;
    }

    private answerKeys(): void {
        const look = (x: number, y: number, z: number) => () => {
            lookThrough.value = null;
            this.free.position.set(x, y, z);
            this.orbit.target.set(0, 0, 0);
            this.orbit.update();
            this.aim();
        };
        this.ends.push(
            onCommand('viewTop', look(0, -0.001, 3.6)),
            onCommand('viewSide', look(0, -3.6, 0.3)),
            onCommand('viewFree', look(-0.6, -2.6, 1.7)),
            onCommand('lookThrough', () => {
                const camera = shot.peek()?.cameras[filmCamera.peek()];
                lookThrough.value = lookThrough.peek() === null ? camera?.name ?? null : null;
            }),
        );
    }

    private listen(): void {
        let start: [number, number] | null = null;
        const down = (event: PointerEvent) => {
            start = event.button === 0 ? [event.clientX, event.clientY] : null;
        };
        const up = (event: PointerEvent) => {
            const way = start ? Math.hypot(event.clientX - start[0], event.clientY - start[1])
                : Infinity;
            if (way < kClickDistance) {
                const object = this.objectAt(event);
                selection.value = !object || object.kind === 'table' ? null : object.path;
            }
        };
        this.canvas.addEventListener('pointerdown', down);
        this.canvas.addEventListener('pointerup', up);
        this.ends.push(dragBalls(this.canvas, {
            rayAt: (event) => rayAt(event, this.canvas, this.camera),
            objectAt: (event) => this.objectAt(event),
        }), () => {
            this.canvas.removeEventListener('pointerdown', down);
            this.canvas.removeEventListener('pointerup', up);
        });
        this.scene.background = new Color(0x202428);
    }

    private objectAt(event: PointerEvent): SceneObject | null {
        return pick(rayAt(event, this.canvas, this.camera), shot.peek()?.objects ?? [],
            (name) => this.meshes.node(name));
    }
}
