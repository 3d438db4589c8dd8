/// What the view draws, and from where: follows the signals of src/state.
import { effect, signal } from '@preact/signals';
import { DirectionalLight, Group, HemisphereLight, Scene } from 'three';
import type { CameraPose } from '../motion/camera';
import { cameraLookedThrough, framesOfCameras, tracks } from '../motion/clock';
import { connection, filmTime, lookThrough, meshes, notice, sceneTime, shot } from '../state/state';
import { isWireframe } from '../state/view_state';
import { kAllParts } from './all_parts';
import { BallFigures } from './ball_figures';
import { CameraLock } from './camera_gizmos/camera_lock';
import { Cameras } from './cameras';
import { makeContext } from './context';
import { Drawing } from './drawing';
import { FilmMask } from './film_mask';
import { answerContextMenu, openContextMenu } from './menu/context_menu';
import { objectIds } from './object_ids';
import type { ViewCamera, ViewContext } from './parts';
import { arbitratePointer } from './pointer';
import { SceneMeshes } from './scene_meshes';
import { pickedBy, selectByClick, traceByDoubleClick } from './selecting';
import { answerViewKeys, lookAtAll } from './view_keys';
import { followVisibility } from './visibility';

/// Everything drawn on one canvas.
export class Stage {
    /// Null if the browser has no WebGL.
    static on(canvas: HTMLCanvasElement): Stage | null {
        const scene = new Scene();
        let stage: Stage | null = null;
        const cameras = new Cameras(canvas, () => stage?.aim());
        const drawing = Drawing.on(canvas, scene, () => cameras.current);
        if (!drawing) {
            cameras.dispose();
            return null;
        }
        stage = new Stage(canvas, drawing, scene, cameras);
        return stage;
    }

    readonly context: ViewContext;
    private readonly meshes: SceneMeshes;
    private readonly figures = new BallFigures();
    private readonly mask: FilmMask;
    private readonly moved = signal(0);
    private readonly loaded = signal(0); // how often meshes were loaded
    private readonly lock: CameraLock;
    private readonly ends: (() => void)[] = [];
    private missing: string | null = null; // meshes that could not be loaded
    private seen: string | null = null; // the shot that the free view was turned to

    private constructor(
        readonly canvas: HTMLCanvasElement, readonly drawing: Drawing, scene: Scene,
        readonly cameras: Cameras,
    ) {
        this.meshes = new SceneMeshes(drawing.isFast);
        this.mask = new FilmMask(canvas);
        this.lock = new CameraLock(canvas, (held) => {
            if (held) {
                cameras.lookHeld(held);
                this.tellMoved();
            } else {
                this.aim();
            }
        });
        const overlay = new Group();
        overlay.renderOrder = 2;
        this.context = makeContext(
            canvas, overlay, cameras, this.meshes, drawing, this.moved, this.loaded);
        lookAtAll(cameras);
        const lamp = new DirectionalLight(0xffffff, 1.6);
        lamp.position.set(0.4, -0.8, 2);
        scene.add(new HemisphereLight(0xffffff, 0x404840, 1.8), lamp, this.meshes.group,
            this.meshes.instances.group, this.figures.group, overlay);
        scene.onBeforeRender = () => {
            this.meshes.instances.place();
            this.figures.place((name) => this.meshes.node(name), !isWireframe.peek());
        };

        const parts = kAllParts.map((make) => make(this.context));
        this.ends.push(
            arbitratePointer(canvas, parts, (at) => openContextMenu(this.context, parts, at)),
            ...parts.map((part) => () => part.dispose()),
            selectByClick(canvas, (pixel) => {
                const object = this.context.objectAt(pixel);
                return pickedBy(parts, pixel)
                    ?? (!object || object.kind === 'table' ? null : object.path);
            }),
            traceByDoubleClick(canvas, parts),
            answerContextMenu(this.context, parts),
            answerViewKeys(cameras, this.context, () => this.aim()),
            followVisibility(scene, this.meshes, this.loaded, () => drawing.ask()),
        );
        this.follow();
    }

    /// The one that is looked through now.
    get camera(): ViewCamera {
        return this.cameras.current;
    }

    /// Sizes in CSS pixels.
    resize(width: number, height: number): void {
        this.cameras.resize(width, height);
        this.drawing.resize(this.cameras.size.width, this.cameras.size.height);
        this.lookAtNewShot();
        this.aim();
    }

    /// Which object each pixel of the looked-through camera's picture shows, for tests: 1 + its index,
    /// or 0; empty in the free view.
    objectIds(width: number, height: number): Uint16Array {
        const state = shot.peek();
        const pose = this.poseNow();
        return state && pose ? objectIds(this.drawing.renderer, this.meshes, state,
            this.cameras.through, pose, width, height) : new Uint16Array();
    }

    dispose(): void {
        this.ends.forEach((end) => end());
        this.figures.dispose();
        this.mask.dispose();
        this.lock.dispose();
        this.cameras.dispose();
        this.drawing.dispose();
    }

    private follow(): void {
        this.ends.push(
            effect(() => this.load(meshes.value)),
            effect(() => {
                if (connection.value === 'open' && this.missing !== null) {
                    this.load(this.missing);
                }
            }),
            effect(() => {
                if (shot.value) {
                    this.figures.take(shot.value);
                    this.meshes.pose(shot.value, tracks.value, sceneTime.value);
                }
                this.drawing.ask();
            }),
            effect(() => {
                if (shot.value) {
                    this.lookAtNewShot();
                }
            }),
            effect(() => {
                void [filmTime.value, lookThrough.value, cameraLookedThrough.value, framesOfCameras.value];
                this.aim();
            }),
        );
    }

    private lookAtNewShot(): void {
        const name = shot.peek()?.name ?? null;
        if (name !== null && name !== this.seen && this.cameras.size.width > 1) {
            this.seen = name;
            lookAtAll(this.cameras);
            this.aim();
        }
    }

    private load(hash: string | null): void {
        if (hash === null) {
            return;
        }
        this.missing = null;
        this.meshes.load(hash).then((isShown) => {
            const state = shot.peek();
            if (isShown && state) {
                this.figures.take(state);
                this.meshes.pose(state, tracks.peek(), sceneTime.peek());
            }
            if (isShown) {
                this.loaded.value += 1;
            }
            this.drawing.ask();
        }, () => {
            this.missing = hash === meshes.peek() ? hash : null;
            if (this.missing !== null) {
                notice.value = {
                    kind: 'error', text: 'The shapes of the shot could not be loaded. The page tries '
                        + 'it again when it has connected to the server anew.',
                };
            }
        });
    }

    /// Looks from where the view's own or the chosen camera is.
    private aim(): void {
        if (this.lock.isMoving) {
            return;
        }
        const state = shot.peek();
        const pose = this.poseNow();
        if (state && pose) {
            const { width, height } = state.film;
            const aspect = height > 0 ? width / height : 16 / 9;
            this.cameras.lookThrough(pose, this.mask.show(this.cameras.size, aspect));
            this.lock.place(this.cameras.through, pose.target);
        } else {
            this.mask.hide();
            this.cameras.lookFreely();
        }
        this.tellMoved();
    }

    /// Of the camera of the shot that is looked through; null in the free view.
    private poseNow(): CameraPose | null {
        return framesOfCameras.peek()[cameraLookedThrough.peek()]?.poseAt(filmTime.peek()) ?? null;
    }

    private tellMoved(): void {
        this.moved.value = this.moved.peek() + 1;
        this.drawing.ask();
    }
}
