/// What the parts of the view get, over its canvas and cameras.
import type { ReadonlySignal } from '@preact/signals';
import type { Object3D } from 'three';
import { Vector3 } from 'three';
import type { Triple } from '../protocol';
import { shot } from '../state/state';
import type { Cameras } from './cameras';
import type { Drawing } from './drawing';
import type { Pixel, ViewContext } from './parts';
import { pick, rayAt } from './picking';
import type { SceneMeshes } from './scene_meshes';

export function makeContext(
    canvas: HTMLCanvasElement, scene: Object3D, cameras: Cameras, meshes: SceneMeshes,
    drawing: Drawing, moved: ReadonlySignal<number>, loaded: ReadonlySignal<number>,
): ViewContext {
    const raycasterAt = (pixel: Pixel) => rayAt(pixel, canvas, cameras.current);
    return {
        canvas, scene, moved, loaded, raycasterAt,
        camera: () => cameras.current,
        rayAt: (pixel) => raycasterAt(pixel).ray,
        toScreen: (point) => toScreen(point, cameras),
        metresPerPixel: (point) => metresPerPixel(point, cameras),
        size: () => cameras.size,
        pixelRatio: () => drawing.renderer.getPixelRatio(),
        box: () => cameras.box(),
        meshNode: (name) => meshes.node(name) ?? null,
        objectAt: (pixel) => pick(
            raycasterAt(pixel), shot.peek()?.objects ?? [], (name) => meshes.node(name)),
        ask: () => drawing.ask(),
    };
}

function toScreen(point: Triple, { current, size }: Cameras): [number, number] | null {
    const seen = new Vector3(...point).applyMatrix4(current.matrixWorldInverse);
    if (seen.z >= 0) {
        return null;
    }
    seen.applyMatrix4(current.projectionMatrix);
    return [(0.5 + seen.x / 2) * size.width, (0.5 - seen.y / 2) * size.height];
}

function metresPerPixel(point: Triple, { current, size }: Cameras): number {
    const seen = new Vector3(...point).applyMatrix4(current.matrixWorldInverse);
    // The second diagonal element is the distance, or 1, over half the height that is seen.
    const scale = current.projectionMatrix.elements[5] ?? 1;
    const depth = 'isPerspectiveCamera' in current ? Math.max(-seen.z, 1e-6) : 1;
    return (2 * depth) / (scale * size.height);
}
