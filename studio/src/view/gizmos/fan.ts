/// Paths of eight slightly different runs of the shot, faintly: how sure what follows is.
import { effect } from '@preact/signals';
import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments } from 'three';
import { send } from '../../connection/socket';
import { kFanNumbersPerPoint, type FanHead, type SceneObject } from '../../protocol';
import { onCommand } from '../../state/keys';
import { dragging, fan, isStale, selection, shot, timeline } from '../../state/state';
import { showTrails } from '../../state/view_state';
import { kDrawingPriority, type MakePart } from '../parts';
import { trailColour } from '../trail_lines';
import { isFanShown } from './fan_state';
import { forTests } from './sketch';

const kRuns = 8;
const kDistance = 1e-4; // m
const kAngle = 0.00175; // rad

/// The balls whose paths are shown: the selected one, else those that are struck.
function shownBalls(objects: readonly SceneObject[]): SceneObject[] {
    const [section, name] = selection.value ?? [];
    const chosen = objects.filter((one) =>
        one.path[0] === section && one.path[1] === name && one.moves);
    const struck = new Set((shot.value?.events ?? []).map(({ object }) => object));
    return chosen.length > 0 ? chosen : objects.filter((one) => struck.has(one.name));
}

/// Line pieces of the runs of some objects, with their colours.
export function fanLines(
    head: Pick<FanHead, 'tracks'>, numbers: Float64Array, balls: readonly SceneObject[],
): { places: number[]; colours: number[] } {
    const places: number[] = [];
    const colours: number[] = [];
    for (const { name, first, points } of head.tracks) {
        const ball = balls.find((one) => one.name === name);
        const colour = ball ? trailColour(ball).toArray() : null;
        for (let i = 0; colour && i + 1 < points; ++i) {
            const at = first + i * kFanNumbersPerPoint;
            places.push(...numbers.subarray(at + 1, at + 4), ...numbers.subarray(at + 5, at + 8));
            colours.push(...colour, ...colour);
        }
    }
    return { places, colours };
}

export const makeFan: MakePart = ({ scene, ask }) => {
    const lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({
        vertexColors: true, transparent: true, opacity: 0.3, depthWrite: false,
    }));
    lines.frustumCulled = false;
    scene.add(lines);
    forTests['fanPieces'] = () => lines.visible
        ? (lines.geometry.getAttribute('position')?.count ?? 0) / 2 : 0;
    let asked = false;
    const ends = [
        effect(() => {
            const v = timeline.value?.head.v;
            const isWanted = isFanShown.value && !dragging.value && !isStale.value;
            if (isWanted && v !== undefined) {
                asked = send('fan', { v, runs: kRuns, distance: kDistance, angle: kAngle });
            } else if (asked) {
                asked = false;
                send('unfan', {});
            }
        }),
        effect(() => {
            const answer = isFanShown.value && !isStale.value ? fan.value : null;
            lines.visible = answer !== null && showTrails.value;
            if (answer) {
                const { places, colours } = fanLines(
                    answer.head, answer.numbers, shownBalls(shot.value?.objects ?? []));
                lines.geometry.dispose();
                lines.geometry = new BufferGeometry()
                    .setAttribute('position', new Float32BufferAttribute(places, 3))
                    .setAttribute('color', new Float32BufferAttribute(colours, 3));
            }
            ask();
        }),
        onCommand('fan', () => { isFanShown.value = !isFanShown.peek(); }),
    ];
    return {
        priority: kDrawingPriority,
        dispose: () => {
            ends.forEach((end) => end());
            lines.removeFromParent();
            lines.geometry.dispose();
            lines.material.dispose();
        },
    };
};
