/// What is at the pointer.
import { Plane, Raycaster, Vector2, Vector3 } from 'three';
import type { Camera, Object3D, Ray } from 'three';
import type { SceneObject } from '../protocol';
import { kInstancedLayer } from './instances';
import type { Pixel } from './parts';

/// The ray through the pointer's place on the canvas.
export function rayAt(event: Pixel, canvas: HTMLElement, camera: Camera): Raycaster {
    const box = canvas.getBoundingClientRect();
    const ray = new Raycaster();
    ray.layers.enable(kInstancedLayer);
    ray.setFromCamera(new Vector2(
        ((event.clientX - box.left) / box.width) * 2 - 1,
        1 - ((event.clientY - box.top) / box.height) * 2), camera);
    return ray;
}

/// The nearest of the objects that the ray meets; null if it meets none.
export function pick(
    ray: Raycaster, objects: readonly SceneObject[], node: (name: string) => Object3D | undefined,
): SceneObject | null {
    let nearest = Infinity;
    let found: SceneObject | null = null;
    for (const object of objects) {
        const mesh = node(object.name);
        const hit = mesh?.visible && ray.intersectObject(mesh, true)[0];
        if (hit && hit.distance < nearest) {
            nearest = hit.distance;
            found = object;
        }
    }
    return found;
}

/// Where the ray meets the level plane at that height: x and y; null if it does not.
export function onLevel(ray: Ray, height: number): [number, number] | null {
    const point = ray.intersectPlane(new Plane(new Vector3(0, 0, 1), -height), new Vector3());
    return point && [point.x, point.y];
}
