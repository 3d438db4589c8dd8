/// All handles of the strip as it is now.
import { computed, signal } from '@preact/signals';
import { framesOfCameras } from '../../motion/clock';
import { indexOfPart } from '../../sequence/parts';
import { selection, sequence, shot } from '../../state/state';
import { xOf } from '../axis';
import { curveRow, curveScale } from '../curve_row';
import { currentLayout } from '../layout_now';
import { curveCamera, curveName } from '../strip_state';
import { annotationHandles } from './annotation_handles';
import { clipHandles } from './clip_handles';
import { eventHandles } from './event_handles';
import type { Handle } from './handle';
import { lensHandles } from './lens_handles';
import { mapHandles } from './map_handles';
import { partHandles } from './part_handles';
import { speedHandles } from './speed_handles';

/// The id of the handle under the pointer, or with the focus; null: none.
export const activeHandle = signal<string | null>(null);

/// The index of what is selected in a list of the shot; -1 if it is something else.
function selectedIn(list: string): number {
    const [section, index] = selection.value ?? [];
    return section === list ? Number(index) : -1;
}

/// The index of the selected camera; -1 if none is.
export const selectedCamera = computed(() => selectedIn('cameras'));

function inSight(handles: readonly Handle[]): readonly Handle[] {
    return handles.filter(({ time, axis }) => time >= axis.from && time <= axis.to);
}

/// Where several overlap, the first one counts.
export const shownHandles = computed<readonly Handle[]>(() => {
    const layout = currentLayout.value;
    const state = shot.value;
    if (sequence.value && layout.width > 0) {
        return inSight(partHandles(layout, sequence.value, indexOfPart(selection.value)));
    }
    if (!state || layout.width === 0) {
        return [];
    }
    const row = curveRow(layout.curve, curveScale.value);
    const index = curveCamera.value ? state.cameras.indexOf(curveCamera.value) : -1;
    const curve = curveName.value === 'speed' ? speedHandles(layout, state, index, row)
        : lensHandles(layout, state, index, curveName.value, row, framesOfCameras.value[index]);
    return inSight([
        ...annotationHandles(layout, state, selectedIn('annotations')),
        ...eventHandles(layout, state), ...curve, ...mapHandles(layout, state),
        ...clipHandles(layout, state, selectedCamera.value),
    ]);
});

/// The handle at a place; `reach` is added to each handle's own, px.
export function handleAt(
    handles: readonly Handle[], x: number, y: number, reach = 0,
): Handle | undefined {
    return handles.find((handle) => Math.abs(x - xOf(handle.axis, handle.time)) <= handle.reach.x + reach
        && Math.abs(y - handle.y) <= handle.reach.y + reach);
}
