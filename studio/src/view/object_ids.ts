/// Which object of the shot each pixel of the film's picture shows, as drawn by the view: to compare
/// with the renderer's object_id.
import {
    Color, DoubleSide, Mesh, MeshBasicMaterial, NoToneMapping, PerspectiveCamera, Scene,
    WebGLRenderTarget, type Material, type Object3D, type WebGLRenderer,
} from 'three';
import type { CameraPose } from '../motion/camera';
import type { ShotState } from '../protocol';
import { kInstancedLayer } from './instances';
import type { SceneMeshes } from './scene_meshes';

/// The colour that stands for a number in the target, which has no transfer function.
function colourOf(id: number): Color {
    return new Color(((id >> 8) & 255) / 255, (id & 255) / 255, 0);
}

function paint(object: Object3D, id: number, before: Map<Mesh, Material | Material[]>): void {
    const material = new MeshBasicMaterial({ color: colourOf(id), side: DoubleSide, fog: false });
    object.traverse((part) => {
        if (part instanceof Mesh && !before.has(part)) {
            before.set(part, part.material as Material | Material[]);
            part.material = material;
        }
    });
}

/// 1 + the index in `shot.objects` and, after them, `shot.lights`, or 0, for each pixel from the upper left
/// corner. `through` looks as the camera with that pose does; its field of view is replaced by the film's.
export function objectIds(
    renderer: WebGLRenderer, meshes: SceneMeshes, shot: ShotState, through: PerspectiveCamera,
    pose: CameraPose, width: number, height: number,
): Uint16Array {
    const before = new Map<Mesh, Material | Material[]>();
    const nodes = [...shot.objects.map(({ name }) => meshes.node(name)),
        ...shot.lights.map(({ name }) => meshes.lamp(name))];
    nodes.forEach((node, i) => {
        if (node) {
            paint(node, i + 1, before);
        }
    });
    paint(meshes.group, 0, before); // what else there is
    const scene = new Scene();
    const parent = meshes.group.parent;
    scene.add(meshes.group);
    const camera = through.clone();
    camera.fov = (pose.verticalFov * 180) / Math.PI;
    camera.aspect = width / height;
    camera.near = 1e-3;
    camera.layers.enable(kInstancedLayer);
    camera.updateProjectionMatrix();
    const target = new WebGLRenderTarget(width, height);
    const pixels = new Uint8Array(4 * width * height);
    const toneMapping = renderer.toneMapping;
    renderer.toneMapping = NoToneMapping;
    renderer.setRenderTarget(target);
    renderer.setClearColor(0, 1);
    renderer.clear();
    renderer.render(scene, camera);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    renderer.setRenderTarget(null);
    renderer.toneMapping = toneMapping;
    parent?.add(meshes.group);
    before.forEach((material, mesh) => { mesh.material = material; });
    target.dispose();
    return Uint16Array.from({ length: width * height }, (_, i) => {
        const row = height - 1 - Math.floor(i / width);
        const at = 4 * (row * width + (i % width));
        return 256 * (pixels[at] ?? 0) + (pixels[at + 1] ?? 0);
    });
}
