/// Which meshes of the shot the view shows, and whether as surfaces or as edges.
import { effect, type ReadonlySignal } from '@preact/signals';
import { Box3, Color, Vector3, type Scene } from 'three';
import type { SceneLight, ShotState } from '../protocol';
import { lookThrough, shot } from '../state/state';
import { isWireframe, showLamps } from '../state/view_state';
import { reachHorizon } from './far_plane';
import type { SceneMeshes } from './scene_meshes';
import { viewColours } from './theme_colours';
import { Wires } from './wires';

const kShadeMargin = 0.05; // m, of a shade around the lamp in it
const kLowestShade = 0.2; // m, of its lower edge above the cloth

/// The bodies at rest around an area light: the shade of a lamp.
function shadesOf(light: SceneLight, state: ShotState, meshes: SceneMeshes): string[] {
    if (light.kind !== 'rectangle' && light.kind !== 'sphere') {
        return [];
    }
    return state.objects.filter((object) => {
        const node = object.kind === 'object' && !object.moves ? meshes.node(object.name) : undefined;
        const box = node && new Box3().setFromObject(node).expandByScalar(kShadeMargin);
        return box && box.min.z > kLowestShade
            && box.containsPoint(new Vector3(...light.position));
    }).map((object) => object.name);
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
                for (const name of state ? shadesOf(light, state, meshes) : []) {
                    const node = meshes.node(name);
                    if (node) {
                        node.visible = showLamps.value;
                    }
                }
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
