/// Which meshes of the shot the view shows, and whether as surfaces or as edges.
import { effect, type ReadonlySignal } from '@preact/signals';
import { Box3, Color, Vector3, type Object3D, type Scene } from 'three';
import type { ShotState } from '../protocol';
import { lookThrough, shot } from '../state/state';
import { isWireframe, showLamps } from '../state/view_state';
import { reachHorizon } from './far_plane';
import type { SceneMeshes } from './scene_meshes';
import { viewColours } from './theme_colours';
import { Wires } from './wires';

const kShadeMargin = 0.05; // m, of a shade around the lamp in it
const kLowestShade = 0.2; // m, of its lower edge above the cloth
const kLowestHanging = 0.6; // m, of what hangs over the table: bars and chains of lamps, a ceiling

/// The bodies at rest that would hide the table from above: shades around lamps, and what hangs over it.
function hangingIn(state: ShotState, meshes: SceneMeshes): Object3D[] {
    const lamps = state.lights.filter(({ size }) => size.length > 0)
        .map(({ position }) => new Vector3(...position));
    const half = [(state.table?.length ?? 0) / 2, (state.table?.width ?? 0) / 2] as const;
    return state.objects.flatMap((object) => {
        const node = object.kind === 'object' && !object.moves ? meshes.node(object.name) : undefined;
        if (!node) {
            return [];
        }
        const { min, max } = new Box3().setFromObject(node);
        const isShade = min.z > kLowestShade - kShadeMargin && lamps.some((lamp) =>
            new Box3(min, max).expandByScalar(kShadeMargin).containsPoint(lamp));
        const hangs = state.table !== undefined && min.z > kLowestHanging
            && min.x < half[0] && max.x > -half[0] && min.y < half[1] && max.y > -half[1];
        return isShade || hangs ? [node] : [];
    });
}

/// Follows the signals of src/state until the returned function is called. `loaded` changes with the
/// meshes.
export function followVisibility(
    scene: Scene, meshes: SceneMeshes, loaded: ReadonlySignal<number>, ask: () => void,
): () => void {
    const colours = viewColours();
    const wires = new Wires();
    const ends = [
        effect(() => {
            void loaded.value;
            const state = shot.value;
            for (const light of state?.lights ?? []) {
                const lamp = meshes.lamp(light.name);
                if (lamp) {
                    lamp.visible = showLamps.value;
                }
            }
            for (const node of state ? hangingIn(state, meshes) : []) {
                node.visible = showLamps.value;
            }
            for (const object of state?.objects.filter((one) => one.shape === 'plane') ?? []) {
                const node = meshes.node(object.name);
                if (node) {
                    reachHorizon(node);
                    // A table's floor would hide the page's background.
                    node.visible = object.kind !== 'table' || lookThrough.value !== null;
                }
            }
            ask();
        }),
        effect(() => {
            void loaded.value;
            wires.show(isWireframe.value ? meshes.group : null, colours.value, shot.peek());
            ask();
        }),
        effect(() => {
            scene.background = new Color(colours.value.back);
            ask();
        }),
    ];
    return () => {
        ends.forEach((end) => end());
        wires.show(null, colours.peek(), null);
    };
}
