/// The keys that move the selected object: a line from place to place, with a handle for each place.
import { computed, effect } from '@preact/signals';
import type { KeyPath, Triple } from '../../protocol';
import { selection, shot } from '../../state/state';
import type { Handle } from '../handles/handle';
import { handleSet } from '../handles/handle_part';
import { kHandlePriority, type MakePart } from '../parts';
import { kColours, type Figure, type Line } from './figure';
import type { Parsed } from './measures';
import { selectedObject } from './nudge';
import { tripleOf, valueAt } from './shot_values';
import { forTests, sketchOf } from './sketch';

/// A key of a motion with the place that its text has.
export interface PlacedKey {
    index: number;
    time: number | null; // scene time, s
    place: Triple;
}

/// The keys with a place of their own, from the value of `motion.keys`.
export function placedKeys(keys: Parsed | undefined): PlacedKey[] {
    return (Array.isArray(keys) ? keys : []).flatMap((key, index) => {
        const parts = typeof key === 'object' && !Array.isArray(key) ? key : {};
        const place = tripleOf(parts['position']);
        const time = parts['at'];
        return place ? [{ index, place, time: typeof time === 'number' ? time : null }] : [];
    });
}

/// A handle for each key with a place; `path` is that of the object.
export function keyHandles(path: KeyPath, name: string, keys: readonly PlacedKey[]): Handle[] {
    return keys.map(({ index, time, place }) => {
        const own = [...path, 'motion', 'keys', String(index), 'position'];
        return {
            key: own.join('/'), path: own, at: place, colour: kColours.accent, shape: 'ring', size: 13,
            label: `${name}: key ${index + 1}${time === null ? '' : ` at ${Number(time.toFixed(3))} s`}`,
            way: { kind: 'free' },
            changes: (to, precision) => [{ path: own, value: to, precision }],
        };
    });
}

/// Lines from handle to handle, as they are dragged.
export function keyLines(handles: readonly Handle[]): Figure {
    const lines: Line[] = handles.slice(1).map(({ at, colour }, i) =>
        ({ from: handles[i]?.at ?? at, to: at, colour, isFaint: true }));
    return { lines };
}

const handles = computed((): Handle[] => {
    void [selection.value, shot.value];
    const object = selectedObject();
    return object?.kind === 'object' ? keyHandles(object.path, object.name,
        placedKeys(valueAt([...object.path, 'motion', 'keys']))) : [];
});

export const makeMotionKeys: MakePart = (context) => {
    const sketch = sketchOf(context);
    const set = handleSet(handles, context);
    forTests['motionKeys'] = () => set.shown.peek();
    const ends = [
        effect(() => sketch.show('motion keys', keyLines(set.shown.value))),
        effect(() => sketch.show('motion key handles', set.figure())),
    ];
    return {
        priority: kHandlePriority,
        grab: set.grab,
        hover: set.hover,
        pick: set.pick,
        dispose: () => {
            ends.forEach((end) => end());
            sketch.dispose();
        },
    };
};
